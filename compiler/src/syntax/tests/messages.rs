//! One mistake, one message, at the right place, with a way out.

use super::parsed;
use crate::diagnostic::Diagnostic;
use crate::source::LineIndex;

/// The only diagnostic of a text.
fn only(text: &str) -> Diagnostic {
    let mut all = parsed(text).diagnostics;
    assert_eq!(all.len(), 1, "{text}: {all:#?}");
    all.remove(0)
}

/// `E0201 1:9 message`, the line and column from 1.
fn said(text: &str) -> String {
    let found = only(text);
    let at = LineIndex::new(text).characters(text, found.span.start);
    format!("{} {}:{} {}", found.code.name(), at.line + 1, at.column + 1, found.message)
}

/// The text with the first fix of its only diagnostic made.
fn mended(text: &str) -> String {
    let found = only(text);
    let fix = found.fixes().next();
    let fix = fix.unwrap_or_else(|| panic!("a fix for {text}: {found:#?}"));
    let mut better = text.to_owned();
    let edit = &fix.edits[0];
    better.replace_range(edit.span.range(), &edit.replacement);
    better
}

#[test]
fn what_was_expected_and_found() {
    for (text, message) in [
        ("let a = f(1 2)", "E0201 1:13 expected `,` or `)`, found the number `2`"),
        ("let a = [1, 2 x]", "E0201 1:15 expected `,` or `]`, found `x`"),
        ("let a = (1, )\nlet b = 3 +", "E0201 2:12 expected a value, found the end of the file"),
        ("let a =\nlet b = 4", "E0201 1:8 expected a value, found the keyword `let`"),
        ("let a = )", "E0203 1:9 this `)` closes nothing"),
        ("let a = x.\nlet b = 3", "E0201 1:11 expected a name, found the keyword `let`"),
        ("let a = if x then y", "E0201 1:20 expected `else` or an operator, found the end of the file"),
        ("let a = if x y else z", "E0201 1:14 expected `then` or an operator, found `y`"),
        ("let a = [i for i 0..3]", "E0201 1:18 expected `in`, found the number `0`"),
        ("let a = [i for i in 0..3, 4]", "E0201 1:25 expected `for` or `]`, found `,`"),
        ("let a = f(, 3)", "E0201 1:11 expected a value, found `,`"),
        ("let figure = 3", "E0201 1:5 expected a name, found the keyword `figure`"),
        ("foo bar", "E0201 1:1 expected an item, found `foo`"),
        ("pub a = 3", "E0201 1:5 expected an item, found `a`"),
        ("let a = ()", "E0201 1:9 expected a value between the brackets"),
        ("let a = 1 < 2 < 3", "E0201 1:15 comparisons cannot be chained"),
        ("let a = 0..1..2", "E0201 1:13 a range has two ends"),
        (
            "let a = b at level (1, 2, 3)",
            "E0201 1:20 a level is one whole number, or two in brackets for u and v",
        ),
        (
            "ifs a { germ x }",
            "E0201 1:7 expected a space (`on (p0, p1)`, `in plane` or `in space`), found `{`",
        ),
        ("ifs a in circle { germ x }", "E0201 1:10 expected `plane` or `space`, found `circle`"),
        ("test foo { assert a }", "E0201 1:6 expected a text in quotes, found `foo`"),
        ("use std.curves", "E0201 1:15 expected `.` or `(`, found the end of the file"),
        (
            "fabricate a as b { require edge 150mm }",
            "E0201 1:33 expected `<=`, `>=` or `in`, found the number `150mm`",
        ),
        ("fabricate a as b { require edge in 3m }", "E0201 1:39 expected `..` or an operator, found `}`"),
        ("let a = (tool: 6mm, feed: 3m)", "E0201 1:10 expected a value, found `tool`"),
        ("fn f(a, b: Int) = a", "E0201 1:7 expected `:`, found `,`"),
        ("fn f(a: Int) { return a }", "E0201 1:14 expected `=` or `->`, found `{`"),
        (
            "ifs a on (p) { germ p\n  foo = 3 }",
            "E0201 2:3 expected a member (`let`, `transform`, `germ`, `keep`, `boundary` or `join`) or `}`, found `foo`",
        ),
    ] {
        assert_eq!(said(text), message, "{text}");
    }
}

