//! Random ifs against a second opinion: a small evaluator of weight vectors in fractions, written here, says whether
//! each image of a control point has weights that sum to 1, and the compiler must say the same.
//!
//! Without parameters the oracle works the weights out once. With a parameter it works them out at several values: an
//! image is a point for all of them exactly when its sum, a polynomial of the parameter of low degree, is 1 at more
//! values than its degree.

use ifs_compiler::analysis::analyse;
use ifs_compiler::diagnostic::Severity;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::MemoryFiles;
use ifs_tests::fraction::{Fraction, ONE, ZERO};
use proptest::prelude::*;

/// A number of a program: a fraction, the parameter, or one less the parameter.
#[derive(Clone, Debug)]
enum Number {
    Fraction(Fraction),
    Parameter,
    Rest,
}

impl Number {
    fn value(&self, parameter: Fraction) -> Fraction {
        match self {
            Number::Fraction(value) => *value,
            Number::Parameter => parameter,
            Number::Rest => ONE.plus(parameter.times(Fraction(-1, 1))),
        }
    }

    fn text(&self) -> String {
        match self {
            Number::Fraction(Fraction(a, 1)) if *a >= 0 => a.to_string(),
            Number::Fraction(Fraction(a, b)) => format!("({a} / {b})"),
            Number::Parameter => "t".to_owned(),
            Number::Rest => "(1 - t)".to_owned(),
        }
    }
}

/// A combination of control points.
#[derive(Clone, Debug)]
enum Combination {
    Point(usize),
    Add(Box<Combination>, Box<Combination>),
    Subtract(Box<Combination>, Box<Combination>),
    Times(Number, Box<Combination>, bool),
    Over(Box<Combination>, i128),
    Negated(Box<Combination>),
    Lerp(Box<Combination>, Box<Combination>, Number),
}

use Combination::{Add, Lerp, Negated, Over, Point, Subtract, Times};

impl Combination {
    /// Its weights, one for each control point.
    fn weights(&self, t: Fraction) -> Vec<Fraction> {
        let scaled = |inner: &Combination, factor: Fraction| -> Vec<Fraction> {
            inner.weights(t).into_iter().map(|weight| weight.times(factor)).collect()
        };
        let sum = |a: Vec<Fraction>, b: Vec<Fraction>| a.into_iter().zip(b).map(|(a, b)| a.plus(b)).collect();
        match self {
            Point(place) => (0..POINTS).map(|other| if other == *place { ONE } else { ZERO }).collect(),
            Add(a, b) => sum(a.weights(t), b.weights(t)),
            Subtract(a, b) => sum(a.weights(t), scaled(b, Fraction(-1, 1))),
            Times(factor, inner, _) => scaled(inner, factor.value(t)),
            Over(inner, divisor) => scaled(inner, Fraction::new(1, *divisor)),
            Negated(inner) => scaled(inner, Fraction(-1, 1)),
            Lerp(a, b, factor) => {
                let factor = factor.value(t);
                sum(scaled(a, ONE.plus(factor.times(Fraction(-1, 1)))), scaled(b, factor))
            }
        }
    }

    fn sum(&self, t: Fraction) -> Fraction {
        self.weights(t).into_iter().fold(ZERO, Fraction::plus)
    }

    /// As it is written. `lerp` takes points: its sides are points by construction.
    fn text(&self) -> String {
        match self {
            Point(place) => format!("p{place}"),
            Add(a, b) => format!("({} + {})", a.text(), b.text()),
            Subtract(a, b) => format!("({} - {})", a.text(), b.text()),
            Times(factor, inner, true) => format!("{} * {}", factor.text(), inner.text()),
            Times(factor, inner, false) => format!("({} * {})", inner.text(), factor.text()),
            Over(inner, divisor) => format!("{} / {divisor}", inner.text()),
            Negated(inner) => format!("(-{})", inner.text()),
            Lerp(a, b, factor) => format!("lerp({}, {}, {})", a.text(), b.text(), factor.text()),
        }
    }
}

const POINTS: usize = 3;

fn number() -> impl Strategy<Value = Number> + Clone {
    prop_oneof![
        4 => (-4_i128..=4, 1_i128..=4).prop_map(|(a, b)| Number::Fraction(Fraction::new(a, b))),
        2 => Just(Number::Parameter),
        2 => Just(Number::Rest),
    ]
}

