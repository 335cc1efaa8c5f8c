//! `require mitre`: the angle of each end cut at a joint.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::plank::Plank;

/// Measures the mitre of every end that meets another plank, rad, without its sign. The outer ends of a curve are
/// left out.
#[must_use]
pub fn mitre(planks: &[Plank], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for plank in planks {
        for (end, place) in ["start", "end"].into_iter().enumerate() {
            if plank.neighbours[end].is_some() {
                tally.judge(plank.mitres[end].abs(), limit, &plank.label, || place.to_owned());
            }
        }
    }
    tally.result
}
