//! Texts with a cursor, and what is offered there.

mod declarations;
mod examples;
mod fabrication;
mod figures;

use super::*;
use crate::features::fixture::{fixture, with_files};

fn offers(text: &str) -> Vec<Offer> {
    let design = fixture(text);
    let paths = ["design.ifs", "parts/ribs.ifs", "joint.glb"].map(str::to_owned);
    completion(&design.analysis, design.analysis.root, design.at, &|| paths.to_vec())
        .map_or(Vec::new(), |found| found.offers)
}

fn labels(text: &str) -> Vec<String> {
    offers(text).into_iter().map(|offer| offer.label).collect()
}

/// The first labels are these.
#[track_caller]
fn first(text: &str, expected: &str) {
    let labels = labels(text);
    let count = expected.split(' ').filter(|word| !word.is_empty()).count();
    assert_eq!(labels.iter().take(count.max(1)).cloned().collect::<Vec<_>>().join(" "), expected, "{text}");
}

/// These are among the labels, and those are not.
#[track_caller]
fn has(text: &str, expected: &str, without: &str) {
    let labels = labels(text);
    for word in expected.split_whitespace() {
        assert!(labels.iter().any(|label| label == word), "no {word} in {labels:?}: {text}");
    }
    for word in without.split_whitespace() {
        assert!(!labels.iter().any(|label| label == word), "{word} in {labels:?}: {text}");
    }
}

#[test]
fn what_begins_an_item() {
    first("$0", "use param let fn ifs");
    first("let a = 2m\n$0", "use param let fn ifs");
    first("let a = 2m\nfi$0\nlet b = 3m", "use param let fn ifs");
    first("let a = 2m\n\npub $0", "use param");
    first("let $0", "");
    first("// a comment $0", "");
    first("/// docs $0\nlet a = 2", "");
    first("test \"a text $0\" {}", "");
}

#[test]
fn fields_of_an_element_before_its_number_is_declared() {
    has("let points = [(1m, 2m)]\nlet z = [points[k].$0", "x y", "");
    has("let points = [(1m, 2m)]\nlet z = [points[k].$0 for k in 0..1]", "x y", "");
}

#[test]
fn a_block_is_of_a_figure() {
    let text = "use std.curves (line)\nfn arch(i: Int) -> Curve = line on ((0m, 0m), (1m, 0m)) at level 1\nlet helper = arch(1)\nfigure rail = arch(2)\n";
    let offered = |text: &str| {
        let found = offers(text).into_iter().find(|offer| offer.label == "fabricate as planks");
        found.map_or(String::new(), |offer| offer.snippet)
    };
    assert!(offered(&format!("{text}fabr$0")).starts_with("fabricate ${1:rail} as"));
    let none = text.replace("figure rail", "let rail");
    assert!(offered(&format!("{none}fabr$0")).starts_with("fabricate ${1:figure} as"));
}

#[test]
fn names_in_scope_by_what_fits() {
    let head = "param span: Length = 6m\nlet turns = 4\nlet wide = true\nlet angle = 30deg\n";
    first(&format!("{head}let x: Length = $0"), "span");
    first(&format!("{head}let x: Angle = $0\nfigure y = z"), "angle");
    first(&format!("{head}let x: Bool = $0"), "false true wide");
    has(&format!("{head}let x = $0"), "span turns wide angle sin lerp bezier3 if for", "self use x");
    has(&format!("{head}let x = [1, $0]\nlet y = 3\n"), "span y", "x");
    has(&format!("{head}let x = sp$0"), "span", "use");
    has(&format!("{head}let x = 2 * s$0"), "span sin", "");
    let arch = "fn arch(i: Int, width: Length) -> Length = i * $0\nlet other = 1";
    has(arch, "i width arch", "");
    let ifs = "ifs curve(t: Number = 1/2) on (a, b) {\n    let m = lerp(a, b, t)\n    transform left = self on (a, $0\n    germ segment(a, b)\n}";
    has(ifs, "a b m t lerp", "");
    has("let xs = [i * 1m for i in 0..3 if $0]", "i true", "");
}

#[test]
fn names_of_the_library_bring_their_use() {
    let find = |text: &str, label: &str| offers(text).into_iter().find(|offer| offer.label == label).unwrap();
    let offer = find("//! A design.\n\nfigure f = bez$0", "bezier3");
    assert_eq!(offer.elsewhere.as_ref().unwrap().1, "use std.curves (bezier3)\n\n");
    assert_eq!(offer.elsewhere.unwrap().0.start, 15);
    assert_eq!(offer.module.as_deref(), Some("std.curves"));
    let offer = find("use std.curves (bezier2)\nfigure f = bez$0", "bezier3");
    assert_eq!(offer.elsewhere.unwrap().1, ", bezier3");
    let offer = find("use std.curves (bezier2)\nfigure f = bez$0", "bezier2");
    assert_eq!(offer.elsewhere, None);
    let offer = find("use std.curves (bezier2)\nfigure f = $0", "sheet");
    assert_eq!(offer.elsewhere.unwrap().1, "\nuse std.surfaces (sheet)");
    assert_eq!(offer.snippet, "sheet(${1:u}, ${2:v}, ${3:net})");
    assert!(library_item_docs("std.curves", "bezier3").unwrap().summary().starts_with("A cubic"));
}

