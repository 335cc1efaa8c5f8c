//! Ifs with many control points, states or long weights, and figures of strange control points.

use std::iter::successors;

use super::evaluation::figure;
use super::text::lines;
use super::{Case, case};

/// All of them.
pub(crate) fn cases() -> Vec<Case> {
    let mut cases = ifs();
    cases.extend(states());
    cases.extend(curves());
    cases.extend(surfaces());
    cases
}

fn ifs() -> Vec<Case> {
    let digits = format!("0.{}", "123456789".repeat(40));
    vec![
        case("300 control points", &[], halves(300)),
        case("a Bézier curve of degree 29", &[], bezier(30)),
        case("a Bézier curve of degree 99", &[], bezier(100)),
        case(
            "weights of 360 digits",
            &["E0104"],
            format!(
                "use std.curves (bezier2)\nfigure f = bezier2(t: {digits}) on ((0m, 0m), (1m, 1m), (2m, 0m)) at level 9\n"
            ),
        ),
        case(
            "weights of 90 digits",
            &[],
            format!(
                "use std.curves (bezier2)\nfigure f = bezier2(t: {}) on ((0m, 0m), (1m, 1m), (2m, 0m)) at level 9\n",
                &digits[..92]
            ),
        ),
        case(
            "a tiny weight",
            &[],
            "use std.curves (bezier2)\nfigure f = bezier2(t: 1e-300) on ((0m, 0m), (1m, 1m), (2m, 0m)) at level 9\n",
        ),
        case(
            "a polynomial of degree 300",
            &[],
            two(&lines(300, |i| format!("let m{} = lerp(m{i}, b, t)", i + 1)), "m300"),
        ),
        case(
            "a polynomial squared 40 times",
            &["W0508"],
            two(
                &format!("let s0 = t\n{}", lines(40, |i| format!("let s{} = s{i} * s{i} / 2", i + 1))),
                "lerp(a, b, s40)",
            ),
        ),
        case("2,000 transforms", &[], many_transforms(2_000)),
        case("a weight divided by zero", &["E0603"], two("", "(a + b) / 0")),
        case("a weight divided by a zero argument", &["E0603"], two("", "lerp(a, b, t / (2 * t - 1))")),
    ]
}

fn states() -> Vec<Case> {
    let argument = |left: &str, right: &str| {
        format!(
            "ifs c(n: Int) on (a, b) {{\n transform l = self(n: {left}) on (a, lerp(a, b, 1/2))\n transform r = self(n: {right}) on (lerp(a, b, 1/2), b)\n germ segment(a, b)\n}}\nfigure f = c(1) on ((0m, 0m), (1m, 0m)) at level 5\n"
        )
    };
    vec![
        case("states without an end", &["E0702"], argument("2 * n", "2 * n + 1")),
        case("a chain of states", &["E0702"], argument("n + 1", "n + 1")),
        case("991 states", &[], argument("if n > 990 then 0 else n + 1", "if n > 480 then 0 else 2 * n")),
    ]
}

fn curves() -> Vec<Case> {
    let on = |points: &str| {
        format!(
            "use std.curves (bezier2)\nuse std.materials (sawn_spruce)\nfigure f = bezier2 on ({points}) at level 5\nfabricate f as planks {{ material: sawn_spruce  section: 10cm by 4cm  stock: 4m }}\n"
        )
    };
    vec![
        case("level 40", &["E0701"], figure("40")),
        case("level 1,000,000,000", &["E0701"], figure("1000000000")),
        case("equal control points", &["E0805"], on("(0m, 0m), (0m, 0m), (0m, 0m)")),
        case("a curve back to its start", &["E0805"], on("(0m, 0m), (1m, 0m), (0m, 0m)")),
        case("huge coordinates", &["E0802"], on("(0m, 0m), (1e300mm, 1m), (2m, 0m)")),
        case("tiny coordinates", &["E0805"], on("(0m, 0m), (1e-300mm, 0m), (2e-300mm, 0m)")),
        case(
            "100,000 figures",
            &[],
            "use std.curves (bezier2)\nfigure f = [bezier2 on ((0m, i * 1cm), (1m, 1m), (2m, 0m)) at level 1 for i in 0..100000]\n",
        ),
        case(
            "5,000 states of figures",
            &["E0702"],
            "use std.curves (bezier2)\nfigure f = [bezier2(t: (i + 1) / 5002) on ((0m, 0m), (1m, 1m), (2m, 0m)) at level 1 for i in 0..5000]\n",
        ),
    ]
}

