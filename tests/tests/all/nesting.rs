//! Nested sheets as they are written, judged by shapely; it also sees a board that was moved.
#![allow(clippy::disallowed_methods, reason = "the tests read and write files")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::path::{Path, PathBuf};

use ifs_tests::designs::example_path;
use ifs_tests::outcome::run;
use ifs_tests::referees::python_referee;
use ifs_tests::{program, scratch};

/// A rough surface: no two boards are alike, and the grain is free.
const ROUGH: &str = "
use std.curves (bspline3)
use std.surfaces (sheet)
use std.materials (birch_plywood)

let net = [[(i * 1m + 0.2m * sin(90deg * j), j * 0.8m * (1 + j / 10), 0.2m * sin(70deg * i * j)) for j in 0..7] for i in 0..7]
figure rough = sheet(bspline3, bspline3, net) at level 2

fabricate rough as panels {
    material: birch_plywood(12mm)
    board: 1500mm by 1000mm
    nest: { gap: 5mm, margin: 12mm }
}
";

fn built(design: &Path, out: PathBuf) -> PathBuf {
    run(program().arg("build").arg(design).args(["--emit", "csv,svg,json", "-o"]).arg(&out)).good();
    out
}

#[test]
fn shapely_finds_every_board_in_its_place() {
    let folder = scratch("nesting-good");
    let rough = folder.join("rough.ifs");
    fs::write(&rough, ROUGH).unwrap();
    for (design, name) in [(example_path("shell"), "shell"), (rough, "rough")] {
        let out = built(&design, folder.join(name));
        let verdict = python_referee("nest.py", &[&out]);
        assert!(verdict.good, "{name}: {}", verdict.faults);
        assert_eq!(verdict.counts["boards"], 256, "{name}");
    }
}

#[test]
fn shapely_sees_a_board_that_was_moved() {
    let folder = scratch("nesting-bad");
    let out = built(&example_path("shell"), folder.join("out"));
    let path = out.join("sheets/1.svg");
    let text = fs::read_to_string(&path).unwrap();
    let (before, rest) = text.split_once("points=\"").unwrap();
    let (points, after) = rest.split_once('"').unwrap();
    let moved: Vec<String> = points
        .split(' ')
        .map(|pair| {
            let (x, y) = pair.split_once(',').unwrap();
            format!("{:.3},{y}", x.parse::<f64>().unwrap() + 5.0)
        })
        .collect();
    fs::write(&path, format!("{before}points=\"{}\"{after}", moved.join(" "))).unwrap();
    let verdict = python_referee("nest.py", &[&out]);
    assert!(!verdict.good && verdict.faults.contains("1: part"), "{}", verdict.faults);
}
