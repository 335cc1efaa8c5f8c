//! `require length`: the length of each plank between its end cuts, and of each board along its grain.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;
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

/// Measures every board along its grain, or along its longest side where the grain is free, mm: the length of the
/// blank it is cut from, as in the cut list.
#[must_use]
pub fn blank_length(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        tally.judge(panel.size().x, limit, &panel.label, String::new);
    }
    tally.result
}
