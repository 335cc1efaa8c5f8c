//! A machine to test with, and what `try_new` refuses.

use super::*;

/// A small router: a 6 mm cutter, a 1 mm engraver, Z zero on top of the stock.
pub(crate) fn router() -> MachineSpec {
    let cutter = Tool {
        number: 1,
        name: "spiral 6".to_owned(),
        diameter: 6.0,
        flute_length: 50.0,
        feed: 4000.0 / 60.0,
        plunge: 1200.0 / 60.0,
        spindle: 300.0,
        max_step_down: 5.0,
    };
    let engraver = Tool {
        number: 2,
        name: "engraver".to_owned(),
        diameter: 1.0,
        flute_length: 3.0,
        feed: 50.0,
        plunge: 10.0,
        spindle: 300.0,
        max_step_down: 1.0,
    };
    MachineSpec {
        name: "router3".to_owned(),
        envelope: DVec3::new(3000.0, 1500.0, 200.0),
        safe_height: 20.0,
        z_zero: ZZero::TopOfStock,
        work_offset: WorkOffset::G54,
        stock_margin: 10.0,
        cut_through: 0.5,
        engrave_depth: 0.4,
        spindle_range: (100.0, 400.0),
        spin_up: 3.0,
        direction: CutDirection::Climb,
        allowance: 0.0,
        fixing: Fixing::Held,
        clamps: Vec::new(),
        dialect: Dialect::LinuxCnc,
        tools: vec![cutter, engraver],
        cutter: 1,
        engraver: 2,
    }
}

#[test]
fn a_sound_machine_is_built_and_knows_its_heights() {
    let mut spec = router();
    let top = Machine::try_new(spec.clone()).unwrap();
    assert_eq!((top.top(12.0), top.safe_z(12.0), top.bottom(12.0)), (0.0, 20.0, -12.5));
    spec.z_zero = ZZero::Table;
    let table = Machine::try_new(spec).unwrap();
    assert_eq!((table.top(12.0), table.safe_z(12.0), table.bottom(12.0)), (12.0, 32.0, -0.5));
    assert_eq!((table.cutter().number, table.engraver().number), (1, 2));
}

#[test]
fn each_bad_figure_is_named() {
    type Spoil = fn(&mut MachineSpec);
    let cases: [(Spoil, &str); 12] = [
        (|m| m.envelope.y = f64::NAN, "width (along Y)"),
        (|m| m.safe_height = 0.0, "safe height"),
        (|m| m.stock_margin = -1.0, "stock margin"),
        (|m| m.cut_through = f64::INFINITY, "cut-through"),
        (|m| m.engrave_depth = 2.0, "engraving depth"),
        (|m| m.spindle_range = (400.0, 100.0), "greatest spindle speed"),
        (|m| m.spin_up = -1.0, "spin-up time"),
        (|m| m.tools[0].diameter = 0.0, "diameter of tool 1"),
        (|m| m.tools[0].spindle = 500.0, "spindle speed of tool 1"),
        (|m| m.tools[1].number = 1, "tool number 1 is given twice"),
        (|m| m.cutter = 7, "tool number 7 is not among"),
        (|m| m.tools.clear(), "tool number 1 is not among"),
    ];
    for (spoil, words) in cases {
        let mut spec = router();
        spoil(&mut spec);
        let message = Machine::try_new(spec).unwrap_err().to_string();
        assert!(message.contains(words), "{message} does not say {words}");
    }
}

#[test]
fn every_fault_is_told_in_the_units_that_people_write() {
    let mut spec = router();
    spec.tools[0].spindle = 200_000.0 / 60.0;
    spec.tools[0].feed = 700_000.0 / 60.0;
    spec.tools[1].diameter = 0.0;
    spec.spin_up = -1.5;
    let words = [
        "spin-up time is -1.5s, must be from 0s to 600s",
        "feed of tool 1 is 700m/min, must be from 0.0006m/min to 600m/min",
        "spindle speed of tool 1 is 200000rpm, must be from 6000rpm to 24000rpm",
        "diameter of tool 2 is 0mm, must be from 0.1mm to 200mm",
    ];
    assert_eq!(Machine::try_new(spec).unwrap_err().to_string(), words.join("; "));
}

#[test]
fn what_depends_on_a_wrong_figure_is_left_aside() {
    type Spoil = fn(&mut MachineSpec);
    let cases: [Spoil; 4] = [
        |m| m.spindle_range = (400.0, 100.0),
        |m| (m.tools[1].max_step_down, m.engrave_depth) = (0.01, 0.3),
        |m| (m.tools[0].diameter, m.allowance) = (0.0, 0.5),
        |m| {
            m.safe_height = 0.5;
            m.clamps = vec![Clamp { low: glam::DVec2::ZERO, high: glam::DVec2::splat(9.0), height: 10.0 }];
        },
    ];
    for spoil in cases {
        let mut spec = router();
        spoil(&mut spec);
        assert_eq!(spec.faults().len(), 1, "{:?}", spec.faults());
    }
}

#[test]
fn only_g54_to_g59_are_work_offsets() {
    assert_eq!(WorkOffset::from_code(54), Some(WorkOffset::G54));
    assert!(WorkOffset::from_code(59).is_some());
    assert!(WorkOffset::from_code(53).is_none() && WorkOffset::from_code(60).is_none());
}
