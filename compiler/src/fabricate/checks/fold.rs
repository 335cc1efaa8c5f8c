//! `require fold`: the angle between the two triangles of each board (GEOMETRY section 5).

use super::{CheckResult, Limit, Tally};
use crate::fabricate::panel::Panel;

/// Measures the fold of every board over the diagonal it is split along, rad; 0 is flat.
#[must_use]
pub fn fold(panels: &[Panel], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for panel in panels {
        tally.judge(panel.fold, limit, &panel.label, String::new);
    }
    tally.result
}
