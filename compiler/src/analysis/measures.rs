//! Which check measures what a requirement asks for.

use super::fabrication::Elements;
use super::requirements::LimitValue;
use crate::fabricate::checks::{self, CheckResult, bend_radius::BendLimit, overlap::Curve};
use crate::hir::schema::Measure;

/// Measures every element; a measure that does not apply to these elements (refused by the checker) measures nothing.
pub(super) fn measure(elements: &Elements, measure: Measure, limit: &LimitValue) -> CheckResult {
    match (elements, measure, limit) {
        (Elements::Panels(made), Measure::Planarity, LimitValue::Plain(limit)) => {
            checks::planarity::planarity(&made.panels, *limit)
        }
        (Elements::Panels(made), Measure::Edge, LimitValue::Plain(limit)) => {
            checks::edge::edge(&made.panels, *limit)
        }
        (Elements::Panels(made), Measure::BendRadius, LimitValue::Plain(limit)) => {
            checks::bend_radius::bend_radius(&made.panels, BendLimit::Radius(*limit))
        }
        (Elements::Panels(made), Measure::BendRadius, LimitValue::Grain(least)) => {
            checks::bend_radius::bend_radius(&made.panels, BendLimit::Grain(*least))
        }
        (Elements::Planks(made), Measure::Length, LimitValue::Plain(limit)) => {
            checks::length::length(&made.planks, *limit)
        }
        (Elements::Planks(made), Measure::Mitre, LimitValue::Plain(limit)) => {
            checks::mitre::mitre(&made.planks, *limit)
        }
        (Elements::Planks(made), Measure::Overlap, LimitValue::Plain(limit)) => {
            let curves: Vec<Curve<'_>> = made
                .figures
                .iter()
                .map(|figure| Curve { points: &figure.points, labels: &figure.labels, closed: figure.closed })
                .collect();
            checks::overlap::overlap(&curves, *limit)
        }
        _ => CheckResult::default(),
    }
}
