//! Evaluations without an end, of too many steps, or of numbers that are none.

use super::text::lines;
use super::{Case, case};

/// All of them.
pub(crate) fn cases() -> Vec<Case> {
    let mut cases = endless();
    cases.extend(numbers());
    cases.extend(lists());
    cases
}

fn endless() -> Vec<Case> {
    let fibonacci = "fn f(n: Int) -> Int = if n < 2 then n else f(n - 1) + f(n - 2)\nlet a = f(60)\n";
    let ackermann = "fn a(m: Int, n: Int) -> Int =\n    if m == 0 then n + 1\n    else if n == 0 then a(m - 1, 1)\n    else a(m - 1, a(m, n - 1))\nlet x = a(4, 4)\n";
    let chain = |count: usize| lines(count, |i| format!("let a{} = a{i} + 1", i + 1)) + "let a0 = 1\n";
    vec![
        case("a function of itself", &["E0703"], "fn f(x: Number) -> Number = f(x)\nlet a = f(1)\n"),
        case("a growing one", &["E0703"], "fn f(x: Number) -> Number = f(x + 1) * 2\nlet a = f(1)\n"),
        case(
            "two of each other",
            &["E0703"],
            "fn f(n: Int) -> Int = g(n)\nfn g(n: Int) -> Int = f(n)\nlet a = f(1)\n",
        ),
        case("without a result type", &["E0305"], "fn f(n: Int) = f(n)\nlet a = f(1)\n"),
        case("exponential recursion", &["E0703"], fibonacci),
        case("Ackermann's function", &["E0703"], ackermann),
        case("a default of itself", &["E0703"], "fn f(n: Int = f()) -> Int = n\nlet a = f()\n"),
        case("a record of itself", &["E0305"], "record A { a: A = A() }\nlet a = A()\n"),
        case("lets in a circle", &["E0305"], "let a = b\nlet b = c\nlet c = a\nlet d = a\n"),
        case("a let of itself", &["E0305"], "let a = a\n"),
        case("a param of itself", &["E0305"], "param a: Int = a\n"),
        case("a figure of itself", &["E0305"], "figure f = f at level 3\n"),
        case("1,000 lets, each of the one before", &[], chain(1_000)),
    ]
}

fn numbers() -> Vec<Case> {
    let squares = |first: &str, count: usize| {
        format!("let a0 = {first}\n{}", lines(count, |i| format!("let a{} = a{i} * a{i}", i + 1)))
    };
    vec![
        case("squares of squares", &["E0604"], squares("1.0000001", 100)),
        case("lengths of lengths", &["E0402"], squares("3m", 20)),
        case("large exact numbers", &[], "let a = 1e300 * 1e300 * 1e300\n"),
        case("beyond doubles", &["E0604"], "let a = sqrt(2) * 1e300 * 1e300\n"),
        case("a long harmonic sum", &[], "let h = sum([1 / i for i in 1..20000])\n"),
        case(
            "divisions by zero",
            &["E0603"],
            "let a = 1 / 0\nlet b = 1m / 0m\nlet c = 0 / 0\nlet d = 1 / sin(0deg)\n",
        ),
        case("a point divided by zero", &["E0603"], "let p = (1m, 1m)\nlet a = (p + p) / 0\n"),
        case("a sine of a huge angle", &[], "let a = sin(1e300deg)\nlet b = cos(1e300rad)\n"),
        case("a root of a negative number", &["E0604"], "let a = sqrt(-1)\n"),
        case("a huge level", &["E0604"], figure("1000000000 * 1000000000 * 1000000000")),
        case("a level of a division by zero", &["E0603"], figure("floor(1 / 0)")),
        case("a level below 0", &["E0604"], figure("-1")),
    ]
}

fn lists() -> Vec<Case> {
    let doubled = format!("let a0 = [1]\n{}", lines(60, |i| format!("let a{} = [a{i}, a{i}]", i + 1)));
    let text = format!("let a = \"{}\"\nlet b = [a == a for i in 0..10000]\n", "x".repeat(100_000));
    vec![
        case("10^9 elements", &["E0704"], "let a = [i for i in 0..1000000000]\n"),
        case("10^18 elements", &["E0704"], "let a = [i for i in 0..1000000000000000000]\n"),
        case("10^9 elements left out", &["E0703"], "let a = [1 for i in 0..1000000000 if false]\n"),
        case(
            "10^9 elements in three clauses",
            &["E0704"],
            "let a = [i for i in 0..1000 for j in 0..1000 for k in 0..1000]\n",
        ),
        case(
            "10^9 elements in three lists",
            &["E0703"],
            "let a = [[[i for i in 0..1000] for j in 0..1000] for k in 0..1000]\n",
        ),
        case("a range backwards", &[], "let a = [i for i in 5..0]\n"),
        case("a part backwards", &["E0602"], "let a = [1, 2, 3]\nlet b = a[2..1]\n"),
        case("an element below 0", &["E0602"], "let a = [1]\nlet b = a[-1]\n"),
        case(
            "a part of everything",
            &["E0602"],
            "let a = [1]\nlet b = a[-9223372036854775808..9223372036854775807]\n",
        ),
        case("an element beyond counting", &["E0604"], "let a = [1]\nlet b = a[1000000000000000000000]\n"),
        case("lists doubled 60 times", &[], format!("{doubled}let n = len(a60)\n")),
        case("long texts compared", &[], text),
    ]
}

/// A curve at a level.
pub(crate) fn figure(level: &str) -> String {
    format!(
        "use std.curves (bezier2)\nfigure f = bezier2 on ((0m, 0m), (1m, 1m), (2m, 0m)) at level {level}\n"
    )
}