/// A combination whose weights sum to 1 whatever the parameter is.
fn affine() -> impl Strategy<Value = Combination> {
    let point = (0..POINTS).prop_map(Point);
    point.prop_recursive(3, 12, 3, |inner| {
        let two = (inner.clone(), inner.clone(), number());
        let boxed = |a: &Combination| Box::new(a.clone());
        let middle = |(a, b): (Combination, Combination)| Over(Box::new(Add(Box::new(a), Box::new(b))), 2);
        let steps = move |(a, b, t): (Combination, Combination, Number)| {
            let step = Times(t, Box::new(Subtract(Box::new(b), boxed(&a))), false);
            Add(Box::new(a), Box::new(step))
        };
        let parts = |(a, b): (Combination, Combination)| {
            let (first, second) =
                (Times(Number::Rest, Box::new(a), true), Times(Number::Parameter, Box::new(b), false));
            Add(Box::new(first), Box::new(second))
        };
        prop_oneof![
            two.clone().prop_map(|(a, b, t)| Lerp(Box::new(a), Box::new(b), t)),
            two.prop_map(steps),
            (inner.clone(), inner.clone()).prop_map(middle),
            (inner.clone(), inner).prop_map(parts),
        ]
    })
}

/// Any combination; its weights rarely sum to 1.
fn any_sum() -> impl Strategy<Value = Combination> {
    affine().prop_recursive(3, 8, 2, |inner| {
        let two = (inner.clone(), inner.clone());
        prop_oneof![
            two.clone().prop_map(|(a, b)| Add(Box::new(a), Box::new(b))),
            two.prop_map(|(a, b)| Subtract(Box::new(a), Box::new(b))),
            (number(), inner.clone(), any::<bool>()).prop_map(|(t, a, left)| Times(t, Box::new(a), left)),
            (inner.clone(), 1_i128..=4).prop_map(|(a, by)| Over(Box::new(a), by)),
            inner.prop_map(|a| Negated(Box::new(a))),
        ]
    })
}

/// Images that are points by construction, and images that may be anything.
fn images() -> impl Strategy<Value = Vec<Combination>> {
    prop::collection::vec(prop_oneof![2 => affine().boxed(), 1 => any_sum().boxed()], POINTS)
}

/// The codes of the errors of an ifs with these images, and where the images stand.
fn verdict(images: &[Combination], parameter: &str) -> (Vec<(&'static str, usize)>, String) {
    let lines: Vec<String> = images.iter().map(|image| format!("    {},\n", image.text())).collect();
    let text = format!(
        "ifs c{parameter} on (p0, p1, p2) {{\n  transform only = self on (\n{}  )\n  germ segment(p0, p2)\n}}\n",
        lines.concat()
    );
    let analysis = analyse(&MemoryFiles::single("a.ifs", &text), "a.ifs", &Overrides::default());
    let errors = analysis.diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error);
    let line = |byte: u32| text[..byte as usize].matches('\n').count();
    (errors.map(|error| (error.code.name(), line(error.span.start))).collect(), text)
}

/// What the compiler ought to say: an error at the line of each image that is not a point.
fn expected(images: &[Combination], values: &[Fraction]) -> Vec<usize> {
    let wrong = |image: &Combination| values.iter().any(|value| image.sum(*value) != ONE);
    images.iter().enumerate().filter(|(_, image)| wrong(image)).map(|(place, _)| place + 2).collect()
}

/// E0501 where a sum may be anything, E0401 where its very form is that of a vector (a difference of two points).
fn agrees(images: &[Combination], parameter: &str, values: &[Fraction]) -> Result<(), TestCaseError> {
    let (errors, text) = verdict(images, parameter);
    let lines: Vec<usize> = errors.iter().map(|(_, line)| *line).collect();
    prop_assert_eq!(&lines, &expected(images, values), "{}\n{:?}", text, errors);
    let known = errors.iter().all(|(code, _)| matches!(*code, "E0501" | "E0401"));
    prop_assert!(known, "{}\n{:?}", text, errors);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn weights_with_a_parameter_are_judged_as_by_fractions(images in images()) {
        // No sum has a degree above 12 in the parameter: each operation raises it by 1 at most, along at most 9 of them.
        let values: Vec<Fraction> = (0..13).map(|value| Fraction::new(value - 5, 3)).collect();
        agrees(&images, "(t: Number)", &values)?;
    }

    #[test]
    fn weights_without_a_parameter_are_judged_as_by_fractions(images in images()) {
        let (errors, text) = {
            // The parameter has one value: it stands in the text instead.
            let value = Fraction(2, 5);
            let placed: Vec<Combination> = images.iter().map(|image| at(image, value)).collect();
            agrees(&placed, "", &[value])?;
            verdict(&placed, "")
        };
        prop_assert!(errors.len() <= POINTS, "{}", text);
    }
}

/// The combination with a value instead of the parameter.
fn at(image: &Combination, value: Fraction) -> Combination {
    let inner = |inner: &Combination| Box::new(at(inner, value));
    let number = |number: &Number| Number::Fraction(number.value(value));
    match image {
        Point(place) => Point(*place),
        Add(a, b) => Add(inner(a), inner(b)),
        Subtract(a, b) => Subtract(inner(a), inner(b)),
        Times(factor, a, left) => Times(number(factor), inner(a), *left),
        Over(a, by) => Over(inner(a), *by),
        Negated(a) => Negated(inner(a)),
        Lerp(a, b, factor) => Lerp(inner(a), inner(b), number(factor)),
    }
}
