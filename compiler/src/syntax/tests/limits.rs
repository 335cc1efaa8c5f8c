//! Texts made to exhaust the stack, the memory or patience: each ends on a 2 MiB stack, with an error that says why.

use super::parsed;
use crate::diagnostic::Code;
use crate::source::{FileId, Source};
use crate::syntax::Parse;
use crate::syntax::counted;
use crate::syntax::limits::{MAX_BYTES, MAX_DEPTH, MAX_DIAGNOSTICS};

/// Parses, walks and drops a text on a small stack, and gives the codes of its diagnostics.
fn on_small_stack(text: String) -> Vec<Code> {
    let run = move || {
        let parse = parsed(&text);
        let copy: Parse = parse.clone();
        assert_eq!(copy.ast, parse.ast);
        drop(copy);
        let shown = format!("{:?}", parse.ast);
        assert!(!shown.is_empty());
        parse.diagnostics.iter().map(|diagnostic| diagnostic.code).collect()
    };
    std::thread::Builder::new().stack_size(2 << 20).spawn(run).unwrap().join().unwrap()
}

/// Every diagnostic has this code.
fn only(code: Code, text: String) {
    let start: String = text.chars().take(30).collect();
    let codes = on_small_stack(text);
    assert_eq!(codes, vec![code], "{start}");
}

#[test]
fn a_million_open_brackets() {
    only(Code::E0107, format!("let a = {}", "(".repeat(1_000_000)));
    only(Code::E0107, format!("let a = {}", "[".repeat(1_000_000)));
    assert_eq!(on_small_stack("(".repeat(1_000_000)), vec![Code::E0201, Code::E0107]);
    only(Code::E0107, format!("let a = {}", "{ b: ".repeat(500_000)));
    only(Code::E0107, format!("let a = {}", "f(".repeat(1_000_000)));
    only(Code::E0107, format!("let a = {}3{}", "(".repeat(500_000), ")".repeat(500_000)));
    only(Code::E0107, format!("let a: {} = 3", "[".repeat(100_000)));
}

#[test]
fn a_million_closing_brackets() {
    let codes = on_small_stack(")".repeat(1_000_000));
    assert_eq!(codes.len(), MAX_DIAGNOSTICS);
    assert!(codes.iter().all(|code| *code == Code::E0203));
}

#[test]
fn brackets_at_the_limit_are_accepted() {
    let nested = |deep: usize| format!("let a = {}3{}", "(".repeat(deep), ")".repeat(deep));
    assert_eq!(on_small_stack(nested(128)), vec![]);
    only(Code::E0107, nested(129));
}

#[test]
fn long_chains_of_every_kind() {
    let many = 100_000;
    for chain in ["a + ", "a - b * ", "a / ", "a by ", "a and ", "a or ", "not ", "- ", "a or not "] {
        only(Code::E0107, format!("let a = {}a", chain.repeat(many)));
    }
    for suffix in
        [".a", "(a)", "[a]", " on (a)", " on a", " at level 4", " until edge <= 3", "()", " each until b < c"]
    {
        only(Code::E0107, format!("let a = a{}", suffix.repeat(many)));
    }
    for nest in ["if a then a else ", "if a then ", "if "] {
        only(Code::E0107, format!("let a = {}a", nest.repeat(many)));
    }
}

#[test]
fn chains_inside_brackets_count_together() {
    let chain = format!("{}a", "a + ".repeat(100));
    let mut text = chain.clone();
    for _ in 0..20 {
        text = format!("({text}) + {chain}");
    }
    only(Code::E0107, format!("let a = {text}"));
}

#[test]
fn a_chain_up_to_the_limit_is_accepted() {
    let chain = |terms: u32| format!("let a = {}a", "a + ".repeat(terms as usize));
    assert_eq!(on_small_stack(chain(MAX_DEPTH - 1)), vec![]);
    only(Code::E0107, chain(MAX_DEPTH));
}

#[test]
fn wide_texts_are_no_problem() {
    let many = 100_000;
    let none = |text: String| assert_eq!(on_small_stack(text), vec![]);
    none(format!("let a = [{}]", "1, ".repeat(many)));
    none("let a = 1\n".repeat(many));
    none(format!("let a = 1 // {}", "x".repeat(10_000_000)));
    none(format!("let a = \"{}\"", "x".repeat(10_000_000)));
    none(format!("let {} = 3", "a".repeat(1_000_000)));
    none(format!("ifs a on (p) {{ {} }}", "germ p ".repeat(many)));
    none(format!("test \"x\" {{ {} }}", "assert if a then b else c ".repeat(1000)));
    none(format!("let a = [{}]", "i for i in 0..3 ".to_owned() + &"if i != 3 ".repeat(many)));
}

#[test]
fn a_million_errors_are_not_all_collected() {
    for wrong in [
        "let = ; ",
        "\u{202e}",
        "@ @ ",
        "let a = 1 2 ",
        "3x ",
        "\"\n",
        "/*\n",
        "“x",
        "fn f( ",
        "let a = [1 2] ",
        "record A { b b } ",
    ] {
        let codes = on_small_stack(wrong.repeat(1_000_000 / wrong.len()));
        assert!(!codes.is_empty() && codes.len() <= MAX_DIAGNOSTICS, "{wrong}: {}", codes.len());
    }
}

#[test]
fn a_file_that_is_too_large_is_not_read() {
    let parse = parsed(&" ".repeat(MAX_BYTES + 1));
    assert_eq!(parse.diagnostics[0].code, Code::E0108);
    assert_eq!(parse.tokens.len(), 1);
    assert_eq!(on_small_stack(" ".repeat(MAX_BYTES)), vec![]);
}

