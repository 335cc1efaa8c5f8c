//! Points of curves and surfaces, from a design's text through the compiler to doubles, against scipy and geomdl at
//! 1e-12 of the control points' size; and the middle point of De Casteljau, exactly.
#![allow(clippy::disallowed_methods, reason = "the tests write what the referees read")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;

use ifs_compiler::analysis::{Analysis, FigureGeometry};
use ifs_compiler::exact::Rational;
use ifs_compiler::plan::{FigurePlan, Shape, SheetPlan};
use ifs_tests::designs::{analysis_of, example_text, geometries};
use ifs_tests::referees::{Verdict, python_referee};
use ifs_tests::{root, scratch};
use serde_json::{Value, json};

/// What the referee is told of an ifs: kind, degree, split.
type Rule = (&'static str, u32, Option<f64>);

fn judge(test: &str, curves: Vec<Value>, surfaces: Vec<Value>) -> Verdict {
    let path = scratch(test).join("points.json");
    fs::write(&path, json!({"curves": curves, "surfaces": surfaces}).to_string()).unwrap();
    let verdict = python_referee("curves.py", &[&path]);
    println!("{test}: {}", verdict.counts);
    verdict
}

/// The evaluated figure of a name.
fn figure<'a>(analysis: &'a Analysis, name: &str) -> (&'a FigurePlan, FigureGeometry) {
    let plan = &analysis.plan.as_ref().unwrap().plan;
    let found =
        plan.figures().iter().zip(geometries(analysis)).find(|(figure, _)| figure.to_string() == name);
    let (plan, (_, geometry)) = found.unwrap();
    (plan, geometry)
}

fn curve(analysis: &Analysis, name: &str, (kind, degree, split): Rule) -> Value {
    let (plan, FigureGeometry::Curve(vertices)) = figure(analysis, name) else {
        panic!("{name} is no curve")
    };
    let mut vertices: Vec<[f64; 3]> = vertices.into_iter().map(|point| point.to_array()).collect();
    let (points, level, weights, closed) = match &plan.shape {
        Shape::Curve { points, level, .. } => (points, level, &None, false),
        Shape::Chain(chain) => (&chain.points, &chain.level, &chain.weights, chain.closed),
        _ => panic!("{name} is no curve"),
    };
    if closed {
        assert_eq!(vertices.pop(), vertices.first().copied(), "{name} ends where it began");
    }
    json!({
        "kind": kind, "degree": degree, "split": split, "level": level, "points": points, "weights": weights,
        "closed": closed, "vertices": vertices,
    })
}

fn surface(analysis: &Analysis, name: &str, rules: [Rule; 2]) -> Value {
    let (plan, FigureGeometry::Surface(mesh)) = figure(analysis, name) else {
        panic!("{name} is no surface")
    };
    let (SheetPlan { net, net_columns, levels, .. }, weights, closed) = match &plan.shape {
        Shape::Sheet(sheet) => (sheet, &None, (false, false)),
        Shape::Net(net) => (&net.sheet, &net.weights, net.closed),
        _ => panic!("{name} is no product"),
    };
    // The vertices lie row by row, v along a row; a closed row does not repeat its first one.
    let degree = rules[1].1 as usize;
    let windows = match (rules[1].0, closed.1) {
        ("bezier", _) => 1,
        (_, false) => net_columns - degree,
        (_, true) => *net_columns,
    };
    let columns = (windows << levels.1) + usize::from(!closed.1);
    let vertices: Vec<[f64; 3]> = mesh.vertices.iter().map(|point| point.to_array()).collect();
    json!({
        "kind": rules.map(|rule| rule.0), "degree": rules.map(|rule| rule.1), "split": rules.map(|rule| rule.2),
        "levels": [levels.0, levels.1],
        "net": net.chunks(*net_columns).collect::<Vec<_>>(),
        "weights": weights.as_ref().map(|weights| weights.chunks(*net_columns).collect::<Vec<_>>()),
        "closed": [closed.0, closed.1],
        "vertices": vertices.chunks(columns).collect::<Vec<_>>(),
    })
}

const BEZIER3: Rule = ("bezier", 3, None);
const BEZIER2: Rule = ("bezier", 2, None);
const BSPLINE3: Rule = ("bspline", 3, None);
const BSPLINE2: Rule = ("bspline", 2, None);

