//! `require count`: how many boards or planks a figure has.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::label::Label;

/// One measurement: the number of elements. It is the figure's, and has no address.
#[must_use]
pub fn count(elements: usize, limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    tally.judge(elements as f64, limit, &Label::default(), String::new);
    tally.result
}
