//! The layout of texts: what holds for all of them, on every design of the tree and on many made up ones.
#![allow(clippy::disallowed_methods, reason = "the tests read the designs")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use ifs_tests::layout::{Read, check};
use ifs_tests::{root, sources};
use proptest::prelude::*;

fn designs(folder: &str) -> Vec<PathBuf> {
    let found = sources::files(&root().join(folder), "ifs");
    assert!(!found.is_empty(), "{folder} is empty");
    found
}

/// All texts of the tree without mistakes of form.
fn good_texts() -> Vec<String> {
    let folders = ["stdlib", "examples", "tests/suite", "benches", "compiler/src/syntax/tests/language"];
    let paths = folders.into_iter().flat_map(designs);
    let texts: Vec<String> = paths.filter_map(|path| fs::read_to_string(path).ok()).collect();
    texts.into_iter().filter(|text| Read::new(text).is_good()).collect()
}

#[test]
fn every_design_of_the_tree_keeps_its_meaning() {
    let texts = good_texts();
    assert!(texts.len() > 100, "{}", texts.len());
    for text in texts {
        check(&text);
        check(&text.replace('\n', "\r\n"));
    }
}

#[test]
fn the_library_and_the_examples_are_laid_out() {
    for path in ["stdlib", "examples"].into_iter().flat_map(designs) {
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(check(&text), text, "`ifs fmt {}` mends it", path.display());
    }
}

/// Texts with mistakes of form are never changed.
#[test]
fn what_is_broken_is_refused() {
    let mut broken = 0;
    for path in designs("tests/suite") {
        // One is not UTF-8.
        let Ok(text) = fs::read_to_string(&path) else { continue };
        let read = Read::new(&text);
        if !read.is_good() {
            assert_eq!(read.formatted(), None, "{}", path.display());
            broken += 1;
        }
    }
    assert!(broken > 10, "{broken}");
}

#[test]
fn a_large_text_is_quick() {
    let shapes = [
        "let a = f(1, [2, 3]) + 4 * (5 - 6)\n".repeat(30_000),
        format!("let a = [{}]\n", "(1m, 2m, [3m]), ".repeat(60_000)),
        format!("let a = [\n{}]\n", "(1m, 2m, [3m]),\n".repeat(60_000)),
        format!("let a = f({})\n", "b + c * d, ".repeat(90_000)),
        format!("ifs a on (p) {{ {} }}\n", "germ p ".repeat(140_000)),
        format!("record A {{ {} }}\n", "b: Int // c\n".repeat(80_000)),
        "// a comment\n".repeat(80_000),
        "\n\n".repeat(500_000),
        format!("let a = {}1{}\n", "[f(1, 2, ".repeat(60), ")]".repeat(60)).repeat(50),
        format!("let a = {}\n", ["f(first_argument, second_argument, third)"; 250].join(" + ")).repeat(100),
    ];
    for text in shapes {
        let read = Read::new(&text);
        assert!(read.is_good(), "{:?}", read.parse.diagnostics.first());
        let begun = Instant::now();
        let laid_out = read.formatted().unwrap();
        assert!(begun.elapsed() < Duration::from_secs(5), "{:?} for {:.60}", begun.elapsed(), text);
        assert_eq!(Read::new(&laid_out).formatted().unwrap(), laid_out, "{:.60}", text);
    }
}

/// What may stand between two tokens.
const GAPS: &[&str] = &[
    " ",
    " ",
    " ",
    "  ",
    "\n",
    "\n",
    "\n    ",
    "\n\n",
    "\n\n\n",
    "\t",
    " // why\n",
    "\n// what\n",
    "\n\n// so\n\n",
];

/// The same tokens with other spaces, line ends and comments between them; docs stay where they are.
fn shaken(text: &str, gaps: &[usize]) -> String {
    let read = Read::new(text);
    let mut shaken = String::new();
    let mut gap = gaps.iter().cycle();
    let mut documents = false;
    for token in &read.parse.tokens {
        let word = read.source.slice(token.span);
        if token.kind == ifs_compiler::syntax::TokenKind::Whitespace {
            continue;
        }
        if token.kind.is_trivia() {
            documents = !word.starts_with("// ");
            shaken.push_str(&format!("\n{word}\n"));
            continue;
        }
        let comma = token.kind == ifs_compiler::syntax::TokenKind::Comma;
        if !(documents && comma) {
            shaken.push_str(GAPS[*gap.next().unwrap() % GAPS.len()]);
        }
        documents = false;
        shaken.push_str(word);
    }
    shaken
}

