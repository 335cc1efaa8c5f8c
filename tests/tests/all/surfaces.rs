//! Surfaces and curves that go round, and surfaces that are planar by construction, from the text of a design to its
//! boards, its report and the table of a build.
#![allow(clippy::disallowed_methods, reason = "the tests write designs and read what is built")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::collections::BTreeSet;
use std::fs;

use ifs_tests::outcome::run;
use ifs_tests::referees::gltf_validator;
use ifs_tests::{program, scratch};
use serde_json::Value;

const DESIGN: &str = "
use std.curves (bezier2, bspline3, chain)
use std.surfaces (sheet, translation, revolution)
use std.materials (birch_plywood, sawn_spruce)

let ring = [[ ((3m + 1m * cos(60deg * j)) * cos(45deg * i), (3m + 1m * cos(60deg * j)) * sin(45deg * i), 1m * sin(60deg * j)) for j in 0..6 ] for i in 0..8]
figure torus = sheet(bspline3, bspline3, ring, closed: uv) at level 1

let rail    = bezier2 on ((0m, 0m, 0m), (2m, 0m, 1m), (4m, 0m, 0m)) at level 2
let profile = bezier2 on ((0m, 0m, 0m), (0m, 2m, 1m), (0m, 4m, 0m)) at level 3
figure flat = translation(rail, profile)
figure bare = translation(rail, profile) at level (1, 2)
figure dome = revolution(
    bezier2 on ((2m, 0m, 0m), weighted((2m, 0m, 2m), w: 2), (0.4m, 0m, 2m)) at level 2,
    point: (0m, 0m, 0m), direction: (0m, 0m, 1m), segments: 12,
)
figure hoop = chain(bspline3, [(3m * cos(60deg * i), 3m * sin(60deg * i)) for i in 0..6], closed: true) at level 1

fabricate torus as panels { material: birch_plywood(12mm)  board: 2500mm by 1250mm }
fabricate flat as panels { material: birch_plywood(12mm)  board: 2500mm by 1250mm  require planarity >= 0.9999999 }
fabricate dome as panels { material: birch_plywood(12mm)  board: 2500mm by 1250mm  planarize: { iterations: 3 } }
fabricate hoop as planks { material: sawn_spruce  section: 120mm by 27mm  require mitre in 14deg .. 16deg }
";

struct Built {
    table: String,
    report: Value,
    model: std::path::PathBuf,
}

fn built(test: &str) -> Built {
    let folder = scratch(test);
    let design = folder.join("round.ifs");
    fs::write(&design, DESIGN).unwrap();
    let out = folder.join("out");
    let outcome = run(program().arg("build").arg(&design).arg("-o").arg(&out));
    // One warning: the dome is to be planarized, and need not be.
    assert_eq!(outcome.code, Some(0), "{outcome:?}");
    assert!(outcome.stderr.contains("W0525") && outcome.stderr.ends_with("\n1 warning\n"), "{outcome:?}");
    let report = serde_json::from_str(&fs::read_to_string(out.join("report.json")).unwrap()).unwrap();
    Built { table: outcome.stdout, report, model: out.join("model.glb") }
}

fn fabrication<'a>(report: &'a Value, figure: &str) -> &'a Value {
    let made = report["fabrications"].as_array().unwrap();
    made.iter().find(|made| made["figure"] == figure).unwrap()
}

/// The neighbours of each part of a figure, as many as it has.
fn neighbours(report: &Value, figure: &str) -> Vec<(String, Vec<String>)> {
    let parts = fabrication(report, figure)["parts"].as_array().unwrap();
    parts
        .iter()
        .map(|part| {
            let near = part["neighbours"].as_array().unwrap().iter().filter_map(Value::as_str);
            (part["address"].as_str().unwrap().to_owned(), near.map(str::to_owned).collect())
        })
        .collect()
}

#[test]
fn boards_and_planks_have_neighbours_across_the_seam() {
    let Built { report, model, .. } = built("surfaces-seam");
    let torus = neighbours(&report, "torus");
    assert_eq!(torus.len(), 8 * 2 * 6 * 2);
    assert!(torus.iter().all(|(_, near)| near.iter().collect::<BTreeSet<_>>().len() == 4));
    let (first, near) = &torus[0];
    assert_eq!(first, "torus.0-0.left-left");
    assert!(near.contains(&"torus.7-0.right-left".to_owned()), "{near:?}");
    assert!(near.contains(&"torus.0-5.left-right".to_owned()), "{near:?}");
    let dome = neighbours(&report, "dome");
    assert_eq!(dome.len(), 12 * 4);
    assert_eq!(dome.iter().filter(|(_, near)| near.len() == 3).count(), 24, "only the two rims are open");
    let hoop = neighbours(&report, "hoop");
    assert_eq!(hoop.len(), 12);
    assert_eq!(
        hoop[0],
        ("hoop.0.left".to_owned(), vec!["hoop.5.right".to_owned(), "hoop.0.right".to_owned()])
    );
    assert!(hoop.iter().all(|(_, near)| near.len() == 2));
    let verdict = gltf_validator(&[&model]);
    assert!(verdict.good, "{}", verdict.faults);
}

#[test]
fn a_build_says_what_is_planar_by_construction() {
    let Built { table, report, .. } = built("surfaces-planar");
    let planar: Vec<(&str, bool, &str)> = report["figures"]
        .as_array()
        .unwrap()
        .iter()
        .map(|figure| {
            let planar = figure["planar_by_construction"].as_bool().unwrap();
            (figure["name"].as_str().unwrap(), planar, figure["level"].as_str().unwrap())
        })
        .collect();
    let expected = [
        ("torus", false, "1"),
        ("flat", true, "(2, 3)"),
        ("bare", true, "(1, 2)"),
        ("dome", true, "2"),
        ("hoop", false, "1"),
    ];
    assert_eq!(planar, expected);
    assert!(table.contains("bare            8 elements, planar by construction\n"), "{table}");
    assert_eq!(table.matches(", planar by construction").count(), 3, "{table}");
    for figure in ["flat", "dome"] {
        let planarity = &fabrication(&report, figure)["planarity"];
        assert!(planarity["planarize"].is_null(), "{figure} is not planarized");
        assert_eq!(planarity["moved"]["count"], 0);
        assert!(planarity["before"]["largest_diagonal_ratio"]["value"].as_f64().unwrap() < 1e-9);
        assert!(planarity["before"]["worst_planarity"]["value"].as_f64().unwrap() > 1.0 - 1e-9);
    }
}
