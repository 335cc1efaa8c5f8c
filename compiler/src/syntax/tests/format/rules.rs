//! One test a rule.

use super::{becomes, formatted, stays};
use crate::source::{FileId, Source};
use crate::syntax::format::{COLUMNS, format};
use crate::syntax::parse;

#[test]
fn spaces_are_set_anew() {
    becomes("let a=b+c*-d\n", "let a = b + c * -d\n");
    becomes("let a = f ( x , y: 3 ) [ 0 ] . z\n", "let a = f(x, y: 3)[0].z\n");
    becomes("let a = - - x -y\n", "let a = --x - y\n");
    becomes("let a = [ [ 1,2 ] ,[ 3 ] ]\n", "let a = [[1, 2], [3]]\n");
    becomes("let a = not(b)and c\n", "let a = not (b) and c\n");
    becomes("let a =if(b)then(c)else d\n", "let a = if (b) then (c) else d\n");
    becomes("use  std . curves(a,b)\n", "use std.curves (a, b)\n");
    becomes("use \"./a.ifs\"(a)\n", "use \"./a.ifs\" (a)\n");
    becomes("fn f (a:[Int]=[],b :Int)->[ [Int] ]=a\n", "fn f(a: [Int] = [], b: Int) -> [[Int]] = a\n");
    becomes("figure a=b on(c,d)at level(4,3)\n", "figure a = b on (c, d) at level (4, 3)\n");
    becomes("figure a=b on net[0 .. 4,0..4]\n", "figure a = b on net[0..4, 0..4]\n");
    becomes("ifs a(t:Int)on(p,q){germ(p)}\n", "ifs a(t: Int) on (p, q) { germ (p) }\n");
    becomes("record A{}\n", "record A {}\n");
    becomes("\u{feff}\tlet a = \"x  y\"\t\n", "let a = \"x  y\"\n");
}

#[test]
fn fractions_are_one_word() {
    becomes("let a = b * 4 / 3 + c / 2 + 2m / 3\n", "let a = b * 4/3 + c / 2 + 2m / 3\n");
    becomes("let a = b / 4/3 + 1 / 2 / 3\n", "let a = b / 4 / 3 + 1/2 / 3\n");
    becomes("let a = 4 /\n3\n", "let a = 4/3\n");
}

#[test]
fn ranges_are_tight_between_operands_and_open_where_they_are_limits() {
    becomes("let a = [i for i in 0 .. n]\n", "let a = [i for i in 0..n]\n");
    becomes("let a = 0 ..n-1\n", "let a = 0 .. n - 1\n");
    becomes("let a = -1 .. (n-1)\n", "let a = -1..(n - 1)\n");
    becomes("param a: Int = 3 in 1..5 step 1\n", "param a: Int = 3 in 1 .. 5   step 1\n");
    becomes(
        "fabricate a as b { require edge in 1m..2m }\n",
        "fabricate a as b { require edge in 1m .. 2m }\n",
    );
    becomes("figure a = b until edge in 1m..2m\n", "figure a = b until edge in 1m .. 2m\n");
}

#[test]
fn brackets_that_span_lines_end_and_begin_lines() {
    becomes("let a = f(b,\n c, d)\n", "let a = f(\n    b,\n    c, d,\n)\n");
    becomes("let a = [\n1, 2,\n3, 4]\n", "let a = [\n    1, 2,\n    3, 4,\n]\n");
    becomes("let a = (b\n)\n", "let a = (\n    b\n)\n");
    becomes("let a = [b for b in c\nif d]\n", "let a = [\n    b for b in c\n    if d\n]\n");
    becomes("figure a = b on (\np)\nat level 3\n", "figure a = b on (\n    p,\n)\n    at level 3\n");
    becomes("let a = f(g(x, [\n1\n]))\n", "let a = f(g(x, [\n    1,\n]))\n");
    becomes("let a = f(b\n, c,)\n", "let a = f(\n    b,\n    c,\n)\n");
    becomes("let a = f(\n)\nlet b = [x,]\n", "let a = f()\nlet b = [x]\n");
    becomes("let a = { b: 1 c: 2 }\n", "let a = { b: 1, c: 2 }\n");
    becomes("let a = {\nb: 1\nc: 2 }\n", "let a = {\n    b: 1,\n    c: 2,\n}\n");
}