#[test]
fn the_examples_agree_with_scipy_and_geomdl() {
    let vault = analysis_of(&example_text("vault"));
    let splits = [0.46, 0.48, 0.50, 0.52, 0.54];
    let arches = splits.iter().enumerate();
    let arches =
        arches.map(|(i, t)| curve(&vault, &format!("vault[{i}]"), ("bezier", 3, Some(*t)))).collect();
    let shell = analysis_of(&example_text("shell"));
    let verdict = judge("curves-examples", arches, vec![surface(&shell, "shell", [BSPLINE3, BSPLINE3])]);
    assert!(verdict.good, "{}", verdict.faults);
    assert_eq!(
        (&verdict.counts["compared"], &verdict.counts["vertices"]),
        (&json!(6), &json!(5 * 17 + 17 * 17))
    );
}

/// Every ifs of `std.curves`, alone and in products, at several splits and levels.
const DESIGN: &str = "
use std.curves (bezier, bezier2, bezier3, bspline1, bspline2, bspline3, bspline4, bspline5, line)
use std.surfaces (tensor, sheet)

let net = [[ (i * 0.7m, j * 1.1m + i * 0.1m, 0.8m * sin(35deg * i) * cos(25deg * j)) for j in 0..7 ] for i in 0..6]

figure half    = bezier3 on ((0m, 0m), (0.5m, 2m), (3.5m, 2m), (4m, 0m)) at level 7
figure third   = bezier3(t: 1/3) on ((0m, 0m, 1m), (0.5m, 2m, 0m), (3.5m, 2m, -1m), (4m, 0m, 3m)) at level 6
figure early   = bezier3(t: 0.05) on ((0m, 0m), (0.5m, 2m), (3.5m, 2m), (4m, 0m)) at level 5
figure late    = bezier3(t: 0.93) on ((0m, 0m), (0.5m, 2m), (3.5m, 2m), (4m, 0m)) at level 5
figure parabola = bezier2(t: 0.4) on ((0m, 0m), (1m, 3m), (4m, 0m)) at level 6
figure chaikin = bspline2 on ((0m, 0m), (1m, 3m), (4m, 0m)) at level 6
figure cubic   = bspline3 on ((0m, 0m, 0m), (1m, 3m, 1m), (4m, 0m, 2m), (5m, 5m, 0m)) at level 6
figure quintic_arc = bezier(degree: 5, t: 0.4) on [(i * 1m, i * i * 0.2m) for i in 0..6] at level 4
figure ninth   = bezier(degree: 9) on [(i * 1m, 1m * sin(40deg * i), 1m * cos(50deg * i)) for i in 0..10] at level 4
figure polygon = bspline1 on ((0m, 0m), (1m, 3m)) at level 4
figure quartic = bspline4 on ((0m, 0m, 0m), (1m, 3m, 1m), (4m, 0m, 2m), (5m, 5m, 0m), (7m, 1m, 1m)) at level 5
figure quintic = bspline5 on ((0m, 0m), (1m, 3m), (4m, 0m), (5m, 5m), (7m, 1m), (9m, 0m)) at level 5
figure straight = line on ((0m, 0m), (4m, 1m)) at level 3
figure least   = bezier3(t: 0.46) on ((0m, 0m), (0.5m, 2m), (3.5m, 2m), (4m, 0m)) at level 0

figure patch   = tensor(bezier3, bezier3) on net[0..4, 0..4] at level (4, 3)
figure leaning = tensor(bezier3(t: 0.46), bezier2(t: 0.7)) on net[0..4, 2..5] at level (3, 4)
figure mixed   = tensor(bspline3, bezier2) on net[1..5, 0..3] at level (2, 3)
figure cloth   = sheet(bspline3, bspline3, net) at level (3, 2)
figure smooth  = sheet(bspline2, bspline2, net) at level 3
figure woven   = sheet(bspline3, bspline2, net) at level (1, 3)
figure folded  = sheet(bspline1, bspline4, net) at level (2, 3)
figure smoothest = sheet(bspline5, bspline5, net) at level 2
";

