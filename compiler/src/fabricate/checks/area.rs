//! `require area`: the area of each board.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the area of every board, mm².
#[must_use]
pub fn area(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        tally.judge(panel.area, limit, &panel.label, String::new);
    }
    tally.result
}
