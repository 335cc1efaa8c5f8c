//! A whole build of a shell of many boards, planarized and nested: `ifs verify` reads every file again, the program of
//! every board among them, and 300 programs taken at random go before LinuxCNC's interpreter and shapely.
//! `WHOLE_BUILD_SIDE` is how many boards lie along a side: 100 in the acceptance run.
#![allow(clippy::disallowed_methods, reason = "the test starts programs and reads what they write")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;

use ifs_compiler::analysis::Elements;
use ifs_tests::designs::analysis_of;
use ifs_tests::outcome::run;
use ifs_tests::programs::expected_program;
use ifs_tests::referees::python_referee;
use ifs_tests::{program, scratch};
use serde_json::Value;

/// How many programs are run.
const RUN: usize = 300;

fn design(side: usize) -> String {
    format!(
        "use std.curves (bspline1)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\n\
         use std.machines (router3)\n\
         let net = [[(i * 500mm, j * 500mm, 120mm * sin(12deg * i) * cos(9deg * j)) for j in 0..{last}] for i in 0..{last}]\n\
         figure shell = sheet(bspline1, bspline1, net) at level 0\n\
         fabricate shell as panels {{\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n    \
         grain: u\n    planarize: {{ method: projection, threshold: 0.99999 }}\n    address: engraved(height: 18mm)\n    \
         machine: router3(tool: 6mm, feed: 4m/min, plunge: 1.2m/min, spindle: 18000rpm)\n    \
         nest: {{ gap: 8mm, margin: 16mm }}\n    require planarity >= 0.9999\n}}\n",
        last = side + 1
    )
}

#[test]
fn a_whole_build_is_read_again_and_run() {
    let side: usize = std::env::var("WHOLE_BUILD_SIDE").map_or(6, |side| side.parse().unwrap());
    let folder = scratch("whole-build");
    let (path, out) = (folder.join("shell.ifs"), folder.join("out"));
    fs::write(&path, design(side)).unwrap();
    let table = run(program().arg("build").arg(&path).arg("-o").arg(&out)).good();
    assert!(table.contains(&format!("{} boards", side * side)), "{table}");
    let verified = run(program().arg("verify").arg(&out)).good();
    println!("{verified}");

    let analysis = analysis_of(&design(side));
    let Elements::Panels(made) = &analysis.fabrications[0].elements else { panic!("boards") };
    assert_eq!(made.panels.len(), side * side);
    // Numbers of a linear congruential generator; a board that comes again is taken once.
    let mut number = 7_u64;
    let mut taken = std::collections::BTreeSet::new();
    while taken.len() < RUN.min(side * side) {
        number = number.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        taken.insert((number >> 33) as usize % made.panels.len());
    }
    let chosen = folder.join("chosen");
    fs::create_dir_all(&chosen).unwrap();
    let listed: Vec<Value> = taken
        .into_iter()
        .map(|place| {
            let panel = &made.panels[place];
            let file = format!("{}.nc", panel.label.address);
            fs::copy(out.join("boards").join(&file), chosen.join(&file)).unwrap();
            expected_program(&chosen, &panel.label.address, &panel.outline, panel.thickness)
        })
        .collect();
    let listing = folder.join("programs.json");
    fs::write(&listing, Value::from(listed).to_string()).unwrap();
    let verdict = python_referee("nc.py", &[&chosen, &listing]);
    println!("{}", verdict.counts);
    assert!(verdict.good, "{}", verdict.faults);
    fs::remove_dir_all(&out).unwrap();
}
