//! `require bevel`: how far each edge of each board is from a square cut (GEOMETRY section 8).

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the bevel at every side that meets another board, rad, without its sign. Sides on the border are left out.
/// A side two boards share is measured on both.
#[must_use]
pub fn bevel(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        for (side, bevel) in panel.bevels.iter().enumerate() {
            if let Some(bevel) = bevel {
                tally.judge(bevel.abs(), limit, &panel.label, || format!("edge {side}"));
            }
        }
    }
    tally.result
}
