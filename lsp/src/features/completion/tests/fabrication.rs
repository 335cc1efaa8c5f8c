//! Blocks: what they can be made of, sizes and requirements.

use super::{first, has, labels, offers};

const ARCH: &str =
    "use std.curves (bezier2)\nfigure arch = bezier2 on ((0m, 0m), (1m, 2m), (2m, 0m)) at level 2\n";
const SHELL: &str = "use std.surfaces (sheet)\nlet net = [[(i * 1m, j * 1m, 0m) for j in 0..3] for i in 0..3]\nfigure shell = sheet(bezier2, bezier2, net) at level 1\n";
const MADE: &str = "fabricate arch as planks {\n    material: sawn_spruce\n    section: 120mm by 40mm\n}\n";

#[test]
fn a_figure_by_what_it_can_be_made_as() {
    let begun = |text: &str, label: &str| {
        let found = offers(text).into_iter().find(|offer| offer.label == label).unwrap().snippet;
        found.split_whitespace().nth(1).unwrap().to_owned()
    };
    let both = format!("{ARCH}{SHELL}$0");
    assert_eq!(begun(&both, "fabricate as panels"), "${1:shell}");
    assert_eq!(begun(&both, "fabricate as planks"), "${1:arch}");
    assert_eq!(begun(&format!("{ARCH}$0"), "fabricate as panels"), "${1:figure}");
    let row = "fn rib(i: Int) -> Curve = bezier2 on ((0m, 0m), (1m, 2m), (2m, 0m)) at level 2\nfigure row = [rib(i) for i in 0..3]\n";
    assert_eq!(begun(&format!("use std.curves (bezier2)\n{row}$0"), "fabricate as planks"), "${1:row}");
    first(&format!("{ARCH}fabricate arch as $0"), "planks panels");
    first(&format!("{ARCH}{SHELL}fabricate shell as $0"), "panels planks");
}

#[test]
fn a_figure_is_made_once() {
    let materials = "use std.materials (sawn_spruce)\n";
    assert_eq!(labels(&format!("{materials}{ARCH}{SHELL}{MADE}fabricate $0")), ["shell"]);
    let broken = "fabricate arch as planks {\n    section: \n}\n";
    assert_eq!(labels(&format!("{materials}{ARCH}{SHELL}{broken}fabricate $0")), ["shell"]);
    let again = MADE.replace("arch", "ar$0");
    has(&format!("{materials}{ARCH}{SHELL}{again}"), "arch shell", "");
}

#[test]
fn panels_are_cut_from_what_has_a_thickness() {
    let head = format!("use std.materials (sawn_spruce)\n{ARCH}{SHELL}let thin = birch_plywood(9mm)\n");
    let panels = labels(&format!(
        "use std.materials (birch_plywood)\n{head}fabricate shell as panels {{\n    material: $0\n}}"
    ));
    assert_eq!(panels[..3], ["thin", "birch_plywood", "beech_plywood"]);
    let place = |label: &str| panels.iter().position(|known| known == label);
    assert!(place("sawn_spruce") > place("Plywood") && place("Board").is_none(), "{panels:?}");
    first(&format!("{head}fabricate arch as planks {{\n    material: $0\n}}"), "thin sawn_spruce");
}

#[test]
fn sizes_are_two_lengths() {
    let section =
        |text: &str| format!("{ARCH}let wide = 3m\nfabricate arch as planks {{\n    section: {text}\n}}");
    let found = offers(&section("$0"));
    assert_eq!(found[0].snippet, "${1:120mm} by ${2:40mm}");
    assert_eq!(found[1].label, "wide");
    has(&section("$0"), "wide", "concat reverse transpose");
    assert_eq!(labels(&section("120mm $0")), ["by"]);
    assert_eq!(labels(&section("120mm by 40mm $0")), [""; 0]);
    first(&section("120mm by $0"), "wide");
    let board = format!("{SHELL}fabricate shell as panels {{\n    board: $0\n}}");
    assert_eq!(offers(&board)[0].snippet, "${1:2500mm} by ${2:1250mm}");
}

#[test]
fn a_measure_goes_on_with_its_words_and_its_limit() {
    let requires =
        |text: &str| labels(&format!("{SHELL}fabricate shell as panels {{\n    require {text}\n}}"));
    assert_eq!(requires("length $0"), ["in", "<=", ">="]);
    assert_eq!(requires("planarity $0"), [">=", "<=", "in"]);
    assert_eq!(requires("bend $0"), ["radius"]);
    assert_eq!(requires("bend radius $0")[0], ">=");
    assert_eq!(requires("diagonal ra$0"), ["ratio"]);
    assert_eq!(requires("length in 3m $0"), [".."]);
    assert_eq!(requires("length <= 3m $0"), [""; 0]);
    assert!(requires("bend radius >= $0").contains(&"material".to_owned()));
}