#[test]
fn settings_that_are_not_given_yet() {
    let head = "use std.materials (birch_plywood)\nlet net = [[(i * 1m, j * 1m, 0m) for j in 0..3] for i in 0..3]\nuse std.surfaces (sheet)\nuse std.curves (bspline2)\nfigure shell = sheet(bspline2, bspline2, net) at level 1\n";
    first(&format!("{head}fabricate $0"), "shell");
    first(&format!("{head}fabricate shell $0"), "as");
    first(&format!("{head}fabricate shell as $0"), "panels planks");
    let block = format!("{head}fabricate shell as panels {{ $0");
    assert_eq!(labels(&block)[..3], ["material, board", "material", "board"]);
    let given = format!(
        "{head}fabricate shell as panels {{\n    material: birch_plywood(12mm)\n    $0\n    side: outer\n}}"
    );
    first(&given, "board grain edges planarize");
    has(&given, "require machine", "material side section");
    first(&format!("{head}fabricate shell as panels {{\n    side: $0\n}}"), "inner centred outer");
    first(
        &format!("{head}fabricate shell as panels {{\n    side: o$0\n    grain: u\n}}"),
        "inner centred outer",
    );
    first(&format!("{head}fabricate shell as panels {{\n    material: $0"), "birch_plywood");
    first(&format!("{head}fabricate shell as panels {{\n    planarize: {{ $0"), "method worst average");
    first(
        &format!("{head}fabricate shell as panels {{\n    planarize: {{ worst: 1, $0 }}\n}}"),
        "method average select",
    );
    first(
        &format!("{head}fabricate shell as panels {{\n    planarize: {{ method: $0 }}\n}}"),
        "perturbation projection",
    );
    first(&format!("{head}fabricate shell as planks {{\n    nest: {{ $0 }}\n}}"), "kerf trim");
    has(&format!("{head}fabricate shell as panels {{\n    machine: $0\n}}"), "router3", "sin");
    first(&format!("{head}fabricate shell as panels {{\n    require $0\n}}"), "planarity fold");
    has(&format!("{head}fabricate shell as planks {{\n    require $0\n}}"), "mitre overlap", "planarity");
    has(
        &format!(
            "{head}fabricate shell as panels {{\n    material: birch_plywood(12mm)\n    require bend radius >= material.$0\n}}"
        ),
        "",
        "",
    );
}

#[test]
fn fields_by_the_type_that_is_wanted() {
    let head = "record Bay {\n    offset: Length\n    crown: Length = 1m\n}\nfn wide(bay: Bay) -> Length = bay.offset\n";
    has(&format!("{head}let bay: Bay = {{ $0 }}\n"), "offset crown", "use");
    has(&format!("{head}let bay: Bay = {{ offset: 1m, $0 }}\n"), "crown", "offset");
    has(&format!("{head}let bay: Bay = {{ $0\nlet other = 1m\n"), "offset crown", "");
    has(&format!("{head}let all = [wide({{ $0 }})]\n"), "offset crown", "");
    first("let odd = { $0 }\n", "");
}

#[test]
fn units_behind_a_number() {
    first("let x = 12$0", "mm cm m in ft");
    first("let x = 12m$0", "mm cm m in ft");
    first("let x: Angle = 30$0", "deg rad");
    first("let x: Speed = 3$0", "mm/min m/min mm/s m/s");
    first("let x = sin(12d$0)", "deg rad");
    let design = fixture("let x = 1.5e2m$0m");
    let found = completion(&design.analysis, design.analysis.root, design.at, &Vec::new).unwrap();
    assert_eq!((found.span.start, found.span.end), (13, 15));
}

#[test]
fn arguments_by_name() {
    let head =
        "use std.machines (router3)\nfn arch(i: Int, width: Length, tall: Bool = true) -> Length = width\n";
    has(&format!("{head}let x = arch($0"), "i: width: tall:", "");
    has(&format!("{head}let x = arch(1, $0\n\nlet y = 2"), "width: tall:", "i:");
    first(&format!("{head}let x = arch(1, width: 3m, $0)"), "tall:");
    first(&format!("{head}let x = arch(1, tall: $0)"), "false true");
    has(&format!("{head}let x = arch(1, tall: true, $0)"), "width:", "i: tall:");
    has(&format!("{head}let x = router3($0)"), "tool: feed: spindle:", "");
    has("let x = rotate(30deg, $0)", "about:", "angle:");
    has("use std.curves (bezier3)\nfigure f = bezier3($0)", "t:", "");
    has("use std.surfaces (sheet)\nfigure f = sheet(a, b, c, closed: $0)", "u v uv", "sin");
}

