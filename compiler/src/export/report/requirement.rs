//! The part of the report on what the design requires.

use serde::Serialize;

use super::Distribution;
use crate::export::number::Fixed;
use crate::fabricate::checks::{CheckResult, Measured};

/// A `require` and what came of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Requirement {
    /// As the design writes it.
    pub text: String,
    /// What is measured: `edge`, `bend radius`.
    pub measure: &'static str,
    /// Whether everything measured is within it.
    pub holds: bool,
    /// The unit of the figures below: `mm`, `m2`, `kg`, `deg`, or none for plain numbers.
    pub unit: Option<&'static str>,
    /// What the figures are held against.
    pub limits: Vec<LimitReport>,
    /// How many measurements are outside it.
    pub failing: usize,
    /// How many measurements there are.
    pub total: usize,
    /// The least measured.
    pub least: Option<Fixed>,
    /// The largest measured.
    pub most: Option<Fixed>,
    /// How the figures are spread between these two.
    pub distribution: Option<Distribution>,
    /// The worst, the worst first.
    pub worst: Vec<WorstReport>,
}

/// A bound of a requirement.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LimitReport {
    /// `at least`, `at most`, `above`, `below` or `equal to`; with `across the grain` or `along the grain` where the
    /// bound depends on it.
    pub words: &'static str,
    /// The bound, in the unit of the requirement.
    pub value: Fixed,
}

/// One of the worst elements of a requirement.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WorstReport {
    /// Its address.
    pub address: String,
    /// Its alias.
    pub alias: String,
    /// Where on it.
    pub place: String,
    /// What was measured.
    pub value: Fixed,
}

/// What a requirement measures, and so how its figures are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// mm
    Length,
    /// Measured in mm², written in m².
    Area,
    /// kg
    Mass,
    /// Measured in rad, written in degrees.
    Angle,
    /// A planarity, without a unit.
    Planarity,
    /// A diagonal ratio, without a unit.
    Ratio,
    /// A whole number.
    Count,
}

impl Requirement {
    /// The result of a check of `measure`, asked for by what the design writes as `text`, against limits in words with
    /// their values in the unit of the measurement.
    #[must_use]
    pub fn of(
        text: &str,
        measure: &'static str,
        quantity: Quantity,
        limits: &[(&'static str, f64)],
        result: &CheckResult,
    ) -> Self {
        let (unit, number): (_, fn(f64) -> Fixed) = match quantity {
            Quantity::Length => (Some("mm"), Fixed::mm),
            Quantity::Angle => (Some("deg"), Fixed::degrees),
            Quantity::Area => (Some("m2"), Fixed::square_metres),
            Quantity::Mass => (Some("kg"), Fixed::kilograms),
            Quantity::Planarity => (None, Fixed::planarity),
            Quantity::Ratio => (None, Fixed::ratio),
            Quantity::Count => (None, |value| Fixed { value, decimals: 0 }),
        };
        let worst = |measured: &Measured| WorstReport {
            address: measured.address.clone(),
            alias: measured.alias.clone(),
            place: measured.place.clone(),
            value: number(measured.value),
        };
        Self {
            text: text.to_owned(),
            measure,
            holds: result.holds(),
            unit,
            limits: limits
                .iter()
                .map(|&(words, value)| LimitReport { words, value: number(value) })
                .collect(),
            failing: result.failing,
            total: result.total,
            least: result.extremes.map(|(least, _)| number(least)),
            most: result.extremes.map(|(_, most)| number(most)),
            distribution: Distribution::of(result.values.iter().copied(), number),
            worst: result.measured.iter().map(worst).collect(),
        }
    }
}
