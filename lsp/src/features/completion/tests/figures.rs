//! Members of an ifs: what it continues with, its boundaries and joins.

use super::{first, fixture, has, labels, offers};

/// An ifs that lives there with this member.
fn ifs(space: &str, member: &str) -> String {
    let germ = if space.starts_with("on") { "segment(p, q)" } else { "point((0m, 0m))" };
    format!("ifs around {space} {{\n    transform old = self on (p, q)\n    {member}\n    germ {germ}\n}}\n")
}

#[test]
fn an_ifs_continues_in_its_own_space() {
    let others = "ifs flat in plane {\n    transform a = scale(1/2) * self\n    germ point((0m, 0m))\n}\nifs deep in space {\n    transform a = scale(1/2) * self\n    germ point((0m, 0m, 0m))\n}\n";
    let found = |space: &str, member: &str| labels(&format!("{others}{}", ifs(space, member)));
    let plane = found("in plane", "transform l = $0");
    assert_eq!(plane[..3], ["self", "around", "flat"]);
    let among = |all: &[String], word: &str| all.iter().position(|label| label == word);
    assert!(among(&plane, "scale") < Some(9) && among(&plane, "rotate").is_some(), "{plane:?}");
    assert!(among(&plane, "turn").is_none() && among(&plane, "bezier3").is_none(), "{plane:?}");
    assert!(among(&plane, "deep") > among(&plane, "fern"), "{plane:?}");
    assert_eq!(found("in plane", "transform l = scale(0.5) * $0")[0], "self");
    let space = found("in space", "transform l[i in 0..3] = scale(0.5) * $0");
    assert_eq!(space[..3], ["self", "around", "deep"]);
    assert!(among(&space, "turn").is_some() && among(&space, "rotate").is_none(), "{space:?}");
    let points = found("on (p, q)", "transform l = $0");
    assert_eq!(points[..3], ["self", "around", "bezier"]);
    assert!(among(&points, "scale").is_none() && among(&points, "fern").is_none(), "{points:?}");
    let scale = |member: &str| {
        let all = offers(&ifs("in plane", member));
        all.into_iter().find(|offer| offer.label == "scale").unwrap().snippet
    };
    assert_eq!(scale("transform l = $0"), "scale(${1:kx}) * self");
    assert_eq!(scale("transform l = $0 * self"), "scale(${1:kx})");
}

#[test]
fn what_a_figure_is_made_of() {
    let curves = "use std.curves (bezier3)\nfn rib(i: Int) -> Curve = bezier3 on ((0m, 0m), (1m, 2m), (2m, 1m), (2m, 0m))\n";
    for text in ["figure f = $0", "figure f = $0 at level 3", "figure f = $0\n\nlet other = 2"] {
        first(&format!("{curves}{text}"), "rib bezier3");
        has(&format!("{curves}{text}"), "sheet fern", "Engraving sin true");
    }
    has(&format!("{curves}figure f = $0"), "for", "");
    has(&format!("{curves}figure f = rib($0)"), "i:", "fern");
}

#[test]
fn what_is_drawn_by_where_the_ifs_lives() {
    has("ifs a on (p, q) {\n    germ $0\n}", "limit control segment", "import");
    has("ifs a in plane {\n    germ $0\n}", "segment", "limit control import");
    has("ifs a in space {\n    germ $0\n}", "segment import", "limit control");
    assert_eq!(labels("ifs a in plane {\n    transform l = scale(2) $0\n}"), ["* self"]);
    assert_eq!(labels("ifs a in plane {\n    transform l = scale(2) * self $0\n}"), [""; 0]);
}

#[test]
fn members_are_right_where_the_ifs_lives() {
    for (space, germ) in [("in plane", "point((0m, 0m))"), ("in space", "point((0m, 0m, 0m))")] {
        let text =
            format!("ifs around {space} {{\n    $0\n    germ {germ}\n}}\nfigure f = around at level 2\n");
        let found = offers(&text);
        let transform = found.iter().find(|offer| offer.label == "transform").unwrap();
        let written = super::super::snippets::filled(&transform.snippet);
        let made = fixture(&text.replace("$0", &written)).made();
        assert!(made.diagnostics.is_empty(), "{written}: {:?}", made.diagnostics);
        has(&text, "join keep", "boundary");
    }
    has("ifs around on (p, q) {\n    $0\n}", "transform boundary join", "");
}

#[test]
fn a_boundary_is_an_ifs() {
    let hinge = "ifs hinge on (p) {\n    transform only = self on (p)\n    germ point(p)\n}\n";
    let text = format!("{hinge}{}", ifs("on (p, q)", "boundary e = $0"));
    first(&text, "self around hinge bezier");
    has(&text, "bezier3", "lerp fern scale");
    has(&ifs("on (p, q)", "boundary e = self $0"), "on", "until");
}

#[test]
fn joins_are_of_transforms_and_boundaries() {
    let hinge = "ifs hinge on (p) {\n    transform only = self on (p)\n    germ point(p)\n}\n";
    let members = "boundary first = hinge on (p)\n    boundary last = hinge on (q)\n    transform end[i in 0..3] = hinge on (p)\n    ";
    let found = |join: &str| offers(&format!("{hinge}{}", ifs("on (p, q)", &format!("{members}{join}"))));
    for join in ["join $0", "join old.last = $0", "join fi$0"] {
        let written: Vec<_> = found(join).into_iter().map(|offer| offer.snippet).collect();
        assert_eq!(written, ["old.${1|first,last|}", "end[${1:0}].${2|start,end|}", "first", "last"]);
    }
    let names = |join: &str| found(join).into_iter().map(|offer| offer.label).collect::<Vec<_>>();
    assert_eq!(names("join old.$0"), ["first", "last"]);
    assert_eq!(names("join old.last = end[0].$0"), ["end", "start"]);
    assert_eq!(names("join old.last = first.$0"), ["only"]);
    assert_eq!(names("join old.last $0"), ["="]);
    assert_eq!(names("join old.last = old.first $0"), [""; 0]);
}