#[test]
fn brackets() {
    for (text, message) in [
        ("let a = (1, 2\nlet b = 4", "E0202 1:9 this `(` is never closed"),
        ("let a = f([1, 2)", "E0202 1:11 this `[` is never closed"),
        ("record A { a: Length\nrecord B { b: Length }", "E0202 1:10 this `{` is never closed"),
        ("ifs a on (p, q) {\n    germ p\n\nlet b = 4", "E0202 1:17 this `{` is never closed"),
        (
            "ifs a on (p, q) {\n    transform l = self on (p, q\n    germ p\n}",
            "E0202 2:27 this `(` is never closed",
        ),
        ("fn f(a: Int -> Int = a", "E0202 1:5 this `(` is never closed"),
        ("ifs a(t: Int on (p) {\n    germ p\n}", "E0202 1:6 this `(` is never closed"),
        ("let b = (3]", "E0203 1:11 this `]` cannot close a `(`"),
        ("let b = (3, [4))", "E0203 1:15 this `)` cannot close a `[`"),
        ("let b = f(3))", "E0203 1:13 this `)` closes nothing"),
        ("let b = f 3, 4)", "E0203 1:15 this `)` closes nothing"),
        ("ifs a on (p)\n    germ p\n}", "E0201 2:5 expected `{` before this"),
        ("fabricate a as b\n    c: { d: 1 }\n}", "E0201 2:5 expected `{` before this"),
        ("let a = f(g(h(1", "E0202 1:14 this `(` is never closed"),
        (
            "fabricate a as b {\n    c: { d: 1\n    e: 2\n    require edge <= 1m\n}",
            "E0202 2:8 this `{` is never closed",
        ),
    ] {
        assert_eq!(said(text), message, "{text}");
    }
}

#[test]
fn every_fix_mends_its_text() {
    for (text, better) in [
        ("let a = 5 mm", "let a = 5mm"),
        ("let a 3", "let a = 3"),
        ("let a == 3", "let a = 3"),
        ("let a := 3", "let a = 3"),
        ("function f(i: Int) = 3", "fn f(i: Int) = 3"),
        ("let a = 3\ndef f(i: Int) = 3", "let a = 3\nfn f(i: Int) = 3"),
        ("const a = 3", "let a = 3"),
        ("figrue a = b", "figure a = b"),
        ("let a = 3;", "let a = 3"),
        ("a = 3", "let a = 3"),
        ("let a = 3\nb = a", "let a = 3\nlet b = a"),
        ("ifs a on (p) { germ p\n  m = p }", "ifs a on (p) { germ p\n  let m = p }"),
        ("let a = f(1 2)", "let a = f(1, 2)"),
        ("let a = f(x = 2)", "let a = f(x : 2)"),
        ("let a = if x = 3 then y else z", "let a = if x == 3 then y else z"),
        ("let a = if x them y else z", "let a = if x then y else z"),
        ("let a = .5", "let a = 0.5"),
        ("let a = 12mmm", "let a = 12mm"),
        ("let a = 35°", "let a = 35deg"),
        ("let a = 3 degrees", "let a = 3 degrees"),
        ("let a = \"b", "let a = \"b\""),
        ("let a = 'b'", "let a = \"b\""),
        ("let a = b && c", "let a = b and c"),
        ("let a = 3 × 4", "let a = 3 * 4"),
        ("# note\nlet a = 3", "// note\nlet a = 3"),
        ("let a = 3\n//! late", "let a = 3\n/// late"),
        ("let MyWidth = 3", "let my_width = 3"),
        ("record my_record { a: Int }", "record MyRecord { a: Int }"),
        ("record HTTPThing_x { a: Int }", "record HttpThingX { a: Int }"),
        ("figure a = b at 4", "figure a = b at level 4"),
        ("figure a = b at levle 4", "figure a = b at level 4"),
        ("param a Int = 3", "param a: Int = 3"),
        ("fabricate a as b { board 3m }", "fabricate a as b { board: 3m }"),
        ("fabricate a as b { side: u\n board 3m }", "fabricate a as b { side: u\n board: 3m }"),
        ("fabricate a as b { board = 3m }", "fabricate a as b { board : 3m }"),
        ("fabricate a as b { require flatness >= 1 }", "fabricate a as b { require planarity >= 1 }"),
        ("fabricate a as b { require bend radus >= 1m }", "fabricate a as b { require bend radius >= 1m }"),
        ("ifs a on (p) { transfrom l = p }", "ifs a on (p) { transform l = p }"),
        ("ifs a on (p) { germ p\n  tranform l = p }", "ifs a on (p) { germ p\n  transform l = p }"),
        ("test \"x\" { asert a }", "test \"x\" { assert a }"),
        ("let a = (1, 2\nlet b = 4", "let a = (1, 2)\nlet b = 4"),
        ("let a = f(g(h(1", "let a = f(g(h(1)))"),
        ("ifs a on (p) {\n  germ p\n\nlet b = 4", "ifs a on (p) {\n  germ p}\n\nlet b = 4"),
        ("ifs a on (p)\n  germ p\n}", "ifs a on (p) {\n  germ p\n}"),
        ("let b = (3]", "let b = (3)"),
        ("let a = \u{202e}3", "let a = 3"),
    ] {
        if text == better {
            continue;
        }
        assert_eq!(mended(text), better, "{text}");
        assert_eq!(parsed(better).diagnostics, vec![], "{better}");
    }
}