#[test]
fn every_curve_of_the_library_agrees_at_every_split_and_level() {
    let design = analysis_of(DESIGN);
    let bezier = |degree, split| ("bezier", degree, Some(split));
    let curves = [
        ("half", BEZIER3),
        ("third", bezier(3, 1.0 / 3.0)),
        ("early", bezier(3, 0.05)),
        ("late", bezier(3, 0.93)),
        ("parabola", bezier(2, 0.4)),
        ("chaikin", BSPLINE2),
        ("cubic", BSPLINE3),
        ("quintic_arc", bezier(5, 0.4)),
        ("ninth", ("bezier", 9, None)),
        ("polygon", ("bspline", 1, None)),
        ("quartic", ("bspline", 4, None)),
        ("quintic", ("bspline", 5, None)),
        ("straight", ("bezier", 1, None)),
        ("least", bezier(3, 0.46)),
    ];
    let surfaces = [
        ("patch", [BEZIER3, BEZIER3]),
        ("leaning", [bezier(3, 0.46), bezier(2, 0.7)]),
        ("mixed", [BSPLINE3, BEZIER2]),
        ("cloth", [BSPLINE3, BSPLINE3]),
        ("smooth", [BSPLINE2, BSPLINE2]),
        ("woven", [BSPLINE3, BSPLINE2]),
        ("folded", [("bspline", 1, None), ("bspline", 4, None)]),
        ("smoothest", [("bspline", 5, None), ("bspline", 5, None)]),
    ];
    let count = design.plan.as_ref().unwrap().plan.figures().len();
    assert_eq!(curves.len() + surfaces.len(), count, "each figure is compared");
    let verdict = judge(
        "curves-library",
        curves.map(|(name, rule)| curve(&design, name, rule)).into(),
        surfaces.map(|(name, rules)| surface(&design, name, rules)).into(),
    );
    assert!(verdict.good, "{}", verdict.faults);
    // The referee allows 1e-12 of the largest coordinate; these curves of metres stay within 1e-12 of one metre.
    for who in ["scipy", "geomdl"] {
        assert!(verdict.counts["worst"][who].as_f64().unwrap() <= 1e-9, "{}", verdict.counts);
    }
}

/// Chains of windows, open and closed; closed nets; rational curves and surfaces.
const ROUND: &str = "
use std.curves (bezier, bezier2, bezier3, bspline2, bspline3, chain)
use std.surfaces (tensor, sheet)

let c = sqrt(2) / 2
let list = [(i * 1m, 2m * sin(70deg * i), 0.3m * i * i) for i in 0..8]
let heavy = [weighted(list[i], w: 1 + i / 3) for i in 0..8]
let net = [[ weighted((i * 0.7m, j * 1.1m, 0.8m * sin(35deg * i) * cos(25deg * j)), w: 1 + i * j / 5) for j in 0..7 ] for i in 0..6]
let ring = [[ ((3m + 1m * cos(60deg * j)) * cos(45deg * i), (3m + 1m * cos(60deg * j)) * sin(45deg * i), 1m * sin(60deg * j)) for j in 0..6 ] for i in 0..8]

figure open    = chain(bspline3, list) at level 4
figure round   = chain(bspline3, list, closed: true) at level 4
figure chaikin = chain(bspline2, heavy, closed: true) at level 3
figure rope    = chain(bspline3, heavy) at level 5
figure quarter = bezier2 on ((1m, 0m), weighted((1m, 1m), w: c), (0m, 1m)) at level 8
figure leaning = bezier3(t: 0.3) on (list[0], weighted(list[1], w: 5), weighted(list[2], w: 0.2), list[3]) at level 5
figure window  = bspline3 on heavy[2..6] at level 5

figure torus   = sheet(bspline3, bspline3, ring, closed: uv) at level 3
figure around  = sheet(bspline3, bspline2, ring, closed: u) at level (2, 3)
figure tube    = sheet(bspline2, bspline3, ring, closed: v) at level (1, 2)
figure soft    = sheet(bspline3, bspline2, net) at level 2
figure closed  = sheet(bspline2, bspline3, net, closed: uv) at level 2
figure patch   = tensor(bezier2, bezier3(t: 0.6)) on net[0..3, 2..6] at level (4, 3)
figure dome    = tensor(bezier2, bezier2) on [
    [(1m, 0m, 0m), weighted((1m, 0m, 1m), w: c), (0m, 0m, 1m)],
    [weighted((1m, 1m, 0m), w: c), weighted((1m, 1m, 1m), w: c * c), weighted((0m, 0m, 1m), w: c)],
    [(0m, 1m, 0m), weighted((0m, 1m, 1m), w: c), (0m, 0m, 1m)],
] at level 5
";

