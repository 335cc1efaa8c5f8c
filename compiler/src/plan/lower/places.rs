//! Places in words: weights on control points as they are, weights on the frame of plane or space as coordinates.

use crate::exact::Rational;
use crate::hir::dimension::Dimension;
use crate::hir::evaluate::quantity_words;
use crate::ifs::{State, StateSpace};

/// Fractions written out up to this length; longer ones, which come of rounded numbers, as decimals.
const LONGEST_FRACTION: usize = 12;

/// Where a point of these weights on the points of a state lies: `1/2 p0 + 1/2 p1`, or `(1000mm, 250mm)`.
pub(super) fn place_words(state: &State, row: &[Rational]) -> String {
    match state.space {
        StateSpace::Control => weights(row, &state.point_names),
        StateSpace::Plane | StateSpace::Space => {
            format!("({})", coordinates(row).map(millimetres).collect::<Vec<_>>().join(", "))
        }
    }
}

/// How far two places are from each other: `1/3 p0 - 1/3 p1`, or `333.333mm`.
pub(super) fn gap_words(state: &State, [left, right]: [&[Rational]; 2]) -> String {
    let difference: Vec<Rational> = left.iter().zip(right).map(|(left, right)| left - right).collect();
    match state.space {
        StateSpace::Control => weights(&difference, &state.point_names),
        StateSpace::Plane | StateSpace::Space => millimetres(coordinates(&difference).fold(0.0, libm::hypot)),
    }
}

/// In millimetres: the points of the frame but the origin lie 1 mm from it.
fn coordinates(row: &[Rational]) -> impl Iterator<Item = f64> {
    row.iter().skip(1).map(Rational::to_f64)
}

fn millimetres(length: f64) -> String {
    let tiny = length != 0.0 && libm::fabs(length) < 0.0005;
    if tiny { format!("{length:.1e}mm") } else { quantity_words(length, Dimension::LENGTH) }
}

/// `1/2 p0 - 1/2 p1`
pub(super) fn weights(weights: &[Rational], names: &[String]) -> String {
    let mut words = String::new();
    for (weight, name) in weights.iter().zip(names).filter(|(weight, _)| !weight.is_zero()) {
        words.push_str(match (words.is_empty(), weight.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        let size = weight.abs();
        if !size.is_one() {
            words.push_str(&format!("{} ", number(&size)));
        }
        words.push_str(name);
    }
    if words.is_empty() { "nothing".to_owned() } else { words }
}

fn number(size: &Rational) -> String {
    let exact = size.to_string();
    let value = size.to_f64();
    match () {
        () if exact.len() <= LONGEST_FRACTION => exact,
        () if value < 0.0001 => format!("{value:.1e}"),
        () => quantity_words(value, Dimension::NUMBER),
    }
}