#[test]
fn modules_and_what_they_offer() {
    first("use $0", "std.boards std.curves");
    has("use $0", "\"./parts/ribs.ifs\"", "\"./design.ifs\" prelude");
    has("use std.$0", "curves surfaces materials", "std.curves prelude");
    has("use std.c$0\nlet a = 1", "curves", "");
    has("use std.curves ($0)", "bezier3 bspline3 chain", "");
    has("use std.curves (bezier3, $0", "bspline3", "bezier3");
    has("use \"$0\"", "./parts/ribs.ifs", "./design.ifs");
    has("use \"./pa$0", "./parts/ribs.ifs", "");
    has("ifs a in space {\n    germ import(\"$0\")\n}", "./joint.glb", "");
    let text = "use \"./ribs.ifs\" ($0)";
    let design = with_files(text, &[("ribs.ifs", "pub let rib = 2m\nlet hidden = 3m")]);
    let found = completion(&design.analysis, design.analysis.root, design.at, &Vec::new).unwrap();
    assert_eq!(found.offers.iter().map(|offer| offer.label.as_str()).collect::<Vec<_>>(), ["rib"]);
}

#[test]
fn parts_behind_a_full_stop() {
    let head = "use std.materials (birch_plywood)\nlet board = birch_plywood(12mm)\nlet p = (1m, 2m, 3m)\n";
    first(&format!("{head}let x = board.$0"), "name thickness density min_bend_radius");
    first(&format!("{head}let x = board.min_bend_radius.$0\nlet y = 2"), "across along");
    first(&format!("{head}let x = birch_plywood(12mm).th$0"), "name thickness");
    first(&format!("{head}let x = [board].$0"), "name thickness");
    first(&format!("{head}let x = p.$0"), "x y z");
    first("let x = 12.$0", "");
    // Before the rest of brackets that are closed behind.
    let lists = "record Entry { a: Length }\nlet points = [(1m, 2m)]\nlet records = [Entry(a: 1m)]\n";
    for rest in ["for p in points]", "> 1m for p in points]", "* 2 for p in points if p.x > 1m]"] {
        first(&format!("{lists}let x = [p.$0 {rest}"), "x y");
        first(&format!("{lists}test \"t\" {{\n    assert all([p.$0 {rest})\n}}\n"), "x y");
    }
    first(&format!("{lists}let x = [e.$0 for e in records]"), "a");
    first(&format!("{lists}let x = [[e.$0] for e in records"), "a");
    let ifs = "ifs a in plane {\n    let p = (1m, 2m)\n    let q = (p.$0\n    germ segment(p, p)\n}";
    first(ifs, "x y");
    let figure =
        "use std.curves (bezier2)\nfigure f = bezier2 on ((0m, 0m), (1m, 1m), (2m, 0m)) at level 2\n";
    first(&format!("{figure}test \"t\" {{\n    assert f.$0\n}}"), "boards elements vertices");
    let planks = "use std.materials (sawn_spruce)\nfabricate f as planks {\n    material: sawn_spruce\n    section: 120mm by 40mm\n}\n";
    let every = "test \"t\" {\n    assert all([p.$0 > 1m for p in f.boards])\n}";
    first(&format!("{figure}{planks}{every}"), "address alias length");
}

#[test]
fn types_and_words_in_their_places() {
    has("param a: $0", "Length Angle Int", "sin use");
    has("record Part { width: $0 }\nrecord Other { a: Int }", "Length Other", "");
    has("fn f(a: Int) -> $0", "Curve Length", "");
    first("ifs a in space {\n    $0\n}", "transform let germ keep");
    first(
        "ifs a on (p, q) {\n    let m = lerp(p, q, 1/2)\n    $0\n    germ segment(p, q)\n}",
        "transform let germ keep",
    );
    first("ifs a on (p, q) {\n    germ $0\n}", "control limit");
    has("ifs a on (p, q) {\n    germ $0\n}", "segment polygon", "sin span");
    first("ifs a on (p, q) {\n    transform t = $0\n}", "self");
    first("ifs a $0", "in plane in space on");
    first("test \"t\" {\n    $0\n}", "assert let");
    has("figure f = a $0", "on until", "sin");
    has("figure f = a on (p, q) at $0", "level", "sin");
    first("figure f = a until $0", "edge length size");
    has("let xs = [i $0]", "for", "in sin");
    has("let x = if a $0", "then", "else");
    has("param a: Length = 2m $0", "in step", "on");
}

