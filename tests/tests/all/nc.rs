//! LinuxCNC's interpreter as referee of NC programs: it takes ours, and refuses what is wrong.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::path::Path;

use glam::{DVec2, DVec3};
use ifs_compiler::export::nc;
use ifs_compiler::fabricate::cut_job::{CutJob, Engraving};
use ifs_compiler::fabricate::machine::{
    CutDirection, Dialect, Machine, MachineSpec, Tool, WorkOffset, ZZero,
};
use ifs_compiler::fabricate::toolpath::program;
use ifs_compiler::readback::{Expected, read_back};
use ifs_tests::referees::{Verdict, python_referee};
use ifs_tests::scratch;
use serde_json::{Value, json};

const THICKNESS: f64 = 12.0;

fn tool(number: u32, diameter: f64) -> Tool {
    let (feed, plunge, spindle, max_step_down) = (60.0, 15.0, 300.0, 5.0);
    let name = format!("{diameter} mm");
    Tool { number, name, diameter, flute_length: 40.0, feed, plunge, spindle, max_step_down }
}

fn machine(z_zero: ZZero, direction: CutDirection) -> Machine {
    Machine::try_new(MachineSpec {
        name: "router".to_owned(),
        envelope: DVec3::new(2500.0, 1250.0, 150.0),
        safe_height: 15.0,
        z_zero,
        work_offset: WorkOffset::G54,
        stock_margin: 8.0,
        cut_through: 0.4,
        engrave_depth: 0.4,
        spindle_range: (100.0, 400.0),
        spin_up: 2.0,
        direction,
        dialect: Dialect::LinuxCnc,
        tools: vec![tool(1, 6.0), tool(2, 1.0)],
        cutter: 1,
        engraver: 2,
    })
    .unwrap()
}

/// A panel, a plank, a small board and a board with a gently curved side, bulging in and out.
fn outlines() -> Vec<Vec<DVec2>> {
    let wave = |i: i32| {
        let x = f64::from(i) * 12.0;
        DVec2::new(x, 150.0 + 10.0 * (x / 480.0) * (1.0 - x / 480.0) * (x / 240.0 - 1.0))
    };
    let mut bent = vec![DVec2::ZERO, DVec2::new(480.0, 0.0)];
    bent.extend((0..=40).rev().map(wave));
    let straight = |corners: [(f64, f64); 4]| corners.map(DVec2::from).to_vec();
    vec![
        straight([(0.0, 0.0), (250.0, 10.0), (240.0, 235.0), (-12.0, 228.0)]),
        straight([(0.0, 0.0), (1200.0, 0.0), (1150.0, 120.0), (80.0, 120.0)]),
        straight([(0.0, 0.0), (60.0, 0.0), (62.0, 55.0), (3.0, 58.0)]),
        bent,
    ]
}

fn job(outline: Vec<DVec2>, alias: String) -> CutJob {
    CutJob {
        address: format!("shell.{alias}"),
        alias,
        design: "shell (of a \u{1f332})".to_owned(),
        design_hash: "0123456789abcdef".repeat(4),
        outline,
        thickness: THICKNESS,
        engraving: Engraving { height: 18.0, least_height: 3.0, clearance: 3.0, mark_edge_0: true },
        face_up: "top".to_owned(),
        notes: vec!["edge 0 bevel 3.250 deg, not cut by this file".to_owned()],
    }
}

/// Writes every outline for both zeros and directions; what the referee is to expect of each.
fn written(folder: &Path) -> Value {
    let mut entries = Vec::new();
    for (z_zero, direction) in
        [(ZZero::TopOfStock, CutDirection::Climb), (ZZero::Table, CutDirection::Conventional)]
    {
        let machine = machine(z_zero, direction);
        for outline in outlines() {
            let job = job(outline, format!("b-{}", entries.len()));
            let made = program(&job, &machine).unwrap();
            let text = nc::write(&made, &machine);
            read_back(&text, &Expected::new(&job, &machine)).unwrap();
            let file = format!("{}.nc", job.alias);
            fs::write(folder.join(&file), text).unwrap();
            let corners: Vec<[f64; 2]> = made.placed_outline.iter().map(|p| [p.x, p.y]).collect();
            entries.push(json!({
                "file": file, "outline": corners, "tool_diameter": machine.cutter().diameter,
                "thickness": THICKNESS, "top": machine.top(THICKNESS),
            }));
        }
    }
    Value::Array(entries)
}

fn judged(folder: &Path, entries: &Value) -> Verdict {
    let listing = folder.join("expected.json");
    fs::write(&listing, entries.to_string()).unwrap();
    python_referee("nc.py", &[folder, &listing])
}

#[test]
fn linuxcnc_cuts_the_outlines_out_of_our_programs() {
    let folder = scratch("nc");
    let verdict = judged(&folder, &written(&folder));
    assert!(verdict.good, "{}", verdict.faults);
    assert_eq!(verdict.counts["programs"], 8);
    assert!(verdict.counts["worst"].as_f64().unwrap() < 0.01, "{}", verdict.counts);
}

#[test]
fn the_referee_refuses_what_is_wrong() {
    let folder = scratch("nc-wrong");
    let good = written(&folder);
    let text = fs::read_to_string(folder.join("b-0.nc")).unwrap();
    let end = "G0 Z15.000\nM5\nM2";
    let spoilt: [(&str, String, &str); 5] = [
        ("arc", text.replace(" J", " J1"), "b-0.nc: rs274 ends with 1"),
        (
            "gouge",
            text.replace(end, &format!("G1 X150.000 Y125.000 Z-5.000\n{end}")),
            "mm² out of the part above",
        ),
        ("shallow", text.replace("Z-12.400", "Z-11.900"), "b-0.nc: cuts to Z -11.9, not through 12"),
        ("tool", text.replace("diameter 6.000", "diameter 8.000"), "b-0.nc: nothing is cut with a tool of 6"),
        ("end", text.replace("M2\n", ""), "b-0.nc: rs274 "),
    ];
    for (what, wrong, fault) in spoilt {
        assert_ne!(wrong, text, "{what}");
        fs::write(folder.join("b-0.nc"), wrong).unwrap();
        let verdict = judged(&folder, &good);
        assert!(!verdict.good && verdict.faults.contains(fault), "{what}: {}", verdict.faults);
    }
    fs::write(folder.join("b-0.nc"), &text).unwrap();
    let mut other = good.clone();
    other[0]["outline"][2][0] = json!(good[0]["outline"][2][0].as_f64().unwrap() + 0.1);
    assert!(judged(&folder, &other).faults.contains("b-0.nc: the part is "));
    other = good.clone();
    other[0]["file"] = json!("b-9.nc");
    let unlisted = judged(&folder, &other);
    assert!(unlisted.faults.contains("b-0.nc: there and not listed"), "{}", unlisted.faults);
    assert!(unlisted.faults.contains("b-9.nc: listed and not there"), "{}", unlisted.faults);
    assert!(!judged(&folder, &json!([])).good);
}
