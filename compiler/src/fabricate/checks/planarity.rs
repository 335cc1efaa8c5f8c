//! `require planarity`: the cosine of GEOMETRY section 5 of each board.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the planarity of every board; 1 is flat.
#[must_use]
pub fn planarity(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        tally.judge(panel.planarity, limit, &panel.label, String::new);
    }
    tally.result
}
