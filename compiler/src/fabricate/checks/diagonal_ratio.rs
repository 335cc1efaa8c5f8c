//! `require diagonal ratio`: how far the diagonals of each board pass by each other (GEOMETRY section 5).

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the distance of the diagonals of every board by their mean length; 0 is flat.
#[must_use]
pub fn diagonal_ratio(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        // The diagonals of a convex quad are never parallel.
        tally.judge(panel.diagonal_ratio.unwrap_or(0.0), limit, &panel.label, String::new);
    }
    tally.result
}