#[test]
fn chains_closed_nets_and_rational_figures_agree() {
    let design = analysis_of(ROUND);
    let curves = [
        ("open", BSPLINE3),
        ("round", BSPLINE3),
        ("chaikin", BSPLINE2),
        ("rope", BSPLINE3),
        ("quarter", BEZIER2),
        ("leaning", ("bezier", 3, Some(0.3))),
        ("window", BSPLINE3),
    ];
    let surfaces = [
        ("torus", [BSPLINE3, BSPLINE3]),
        ("around", [BSPLINE3, BSPLINE2]),
        ("tube", [BSPLINE2, BSPLINE3]),
        ("soft", [BSPLINE3, BSPLINE2]),
        ("closed", [BSPLINE2, BSPLINE3]),
        ("patch", [BEZIER2, ("bezier", 3, Some(0.6))]),
        ("dome", [BEZIER2, BEZIER2]),
    ];
    let count = design.plan.as_ref().unwrap().plan.figures().len();
    assert_eq!(curves.len() + surfaces.len(), count, "each figure is compared");
    let verdict = judge(
        "curves-round",
        curves.map(|(name, rule)| curve(&design, name, rule)).into(),
        surfaces.map(|(name, rules)| surface(&design, name, rules)).into(),
    );
    assert!(verdict.good, "{}", verdict.faults);
}

/// An eighth of a sphere is one: rational points are divided, and sizes are measured after it.
#[test]
fn a_rational_dome_is_an_eighth_of_a_sphere() {
    let design = analysis_of(ROUND);
    let (_, FigureGeometry::Surface(dome)) = figure(&design, "dome") else { panic!("no surface") };
    let (_, FigureGeometry::Curve(quarter)) = figure(&design, "quarter") else { panic!("no curve") };
    for point in dome.vertices.iter().chain(&quarter) {
        assert!((point.length() - 1000.0).abs() <= 1000.0 * 1e-12, "{point}");
    }
}

/// The referee sees weights that are lost.
#[test]
fn a_circle_without_its_weights_is_refused() {
    let mut quarter = curve(&analysis_of(ROUND), "quarter", BEZIER2);
    quarter["weights"] = Value::Null;
    assert!(!judge("curves-lost", vec![quarter], Vec::new()).good);
}

/// The paper's program: the first one of the README, as it stands there.
fn paper_program() -> String {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    readme.split("```ifs\n").nth(1).unwrap().split("```").next().unwrap().to_owned()
}

/// The weights of the last point of the first transform and of the first point of the second.
fn middle(text: &str) -> [Vec<Rational>; 2] {
    let analysis = analysis_of(text);
    let states = analysis.plan.as_ref().unwrap().plan.automaton().states();
    let [left, right] = states[0].transforms.as_slice() else { panic!("two transforms") };
    assert_eq!((left.name.as_str(), right.name.as_str()), ("left", "right"));
    [left.matrix.row(3).to_vec(), right.matrix.row(0).to_vec()]
}

fn eighths(weights: [i64; 4]) -> Vec<Rational> {
    let eighth = |n: i64| Rational::new(n, 8).unwrap();
    weights.map(eighth).to_vec()
}

const LIBRARY: &str = "use std.curves (bezier3)
figure curve = bezier3 on ((0m, 0m), (0.5m, 2m), (3.5m, 2m), (4m, 0m)) at level 4
";

#[test]
fn de_casteljaus_middle_point_is_exact_in_the_library_and_in_the_papers_program() {
    for (whose, text) in [("the library's", LIBRARY.to_owned()), ("the paper's", paper_program())] {
        assert_eq!(middle(&text), [eighths([1, 3, 3, 1]), eighths([1, 3, 3, 1])], "{whose}");
        let verdict = judge("curves-middle", vec![curve(&analysis_of(&text), "curve", BEZIER3)], Vec::new());
        assert!(verdict.good, "{whose}: {}", verdict.faults);
    }
}

/// The formula as it is printed, `P3' = (P2' + P1') / 2`, is not De Casteljau's: what pins the right one sees it.
#[test]
fn the_slip_of_the_printed_paper_is_another_curve() {
    let printed = paper_program().replace("let m = lerp(b, c, t)", "let m = lerp(a, b, t)");
    assert_eq!(middle(&printed), [eighths([3, 4, 1, 0]), eighths([3, 4, 1, 0])]);
    let verdict = judge("curves-slip", vec![curve(&analysis_of(&printed), "curve", BEZIER3)], Vec::new());
    assert!(!verdict.good);
}