#[test]
fn blocks_have_an_entry_a_line_unless_they_stand_on_one() {
    becomes("record A { b: Int c: Int, }\n", "record A { b: Int, c: Int }\n");
    becomes("record A {\nb: Int, c: Int, }\n", "record A {\n    b: Int\n    c: Int\n}\n");
    becomes(
        "ifs a on (p, q) { let b = p germ segment(b, q) }\n",
        "ifs a on (p, q) { let b = p   germ segment(b, q) }\n",
    );
    becomes(
        "test \"a\" { let b = 1\nassert b == 1 }\n",
        "test \"a\" {\n    let b = 1\n    assert b == 1\n}\n",
    );
    becomes("let a = 1 let b = 2 fn f() -> Int = 3\n", "let a = 1\nlet b = 2\nfn f() -> Int = 3\n");
}

#[test]
fn line_ends_stay_around_operators_and_go_elsewhere() {
    becomes("let\na\n=\nb\n+ c *\nd\n", "let a =\n    b\n    + c *\n    d\n");
    becomes(
        "let a = if b\nthen c\nelse\nif d then e else f\n",
        "let a = if b\n    then c\n    else\n    if d then e else f\n",
    );
    becomes("let a = b\n.c\n(d)\n", "let a = b.c(d)\n");
    becomes("let a: [\nInt\n] = f\n", "let a: [Int] = f\n");
    stays("figure a = b\n    until edge <= 3m\n    each until size <= 3m\n");
    stays("param a: Int = 3\n    in 1 .. 5\n    step 1\n");
    stays("test \"a\" {\n    assert b\n        == c\n        and d\n}\n");
}

#[test]
fn what_is_too_long_is_broken() {
    let value = "x".repeat(100);
    becomes(
        &format!("let aaaaaaaaaaaaaaaaaa = {value}\n"),
        &format!("let aaaaaaaaaaaaaaaaaa =\n    {value}\n"),
    );
    let long = format!("{}z", "long_name + ".repeat(12));
    stays(&format!("let a = {long}\n"));
    becomes(
        &format!("let a = f(g({long}), b)\n"),
        &format!("let a = f(\n    g(\n        {long},\n    ),\n    b,\n)\n"),
    );
    becomes(&format!("let a = f([{long}])\n"), &format!("let a = f([\n    {long},\n])\n"));
    becomes(
        &format!("record A {{ a: Int = {value}, b: Int }}\n"),
        &format!("record A {{\n    a: Int = {value}\n    b: Int\n}}\n"),
    );
}

#[test]
fn short_elements_fill_lines() {
    let numbers: Vec<String> = (1000..1060).map(|n| n.to_string()).collect();
    let text = formatted(&format!("let a = [{}]\n", numbers.join(", ")));
    assert_eq!(text.lines().count(), 2 + 4, "{text}");
    assert!(text.lines().all(|line| line.len() <= COLUMNS), "{text}");
    stays(&text);
    // A row of the author's that is too long is filled as well.
    let text = formatted(&format!("let a = f(\n    0,\n    {})\n", numbers.join(", ")));
    assert_eq!(text.lines().count(), 3 + 4, "{text}");
    stays(&text);
}

#[test]
fn blank_lines_group() {
    becomes("\n\n\nlet a = 1\n\n\n\nlet b = 2\n\n\n", "let a = 1\n\nlet b = 2\n");
    becomes(
        "ifs a on (p) {\n\nlet b = p\n\n\ngerm b\n\n}\n",
        "ifs a on (p) {\n    let b = p\n\n    germ b\n}\n",
    );
    becomes("let a = [\n\n1,\n\n2,\n\n]\n", "let a = [\n    1,\n\n    2,\n]\n");
    becomes("let a =\n\n\n1\n", "let a =\n    1\n");
    becomes("// a\n\n\n// b\n\nlet a = 1\n// c\n\n// d\n", "// a\n\n// b\n\nlet a = 1\n// c\n\n// d\n");
}

