//! Which tree a text has.

use super::{parsed, printer};
use crate::syntax::ast::*;

/// The value of `let a = …`, without diagnostics.
fn value(text: &str) -> String {
    let parse = parsed(&format!("let a = {text}"));
    assert_eq!(parse.diagnostics, vec![], "{text}");
    match &parse.ast.items[..] {
        [Item { kind: ItemKind::Let(it), .. }] => printer::expr(&it.value),
        other => panic!("{text}: {other:?}"),
    }
}

/// The only item of a text, without diagnostics.
fn only(text: &str) -> Item {
    let parse = parsed(text);
    assert_eq!(parse.diagnostics, vec![], "{text}");
    assert_eq!(parse.ast.items.len(), 1, "{text}");
    parse.ast.items.into_iter().next().unwrap()
}

#[test]
fn precedence() {
    for (text, tree) in [
        ("a + b * c", "(a + (b * c))"),
        ("a - b - c", "((a - b) - c)"),
        ("a * b / c", "((a * b) / c)"),
        ("-a * b", "((-a) * b)"),
        ("a * -b", "(a * (-b))"),
        ("- -a.b", "(-(-a.b))"),
        ("a + b by c * d", "((a + b) by (c * d))"),
        ("0 .. n + 1", "(0 .. (n + 1))"),
        ("a < b + c", "(a < (b + c))"),
        ("a == b and c != d or e", "(((a == b) and (c != d)) or e)"),
        ("not a == b and c", "((not (a == b)) and c)"),
        ("a and not not b", "(a and (not (not b)))"),
        ("if a then b else c + d", "(if a b (c + d))"),
        ("1 + if a then b else c on (p) at level 2", "(1 + (if a b ((c on {p}) at 2)))"),
        ("if a then b else if c then d else e", "(if a b (if c d e))"),
    ] {
        assert_eq!(value(text), tree, "{text}");
    }
}

#[test]
fn placements_and_levels_are_looser_than_operators() {
    for (text, tree) in [
        ("f(t: s) on (p, q) at level 4", "((f<t: s> on {p, q}) at 4)"),
        ("translate(0m, 1m) * scale(0.85) * self", "((translate<0m, 1m> * scale<0.85>) * self)"),
        ("a on (p)", "(a on {p})"),
        ("a on (p,)", "(a on {p})"),
        ("a on ()", "(a on {})"),
        ("a on net", "(a on net)"),
        ("a on net[0..4, 0..4] at level (4, 3)", "((a on net[(0 .. 4), (0 .. 4)]) at 4 x 3)"),
        ("a on [p, q]", "(a on [p, q])"),
        ("a on b + c at level n * 2", "((a on (b + c)) at (n * 2))"),
        ("a at level (4)", "(a at group<4>)"),
        ("a until edge <= 600mm", "(a until edge <= 600mm)"),
        ("a on (p) each until bend radius in 1m .. 2m", "((a on {p}) each until bend radius in (1m .. 2m))"),
        ("[f(i) on (p) at level 2 for i in 0..5]", "[((f<i> on {p}) at 2) for i in (0 .. 5)]"),
        ("f(a on (p), b: c at level 1)", "f<(a on {p}), b: (c at 1)>"),
        ("[a on (p), b until edge <= 1m]", "[(a on {p}), (b until edge <= 1m)]"),
    ] {
        assert_eq!(value(text), tree, "{text}");
    }
}

#[test]
fn brackets_of_every_kind() {
    for (text, tree) in [
        ("(a)", "group<a>"),
        ("(a,)", "group<a>"),
        ("(1m, 2m, 3m)", "tuple<1m, 2m, 3m>"),
        ("[]", "[]"),
        ("[a, b,]", "[a, b]"),
        (
            "[[i * j for j in 0..7] for i in 0..7 if i != 3 for k in l]",
            "[[(i * j) for j in (0 .. 7)] for i in (0 .. 7) if (i != 3) for k in l]",
        ),
        ("{ worst: 1, average: 2 select: 0.9, }", "{worst: 1, average: 2, select: 0.9}"),
        ("{}", "{}"),
        ("f()", "f<>"),
        ("f(a)(b)[c].d", "f<a><b>[c].d"),
        ("grid[a..b, c..d]", "grid[(a .. b), (c .. d)]"),
        ("min(shell.boards.planarity)", "min<shell.boards.planarity>"),
        ("import(\"a\\\"b\\n\")", "import<\"a\\\"b\\n\">"),
    ] {
        assert_eq!(value(text), tree, "{text}");
    }
}