#[test]
fn all_that_is_needed_as_one_snippet() {
    let head = "use std.surfaces (sheet)\nuse std.curves (bspline2)\nlet net = [[(i * 1m, j * 1m, 0m) for j in 0..3] for i in 0..3]\nfigure shell = sheet(bspline2, bspline2, net) at level 1\n";
    let find = |text: &str, label: &str| {
        let found = offers(text);
        let labels: Vec<_> = found.iter().map(|offer| offer.label.clone()).collect();
        found.into_iter().find(|offer| offer.label == label).unwrap_or_else(|| panic!("{label}: {labels:?}"))
    };
    // What is written without places to fill in is a design that is right, with what it must import.
    let whole = |text: &str, label: &str| {
        let design = fixture(text);
        let found = completion(&design.analysis, design.analysis.root, design.at, &Vec::new).unwrap();
        let offer = found.offers.into_iter().find(|offer| offer.label == label).unwrap();
        let mut new = text.replacen("$0", "", 1);
        new.replace_range(found.span.range(), offer.plain.as_ref().unwrap());
        if let Some((span, import)) = &offer.elsewhere {
            new.replace_range(span.range(), import);
        }
        let made = fixture(&new).made();
        assert!(made.diagnostics.is_empty(), "{new}\n{:?}", made.diagnostics);
        new
    };
    let offer = find(&format!("{head}fabricate shell as panels {{\n    $0\n}}\n"), "material, board");
    assert_eq!(offer.snippet, "material: ${1:birch_plywood(12mm)}\nboard: ${2:2500mm} by ${3:1250mm}");
    assert_eq!(offer.elsewhere.unwrap().1, "\nuse std.materials (birch_plywood)");
    whole(&format!("{head}fabricate shell as panels {{\n    $0\n}}\n"), "material, board");
    whole(&format!("{head}fabricate shell as panels {{ $0 }}\n"), "material, board");
    whole(&format!("{head}fabricate shell as $0\n"), "panels");
    let new = whole(&format!("{head}$0\n"), "fabricate as panels");
    assert!(
        new.contains("fabricate shell as panels {\n    material: birch_plywood(12mm)\n    board: "),
        "{new}"
    );
    // A material of the design's own comes before those of the library.
    let own = format!("use std.materials (spruce_plywood)\nlet thin = spruce_plywood(12mm)\n{head}");
    let offer = find(&format!("{own}fabricate shell as panels {{\n    $0\n}}"), "material, board");
    assert_eq!((&offer.snippet[..20], offer.elsewhere), ("material: ${1:thin}\n", None));
    let arch =
        "use std.curves (bezier2)\nfigure arch = bezier2 on ((0m, 0m), (1m, 2m), (2m, 0m)) at level 2\n";
    let new = whole(&format!("{arch}fabricate arch as $0\n"), "planks");
    assert!(new.contains("as planks {\n    material: sawn_spruce\n    section: 120mm by 40mm\n"), "{new}");
    // Arguments and fields by name, where more than one is missing.
    let call = "fn arch(i: Int, width: Length, tall: Bool = true) -> Length = width * i\n";
    let new = whole(&format!("{call}let x = arch($0)\n"), "i: …, width: …");
    assert!(new.ends_with("arch(i: 1, width: 1m)\n"), "{new}");
    has(&format!("{call}let x = arch(1, $0)\n"), "width:", "width:…");
    assert!(offers(&format!("{call}let x = arch($0 2m)\n")).iter().all(|offer| offer.plain.is_none()));
    let record = "record Part { width: Length, tall: Length, name: Text = \"\" }\n";
    let used = "fn area(part: Part) = part.width * part.tall\n";
    whole(&format!("{record}{used}let x = area(part: {{ $0 }})\n"), "width: …, tall: …");
}

#[test]
fn of_thousands_the_best_that_go_on_with_what_is_written() {
    let names: String = (0..2000).map(|at| format!("let bay_{at} = {at}mm\n")).collect();
    let found = |written: &str| {
        let design = fixture(&format!("{names}let tall: Length = {written}$0"));
        completion(&design.analysis, design.analysis.root, design.at, &Vec::new).unwrap()
    };
    let all = found("");
    assert_eq!((all.offers.len(), all.complete), (MOST_OFFERS, false));
    let some = found("Y1987");
    assert!(!some.complete, "what is written next may be another word");
    assert_eq!(some.offers.iter().map(|offer| offer.label.as_str()).collect::<Vec<_>>(), ["bay_1987"]);
    assert!(completion_of_few().complete);
}

fn completion_of_few() -> Completion {
    let design = fixture("let wide = 3m\nlet tall: Length = $0");
    completion(&design.analysis, design.analysis.root, design.at, &Vec::new).unwrap()
}