#[test]
fn comments_stay_where_they_stand() {
    becomes("  // a  \nlet a = 1 // b\t\n//c", "// a\nlet a = 1  // b\n//c\n");
    becomes("let a = f(b, // why\nc)\n", "let a = f(\n    b,  // why\n    c,\n)\n");
    becomes("let a = f(b // why\n, c // too\n)\n", "let a = f(\n    b,  // why\n    c,  // too\n)\n");
    becomes("let a = f(// all\nb\n// end\n)\n", "let a = f(  // all\n    b,\n    // end\n)\n");
    becomes("let a = [ // none\n]\n", "let a = [  // none\n]\n");
    becomes("let // odd\na = 1\n", "let  // odd\n    a = 1\n");
    becomes("let a: [ // odd\nInt] = b\n", "let a: [  // odd\n    Int] = b\n");
    becomes("let a = b + // why\nc\n// and\n* d\n", "let a = b +  // why\n    c\n    // and\n    * d\n");
    becomes("record A { a: Int // x\n b: Int }\n", "record A {\n    a: Int  // x\n    b: Int\n}\n");
    becomes("record A { /// x\n b: Int }\n", "record A {  /// x\n    b: Int\n}\n");
    becomes("fabricate a as b {\n// one\n\n// two\n}\n", "fabricate a as b {\n    // one\n\n    // two\n}\n");
    becomes("// only\r\n\r\n//! and docs\r\n", "// only\r\n\r\n//! and docs\r\n");
    becomes("let a  = 1\r\nlet b = 2\n", "let a = 1\r\nlet b = 2\r\n");
    becomes("let a  = 1\nlet b = 2\r\n", "let a = 1\nlet b = 2\n");
}

#[test]
fn columns_stand_below_each_other() {
    becomes("let a = 1\nlet bcd = 2\n\nlet e = 3\n", "let a   = 1\nlet bcd = 2\n\nlet e = 3\n");
    becomes("let a = 1\nfigure bcd = 2\n", "let a = 1\nfigure bcd = 2\n");
    becomes("let a = 1\n// c\nlet bcd = 2\n", "let a = 1\n// c\nlet bcd = 2\n");
    stays("let a = 1\nlet a_name_that_is_very_long = 2\nlet b = 3\n");
    becomes(
        "param a: Int = 3 in 1 .. 5 step 1\nparam bc: Int = 30 in 1 .. 50 step 1\nparam d: Int = 3\n",
        "param a: Int  = 3  in 1 .. 5    step 1\nparam bc: Int = 30 in 1 .. 50   step 1\nparam d: Int  = 3\n",
    );
    becomes(
        "fabricate a as b {\n    c: 1\n    def: 2 // e\n    require edge > 3 // h\n}\n",
        "fabricate a as b {\n    c:   1\n    def: 2            // e\n    require edge > 3  // h\n}\n",
    );
    becomes(
        "let a = [\n(1, 20, 3), // a\n(100, 2, 3),\n[1, 2, 3], [4],\n]\n",
        "let a = [\n    (1,   20, 3),  // a\n    (100, 2,  3),\n    [1, 2, 3], [4],\n]\n",
    );
    stays("let a =\n    1\nlet bcd = 2\n");
    stays("fabricate a as b {\n    c:   1\n    planarize: { d: 1 }\n    efg: 2\n}\n");
}

#[test]
fn broken_texts_are_refused() {
    for text in ["let a = (", "let a = 1 2", "let a\u{202e} = 1", "é", "let a = 1\n//! late\n", "x", ")"] {
        let source = Source::new(FileId(0), "a.ifs", text);
        assert_eq!(format(&parse(&source), &source), None, "{text}");
    }
}

#[test]
fn empty_texts_stay_empty() {
    becomes("", "");
    becomes(" \n\n\t\r\n", "");
}