#[test]
fn hints_without_a_change() {
    for (text, hint) in [
        ("let figure = 3", "`figure` is a word of the language: choose another name"),
        ("let a = 1 < 2 < 3", "write `a < b and b < c`"),
        ("fn f(a, b: Int) = a", "each parameter has a type: `a: Length`"),
        ("fn f(a: Int) { return a }", "the body of a function is one expression: `fn f(…) -> Type = …`"),
        ("let a = if x then y", "a condition is written `if c then a else b`, with both values"),
        ("use std.curves", "name what is used, in brackets: `use std.curves (bezier3)`"),
        ("let a = x ** 2", "there is no `**`: multiply, or call a function"),
        ("let a = 2 x", "to multiply, write `*`"),
        (
            "let a = 2\nrequire planarity >= 1",
            "`require` stands in the braces of a `fabricate` block: `fabricate name as panels { require … }`",
        ),
        ("germ segment(a, b)", "`germ` stands in the braces of an ifs: `ifs name on (a, b) { … }`"),
        ("assert a", "`assert` stands in the braces of a test: `test \"what is so\" { assert … }`"),
        (
            "fabricate a { board: b }",
            "what is made of it stands behind `as`: `as panels` of a surface, `as planks` of a curve",
        ),
        ("let a = 3cm2", "an area is written in mm2 or m2, or as a product: `(3cm * 1cm)`"),
        ("let a = 2in3", "a volume is written in mm3 or m3, or as a product: `(2in * 1in * 1in)`"),
        ("let a = (tool: 6mm)", "an argument with a name, like `tool:`, belongs to a call: `name(tool: …)`"),
    ] {
        assert_eq!(only(text).hints[0].text, hint, "{text}");
    }
}

#[test]
fn nothing_is_multiplied_over_lines() {
    let found = only("let a = 2\nx y");
    assert!(found.hints.is_empty(), "{:?}", found.hints);
}

/// What stands in the braces of a loop is no mistake of its own.
#[test]
fn there_are_no_loops() {
    for text in [
        "for i in 0..3 { let b = i }",
        "let a = [1, 2]\nfor i in 0..3 {\n    let b = i\n}\nlet c = 3",
        "let a = 1\nwhile a < 3 { let b = 2 }",
        "ifs a on (p) { germ p\n  for i in 0..3 { let b = i } }",
    ] {
        assert!(only(text).hints[0].text.starts_with("there are no loops: "), "{text}");
    }
}

#[test]
fn an_unknown_measure_lists_the_known_ones() {
    let found = only("fabricate a as b { require zebra >= 1 }");
    assert_eq!(found.code, crate::diagnostic::Code::E0206);
    assert!(found.hints[0].text.starts_with("the measures are planarity, fold, diagonal ratio"));
}