fn surfaces() -> Vec<Case> {
    let sheet = |net: &str| {
        format!(
            "use std.curves (bspline2)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\nfigure s = sheet(bspline2, bspline2, {net}) at level 1\nfabricate s as panels {{ material: birch_plywood(12mm)  board: 2.5m by 1.25m  planarize: {{}} }}\n"
        )
    };
    let net = |point: &str| sheet(&format!("[[{point} for i in 0..5] for j in 0..5]"));
    vec![
        case("an empty net", &["E0510"], sheet("[[]]")),
        case("a net of one row", &["E0510"], sheet("[[(i * 1m, 0m, 0m) for i in 0..5]]")),
        case("a net of equal points", &["E0805"], net("(0m, 0m, 0m)")),
        case("a net on a line", &["E0805"], net("(i * 1m, 0m, 0m)")),
        case("a huge net", &["E0802"], net("(i * 1e300m, j * 1m, 0m)")),
        case(
            "more steps than allowed",
            &["E0804"],
            net("(i * 1m, j * 1m, 0m)").replace("{}", "{ iterations: 1000000000 }"),
        ),
        case(
            "fewer steps than none",
            &["E0804"],
            net("(i * 1m, j * 1m, 0m)").replace("{}", "{ iterations: -1 }"),
        ),
    ]
}

/// An ifs on two points with some lets, split at a point.
fn two(lets: &str, middle: &str) -> String {
    format!(
        "ifs c(t: Number = 1/2) on (a, b) {{\nlet m0 = a\n{lets}let m = {middle}\ntransform l = self on (a, m)\ntransform r = self on (m, b)\ngerm segment(a, b)\n}}\nfigure f = c on ((0m, 0m), (1m, 0m)) at level 1\n"
    )
}

fn many_transforms(count: usize) -> String {
    let transforms = lines(count, |i| {
        format!("transform t{i} = self on (lerp(a, b, {i}/{count}), lerp(a, b, {}/{count}))", i + 1)
    });
    format!(
        "ifs c on (a, b) {{\n{transforms}germ segment(a, b)\n}}\nfigure f = c on ((0m, 0m), (1m, 0m)) at level 1\n"
    )
}

fn list(points: impl IntoIterator<Item = String>) -> String {
    points.into_iter().collect::<Vec<_>>().join(", ")
}

/// Every point halfway to the first, and halfway to the last.
fn halves(count: usize) -> String {
    let last = count - 1;
    let points = list((0..count).map(|i| format!("p{i}")));
    let left = list((0..count).map(|i| format!("lerp(p0, p{i}, 1/2)")));
    let right = list((0..count).map(|i| format!("lerp(p{i}, p{last}, 1/2)")));
    placed(&points, "", &left, &right, count)
}

/// De Casteljau's algorithm at a parameter.
fn bezier(count: usize) -> String {
    let name = |row: usize, i: usize| if row == 0 { format!("p{i}") } else { format!("q{row}_{i}") };
    let rows = successors(Some(1), |row| Some(row + 1)).take(count - 1);
    let lets: String = rows
        .flat_map(|row| (0..count - row).map(move |i| (row, i)))
        .map(|(row, i)| {
            format!("let {} = lerp({}, {}, t)\n", name(row, i), name(row - 1, i), name(row - 1, i + 1))
        })
        .collect();
    let points = list((0..count).map(|i| name(0, i)));
    let left = list((0..count).map(|row| name(row, 0)));
    let right = list((0..count).rev().map(|row| name(row, count - 1 - row)));
    placed(&points, &lets, &left, &right, count)
}

fn placed(points: &str, lets: &str, left: &str, right: &str, count: usize) -> String {
    let last = count - 1;
    format!(
        "ifs c(t: Number = 1/3) on ({points}) {{\n{lets}transform l = self on ({left})\ntransform r = self on ({right})\ngerm segment(p0, p{last})\n}}\nfigure f = c on [(i * 1m, 0m) for i in 0..{count}] at level 5\n"
    )
}
