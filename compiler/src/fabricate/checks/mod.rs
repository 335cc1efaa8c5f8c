//! What a design may require of its boards and planks, one file per requirement, and how a result is told.
//!
//! A check measures every element it is given and judges nothing else: elements that were refused never get here.

pub mod angle;
pub mod area;
pub mod bend_radius;
pub mod bevel;
pub mod count;
pub mod diagonal_ratio;
pub mod edge;
pub mod fold;
pub mod length;
pub mod limit;
pub mod mass;
pub mod mitre;
pub mod overlap;
pub mod planarity;
pub mod width;

use std::cmp::Ordering;

use super::label::Label;

pub use limit::Limit;

/// How many of the worst elements a result keeps.
pub const WORST_KEPT: usize = 20;

/// One element as measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The address of the board or plank.
    pub address: String,
    /// Its alias.
    pub alias: String,
    /// Where on it, or between what: "edge 2", "start", "between … and …". Empty where there is only one place.
    pub place: String,
    /// What was measured: mm, rad, or a cosine, as the check says.
    pub value: f64,
}

/// What a check found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CheckResult {
    /// The elements nearest to failing or farthest beyond the limit, the worst first, at most [`WORST_KEPT`]; of
    /// equals the one that came first.
    pub measured: Vec<Measured>,
    /// How many measurements are outside the limit.
    pub failing: usize,
    /// How many of those are below it; the others are above.
    pub below: usize,
    /// How many measurements there are.
    pub total: usize,
    /// The least and the largest value measured; none where nothing was.
    pub extremes: Option<(f64, f64)>,
    /// Every value measured, in the order of the elements.
    pub values: Vec<f64>,
}

impl CheckResult {
    /// Whether nothing is outside the limit.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.failing == 0
    }
}

/// Gathers measurements, and keeps the names of the worst only.
#[derive(Default)]
struct Tally {
    result: CheckResult,
    /// The shortfall of each of `result.measured`, largest first.
    shortfalls: Vec<f64>,
}

impl Tally {
    /// Counts a measurement. `shortfall` is how far it is beyond its limit, below 0 within it; `verdict` is greater for
    /// what is above the limit.
    fn add(
        &mut self,
        value: f64,
        shortfall: f64,
        verdict: Ordering,
        label: &Label,
        place: impl FnOnce() -> String,
    ) {
        self.result.total += 1;
        self.result.values.push(value);
        self.result.failing += usize::from(verdict.is_ne());
        self.result.below += usize::from(verdict.is_lt());
        let (least, most) = self.result.extremes.unwrap_or((value, value));
        self.result.extremes = Some((least.min(value), most.max(value)));
        let position = self.shortfalls.partition_point(|&kept| kept >= shortfall);
        if position < WORST_KEPT {
            let (address, alias) = (label.address.clone(), label.alias.clone());
            self.shortfalls.insert(position, shortfall);
            self.result.measured.insert(position, Measured { address, alias, place: place(), value });
            self.shortfalls.truncate(WORST_KEPT);
            self.result.measured.truncate(WORST_KEPT);
        }
    }

    /// Counts a measurement against a plain limit.
    fn judge(&mut self, value: f64, limit: Limit, label: &Label, place: impl FnOnce() -> String) {
        self.add(value, limit.shortfall(value), limit.verdict(value), label, place);
    }
}

#[cfg(test)]
mod tests;