/// Expressions of every kind.
fn expression() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(vec![
        "a",
        "bc",
        "net",
        "1",
        "2",
        "0.5",
        "12mm",
        "3m/min",
        "50%",
        "\"text // no\"",
        "true",
        "self",
        "by_hand",
        "a_rather_long_name_for_a_value",
    ])
    .prop_map(str::to_owned);
    leaf.prop_recursive(5, 60, 6, |inner| {
        let many = prop::collection::vec(inner.clone(), 1..6);
        let operator = prop::sample::select(vec!["+", "-", "*", "/", "by", "and", "or"]);
        prop_oneof![
            (inner.clone(), operator, inner.clone())
                .prop_map(|(a, operator, b)| format!("{a} {operator} {b}")),
            inner.clone().prop_map(|a| format!("-{a}")),
            inner.clone().prop_map(|a| format!("({a})")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("({a} < {b})")),
            many.clone().prop_map(|all| format!("({}, 0m)", all.join(", "))),
            many.clone().prop_map(|all| format!("[{}]", all.join(","))),
            many.clone().prop_map(|all| format!("f({},)", all.join(", "))),
            many.clone().prop_map(|all| format!("g(a: {})", all.join(", b: "))),
            many.clone().prop_map(|all| format!("{{ a: {} }}", all.join(" b: "))),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("[{a} for i in {b} if i != 3]")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("[{a} for i in 0..n for j in ({b})]")),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("list[({a})..({b}), 0..4]")),
            (inner.clone(), inner.clone(), inner.clone())
                .prop_map(|(a, b, c)| format!("(if {a} then {b} else {c})")),
            many.prop_map(|all| format!("(c on ({}) at level (4, 3))", all.join(", "))),
            (inner.clone(), inner).prop_map(|(a, b)| format!("(c on {a} each until size in {b} .. 3m)")),
        ]
    })
}

/// Items of every kind around expressions.
fn program() -> impl Strategy<Value = String> {
    let item = (0..12usize, expression(), expression()).prop_map(|(which, a, b)| match which {
        0 => format!("let {} = {a}", &"a_long_name"[..1 + b.len() % 11]),
        1 => format!("param p: Length = {a} in 1m .. 2m step 3mm"),
        2 => format!("fn f(a: [[Int]] = {a}, b: Int) -> [Length] = {b}"),
        3 => format!("record R {{ a: Int = {a} b: Length, c: [Int] }}"),
        4 => format!("ifs c(t: Int = {a}) on (p, q) {{ let m = {b} transform l[i in 0..3] = self germ m }}"),
        5 => format!(
            "ifs c in plane {{ keep {a} boundary start = {b} on (p) join a.b = c transform r = self }}"
        ),
        6 => format!("figure g: Surface = {a} at level {b}"),
        7 => format!("fabricate g as panels {{ board: {a} require bend radius >= 3m side: {b}, }}"),
        8 => format!("test \"t\" {{ let n = {a} assert {b} }}"),
        9 => "use std.curves (a, b,)".to_owned(),
        10 => format!("/// What it is.\npub let documented = {a}"),
        _ => format!("fabricate g as planks {{ require edge in 1m .. {a} require area < {b} }}"),
    });
    prop::collection::vec(item, 1..5).prop_map(|items| items.join("\n"))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1500) })]

    #[test]
    fn made_up_programs_keep_their_meaning(
        text in program(),
        gaps in prop::collection::vec(0..GAPS.len(), 1..40),
    ) {
        prop_assume!(Read::new(&text).is_good());
        check(&text);
        check(&shaken(&text, &gaps));
    }
}

#[test]
fn shaken_designs_keep_their_meaning() {
    for (number, text) in good_texts().iter().enumerate() {
        for step in [1, 5, 7, 11] {
            let gaps: Vec<usize> = (0..97).map(|n| (n * n * step + n + number) % 101).collect();
            check(&shaken(text, &gaps));
        }
    }
}
