//! `require bend radius`: the radius to which each board bends, against one limit or against its grain.

use super::{CheckResult, Limit, Tally};
use crate::fabricate::material::LeastBendRadius;
use crate::fabricate::panel::Panel;

/// What the bend of a board is held against, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BendLimit {
    /// The same limit for every board.
    Radius(Limit),
    /// At least the radius the material takes, by the angle between the bend axis and the grain
    /// ([`LeastBendRadius::at`]); the larger of the two where the grain is free.
    Grain(LeastBendRadius),
}

/// Measures the bend radius of every board, mm. A flat board has none and always passes: it counts, and is not
/// among the extremes. Against the grain, the worst is the one with the smallest part of the radius it needs.
#[must_use]
pub fn bend_radius(panels: &[Panel], limit: BendLimit) -> CheckResult {
    let mut tally = Tally::default();
    let mut flat = 0;
    for panel in panels {
        let Some(radius) = panel.bend_radius else {
            flat += 1;
            continue;
        };
        match limit {
            BendLimit::Radius(limit) => tally.judge(radius, limit, &panel.label, String::new),
            BendLimit::Grain(least) => {
                let axis = panel.bend_axis_to_grain;
                let needed = axis.map_or(least.any_direction(), |angle| least.at(angle));
                let verdict = Limit::AtLeast(needed).verdict(radius);
                tally.add(radius, needed / radius - 1.0, verdict, &panel.label, || place(axis, needed));
            }
        }
    }
    tally.result.total += flat;
    tally.result
}

fn place(axis_to_grain: Option<f64>, needed: f64) -> String {
    match axis_to_grain {
        Some(angle) => {
            format!("bend axis at {:.1}deg to the grain, needs {needed:.0}mm", angle.to_degrees())
        }
        None => format!("grain free, needs {needed:.0}mm"),
    }
}
