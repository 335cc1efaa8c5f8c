//! How quads become flatter: by planarizing at all, by more iterations, or with a border that may move.

use super::{Remedies, Remedy};
use crate::analysis::fabrication::{Elements, Fabrication};
use crate::analysis::requirements::{LimitValue, RequirementResult};
use crate::diagnostic::Fix;
use crate::fabricate::checks::Limit;
use crate::hir::schema::Measure;
use crate::planarize::{Pin, StopReason};

impl Remedies<'_> {
    /// What makes quads flatter, where that is what the requirement asks for.
    pub(super) fn flatter(
        &self,
        fabrication: &Fabrication,
        requirement: &RequirementResult,
    ) -> Option<Remedy> {
        let Elements::Panels(panels) = &fabrication.elements else { return None };
        let limit = match requirement.limit {
            LimitValue::Plain(limit) => Some(limit),
            LimitValue::Grain(_) => None,
        };
        let measure = requirement.measure;
        let too_flat = match measure {
            Measure::Planarity => matches!(limit, Some(Limit::AtMost(_) | Limit::Below(_))),
            Measure::Fold | Measure::DiagonalRatio => {
                matches!(limit, Some(Limit::AtLeast(_) | Limit::Above(_)))
            }
            Measure::BendRadius => matches!(limit, Some(Limit::AtMost(_) | Limit::Below(_))),
            _ => return None,
        };
        if too_flat && measure == Measure::Planarity {
            let sentence = "1 is flat: to ask for flat boards write `require planarity >= 0.9998`";
            let fix = Fix::replacing(requirement.span, "require planarity >= 0.9998");
            return Some(Remedy::mends(sentence.to_owned()).with([fix]));
        }
        if too_flat {
            return None;
        }
        let Some(options) = &panels.planarizing else {
            let sentence = "`planarize: {}` moves vertices to make the quads flatter: add it to the block";
            let fix = self.setting_put(fabrication, "planarize", "{}");
            return Some(Remedy::mends(sentence.to_owned()).with(fix));
        };
        let outcomes = || panels.figures.iter().filter_map(|figure| figure.outcome.as_ref());
        let (mut ways, mut fixes) = (Vec::new(), Vec::new());
        if outcomes().any(|outcome| outcome.stop == StopReason::IterationsUsed) {
            let more = u64::from(options.iterations()).saturating_mul(4).max(100);
            ways.push(format!(
                "planarizing has used up its {} iterations: `iterations: {more}` lets it go on",
                options.iterations()
            ));
            fixes.extend(self.planarize_put(fabrication, "iterations", &more.to_string()));
        }
        if options.pin() == Pin::Boundary {
            ways.push("the border is held in place: `pin: corners` or `pin: none` lets it move".to_owned());
            let pins = ["corners", "none"];
            fixes.extend(pins.iter().filter_map(|pin| self.planarize_put(fabrication, "pin", pin)));
        }
        (!ways.is_empty()).then(|| Remedy::mends(ways.join("; ")).with(fixes))
    }
}
