//! What goes on after a name, a type or a value, and in the brackets of lists and calls.

use super::{first, fixture, has, labels, offers};

#[test]
fn what_is_declared_goes_on_as_the_grammar_has_it() {
    first("fn g(a: Length)$0", "-> =");
    assert_eq!(labels("fn g(a: Length)$0").len(), 2);
    assert_eq!(offers("fn g(a: Length)$0")[0].snippet, " -> ${1:Length} = $0");
    assert_eq!(offers("fn g(a: Length) $0")[0].snippet, "-> ${1:Length} = $0");
    assert_eq!(labels("fn g(a: Length) -> Length $0"), ["="]);
    assert_eq!(labels("pub let a $0"), ["=", ":"]);
    assert_eq!(labels("let a: Length $0"), ["="]);
    assert_eq!(labels("param a $0"), [":"]);
    assert_eq!(labels("param a: Length $0"), ["="]);
    for head in ["fn f(", "ifs a(", "record R { ", "fn f(b: Int, "] {
        assert_eq!(labels(&format!("{head}a $0")), [":"]);
        assert_eq!(labels(&format!("{head}a: Length $0")), ["="]);
        assert_eq!(labels(&format!("{head}a: Length = 1m $0")), [""; 0]);
    }
    first("record R {\n    a: Length\n    $0\n}", "");
    let member = |text: &str| labels(&format!("ifs a on (p, q) {{\n    {text}\n    germ segment(p, q)\n}}"));
    assert_eq!(member("boundary e $0"), ["="]);
    assert_eq!(member("transform e $0"), ["=", "[…]"]);
    assert_eq!(member("transform e[i in 0..3] $0"), ["="]);
    assert_eq!(member("transform e[i $0"), ["in"]);
    assert_eq!(member("let m $0"), ["=", ":"]);
    assert!(member("let m: $0").contains(&"Point".to_owned()));
}

#[test]
fn the_element_of_a_list_is_a_type_where_the_list_is() {
    for text in [
        "fn f(a: [$0",
        "fn f(a: [$0]) -> Length = 1m",
        "fn f() -> [$0",
        "fn f(a: [[$0",
        "record R { a: [$0] }",
        "let a: [$0] = []",
    ] {
        has(text, "Length Point Number", "sin lerp");
        first(text, "Number");
    }
    first("fn f(a: [Length $0", "");
    has("fn f(a: [Length] = [$0])", "sin", "Point");
    has("let x = f(a: [$0])", "sin", "Point");
}

#[test]
fn what_a_value_can_go_on_with() {
    assert_eq!(labels("let x = [i for i $0]"), ["in"]);
    assert_eq!(labels("let x = [i for i in 0..3 $0]"), ["if", "for"]);
    assert_eq!(labels("let x = [i for i in 0..3 if i > 1 $0]"), ["if", "for", "and", "or"]);
    assert_eq!(labels("let xs = [1]\nlet x = xs[0 $0]"), [""; 0]);
    first("let c = true\nlet x = if c $0", "then and or");
    first("let c = true\nlet x = [if c $0 for i in 0..3]", "then and or");
    first("let c = true\nlet x = if c then 1m $0", "else");
    first("let c = true\nlet x = if c then 1m\n    $0", "else");
    first("let c = true\nlet x = if c then 1m else 2m\n    $0", "use");
    has("let a = 3m\nlet x: Bool = $0", "a min max len", "fern");
    assert_eq!(labels("let x = 3m $0"), [""; 0]);
    has("let x = 3m > 2m $0", "and or", "on until");
    assert_eq!(labels("param p: Length = 3m $0"), ["in", "step"]);
    assert_eq!(labels("param p: Length = 3m in 1m $0"), [".."]);
    assert_eq!(labels("param p: Length = 3m in 1m .. 4m $0"), ["step"]);
    assert_eq!(labels("param p: Length = 3m in 1m .. 4m step 1m $0"), [""; 0]);
    assert_eq!(labels("figure f = x until edge $0"), ["<="]);
    let curves = "use std.curves (bezier3)\n";
    first(&format!("{curves}figure q = bezier3 $0"), "on");
    has(&format!("{curves}figure q = bezier3 on [(0m, 0m)] $0"), "until", "on");
    assert_eq!(labels(&format!("{curves}figure q = bezier3 on [(0m, 0m)] at level 2 $0")), [""; 0]);
}

#[test]
fn arguments_that_must_be_given_come_first() {
    let wide = "wide: Length = 1m, tall: Length";
    first(&format!("fn f({wide}) -> Length = tall\nlet x = f($0)"), "tall: wide:");
    first(&format!("record A {{ {wide} }}\nlet x = A($0)"), "tall: wide:");
    first("figure f = bezier3($0)", "t:");
    // Of a function of the program they are mostly given by their places.
    first("let lean = 3deg\nlet x = rotate($0)", "lean angle: about:");
}

#[test]
fn braces_hold_the_fields_that_must_be_given() {
    let arch = "record Arch { base: Length, rise: Length, name: Text = \"\" }\n";
    let offer = &offers(&format!("{arch}let q: Arch = $0"))[0];
    assert_eq!(offer.label, "{ … }");
    assert_eq!(offer.snippet, "{ base: ${1:1m}, rise: ${2:1m} }");
    let made = fixture(&format!("{arch}let q: Arch = {}", offer.plain.as_ref().unwrap())).made();
    assert!(made.diagnostics.is_empty(), "{:?}", made.diagnostics);
    let all = "record All { name: Text = \"\" }\n";
    assert_eq!(offers(&format!("{all}let q: All = $0"))[0].snippet, "{ $0 }");
}