#[test]
fn words_mean_something_only_in_their_place() {
    for word in [
        "by",
        "as",
        "step",
        "level",
        "until",
        "each",
        "join",
        "boundary",
        "start",
        "end",
        "board",
        "edge",
        "and",
        "or",
        "assert",
        "require",
        "transform",
        "germ",
        "keep",
        "plane",
        "space",
        "x",
        "not",
    ] {
        assert_eq!(value(word), word);
        assert_eq!(value(&format!("f({word}: {word})")), format!("f<{word}: {word}>"));
        assert_eq!(
            value(&format!("{{ {word}: 1 {word}: {word} }}")),
            format!("{{{word}: 1, {word}: {word}}}")
        );
        assert_eq!(value(&format!("a.{word}")), format!("a.{word}"));
        let ItemKind::Let(it) = only(&format!("let {word} = 3")).kind else { panic!() };
        assert_eq!(it.name.text, word);
        let ItemKind::Record(it) = only(&format!("record A {{ {word}: Int {word}: Int = {word} }}")).kind
        else {
            panic!()
        };
        assert_eq!(it.fields.len(), 2);
    }
    assert_eq!(value("{ step: 0.01mm, pin: boundary }"), "{step: 0.01mm, pin: boundary}");
    assert_eq!(value("level + edge * by by end"), "((level + (edge * by)) by end)");
    assert_eq!(value("a at level level"), "(a at level)");
}

#[test]
fn lists_of_control_points() {
    let ItemKind::Ifs(it) = only("ifs a on (p[n + 1], q) { germ segment(q, q) }").kind else { panic!() };
    let Space::On(points, _) = &it.space else { panic!() };
    let counts: Vec<Option<String>> = points.iter().map(|p| p.count.as_ref().map(printer::expr)).collect();
    assert_eq!(counts, [Some("(n + 1)".to_owned()), None]);
}

#[test]
fn an_ifs_and_its_members() {
    let text = "pub ifs a(t: Number = 1/2, n: Int) on (p0, p1) { let m = t transform x[i in 0..3] = self on (p0, m) \
        transform y = b(t) * self germ segment(p0, p1) keep strut(p0) boundary start = e on (p0) join x.end = y.start \
        join start = y }";
    let item = only(text);
    assert!(item.public.is_some());
    let ItemKind::Ifs(it) = item.kind else { panic!() };
    let parameters: Vec<String> = it.parameters.iter().map(printer::field).collect();
    assert_eq!(parameters, ["t: Number = (1 / 2)", "n: Int"]);
    assert!(
        matches!(&it.space, Space::On(points, span) if points.len() == 2 && &text[span.range()] == "(p0, p1)")
    );
    let members: Vec<String> = it.members.iter().map(printer::member).collect();
    assert_eq!(
        members,
        [
            "let m = t",
            "transform x[i in (0 .. 3)] = (self on {p0, m})",
            "transform y = (b<t> * self)",
            "germ segment<p0, p1>",
            "keep strut<p0>",
            "boundary start = (e on {p0})",
            "join x.end = y.start",
            "join start = y",
        ]
    );
    assert!(matches!(only("ifs a in plane { }").kind, ItemKind::Ifs(Ifs { space: Space::Plane(_), .. })));
    assert!(matches!(only("ifs a in space { }").kind, ItemKind::Ifs(Ifs { space: Space::Space(_), .. })));
}

#[test]
fn a_fabricate_block() {
    let text = "fabricate a as panels { board: 2m by 1m side: centred, require: 3 require edge in 1m .. 2m \
        require bend radius >= material.min require count == 3, planarize: { step: 1mm } }";
    let ItemKind::Fabricate(it) = only(text).kind else { panic!() };
    assert_eq!((it.figure.text.as_str(), it.kind.text.as_str()), ("a", "panels"));
    let entries: Vec<String> = it.entries.iter().map(printer::entry).collect();
    assert_eq!(
        entries,
        [
            "board: (2m by 1m)",
            "side: centred",
            "require: 3",
            "require edge in (1m .. 2m)",
            "require bend radius >= material.min",
            "require count == 3",
            "planarize: {step: 1mm}",
        ]
    );
}