/// However bad a text is, the grammar reads each of its lexemes a bounded number of times.
#[test]
fn no_lexeme_is_read_again_and_again() {
    for part in [
        "let a = f(1, [2, 3]) + 4 * (5 - 6)\n",
        "(((",
        "let a = [1 2 3, 4 5\n",
        "} ) ] ",
        "{ a: 1\n",
        "f(a b",
        "let a = [[[[[[[[[[[[1]]]]]]]]]]]] ",
        "let a = ((((((((((((((((1 2) 3) 4) 5) 6) 7) 8) 9) 0) 1) 2) 3) 4) 5) 6) 7)\n",
        "let a = [(f({a: [(f({a: [(f({a: 1 2}))]}))]}))]\n",
        "if a then ",
        "not ",
    ] {
        let text = format!("let a = {}", part.repeat(100_000 / part.len()));
        let (parse, steps) = counted(&Source::new(FileId(0), "a.ifs", &*text), None);
        let tokens = parse.tokens.iter().filter(|token| !token.kind.is_trivia()).count();
        assert!(steps <= 60 * tokens, "{part}: {steps} steps for {tokens} tokens");
    }
}

/// How many lexemes the grammar reads of a text.
fn steps(text: &str) -> usize {
    counted(&Source::new(FileId(0), "a.ifs", text), None).1
}

/// Of twice as much text the grammar reads at most twice as many lexemes, and a few more. Gives how many of the shortest.
fn linear(what: &str, of: impl Fn(usize) -> String) -> usize {
    let counts: Vec<usize> = [1000, 2000, 4000].map(|size| steps(&of(size))).to_vec();
    for pair in counts.windows(2) {
        let most = 2 * pair[0] + pair[0] / 50 + 100;
        assert!(pair[1] <= most, "{what}: {counts:?} steps for texts of one, two and four lengths");
    }
    counts[0]
}

/// The same, of texts of which the grammar reads enough to show anything.
fn long_and_linear(what: &str, of: impl Fn(usize) -> String) {
    let first = linear(what, of);
    assert!(first >= 1000, "{what}: {first} steps are too few to show anything");
}

#[test]
fn parsing_is_linear_in_long_files_of_each_item() {
    for item in [
        "use std.curves (bezier3, bspline3)\n",
        "param span: Length = 6m in 4m .. 9m step 100mm\n",
        "let net = [[(i * 1m, j * 1m, sin(30deg * i)) for j in 0..7] for i in 0..7 if i != 3]\n",
        "fn rib(i: Int, h: Length = 2m) -> Curve = if i < 3 then bezier3(t: 1/2) on (a, b, c, d) at level 4 else e\n",
        "record Bay { offset: Length, lean: Length = 0mm }\n",
        "ifs arc(t: Number = 1/2) on (p, q, r) {\n let a = lerp(p, q, t)\n transform left = self on (p, a, r)\n germ segment(p, r)\n}\n",
        "figure roof = sheet(bspline3, bspline3, net) at level (2, 3)\n",
        "figure roof = sheet(bspline3, bspline3, net) until edge <= 300mm\n",
        "fabricate roof as panels {\n material: birch_plywood(12mm)\n board: 2m by 1m\n require edge in 1mm .. 2m\n}\n",
        "test \"it is\" {\n let a = len(roof.boards)\n assert a == 256 and all([b < 3 for b in roof.boards])\n}\n",
        "/// What it is.\nlet a = 1 // a comment\n/* another */\n",
    ] {
        long_and_linear(item, |size| item.repeat(size / 10));
    }
}

#[test]
fn parsing_is_linear_in_long_lists_and_chains() {
    for part in
        ["1, ", "(1mm, 2mm), ", "f(a: 1), ", "[[1], [2]], ", "a + b * c - d, ", "if a then b else c, "]
    {
        long_and_linear(part, |size| format!("let a = [{}]", part.repeat(size)));
    }
    let long = |part: &str, count: usize| format!("let a = a{}\n", part.repeat(count));
    for part in [" + a", " * a - b", " and a or b", ".a", "(a)", "[a]", " == a", " < a", " by a", " on (a)"] {
        // As long as may be, again and again; and much longer than may be.
        long_and_linear(part, |size| long(part, 50).repeat(size / 20));
        linear(part, |size| long(part, size));
    }
}

#[test]
fn parsing_is_linear_where_brackets_are_as_deep_as_may_be() {
    for (open, close) in
        [("(", ")"), ("[", "]"), ("f(", ")"), ("[f(a: (", "))]"), ("if a then (", ") else b")]
    {
        let deep = 100 / open.matches(['(', '[']).count();
        let nested = format!("let a = {}3{}\n", open.repeat(deep), close.repeat(deep));
        long_and_linear(open, |size| nested.repeat(size / 50));
    }
}

#[test]
fn parsing_is_linear_in_broken_texts() {
    for wrong in [
        "let a = \n",
        "let = 3\n",
        "let a = [1 2 3, 4 5\n",
        "let a = f(1, (2, [3)\n",
        "fn f(a: , b) -> = 3\n",
        "ifs a on (p { germ germ }\n",
        "fabricate a as { b c: d e }\n",
        "record A { b b }\n",
        "} ) ] ",
        "(((",
        "{ a: 1\n",
        "f(a b ",
        "if a then ",
        "not ",
        "@ $ a ",
        "let a = \"open\n",
        "figure a b = c at at 3 until\n",
        "test { assert } assert\n",
        "use std. (a,, b\n",
    ] {
        long_and_linear(wrong, |size| format!("let b = 3\n{wrong}").repeat(size));
        linear(wrong, |size| wrong.repeat(size));
        linear(wrong, |size| format!("let a = {}", wrong.repeat(size)));
    }
}
