//! Which check measures what a requirement asks for.

use super::fabrication::{Elements, PanelsMade, PlanksMade};
use super::requirements::LimitValue;
use crate::fabricate::checks::{self, CheckResult, Limit, bend_radius::BendLimit, overlap::Curve};
use crate::hir::schema::Measure;

/// Measures every element; a measure that does not apply to these elements (refused by the checker) measures nothing.
pub(super) fn measure(elements: &Elements, measure: Measure, limit: &LimitValue) -> CheckResult {
    match (elements, limit) {
        (Elements::Panels(made), LimitValue::Grain(least)) => {
            checks::bend_radius::bend_radius(&made.panels, BendLimit::Grain(*least))
        }
        (Elements::Panels(made), LimitValue::Plain(limit)) => of_panels(made, measure, *limit),
        (Elements::Planks(made), LimitValue::Plain(limit)) => of_planks(made, measure, *limit),
        (Elements::Planks(_), LimitValue::Grain(_)) => CheckResult::default(),
    }
}

fn of_panels(made: &PanelsMade, measure: Measure, limit: Limit) -> CheckResult {
    let panels = &made.panels;
    match measure {
        Measure::Planarity => checks::planarity::planarity(panels, limit),
        Measure::Fold => checks::fold::fold(panels, limit),
        Measure::DiagonalRatio => checks::diagonal_ratio::diagonal_ratio(panels, limit),
        Measure::Edge => checks::edge::edge(panels, limit),
        Measure::Length => checks::length::blank_length(panels, limit),
        Measure::Width => checks::width::width(panels, limit),
        Measure::Area => checks::area::area(panels, limit),
        Measure::Angle => checks::angle::angle(panels, limit),
        Measure::Bevel => checks::bevel::bevel(panels, limit),
        Measure::BendRadius => checks::bend_radius::bend_radius(panels, BendLimit::Radius(limit)),
        Measure::Mass => checks::mass::mass(panels.iter().map(|panel| (&panel.label, panel.mass)), limit),
        Measure::Count => checks::count::count(panels.len() + made.refused.len(), limit),
        Measure::Mitre | Measure::Overlap => CheckResult::default(),
    }
}

fn of_planks(made: &PlanksMade, measure: Measure, limit: Limit) -> CheckResult {
    let planks = &made.planks;
    match measure {
        Measure::Length => checks::length::length(planks, limit),
        Measure::Mitre => checks::mitre::mitre(planks, limit),
        Measure::Overlap => {
            let curves: Vec<Curve<'_>> = made
                .figures
                .iter()
                .map(|figure| Curve { points: &figure.points, labels: &figure.labels, closed: figure.closed })
                .collect();
            checks::overlap::overlap(&curves, limit)
        }
        Measure::Mass => checks::mass::mass(planks.iter().map(|plank| (&plank.label, plank.mass)), limit),
        Measure::Count => checks::count::count(planks.len() + made.refused.len(), limit),
        _ => CheckResult::default(),
    }
}
