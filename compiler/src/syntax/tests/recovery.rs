//! What is kept of a text around its mistakes.

use super::{parsed, printer};
use crate::syntax::ast::*;

fn items(text: &str) -> Vec<Item> {
    let parse = parsed(text);
    assert!(!parse.diagnostics.is_empty(), "{text}");
    parse.ast.items
}

/// The value of the first `let`.
fn value(text: &str) -> String {
    match &items(&format!("let a = {text}"))[0].kind {
        ItemKind::Let(it) => printer::expr(&it.value),
        other => panic!("{text}: {other:?}"),
    }
}

#[test]
fn inside_brackets_only_the_wrong_element_is_lost() {
    for (text, tree) in [
        ("f(1 2, 3)", "f<1, 3>"),
        ("f(1, *, 3)", "f<1, ERROR, 3>"),
        ("f(a, b: , c: 3)", "f<a, ERROR, c: 3>"),
        ("[1, (2 +), 3]", "[1, group<2>, 3]"),
        ("[f(x y) for i in 0..3]", "[f<x> for i in (0 .. 3)]"),
        ("{ a: 1, b 2, c: 3 }", "{a: 1, ERROR, c: 3}"),
        ("{ a: 1 b: * c: 3 }", "{a: 1, b: ERROR, c: 3}"),
        ("f(a) 3", "f<a>"),
        ("3foo + 4", "(ERROR + 4)"),
        ("a on (p, *, q) at level 2", "((a on {p, ERROR, q}) at 2)"),
    ] {
        assert_eq!(value(text), tree, "{text}");
    }
}

#[test]
fn inside_an_ifs_only_the_wrong_member_is_lost() {
    let text = "ifs a on (p, q) {\n let m = \n transform l = self on (p m)\n transfrom r = 3\n transform s = )\n germ segment(p q)\n keep }";
    let ItemKind::Ifs(it) = &items(text)[0].kind else { panic!() };
    let members: Vec<String> = it.members.iter().map(printer::member).collect();
    assert_eq!(
        members,
        [
            "let m = ERROR",
            "transform l = (self on {p})",
            "transform s = ERROR",
            "germ segment<p>",
            "keep ERROR",
        ]
    );
}

#[test]
fn inside_a_fabricate_block_only_the_wrong_line_is_lost() {
    let text = "fabricate a as planks {\n x: 1\n y 2\n z: *\n require edge 3\n require mitre <= 3deg\n w: 4 5\n v: 6\n}";
    let ItemKind::Fabricate(it) = &items(text)[0].kind else { panic!() };
    let entries: Vec<String> = it.entries.iter().map(printer::entry).collect();
    assert_eq!(entries, ["x: 1", "z: ERROR", "ERROR", "require mitre <= 3deg", "w: 4", "v: 6"]);
}

#[test]
fn names_stay_where_their_values_are_wrong() {
    let text = "let a = *\nfn f(x, y: Int) -> Int = )\nparam p: = 3\nparam q: Int\nfigure g = at\nrecord R { a, b: Int }\nlet h = 3";
    let found = items(text);
    assert_eq!(found.len(), 7);
    assert!(found.iter().all(|item| item.kind != ItemKind::Error), "{found:#?}");
    let ItemKind::Function(it) = &found[1].kind else { panic!() };
    assert_eq!(it.parameters.iter().map(printer::field).collect::<Vec<_>>(), ["x: ERROR", "y: Int"]);
    let ItemKind::Param(it) = &found[2].kind else { panic!() };
    assert_eq!((printer::ty(&it.ty), printer::expr(&it.default)), ("ERROR".into(), "3".into()));
}

#[test]
fn a_missing_brace_does_not_swallow_the_next_item() {
    for text in [
        "ifs a on (p) {\n    germ p\n\nfigure b = a",
        "ifs a on (p) {\n    germ p\n\nlet b = a",
        "ifs a on (p) { germ p\n\n/// Doc.\npub fn b() = a",
        "ifs a on (p) { germ f(p, [q, {x: 1\nrecord B { x: Int }",
        "fabricate a as b {\n    c: { d: 1,\n    e: f(\nlet b = 3",
        "test \"a\" {\n    let c = 3\n    assert c == f(\ntest \"b\" { }",
        "let a = [1, 2, (3,\nlet b = 4",
        "let a = [1, 2, (3, let b = 4",
    ] {
        let found = items(text);
        assert_eq!(found.len(), 2, "{text}: {found:#?}");
        assert!(found.iter().all(|item| item.kind != ItemKind::Error), "{text}");
    }
}

#[test]
fn what_stands_before_the_first_item_is_one_error() {
    let found = items("hello there ( general\nlet a = 3");
    assert_eq!(found.len(), 2);
    assert_eq!(found[0].kind, ItemKind::Error);
}
