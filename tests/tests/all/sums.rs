//! Weighted sums that are named, divided later, handed to functions and kept in lists, against a second opinion: the
//! oracle follows each sum in fractions and says where something that is no point, or no vector, is taken for one.

use ifs_compiler::analysis::analyse;
use ifs_compiler::diagnostic::Severity;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::MemoryFiles;
use ifs_tests::fraction::{Fraction, ONE, ZERO};
use proptest::prelude::*;

/// The functions of every program.
const FUNCTIONS: &str = "fn middle(a: Point, b: Point) -> Point = (a + b) / 2\n\
                         fn third(v: Vector) -> Vector = v / 3\n\
                         fn share(i: Int, n: Number) -> Number = n / i\n";

const POINTS: usize = 3;

/// A line of a program, which names one more sum. Sums are meant by their place: control points first, then lines.
#[derive(Clone, Debug)]
enum Line {
    /// `a * s + b * s`
    Weighted(Factor, usize, Factor, usize),
    /// `s / n`
    Over(usize, i128),
    /// `s - s`
    Difference(usize, usize),
    /// `sum([a * s, b * s, s])`
    Sum(Factor, usize, Factor, usize, usize),
    /// `[s, s][i]`
    Picked(usize, usize, bool),
    /// `middle(s, s)`, which takes points.
    Middle(usize, usize),
    /// `third(s)`, which takes a vector.
    Third(usize),
    /// `lerp(s, s, t)`, which takes points.
    Lerp(usize, usize, Factor),
}

/// A number: a fraction, the parameter, 1 less it, or a share of it worked out by a function.
#[derive(Clone, Copy, Debug)]
enum Factor {
    Fraction(Fraction),
    Parameter,
    Rest,
    Share(i128),
}

impl Factor {
    fn value(self, t: Fraction) -> Fraction {
        match self {
            Factor::Fraction(value) => value,
            Factor::Parameter => t,
            Factor::Rest => ONE.plus(minus(t)),
            Factor::Share(parts) => t.times(Fraction::new(1, parts)),
        }
    }

    fn text(self) -> String {
        match self {
            Factor::Fraction(Fraction(a, b)) => format!("({a} / {b})"),
            Factor::Parameter => "t".to_owned(),
            Factor::Rest => "(1 - t)".to_owned(),
            Factor::Share(parts) => format!("share({parts}, t)"),
        }
    }
}

fn minus(value: Fraction) -> Fraction {
    value.times(Fraction(-1, 1))
}

/// The name of a sum.
fn name(place: usize) -> String {
    if place < POINTS { format!("p{place}") } else { format!("s{}", place - POINTS) }
}

impl Line {
    fn text(&self) -> String {
        match *self {
            Line::Weighted(a, x, b, y) => format!("{} * {} + {} * {}", a.text(), name(x), name(y), b.text()),
            Line::Over(x, by) => format!("{} / {by}", name(x)),
            Line::Difference(x, y) => format!("{} - {}", name(x), name(y)),
            Line::Sum(a, x, b, y, z) => {
                format!("sum([{} * {}, {} * {}, 1 * {}])", a.text(), name(x), b.text(), name(y), name(z))
            }
            Line::Picked(x, y, first) => {
                format!("[1 * {}, 1 * {}][{}]", name(x), name(y), usize::from(!first))
            }
            Line::Middle(x, y) => format!("middle({}, {})", name(x), name(y)),
            Line::Third(x) => format!("third({})", name(x)),
            Line::Lerp(x, y, t) => format!("lerp({}, {}, {})", name(x), name(y), t.text()),
        }
    }

    /// The weight of the sum at a parameter; `None` where something is taken for what it is not.
    fn weight(&self, sums: &[Fraction], t: Fraction) -> Option<Fraction> {
        let half = Fraction(1, 2);
        let point = |place: usize| (sums[place] == ONE).then_some(sums[place]);
        Some(match *self {
            Line::Weighted(a, x, b, y) => sums[x].times(a.value(t)).plus(sums[y].times(b.value(t))),
            Line::Over(x, by) => sums[x].times(Fraction::new(1, by)),
            Line::Difference(x, y) => sums[x].plus(minus(sums[y])),
            Line::Sum(a, x, b, y, z) => {
                sums[x].times(a.value(t)).plus(sums[y].times(b.value(t))).plus(sums[z])
            }
            Line::Picked(x, y, first) => sums[if first { x } else { y }],
            Line::Middle(x, y) => point(x)?.plus(point(y)?).times(half),
            Line::Third(x) => (sums[x] == ZERO).then_some(ZERO)?,
            Line::Lerp(x, y, _) => point(x).and(point(y))?,
        })
    }
}

