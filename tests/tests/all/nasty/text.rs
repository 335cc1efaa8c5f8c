//! Strange bytes, long lines, and everything that nests, nested too deeply.

use super::{Case, case};

/// Strange and long texts.
pub(crate) fn cases() -> Vec<Case> {
    let long =
        |part: &str, times: usize, end: &str| format!("let b = 1\nlet a = {}{end}\n", part.repeat(times));
    vec![
        case("empty", &[], ""),
        case("blank", &[], "\n\n \t\n"),
        case("only comments", &[], "//! a\n// b\n/// c\n"),
        case("not UTF-8", &["E0101"], b"let a = 1\nlet b = \xff\xfe\n".to_vec()),
        case("UTF-16", &["E0101"], b"\xff\xfel\0e\0t\0".to_vec()),
        case("a byte order mark", &[], "\u{feff}//! a\nlet a = 1\n"),
        case("only a byte order mark", &[], "\u{feff}"),
        case("a byte order mark inside", &["E0102"], "let a = 1\n\u{feff}let b = 1\n"),
        case("carriage returns", &[], "let a = 1\r\n// c\r\nlet b = a + 1\r\n/// d\r\nlet c = 2"),
        case("NUL bytes", &["E0102"], "let a = 1\0\n\0let b = 2\n"),
        case("only NUL bytes", &["E0102"], "\0".repeat(100_000)),
        case("bidirectional controls", &["E0106"], "let a = 1 // \u{202e} abc\nlet b = \"\u{2066} x\"\n"),
        case("an infinite number", &["E0104"], "let a = 1e999\n"),
        case("a number near zero", &["E0104"], "let a = 1e-999\n"),
        case("an exponent beyond all bounds", &["E0104"], "let a = 1e99999999999999999999\n"),
        case("a number of 100,000 digits", &["E0104"], format!("let a = {}\n", "9".repeat(100_000))),
        case("a comment of 10 MB", &[], format!("//{}", "x".repeat(10_000_000))),
        case(
            "a text of 5 MB of the wrong type",
            &["E0401"],
            format!("let a: Int = \"{}\"\n", "x".repeat(5_000_000)),
        ),
        case("a name of 1 MB", &["E0301"], format!("let a = {}\n", "a".repeat(1_000_000))),
        case("a list of 100,000", &[], long("[", 1, &format!("{}1]", "1, ".repeat(100_000)))),
        case("a list beyond the limit", &["E0704"], long("[", 1, &format!("{}1]", "1, ".repeat(1_000_000)))),
        case("a sum of 1,000,000", &["E0107"], long("b + ", 1_000_000, "b")),
        case(
            "100,000 arguments",
            &["E0406"],
            format!("fn f(x: Int) -> Int = x\nlet a = f({})\n", "1, ".repeat(100_000)),
        ),
        case("20,000 unknown names", &["E0301"], lines(20_000, |i| format!("let a{i} = b{i}"))),
        case("20,000 names declared twice", &["E0302"], "let a = 1\n".repeat(20_000)),
        case("20,000 lets without names", &["E0201"], lines(20_000, |i| format!("let = {i}"))),
        case("50,000 items", &[], lines(50_000, |i| format!("let a{i} = {i}"))),
        case("1,000,000 closing brackets", &["E0203"], ")".repeat(1_000_000)),
    ]
}

/// Everything that nests: 100 deep is fine, 1,000 and 100,000 are refused.
pub(crate) fn nested() -> Vec<Case> {
    let mut cases = vec![
        case("1,000,000 round brackets", &["E0107", "E0201"], "(".repeat(1_000_000)),
        case("1,000,000 square brackets", &["E0107"], format!("let a = {}", "[".repeat(1_000_000))),
        case("1,000,000 braces", &["E0107", "E0201"], format!("let a = {}", "{".repeat(1_000_000))),
        case("clauses, 1,000 times", &[], format!("let a = [1{}]\n", " for i in 0..1".repeat(1_000))),
        case(
            "clauses, 100,000 times",
            &["E0703"],
            format!("let a = [1{}]\n", " for i in 0..1".repeat(100_000)),
        ),
    ];
    for (name, before, part, middle, close) in NESTING {
        for depth in [100, 1_000, 100_000] {
            let codes: &[&str] = if depth == 100 { &[] } else { &["E0107"] };
            let text = format!("{before}{}{middle}{}\n", part.repeat(depth), close.repeat(depth));
            cases.push(case(format!("{name}, {depth} times"), codes, text));
        }
    }
    cases
}

/// A name, what stands before, what is repeated, what stands in the middle, what closes.
const NESTING: &[(&str, &str, &str, &str, &str)] = &[
    ("brackets", "let a = ", "(", "1", ")"),
    ("lists", "let a = ", "[", "1", "]"),
    ("calls", "fn f(x: Int) -> Int = x\nlet a = ", "f(", "1", ")"),
    ("else", "let a = ", "if true then 1 else ", "2", ""),
    ("then", "let a = ", "if true then ", "1", " else 2"),
    ("conditions", "let a = ", "if ", "true", " then true else false"),
    ("minus", "let a = ", "- ", "1", ""),
    ("not", "let a = ", "not ", "true", ""),
    ("elements", "let l = [0]\nlet a = ", "l[", "0", "]"),
    ("comprehensions", "let a = ", "[", "1", " for i in 0..1]"),
    ("sums", "let a = 1", " + 1", "", ""),
    ("and", "let a = true", " and true", "", ""),
    (
        "levels",
        "use std.curves (bezier2)\nfigure f = bezier2 on ((0m, 0m), (1m, 1m), (2m, 0m))",
        " at level 1",
        "",
        "",
    ),
];

/// Lines numbered from 0.
pub(crate) fn lines(count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).map(|i| line(i) + "\n").collect()
}
