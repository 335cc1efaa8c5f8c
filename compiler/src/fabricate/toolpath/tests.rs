//! Toolpaths of small parts, and every refusal. That a program cuts the right part is shown by `readback`'s tests.

use super::*;
use crate::fabricate::cut_job::Engraving;
use crate::fabricate::machine::tests::router;

/// A quad of about 250 mm with the alias `shell-07-12`.
pub(crate) fn panel() -> CutJob {
    CutJob {
        address: "shell.7-12".to_owned(),
        alias: "shell-07-12".to_owned(),
        design: "shell".to_owned(),
        design_hash: "sha256:0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef".to_owned(),
        outline: [(0.0, 0.0), (250.0, 10.0), (240.0, 235.0), (-12.0, 228.0)].map(DVec2::from).to_vec(),
        thickness: 12.0,
        engraving: Engraving { height: 18.0, least_height: 6.0, clearance: 4.0, mark_edge_0: true },
        face_up: "top".to_owned(),
        notes: vec![
            "edge 0 bevel 3.250 deg, not cut by this file".to_owned(),
            "edge 1 meets shell.8-12 edge 3".to_owned(),
        ],
    }
}

/// A convex or concave outline as a job, otherwise as [`panel`].
pub(crate) fn shaped(corners: &[(f64, f64)]) -> CutJob {
    CutJob { outline: corners.iter().map(|&p| DVec2::from(p)).collect(), ..panel() }
}

pub(crate) fn machine() -> Machine {
    Machine::try_new(router()).unwrap()
}

fn refused(job: &CutJob) -> Refusal {
    program(job, &machine()).unwrap_err()
}

#[test]
fn a_panel_is_engraved_first_and_cut_in_equal_passes() {
    let made = program(&panel(), &machine()).unwrap();
    let loads = made
        .steps
        .iter()
        .filter_map(|s| if let Step::LoadTool { number } = s { Some(*number) } else { None });
    assert_eq!(loads.collect::<Vec<_>>(), [2, 1]);
    // 12.5 mm in steps of at most 5 mm: three passes of four arcs.
    let arcs: Vec<f64> = made
        .steps
        .iter()
        .filter_map(|s| if let Step::Arc { to, .. } = s { Some(to.z) } else { None })
        .collect();
    // The last leads away from the contour.
    assert_eq!((arcs.len(), arcs[12]), (13, -12.5));
    for (i, z) in arcs[..12].iter().enumerate() {
        assert!((z + 12.5 / 3.0 * (i / 4 + 1) as f64).abs() < 1e-9);
    }
    assert_eq!(made.steps.last(), Some(&Step::SpindleOff));
    // Stock margin and one tool diameter around the part.
    assert_eq!(made.header.stock, DVec3::new(262.0 + 32.0, 235.0 + 32.0, 12.0));
    let (low, _) = Polygon::try_new(&made.parts[0].outline).unwrap().bounds();
    assert!((low - DVec2::splat(16.0)).length() < 1e-12);
}

#[test]
fn text_keeps_its_height_where_it_has_room_and_shrinks_where_not() {
    let plank = shaped(&[(0.0, 0.0), (400.0, 0.0), (380.0, 120.0), (15.0, 120.0)]);
    assert_eq!(program(&plank, &machine()).unwrap().parts[0].engraved_height, 18.0);
    let mut small = shaped(&[(0.0, 0.0), (60.0, 0.0), (62.0, 55.0), (3.0, 58.0)]);
    small.engraving.least_height = 3.0;
    let height = program(&small, &machine()).unwrap().parts[0].engraved_height;
    assert!((3.0..6.0).contains(&height), "{height}");
}

#[test]
fn text_that_fits_at_no_height_is_refused_with_both_heights() {
    let small = shaped(&[(0.0, 0.0), (60.0, 0.0), (62.0, 55.0), (3.0, 58.0)]);
    let message = refused(&small).to_string();
    assert!(message.contains("18.000 mm high as asked nor 6.000 mm"), "{message}");
}

#[test]
fn an_inner_corner_a_round_tool_cannot_cut_is_refused_and_a_gentle_one_is_cut() {
    let notch = shaped(&[(0.0, 0.0), (300.0, 0.0), (300.0, 200.0), (150.0, 120.0), (0.0, 200.0)]);
    assert!(matches!(refused(&notch), Refusal::ConcaveCorner { corner: 3, .. }));
    let gentle = shaped(&[(0.0, 0.0), (300.0, 0.0), (300.0, 200.0), (150.0, 196.0), (0.0, 200.0)]);
    assert!(program(&gentle, &machine()).is_ok());
}

