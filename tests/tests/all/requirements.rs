//! Requirements from their text to the report: what each says it measured, numpy and shapely measure again on what was
//! built; and what would mend those that fail.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referee reads")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::path::{Path, PathBuf};

use ifs_compiler::analysis::{Analysis, analyse};
use ifs_compiler::diagnostic::Code;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::MemoryFiles;
use ifs_tests::outcome::run;
use ifs_tests::referees::python_referee;
use ifs_tests::{program, scratch};
use serde_json::Value;

/// Every measure of panels, with limits that hold for any of the surfaces here.
const PANELS: &str = "
    require planarity >= 0.5
    require fold <= 60deg
    require diagonal ratio <= 90%
    require edge in 1mm .. 3m
    require length >= 1mm
    require width >= 1mm
    require area <= 9m2
    require angle in 1deg .. 179deg
    require bevel <= 89deg
    require bend radius >= 1mm
    require mass <= 99kg
    require count >= 1
";

/// Every measure of planks but `overlap`, which has no other referee than its own tests.
const PLANKS: &str = "
    require length >= 1mm
    require mitre <= 80deg
    require mass <= 99kg
    require count >= 1
";

/// A surface of boards: a point of its net, its level, its settings.
fn panels(point: &str, level: u32, settings: &str) -> String {
    format!(
        "use std.curves (bspline3)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\n\
         let net = [[{point} for j in 0..6] for i in 0..5]\n\
         figure roof = sheet(bspline3, bspline3, net) at level {level}\n\
         fabricate roof as panels {{\n material: birch_plywood(12mm)\n board: 5m by 5m\n {settings}\n{PANELS}}}\n"
    )
}

fn planks(figure: &str) -> String {
    let mut used = vec!["bezier3", "bspline2", "chain"];
    used.retain(|name| figure.contains(name));
    format!(
        "use std.curves ({})\nuse std.materials (sawn_spruce)\nfigure rib = {figure}\n\
         fabricate rib as planks {{\n material: sawn_spruce\n section: 60mm by 40mm\n{PLANKS}}}\n",
        used.join(", ")
    )
}

fn built(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(format!("{name}.ifs"));
    fs::write(&path, text).unwrap();
    let out = folder.join(name);
    run(program().arg("build").arg(&path).arg("-o").arg(&out)).good();
    out
}

#[test]
fn what_is_measured_numpy_and_shapely_measure_too() {
    let folder = scratch("requirements");
    let saddle = "(i * 0.5m + j * 60mm, j * 0.4m - i * 30mm, 0.12m * (i - 2) * (j - 3))";
    let dome = "(i * 0.5m, j * 0.7m, 0.08m * (i * (4 - i) + j * (5 - j)))";
    let rough =
        "(i * 0.5m + 40mm * sin(70deg * i * j), j * 0.5m + 30mm * cos(50deg * j * i), 0.1m * sin(90deg * i))";
    let designs = [
        ("saddle_u", panels(saddle, 1, "grain: u")),
        ("saddle_v", panels(saddle, 2, "grain: v")),
        ("dome_free", panels(dome, 1, "grain: free")),
        ("dome_flat", panels(dome, 1, "grain: u planarize: { iterations: 20, pin: none }")),
        ("rough", panels(rough, 2, "grain: free side: outer")),
        ("arch", planks("bezier3 on ((0m, 0m), (0m, 3m), (5m, 3m), (4m, 0m)) at level 3")),
        (
            "ring",
            planks("chain(bspline2, [(0m, 0m), (3m, 0m), (4m, 3m), (0m, 2m)], closed: true) at level 2"),
        ),
    ];
    for (name, text) in &designs {
        let out = built(&folder, name, text);
        let verdict = python_referee("figures.py", &[&out]);
        assert!(verdict.good, "{name}: {}", verdict.faults);
        let report: Value =
            serde_json::from_str(&fs::read_to_string(out.join("report.json")).unwrap()).unwrap();
        let asked = report["fabrications"][0]["requirements"].as_array().unwrap();
        assert_eq!(asked.len(), text.matches("require").count());
        // Another figure in the report is seen.
        for requirement in asked.iter().filter(|_| matches!(*name, "saddle_u" | "arch")) {
            let measure = requirement["measure"].as_str().unwrap();
            let mut other = report.clone();
            for found in other["fabrications"][0]["requirements"].as_array_mut().unwrap() {
                if found["measure"] == measure {
                    found["most"] = (found["most"].as_f64().unwrap() * 1.02 + 0.02).into();
                }
            }
            fs::write(out.join("report.json"), other.to_string()).unwrap();
            let verdict = python_referee("figures.py", &[&out]);
            let said = format!("require {measure} ");
            assert!(
                verdict.faults.contains(&said),
                "{name}: another {measure} was taken: {}",
                verdict.faults
            );
        }
    }
}

fn analysed(text: &str) -> Analysis {
    analyse(&MemoryFiles::default().with("design.ifs", text.as_bytes()), "design.ifs", &Overrides::default())
}

/// The hints of the diagnostic of a code.
fn hints(text: &str, code: Code) -> Vec<String> {
    let analysis = analysed(text);
    let said: Vec<String> = analysis.diagnostics.iter().map(|found| found.message.clone()).collect();
    let found = analysis.diagnostics.iter().find(|found| found.code == code);
    let found = found.unwrap_or_else(|| panic!("{} is not said: {said:?}", code.name()));
    found.hints.iter().map(|hint| hint.text.clone()).collect()
}

/// A roof of a plane net with `requirements`, and `params` before it.
fn roof(params: &str, point: &str, level: u32, settings: &str) -> String {
    format!(
        "use std.curves (bspline3)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\n{params}\n\
         let net = [[{point} for j in 0..5] for i in 0..5]\n\
         figure roof = sheet(bspline3, bspline3, net) at level {level}\n\
         fabricate roof as panels {{\n material: birch_plywood(12mm)\n {settings}\n}}\n"
    )
}