#[test]
fn the_other_items() {
    let ItemKind::Param(it) = only("param a: Length = 6m in 4m .. 9m step 100mm").kind else { panic!() };
    assert_eq!(printer::expr(&it.range.unwrap().to), "9m");
    assert_eq!(printer::expr(&it.step.unwrap()), "100mm");
    let ItemKind::Param(it) = only("param a: Length = 6m").kind else { panic!() };
    assert!(it.range.is_none() && it.step.is_none());
    let ItemKind::Function(it) = only("fn f(a: [[Point]], b: Int = 2) -> [Curve] = a").kind else { panic!() };
    assert_eq!(printer::ty(&it.result.unwrap()), "[Curve]");
    assert_eq!(it.parameters.iter().map(printer::field).collect::<Vec<_>>(), ["a: [[Point]]", "b: Int = 2"]);
    let ItemKind::Use(it) = only("use std.curves (bezier3, Plywood,)").kind else { panic!() };
    assert!(matches!(&it.module, ModulePath::Library(names) if names.len() == 2));
    assert_eq!(it.names.len(), 2);
    let ItemKind::Use(it) = only("use \"./ribs.ifs\" (rib)").kind else { panic!() };
    assert!(matches!(&it.module, ModulePath::File(text) if text.value == "./ribs.ifs"));
    let ItemKind::Figure(it) = only("figure a: [Curve] = b").kind else { panic!() };
    assert_eq!(printer::ty(&it.ty.unwrap()), "[Curve]");
    let ItemKind::Test(it) = only("test \"x\" { let n = 3 assert n == 3 assert not n }").kind else {
        panic!()
    };
    assert_eq!((it.name.value.as_str(), it.steps.len()), ("x", 3));
}

#[test]
fn docs_belong_to_what_follows() {
    let parse = parsed(
        "//! The file.\n//!second\n/// An ifs.\n///  Indented.\npub ifs a(\n/// T.\nt: Int) on (p) {\n/// Left.\ntransform l = p\n}\n\
         //// no doc\n/// R.\nrecord R { /// F.\n f: Int }\n/// lost",
    );
    assert_eq!(parse.diagnostics, vec![]);
    assert_eq!(parse.ast.docs, ["The file.", "second"]);
    let [ifs, record] = &parse.ast.items[..] else { panic!() };
    assert_eq!(ifs.docs, ["An ifs.", " Indented."]);
    let ItemKind::Ifs(it) = &ifs.kind else { panic!() };
    assert_eq!(it.parameters[0].docs, ["T."]);
    assert_eq!(it.members[0].docs, ["Left."]);
    assert_eq!(record.docs, ["R."]);
    let ItemKind::Record(it) = &record.kind else { panic!() };
    assert_eq!(it.fields[0].docs, ["F."]);
}

#[test]
fn spans_cover_what_they_name() {
    let text = "let a = -f(x, y) * (b + 3mm) on (p) at level 2";
    let parse = parsed(text);
    let ItemKind::Let(it) = &parse.ast.items[0].kind else { panic!() };
    let of = |span: crate::source::Span| &text[span.range()];
    assert_eq!(of(parse.ast.items[0].span), text);
    assert_eq!(of(it.value.span), &text[8..]);
    let ExprKind::At(on, _) = &it.value.kind else { panic!() };
    assert_eq!(of(on.span), "-f(x, y) * (b + 3mm) on (p)");
    let ExprKind::On(product, _) = &on.kind else { panic!() };
    assert_eq!(of(product.span), "-f(x, y) * (b + 3mm)");
    let ExprKind::Binary(_, operator, left, right) = &product.kind else { panic!() };
    assert_eq!((of(*operator), of(left.span), of(right.span)), ("*", "-f(x, y)", "(b + 3mm)"));
}

#[test]
fn line_ends_never_matter() {
    let text = "let\na\n=\nf\n(\nx\n)\n+\n3\nfigure\nb=a\nat\nlevel\n2 let c = 3";
    let parse = parsed(text);
    assert_eq!(parse.diagnostics, vec![]);
    assert_eq!(parse.ast.items.len(), 3);
}