/// A C whose mouth is narrower than the tool, all inner corners gentle.
#[test]
fn a_recess_narrower_than_the_tool_is_refused() {
    let circle = |radius: f64, from: f64, to: f64, n: i32| {
        (0..=n)
            .map(move |i| from + (to - from) * f64::from(i) / f64::from(n))
            .map(move |a| (radius * libm::cos(a), radius * libm::sin(a)))
    };
    let outer = circle(200.0, 0.02, 6.263, 120);
    let inner = circle(100.0, 6.243, 0.04, 120);
    let corners: Vec<(f64, f64)> = outer.chain(inner).collect();
    // The mouth is 8 mm wide inside and outside: a 6 mm tool passes, a 12 mm tool does not.
    assert!(program(&shaped(&corners), &machine()).is_ok());
    let mut spec = router();
    spec.tools[0].diameter = 12.0;
    let wide = Machine::try_new(spec).unwrap();
    assert!(matches!(program(&shaped(&corners), &wide), Err(Refusal::ToolDoesNotFit { .. })));
}

#[test]
fn bad_outlines_are_refused_with_what_is_wrong() {
    let cases: [(&[(f64, f64)], &str); 7] = [
        (&[(0.0, 0.0), (100.0, 0.0)], "has 2 corners"),
        (&[(0.0, 0.0), (0.0, 100.0), (100.0, 0.0)], "runs clockwise"),
        (
            &[(0.0, 0.0), (100.0, 100.0), (100.0, 0.0), (0.0, 100.0)],
            "touches or crosses itself at edges 0 and 2",
        ),
        (&[(0.0, 0.0), (100.0, 0.0), (100.0, 0.001), (0.0, 100.0)], "edge 1 shorter"),
        (
            &[(0.0, 0.0), (100.0, 0.0), (50.0, 0.0), (50.0, 100.0)],
            "touches or crosses itself at edges 0 and 1",
        ),
        (&[(0.0, 0.0), (f64::NAN, 0.0), (100.0, 100.0)], "corner 1 out of range"),
        (&[(0.0, 0.0), (1e300, 0.0), (100.0, 100.0)], "corner 1 out of range"),
    ];
    for (corners, words) in cases {
        let message = refused(&shaped(corners)).to_string();
        assert!(message.contains(words), "{message} does not say {words}");
    }
    assert!(matches!(refused(&shaped(&vec![(0.0, 0.0); MAX_CORNERS + 1])), Refusal::Outline { .. }));
}

#[test]
fn every_other_refusal_has_its_own_reason() {
    type Spoil = fn(&mut CutJob, &mut crate::fabricate::machine::MachineSpec);
    use crate::fabricate::machine::{Clamp, Fixing};
    let cases: [(Spoil, &str); 16] = [
        (
            |_, m| m.fixing = Fixing::OnionSkin { thickness: 7.0 },
            "onion skin of 7 mm is more than half of 12",
        ),
        (|_, m| m.fixing = Fixing::Tabs { count: 4, width: 8.0, height: 13.0 }, "tabs 13 mm high are higher"),
        (
            |_, m| m.fixing = Fixing::Tabs { count: 90, width: 8.0, height: 3.0 },
            "90 tabs do not fit: one 8 mm wide takes 14 mm",
        ),
        (|_, m| m.fixing = Fixing::Tabs { count: 1, width: 300.0, height: 3.0 }, "there is room for 0"),
        (
            |_, m| {
                let (low, high) = (DVec2::new(0.0, 220.0), DVec2::new(10.5, 250.0));
                m.clamps = vec![Clamp { low, high, height: 5.0 }];
            },
            "a tool would touch clamp 0",
        ),
        (|job, _| job.thickness = f64::NAN, "a thickness of NaN mm"),
        (|job, _| job.thickness = 0.5, "takes more than half of 0.5 mm"),
        (|job, _| job.thickness = 60.0, "60.500 mm deep, its flutes are 50.000 mm"),
        (|_, m| m.envelope.x = 200.0, "needs 281.480 mm of travel in x"),
        (|_, m| m.envelope.z = 30.0, "needs 32.500 mm of travel in z"),
        (|job, _| job.alias = String::new(), "the alias is empty"),
        (|job, _| job.alias = "shell ".to_owned(), "space at its end"),
        (|job, _| job.alias = "häuschen".to_owned(), "no character 'ä'"),
        (|job, _| job.engraving.height = f64::NAN, "engraving height NaN"),
        (|job, _| job.engraving.clearance = -1.0, "clearance -1 mm"),
        (|job, m| (m.engraver, job.engraving.height) = (1, 17.0), "text 17.000 mm high runs together"),
    ];
    for (spoil, words) in cases {
        let (mut job, mut spec) = (panel(), router());
        spoil(&mut job, &mut spec);
        let message = program(&job, &Machine::try_new(spec).unwrap()).unwrap_err().to_string();
        assert!(message.contains(words), "{message} does not say {words}");
    }
}

#[test]
fn a_clamp_over_the_corner_where_coordinates_begin_is_in_nobodys_way() {
    let mut spec = router();
    let clamp = |high| crate::fabricate::machine::Clamp { low: DVec2::ZERO, high, height: 10.0 };
    spec.clamps = vec![clamp(DVec2::new(5.0, 5.0))];
    assert!(program(&panel(), &Machine::try_new(spec.clone()).unwrap()).is_ok());
    spec.clamps = vec![clamp(DVec2::new(60.0, 60.0))];
    let refusal = program(&panel(), &Machine::try_new(spec).unwrap()).unwrap_err();
    assert!(matches!(refusal, Refusal::Clamped { clamp: 0, .. }), "{refusal}");
}