fn factor() -> impl Strategy<Value = Factor> {
    prop_oneof![
        3 => (-2_i128..=3, 1_i128..=3).prop_map(|(a, b)| Factor::Fraction(Fraction::new(a, b))),
        2 => Just(Factor::Fraction(ONE)),
        2 => Just(Factor::Parameter),
        2 => Just(Factor::Rest),
        1 => (1_i128..=3).prop_map(Factor::Share),
    ]
}

/// A line that may use the control points and `known` lines before it.
fn line(known: usize) -> impl Strategy<Value = Line> {
    let sum = 0..POINTS + known;
    let two = (sum.clone(), sum.clone());
    // Affine by construction where what it is made of is: these make programs that are right often enough.
    let blend = (
        sum.clone(),
        sum.clone(),
        prop_oneof![
            Just((Factor::Parameter, Factor::Rest)),
            Just((Factor::Fraction(Fraction(1, 4)), Factor::Fraction(Fraction(3, 4)))),
        ],
    );
    prop_oneof![
        3 => blend.prop_map(|(x, y, (a, b))| Line::Weighted(a, x, b, y)),
        1 => (factor(), sum.clone(), factor(), sum.clone()).prop_map(|(a, x, b, y)| Line::Weighted(a, x, b, y)),
        2 => (sum.clone(), 1_i128..=3).prop_map(|(x, by)| Line::Over(x, by)),
        1 => two.clone().prop_map(|(x, y)| Line::Difference(x, y)),
        1 => (factor(), sum.clone(), factor(), sum.clone(), sum.clone())
            .prop_map(|(a, x, b, y, z)| Line::Sum(a, x, b, y, z)),
        1 => (sum.clone(), sum.clone(), any::<bool>()).prop_map(|(x, y, first)| Line::Picked(x, y, first)),
        1 => two.prop_map(|(x, y)| Line::Middle(x, y)),
        1 => sum.clone().prop_map(Line::Third),
        1 => (sum.clone(), sum, factor()).prop_map(|(x, y, t)| Line::Lerp(x, y, t)),
    ]
}

fn lines() -> impl Strategy<Value = Vec<Line>> {
    (line(0), line(1), line(2), line(3)).prop_map(|(a, b, c, d)| vec![a, b, c, d])
}

/// Whether the program is right at this parameter: every line, and the last one a point.
fn is_right(lines: &[Line], t: Fraction) -> bool {
    let mut sums = vec![ONE; POINTS];
    for line in lines {
        match line.weight(&sums, t) {
            Some(weight) => sums.push(weight),
            None => return false,
        }
    }
    sums.last() == Some(&ONE)
}

fn program(lines: &[Line]) -> String {
    let lets: String =
        lines.iter().enumerate().map(|(place, line)| format!("  let s{place} = {}\n", line.text())).collect();
    let last = name(POINTS + lines.len() - 1);
    format!(
        "{FUNCTIONS}ifs c(t: Number) on (p0, p1, p2) {{\n{lets}  transform only = self on (p0, {last}, p2)\n  \
         germ segment(p0, p2)\n}}\n"
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn named_sums_are_judged_as_by_fractions(lines in lines()) {
        let text = program(&lines);
        let analysis = analyse(&MemoryFiles::single("a.ifs", &text), "a.ifs", &Overrides::default());
        let errors: Vec<&str> = analysis
            .diagnostics
            .iter()
            .filter(|found| found.severity() == Severity::Error)
            .map(|found| found.code.name())
            .collect();
        // Each line raises the degree of a weight in the parameter by one at most.
        let right = (0..7).all(|value| is_right(&lines, Fraction::new(value - 3, 2)));
        prop_assert_eq!(errors.is_empty(), right, "{}{:?}", text, errors);
        let known = errors.iter().all(|code| matches!(*code, "E0501" | "E0502" | "E0401" | "E0402"));
        prop_assert!(known, "{}{:?}", text, errors);
    }
}
