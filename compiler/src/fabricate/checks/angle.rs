//! `require angle`: the angle at each corner of each board.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the interior angle at each of the four corners of every unrolled board, rad.
#[must_use]
pub fn angle(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        for (corner, angle) in panel.angles().into_iter().enumerate() {
            let place = || format!("between edges {} and {corner}", (corner + 3) % 4);
            tally.judge(angle, limit, &panel.label, place);
        }
    }
    tally.result
}
