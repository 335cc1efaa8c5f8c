//! `require width`: how narrow each board is.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the least width of every board, mm: the least distance of two parallel lines with its outline between
/// them, whatever its grain.
#[must_use]
pub fn width(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        tally.judge(panel.least_width(), limit, &panel.label, String::new);
    }
    tally.result
}
