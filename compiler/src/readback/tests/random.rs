//! Random convex quads and slender planks on random machines read back good.

use super::*;
use proptest::prelude::*;

fn machines() -> impl Strategy<Value = MachineSpec> {
    let cutter = (2.0..12.0_f64, 1.0..8.0_f64, 10.0..100.0_f64, 2.0..30.0_f64);
    let stock = (0.0..20.0_f64, 0.0..1.0_f64, 5.0..40.0_f64);
    let fixing = prop_oneof![
        Just(Fixing::Held),
        (1..6_u32, 3.0..9.0_f64, 0.5..3.0_f64).prop_map(|(count, width, height)| Fixing::Tabs {
            count,
            width,
            height
        }),
        (0.1..1.5_f64).prop_map(|thickness| Fixing::OnionSkin { thickness }),
    ];
    let allowance = prop_oneof![Just(0.0), 0.05..1.0_f64];
    let ways = (any::<bool>(), any::<bool>(), 0..3_usize);
    (cutter, stock, 0.3..1.2_f64, ways, fixing, allowance).prop_map(
        |(cutter, stock, engraver, (table, climb, dialect), fixing, allowance)| {
            let mut spec = router();
            let tool = &mut spec.tools[0];
            (tool.diameter, tool.max_step_down, tool.feed, tool.plunge) = cutter;
            (spec.fixing, spec.allowance) = (fixing, allowance);
            spec.dialect = Dialect::ALL[dialect];
            spec.tools[1].diameter = engraver;
            (spec.stock_margin, spec.cut_through, spec.safe_height) = stock;
            spec.z_zero = if table { ZZero::Table } else { ZZero::TopOfStock };
            spec.direction = if climb { CutDirection::Climb } else { CutDirection::Conventional };
            spec
        },
    )
}

/// Four corners on the sides of a box, turned: always convex, with corners anywhere from sharp to nearly straight.
fn quads() -> impl Strategy<Value = Vec<(f64, f64)>> {
    let part = 0.2..0.8_f64;
    (100.0..400.0_f64, 100.0..400.0_f64, [part.clone(), part.clone(), part.clone(), part], 0.0..6.2_f64)
        .prop_map(|(w, h, t, angle)| {
            let corners = [(t[0] * w, 0.0), (w, t[1] * h), (t[2] * w, h), (0.0, t[3] * h)];
            let (s, c) = (libm::sin(angle), libm::cos(angle));
            corners.map(|(x, y)| (c * x - s * y, s * x + c * y)).to_vec()
        })
}

fn planks() -> impl Strategy<Value = Vec<(f64, f64)>> {
    (300.0..1400.0_f64, 60.0..160.0_f64, -60.0..60.0_f64, -60.0..60.0_f64)
        .prop_map(|(l, d, a, b)| vec![(0.0, 0.0), (l, 0.0), (l + a, d), (b, d)])
}

fn check(corners: &[(f64, f64)], spec: MachineSpec, thickness: f64, has_room: bool) {
    let mut job = shaped(corners);
    job.thickness = thickness;
    job.engraving.least_height = 4.0;
    let machine = Machine::try_new(spec.clone()).unwrap();
    match program(&job, &machine) {
        // A sharp diamond may have no room for the alias: that must be why.
        Err(refusal) => {
            use crate::fabricate::toolpath::Refusal;
            let tabs = matches!(refusal, Refusal::TabsDoNotFit { .. });
            assert!(!has_room || tabs, "{refusal}");
            assert!(tabs || matches!(refusal, Refusal::TextDoesNotFit { .. }), "{refusal}");
        }
        Ok(_) => {
            let read = good(&job, spec);
            assert!(read.parts[0].deviation < OUTLINE_TOLERANCE, "{}", read.parts[0].deviation);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn quads_read_back(corners in quads(), spec in machines(), thickness in 3.0..40.0_f64) {
        check(&corners, spec, thickness, false);
    }

    #[test]
    fn planks_read_back(corners in planks(), spec in machines(), thickness in 3.0..40.0_f64) {
        check(&corners, spec, thickness, true);
    }
}

#[test]
fn planks_and_large_quads_are_never_refused() {
    for corners in [
        [(0.0, 0.0), (400.0, 0.0), (390.0, 120.0), (20.0, 120.0)],
        [(0.0, 0.0), (250.0, 0.0), (250.0, 240.0), (0.0, 260.0)],
    ] {
        good(&shaped(&corners), router());
    }
}