const PLATES: &str = "(i * 1m, j * 1m, 0m)";

#[test]
fn levels_between_which_a_range_lies_are_both_told() {
    let said = hints(&roof("", PLATES, 1, "board: 3m by 3m require edge in 300mm .. 400mm"), Code::E0811);
    assert!(said[0].contains("level 1 as it is now 500mm") && said[0].contains("level 2 250mm"), "{said:?}");
    assert!(said[0].starts_with("no level near this one does it"), "{said:?}");
}

#[test]
fn a_level_that_mends_one_and_breaks_another_says_so() {
    let both = "board: 3m by 3m require edge <= 300mm require count <= 20";
    let said = hints(&roof("", PLATES, 1, both), Code::E0811);
    assert_eq!(
        said[0],
        "it holds at level 2 (250mm), but then `require count <= 20` fails: 64; now it is level 1"
    );
    let free = "board: 3m by 3m require edge <= 300mm require count <= 64";
    assert_eq!(
        hints(&roof("", PLATES, 1, free), Code::E0811)[0],
        "it holds at level 2 (250mm); now it is level 1"
    );
}

#[test]
fn the_nearest_value_of_a_parameter_is_found_in_steps_and_by_halving() {
    let bay = "(i * bay, j * 1m, 0m)";
    let asked = "board: 3m by 3m require area <= 0.1m2";
    // 500mm by bay / 2 is 0.1m2 at a bay of 400mm.
    for (params, level) in [
        ("param bay: Length = 1m in 200mm .. 2m step 50mm", 1),
        ("param bay: Length = 1m in 100mm .. 2m step 0.01mm", 1),
    ] {
        let said = hints(&roof(params, bay, level, asked), Code::E0819);
        let found = said.iter().find(|hint| hint.contains("bay = ")).unwrap();
        assert_eq!(found, "it holds with bay = 400mm; now it is 1000mm");
    }
    let near = "param bay: Length = 1m in 500mm .. 2m";
    let said = hints(&roof(near, bay, 1, "board: 3m by 3m require area <= 0.1m2"), Code::E0819);
    assert!(said.iter().any(|hint| hint.contains("500mm, the best that was tried, gives")), "{said:?}");
    let loose =
        hints(&roof("param bay: Length = 1m", bay, 1, "board: 3m by 3m require mass >= 1000kg"), Code::E0832);
    assert!(loose.last().unwrap().contains("param bay: … = … in … .. …"), "{loose:?}");
}

#[test]
fn thickness_density_grain_and_stock_are_told_in_numbers() {
    // Boards of 1m by 1m by 12mm at 680kg/m3 weigh 8.16kg.
    let said = hints(&roof("", PLATES, 0, "board: 3m by 3m require mass <= 6kg"), Code::E0832);
    assert!(said.contains(&"thinner boards do: `birch_plywood(8.5mm)`".to_owned()), "{said:?}");
    assert!(said.iter().any(|hint| hint.starts_with("a material of 500kg/m3 is light enough")), "{said:?}");
    let none = hints(&roof("", PLATES, 0, "board: 3m by 3m require mass <= 1kg"), Code::E0832);
    assert!(
        none.iter().any(|hint| hint.starts_with("thinner boards are not enough: with 6.5mm")),
        "{none:?}"
    );
    let wide = "(i * 1m, j * 2m, 0m)";
    let said = hints(&roof("", wide, 0, "board: 2500mm by 1250mm grain: u"), Code::E0834);
    assert!(said.contains(&"with `grain: v` they fit the raw boards there are".to_owned()), "{said:?}");
    let large = "a raw board of 2500mm by 2000mm is large enough for all of them, its grain along the first of the two";
    assert!(said.contains(&large.to_owned()), "{said:?}");
    let mended = roof("", wide, 0, "board: 2500mm by 2000mm grain: u");
    assert!(!analysed(&mended).has_errors());
}

#[test]
fn boards_that_bend_too_far_are_told_how_thin_they_must_be() {
    let twisted = "(i * 0.4m, j * 0.4m, 0.04m * (i - 2) * (j - 2))";
    let asked = "board: 3m by 3m grain: u require bend radius >= material.min_bend_radius";
    let text = roof("", twisted, 1, asked);
    let said = hints(&text, Code::E0815);
    let thin =
        said.iter().find_map(|hint| hint.strip_prefix("thinner boards do: `")).unwrap().trim_end_matches('`');
    assert!(!analysed(&text.replace("birch_plywood(12mm)", thin)).has_errors(), "{thin}");
}

#[test]
fn thousands_of_boards_that_fail_much_are_told_all_of_it() {
    let point = "(i * bay, j * bay, rise * (i - 2) * (j - 2))";
    let params = "param rise: Length = 0.3m in 10mm .. 1m\nparam bay: Length = 1m in 0.5m .. 2m step 10mm";
    let asked = "board: 3m by 3m grain: u require planarity >= 0.99999 require edge in 60mm .. 100mm \
                 require count <= 1000 require area >= 0.02m2 require bend radius >= material.min_bend_radius";
    let text = roof(params, point, 5, asked);
    let analysis = analysed(&text);
    let codes: Vec<&str> = analysis.diagnostics.iter().map(|found| found.code.name()).collect();
    assert_eq!(codes, ["E0810", "E0811", "E0833", "E0819", "E0815"]);
    assert!(analysis.diagnostics.iter().all(|found| !found.hints.is_empty()));
    assert!(hints(&text, Code::E0833)[0].starts_with("it holds at level 3 (256 elements)"));
}
