//! `require edge`: the length of each side of each board.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the four sides of every board, mm. A side two boards share is measured on both.
#[must_use]
pub fn edge(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        for (side, &length) in panel.edges.iter().enumerate() {
            tally.judge(length, limit, &panel.label, || format!("edge {side}"));
        }
    }
    tally.result
}
