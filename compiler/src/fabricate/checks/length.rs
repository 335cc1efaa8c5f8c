//! `require length`: the length of each plank between its end cuts.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::plank::Plank;

/// Measures every plank on its axis, mm.
#[must_use]
pub fn length(planks: &[Plank], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for plank in planks {
        tally.judge(plank.length, limit, &plank.label, String::new);
    }
    tally.result
}