#[test]
fn a_contour_with_too_many_passes_is_refused() {
    let mut spec = router();
    spec.tools[0].max_step_down = 0.06;
    let refusal = program(&panel(), &Machine::try_new(spec).unwrap()).unwrap_err();
    assert_eq!(refusal, Refusal::TooManyPasses { passes: 209.0, sides: 4 });
}

#[test]
fn a_ramp_that_is_longer_than_the_edges_goes_around_corners() {
    let round: Vec<(f64, f64)> = (0..24)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 24.0)
        .map(|a| (40.0 * libm::cos(a), 40.0 * libm::sin(a)))
        .collect();
    let mut job = shaped(&round);
    job.engraving.least_height = 3.0;
    let made = program(&job, &machine()).unwrap();
    // Three passes of 4.167 mm, each ramp 41.7 mm long over edges of 10.4 mm: even heights between -4.167 and -8.333.
    let height = |s: &Step| match s {
        Step::Line { to, .. } | Step::Arc { to, .. } => Some(to.z),
        _ => None,
    };
    let heights: Vec<f64> = made.steps.iter().filter_map(height).collect();
    let ramp: Vec<f64> = heights.iter().copied().filter(|z| *z < -4.2 && *z > -8.3).collect();
    assert!(ramp.len() >= 6, "{ramp:?}");
    assert!(ramp.windows(2).all(|w| w[1] < w[0]));
}

#[test]
fn a_machine_with_one_tool_changes_it_once() {
    let mut spec = router();
    (spec.engraver, spec.tools[0].diameter) = (1, 2.0);
    let made = program(&panel(), &Machine::try_new(spec).unwrap()).unwrap();
    let count = |wanted: fn(&Step) -> bool| made.steps.iter().filter(|s| wanted(s)).count();
    assert_eq!(count(|s| matches!(s, Step::LoadTool { .. })), 1);
    assert_eq!(count(|s| matches!(s, Step::SpindleOn { .. })), 1);
    assert_eq!(count(|s| matches!(s, Step::SpindleOff)), 1);
}

#[test]
fn what_would_mend_a_refusal_has_its_figures() {
    let mut job = panel();
    job.thickness = 60.0;
    assert_eq!(
        refused(&job).remedy().unwrap(),
        "use a cutter with flutes of at least 60.5 mm, or a thinner board"
    );
    let mut spec = router();
    spec.fixing = crate::fabricate::machine::Fixing::Tabs { count: 90, width: 8.0, height: 3.0 };
    let refusal = program(&panel(), &Machine::try_new(spec).unwrap()).unwrap_err();
    let Refusal::TabsDoNotFit { fitting, .. } = refusal else { panic!("{refusal}") };
    assert!((20..89).contains(&fitting), "{fitting}");
    assert!(refusal.remedy().unwrap().contains(&format!("ask for {fitting} tabs or fewer")));
}

mod sheets {
    use super::*;
    use crate::fabricate::cut_job::{Placed, Rotation};

    fn board() -> CutJob {
        shaped(&[(0.0, 0.0), (200.0, 0.0), (180.0, 100.0), (10.0, 100.0)])
    }

    fn refusal(places: &[(f64, f64)]) -> PartRefusal {
        let job = board();
        let parts = places
            .iter()
            .map(|&low| Placed { job: &job, rotation: Rotation::None, low: DVec2::from(low) })
            .collect();
        let stock = DVec2::new(600.0, 400.0);
        sheet(&Sheet { name: "plywood.1".to_owned(), number: 1, stock, parts }, &machine()).unwrap_err()
    }

    #[test]
    fn parts_need_room_for_the_cutter() {
        let close = refusal(&[(20.0, 20.0), (20.0, 125.0)]);
        assert_eq!(close.part, 1);
        assert_eq!(close.refusal, Refusal::PartsTooClose { other: 0, gap: 5.0, needed: 6.0 });
        let over = refusal(&[(20.0, 20.0), (40.0, 50.0)]).refusal;
        assert_eq!(over, Refusal::PartsTooClose { other: 0, gap: 0.0, needed: 6.0 });
        let edge = refusal(&[(20.0, 20.0), (399.0, 20.0)]);
        assert_eq!(edge, PartRefusal { part: 1, refusal: Refusal::OutsideStock { room: 1.0, needed: 3.0 } });
        assert_eq!(refusal(&[]).refusal, Refusal::PartCount { count: 0 });
    }

    #[test]
    fn parts_of_a_sheet_are_of_one_thickness() {
        let (thick, thin) = (board(), CutJob { thickness: 9.0, ..board() });
        let at = |job, y| Placed { job, rotation: Rotation::Half, low: DVec2::new(20.0, y) };
        let parts = vec![at(&thick, 20.0), at(&thin, 200.0)];
        let stock = DVec2::new(600.0, 400.0);
        let refused = sheet(&Sheet { name: String::new(), number: 1, stock, parts }, &machine()).unwrap_err();
        assert_eq!(refused.to_string(), "part 1: is 9 mm thick, the first part of its sheet 12 mm");
    }
}
