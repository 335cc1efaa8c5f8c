//! What would mend a requirement that fails: the design is worked out again with parameters moved step by step inside
//! their ranges, and with other levels, and what then holds is said.

use super::fabrication::{Elements, Fabrication};
use super::{Evaluated, Unwatched, evaluate};
use crate::hir::evaluate::{Evaluator, Overrides, words};
use crate::hir::scalar::Scalar;
use crate::hir::schema::Measure;
use crate::hir::tree::{Hir, ItemKind, Param};
use crate::hir::types::Type;
use crate::planarize::Pin;
use std::collections::BTreeMap;

/// How many variants of a design are tried for one requirement and parameter, each way.
const MOST_TRIES: usize = 60;

/// How many elements may be worked out in all while remedies are looked for.
const MOST_ELEMENTS: u64 = 150_000;

/// How many steps a range is cut into where the parameter names none.
const STEPS: i64 = 40;

/// Looks for remedies of one design.
pub(super) struct Remedies<'a> {
    hir: &'a Hir,
    overrides: &'a Overrides,
    elements: u64,
    planarized: bool,
}

impl<'a> Remedies<'a> {
    pub(super) fn new(hir: &'a Hir, overrides: &'a Overrides, evaluated: &Evaluated) -> Self {
        let counts = evaluated.plan.iter().flat_map(|plan| &plan.counts);
        let planarized = evaluated.fabrications.iter().any(|made| match &made.elements {
            Elements::Panels(panels) => panels.planarizing.is_some(),
            Elements::Planks(_) => false,
        });
        Remedies { hir, overrides, elements: counts.map(|count| count.elements).sum(), planarized }
    }

    /// Sentences on what would make the requirement at `place` of the block hold.
    pub(super) fn of(&self, fabrication: &Fabrication, place: usize) -> Vec<String> {
        let mut sentences = Vec::new();
        // Planarizing hundreds of variants would take longer than a person waits.
        let tries = MOST_ELEMENTS / self.elements.max(1);
        if !self.planarized && tries >= 4 {
            let tries = usize::try_from(tries).unwrap_or(MOST_TRIES).min(MOST_TRIES);
            for (name, param) in self.numeric_parameters() {
                sentences.extend(self.parameter(&name, param, fabrication, place, tries));
            }
        }
        sentences.extend(self.levels(fabrication, place));
        sentences.extend(flatter(fabrication, place));
        if sentences.is_empty() {
            sentences.push("move the control points, or change the limit".to_owned());
        }
        sentences
    }

    fn numeric_parameters(&self) -> Vec<(String, &'a Param)> {
        let items = self.hir.own_items().filter_map(|(_, item)| match &item.kind {
            ItemKind::Param(param) if param.range.is_some() && param.ty.dimension().is_some() => {
                Some((item.name.clone(), param.as_ref()))
            }
            _ => None,
        });
        items.collect()
    }

    /// The nearest value of a parameter, up and down, at which the requirement holds.
    fn parameter(
        &self,
        name: &str,
        param: &Param,
        fabrication: &Fabrication,
        place: usize,
        tries: usize,
    ) -> Option<String> {
        let mut evaluator = Evaluator::new(self.hir, self.overrides);
        let (from, to) = param.range.as_ref()?;
        let least = evaluator.body(from).ok()?.scalar()?.clone();
        let most = evaluator.body(to).ok()?.scalar()?.clone();
        let id = self.hir.own_items().find(|(_, item)| item.name == *name)?.0;
        let now = evaluator.global(id).ok()?.scalar()?.clone();
        let step = match &param.step {
            Some(step) => evaluator.body(step).ok()?.scalar()?.clone(),
            None => most.minus(&least).ok()?.over(&Scalar::integer(STEPS)).ok()?,
        };
        let step = if param.ty == Type::Int { Scalar::one() } else { step };
        if step.to_f64()? <= 0.0 {
            return None;
        }
        let walk = |sign: i64| -> Option<(Scalar, bool)> {
            let step = step.times(&Scalar::integer(sign)).ok()?;
            let mut value = now.clone();
            for _ in 0..tries {
                value = value.plus(&step).ok()?;
                let inside = least.compare(&value).ok()?.is_le() && value.compare(&most).ok()?.is_le();
                if !inside {
                    return None;
                }
                let values = BTreeMap::from([(name.to_owned(), value.clone())]);
                let overrides = Overrides { values, ..self.overrides.clone() };
                if let Some(all) = self.holds(&overrides, &fabrication.figure, place) {
                    return Some((value, all));
                }
            }
            None
        };
        let found: Vec<String> = [walk(1), walk(-1)]
            .into_iter()
            .flatten()
            .map(|(value, all)| {
                let rest = if all { "" } else { " (another requirement then fails)" };
                format!("{}{rest}", words(&value, &param.ty))
            })
            .collect();
        let now = words(&now, &param.ty);
        (!found.is_empty()).then(|| format!("it holds with {name} = {}; now it is {now}", found.join(" or ")))
    }

    /// What the levels beside this one give.
    fn levels(&self, fabrication: &Fabrication, place: usize) -> Option<String> {
        let found: Vec<String> = [-1, 1]
            .into_iter()
            .filter(|shift| *shift < 0 || self.elements.saturating_mul(4) <= MOST_ELEMENTS / 8)
            .filter_map(|shift| {
                let level_shift = Some((fabrication.figure.clone(), shift));
                let overrides = Overrides { level_shift, ..self.overrides.clone() };
                let all = self.holds(&overrides, &fabrication.figure, place)?;
                let rest = if all { "" } else { " (another requirement then fails)" };
                let way = if shift < 0 { "one level lower" } else { "one level higher" };
                Some(format!("{way}{rest}"))
            })
            .collect();
        (!found.is_empty()).then(|| format!("it holds {}", found.join(" or ")))
    }

    /// Whether the requirement at `place` holds with these overrides, and with it all others; `None` where it does not.
    fn holds(&self, overrides: &Overrides, figure: &str, place: usize) -> Option<bool> {
        let evaluated = evaluate(self.hir, overrides, false, &mut Unwatched);
        let error = crate::diagnostic::Severity::Error;
        if evaluated.diagnostics.iter().any(|diagnostic| diagnostic.severity() == error) {
            return None;
        }
        let made = evaluated.fabrications.iter().find(|made| made.figure == figure)?;
        if !made.requirements.get(place)?.result.holds() {
            return None;
        }
        let mut others = evaluated.fabrications.iter().flat_map(|made| &made.requirements);
        Some(others.all(|requirement| requirement.result.holds()))
    }
}

/// How quads become flatter: by planarizing at all, or with a border that may move.
fn flatter(fabrication: &Fabrication, place: usize) -> Option<String> {
    let Elements::Panels(panels) = &fabrication.elements else { return None };
    if fabrication.requirements.get(place)?.measure != Measure::Planarity {
        return None;
    }
    match &panels.planarizing {
        None => Some("add `planarize: {}`: it moves vertices until the quads are flat enough".to_owned()),
        Some(method) if method.pin() == Pin::Boundary => {
            Some("the border is held in place: `pin: corners` or `pin: none` lets it move".to_owned())
        }
        Some(_) => None,
    }
}
