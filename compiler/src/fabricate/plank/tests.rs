//! Planks add up to their curve, meet in equal and opposite mitres, and are closed solids of the right volume.

use std::f64::consts::FRAC_PI_8;

use proptest::prelude::*;

use super::*;

fn settings(ends: Ends) -> PlankSettings {
    let material = Material {
        name: "sawn_spruce".into(),
        thickness: None,
        density: Some(450e-9),
        least_bend_radius: None,
    };
    PlankSettings {
        material,
        depth: 120.0,
        width: 27.0,
        ends,
        gap: 0.0,
        stock: 4000.0,
        first: None,
        last: None,
    }
}

fn labels(count: usize) -> Vec<Label> {
    (0..count).map(|k| Label { address: format!("rib.{k}"), ..Label::default() }).collect()
}

fn make(points: &[DVec3], settings: &PlankSettings) -> Planks {
    planks(points, &labels(points.len() - 1), settings).unwrap()
}

/// Two segments of 600 in the xz plane, the second turned by 45 degrees.
fn knee() -> Vec<DVec3> {
    let diagonal = 600.0 * std::f64::consts::FRAC_1_SQRT_2;
    vec![DVec3::ZERO, DVec3::X * 600.0, DVec3::new(600.0 + diagonal, 0.0, diagonal)]
}

/// A square that goes round: four planks alike, each mitred at both ends, the seam a joint like the others.
#[test]
fn a_square_ring() {
    let corners = [(0.0, 0.0), (600.0, 0.0), (600.0, 600.0), (0.0, 600.0), (0.0, 0.0)];
    let points: Vec<DVec3> = corners.iter().map(|(x, z)| DVec3::new(*x, 0.0, *z)).collect();
    let made = closed_planks(&points, &labels(4), &settings(Ends::Mitred)).unwrap();
    assert_eq!((made.planks.len(), made.refused.len()), (4, 0));
    for (place, plank) in made.planks.iter().enumerate() {
        let mitres = plank.mitres.map(|mitre| (mitre.abs() - std::f64::consts::FRAC_PI_4).abs());
        assert!(mitres.iter().all(|off| *off < 1e-12), "{:?}", plank.mitres);
        assert!((plank.inner_length - 480.0).abs() < 1e-9 && (plank.outer_length - 720.0).abs() < 1e-9);
        let neighbours = [(place + 3) % 4, (place + 1) % 4].map(|other| Some(format!("rib.{other}")));
        assert_eq!(plank.neighbours, neighbours);
    }
    // Open, the same points have two square ends.
    let open = make(&points, &settings(Ends::Mitred));
    assert_eq!((open.planks[0].mitres[0], open.planks[3].mitres[1]), (0.0, 0.0));
}

#[test]
fn a_mitred_knee() {
    let made = make(&knee(), &settings(Ends::Mitred));
    let [first, second] = made.planks.as_slice() else { panic!("two planks") };
    let cut = 60.0 * libm::tan(FRAC_PI_8);
    for plank in [first, second] {
        assert!((plank.length - 600.0).abs() < 1e-9);
        assert!((plank.inner_length - (600.0 - cut)).abs() < 1e-9);
        assert!((plank.outer_length - (600.0 + cut)).abs() < 1e-9);
        assert!((plank.mass.unwrap() - 600.0 * 120.0 * 27.0 * 450e-9).abs() < 1e-9);
    }
    // The plane normal is +y; seen against it, z runs to the right of x, so the knee turns right.
    assert_eq!(first.plane_normal, DVec3::Y);
    assert!((first.mitres[1] + FRAC_PI_8).abs() < 1e-12 && first.mitres[0] == 0.0);
    assert!((second.mitres[0] - FRAC_PI_8).abs() < 1e-12 && second.mitres[1] == 0.0);
    assert_eq!(first.neighbours, [None, Some("rib.1".to_owned())]);
    assert_eq!(second.neighbours, [Some("rib.0".to_owned()), None]);
    // Their end faces lie flat against each other: the same four corners.
    let shared = first
        .solid
        .vertices
        .iter()
        .filter(|corner| second.solid.vertices.iter().any(|other| other.distance(**corner) < 1e-9));
    assert_eq!(shared.count(), 4);
}

#[test]
fn square_ends_and_gaps() {
    let made = make(&knee(), &settings(Ends::Square));
    assert!(made.planks.iter().all(|plank| plank.mitres == [0.0; 2] && plank.inner_length == plank.length));
    let gap = 10.0;
    let made = make(&knee(), &PlankSettings { gap, ..settings(Ends::Mitred) });
    let [first, second] = made.planks.as_slice() else { panic!("two planks") };
    assert!((first.length - (600.0 - 5.0 / libm::cos(FRAC_PI_8))).abs() < 1e-9);
    assert_eq!(first.axis[0], DVec3::ZERO);
    // Square to the end cuts, the joint is open by the gap.
    let bisector = DVec3::new(libm::cos(FRAC_PI_8), 0.0, libm::sin(FRAC_PI_8));
    assert!(((second.axis[0] - first.axis[1]).dot(bisector) - gap).abs() < 1e-9);
}

