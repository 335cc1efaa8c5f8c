//! How quads become flatter: by planarizing at all, by projection, for more iterations, or with a border that may move. Each
//! is tried.

use super::levels::found;
use super::parameters::shortfall;
use super::planarized::Planarized;
use super::variants::{Confirmed, MORE_ITERATIONS, Variant};
use super::{Asked, Remedies, Remedy, Worth};
use crate::analysis::fabrication::{Elements, Fabrication, PanelsMade};
use crate::analysis::requirements::{LimitValue, RequirementResult};
use crate::diagnostic::Fix;
use crate::fabricate::checks::Limit;
use crate::hir::schema::{ChoiceKind, Measure};
use crate::planarize::{Method, Pin, StopReason};

impl Remedies<'_> {
    /// What makes quads flatter, where that is what the requirement asks for.
    pub(super) fn flatter(
        &mut self,
        fabrication: &Fabrication,
        place: usize,
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
        let mut tried = Vec::new();
        for how in other_ways(panels) {
            match self.variants.planarized(&fabrication.figure, how) {
                Some(Confirmed::Planarized(variant)) => tried.push((how, variant)),
                Some(Confirmed::Faulty) => {}
                Some(Confirmed::TooLong) | None => return Some(untried(panels)),
            }
        }
        self.flattest(fabrication, place, &tried)
    }

    /// What holds of some ways to planarize, or how near the best of them comes.
    fn flattest(
        &self,
        fabrication: &Fabrication,
        place: usize,
        tried: &[(Planarized, Variant)],
    ) -> Option<Remedy> {
        let asked = Asked::Requirement(place);
        let is_asked = is_planarized(fabrication);
        let (mut words, mut fixes, mut clean) = (Vec::new(), Vec::new(), false);
        let now = shortfall(fabrication.requirements.get(place)?)?;
        let mut best: Option<(f64, String)> = None;
        for (how, variant) in tried {
            let Some(block) = variant.block(&fabrication.figure) else { continue };
            let found = found(block, asked).unwrap_or_default();
            if block.holds(asked) {
                let broken = self.broken(variant);
                if broken.is_none() {
                    clean = true;
                    fixes.extend(self.planarized_put(fabrication, *how));
                }
                let broken = broken.map_or_else(String::new, |broken| format!(", but then {broken}"));
                words.push(format!("with `{}` ({found}){broken}", written(*how, is_asked)));
            } else if let Some(beyond) = block.requirements.get(place).and_then(shortfall)
                && beyond < best.as_ref().map_or(now - now.abs() * 0.01, |(best, _)| *best)
            {
                let sentence = format!(
                    "planarizing otherwise is not enough: `{}`, the best that was tried, gives {found}",
                    written(*how, is_asked)
                );
                best = Some((beyond, sentence));
            }
        }
        if words.is_empty() {
            return best.map(|(_, sentence)| Remedy::falls_short(sentence));
        }
        let worth = if clean { Worth::Mends } else { Worth::Breaks };
        Some(Remedy { sentence: format!("it holds {}", words.join("; or ")), fixes, worth })
    }

    /// The change of the text for a way to planarize.
    fn planarized_put(&self, fabrication: &Fabrication, how: Planarized) -> Option<Fix> {
        let words = how.words();
        match (how, words.split_once(": ")) {
            (Planarized::AtAll, _) => self.setting_put(fabrication, "planarize", "{}"),
            (_, Some((name, value))) if is_planarized(fabrication) => {
                self.planarize_put(fabrication, name, value)
            }
            _ => self.setting_put(fabrication, "planarize", &format!("{{ {words} }}")),
        }
    }
}

fn is_planarized(fabrication: &Fabrication) -> bool {
    matches!(&fabrication.elements, Elements::Panels(made) if made.planarizing.is_some())
}

/// How a way to planarize is written in a block that planarizes already, or in one that does not.
fn written(how: Planarized, is_asked: bool) -> String {
    match how {
        Planarized::AtAll => how.words(),
        _ if is_asked => how.words(),
        _ => format!("planarize: {{ {} }}", how.words()),
    }
}

/// Other ways to planarize than that of the block.
fn other_ways(panels: &PanelsMade) -> Vec<Planarized> {
    let Some(options) = &panels.planarizing else {
        return vec![Planarized::AtAll, Planarized::ByProjection];
    };
    let mut ways = Vec::new();
    if options.pin() == Pin::Boundary {
        ways.extend(
            ["corners", "none"]
                .iter()
                .filter_map(|word| ChoiceKind::Pin.position(word))
                .map(Planarized::Pinned),
        );
    }
    if matches!(options, Method::Perturbation(_)) {
        ways.push(Planarized::ByProjection);
    }
    let mut outcomes = panels.figures.iter().filter_map(|figure| figure.outcome.as_ref());
    if outcomes.any(|outcome| outcome.stop == StopReason::IterationsUsed) {
        let more = u64::from(options.iterations()).saturating_mul(MORE_ITERATIONS).max(100);
        ways.push(Planarized::Iterations(u32::try_from(more).unwrap_or(u32::MAX)));
    }
    ways
}

/// What is said where there are too many quads to try the ways.
fn untried(panels: &PanelsMade) -> Remedy {
    let is_asked = panels.planarizing.is_some();
    let ways = other_ways(panels).into_iter().map(|how| format!("`{}`", written(how, is_asked)));
    let words: Vec<String> = ways.collect();
    Remedy::falls_short(format!(
        "flatter quads may come with {}: there are too many to try it here",
        words.join(" or ")
    ))
}
