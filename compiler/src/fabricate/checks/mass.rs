//! `require mass`: what each board or plank weighs.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::label::Label;

/// Measures the mass of every element, kg. Those of a material without density are left out.
#[must_use]
pub fn mass<'a>(elements: impl Iterator<Item = (&'a Label, Option<f64>)>, limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for (label, mass) in elements {
        if let Some(mass) = mass {
            tally.judge(mass, limit, label, String::new);
        }
    }
    tally.result
}