#[test]
fn what_cannot_be_a_plank() {
    let steep = [DVec3::ZERO, DVec3::X * 50.0, DVec3::new(-50.0, 0.0, 5.0)];
    let made = make(&steep, &settings(Ends::Mitred));
    let words = made.refused[0].reason.to_string();
    assert_eq!(words, "an end would be cut at 88.6deg from square, and 80deg is the most");
    let sharp = [DVec3::ZERO, DVec3::X * 50.0, DVec3::new(0.0, 0.0, 60.0)];
    let made = make(&sharp, &settings(Ends::Mitred));
    assert!(made.planks.is_empty());
    assert!(matches!(made.refused[0].reason, PlankRefusal::CutsCross { inner_length } if inner_length < 0.0));
    let back = [DVec3::ZERO, DVec3::X * 500.0, DVec3::ZERO];
    assert_eq!(make(&back, &settings(Ends::Mitred)).refused.len(), 2, "no bisector to cut along");
    let double = [DVec3::ZERO, DVec3::X * 500.0, DVec3::X * 500.0];
    let made = make(&double, &settings(Ends::Mitred));
    assert_eq!((made.planks.len(), made.refused[0].reason), (1, PlankRefusal::TooShort { length: 0.0 }));
    let made = make(&knee(), &PlankSettings { stock: 620.0, ..settings(Ends::Mitred) });
    assert_eq!(made.refused[1].reason.to_string(), "it takes 624.9mm of a bar of 620mm");
    assert_eq!(made.refused[1].label.address, "rib.1");
}

#[test]
fn curves_and_sections_that_make_no_sense() {
    let good = settings(Ends::Mitred);
    let error = |points: &[DVec3], count: usize, settings: &PlankSettings| {
        planks(points, &labels(count), settings).unwrap_err()
    };
    let bent = [DVec3::ZERO, DVec3::X * 500.0, DVec3::new(500.0, 500.0, 0.0), DVec3::ONE * 500.0];
    assert!(matches!(error(&bent, 3, &good), PlankError::NotPlanar { deviation } if deviation > 100.0));
    assert_eq!(error(&[DVec3::ZERO], 0, &good), PlankError::TooFewPoints);
    assert_eq!(error(&[], 0, &good), PlankError::TooFewPoints);
    assert_eq!(error(&[DVec3::ZERO, DVec3::NAN], 1, &good), PlankError::NotFinite { point: 1 });
    assert_eq!(error(&knee(), 1, &good), PlankError::WrongLabelCount { segments: 2, labels: 1 });
    let thin = PlankSettings { depth: 0.0, ..good };
    assert_eq!(error(&knee(), 2, &thin), PlankError::NoSection { what: "depth of the section", value: 0.0 });
}

#[test]
fn a_straight_beam_stands_upright() {
    let made = make(&[DVec3::ZERO, DVec3::X * 500.0, DVec3::X * 900.0], &settings(Ends::Mitred));
    assert_eq!(made.planks.len(), 2);
    let heights = made.planks[0].solid.vertices.iter().map(|corner| corner.z);
    assert_eq!(heights.fold(0.0, f64::max), 60.0, "the depth is upright");
    assert_eq!(make(&[DVec3::ZERO, DVec3::Z * 500.0], &settings(Ends::Mitred)).planks.len(), 1);
}

proptest! {
    #[test]
    fn planks_of_a_random_curve(
        turns in proptest::collection::vec(-0.7f64..0.7, 1..9),
        lengths in proptest::collection::vec(150.0f64..900.0, 10),
        normal in proptest::array::uniform3(-1.0f64..1.0),
        gap in 0.0f64..8.0,
    ) {
        let Some(normal) = DVec3::from(normal).try_normalize() else { return Ok(()) };
        let (u, v) = normal.any_orthonormal_pair();
        let (mut points, mut heading) = (vec![DVec3::splat(1000.0)], 0.0);
        for (step, length) in lengths.iter().take(turns.len() + 1).enumerate() {
            heading += if step == 0 { 0.0 } else { turns[step - 1] };
            let direction = u * libm::cos(heading) + v * libm::sin(heading);
            points.push(points[step] + direction * *length);
        }
        let made = make(&points, &settings(Ends::Mitred));
        prop_assert!(made.refused.is_empty());
        let total: f64 = made.planks.iter().map(|plank| plank.length).sum();
        prop_assert!((total - crate::geometry::polyline::length(&points)).abs() < 1e-9);
        for pair in made.planks.windows(2) {
            prop_assert_eq!(pair[0].mitres[1], -pair[1].mitres[0]);
        }
        for (plank, turn) in made.planks.iter().zip(&turns) {
            prop_assert!((plank.mitres[1].abs() - turn.abs() / 2.0).abs() < 1e-9);
        }
        let open = make(&points, &PlankSettings { gap, ..settings(Ends::Mitred) });
        for plank in made.planks.iter().chain(&open.planks) {
            prop_assert!(plank.solid.is_watertight());
            let volume = plank.length * plank.depth * plank.width;
            prop_assert!((plank.solid.volume() - volume).abs() < 1e-6 * volume);
            prop_assert!(plank.axis[0].distance(plank.axis[1]) - plank.length < 1e-9);
            let outline = plank.outline.as_slice();
            prop_assert!((outline[0].distance(outline[1]) - plank.inner_length).abs() < 1e-9
                || (outline[0].distance(outline[1]) - plank.outer_length).abs() < 1e-9);
            let (low, high) = crate::fabricate::fit::bounds(outline);
            prop_assert_eq!(low, DVec2::ZERO);
            prop_assert!((high.y - plank.depth).abs() < 1e-9);
        }
    }
}
