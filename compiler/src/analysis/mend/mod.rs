//! What would mend a requirement that fails, or elements that are too large: sentences with numbers.
//!
//! `variants` works the design out again with something changed, within a budget for the whole design; `levels` and
//! `parameters` look through such variants; `material`, `grain` and `stock` work with the elements that are there.

mod grain;
mod levels;
mod material;
mod parameters;
mod stock;
mod variants;

use super::Evaluated;
use super::fabrication::{Elements, Fabrication};
use super::requirements::RequirementResult;
use crate::fabricate::checks::Limit;
use crate::hir::evaluate::Overrides;
use crate::hir::schema::Measure;
use crate::hir::tree::Hir;
use crate::planarize::Pin;
use variants::{Block, Variants};

/// What fails of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asked {
    /// The requirement at this place.
    Requirement(usize),
    /// That every element can be cut from the raw board or bar.
    Stock,
}

/// A way to mend what fails.
struct Remedy {
    /// One sentence.
    sentence: String,
    /// Whether it does: else it says how near one comes.
    mends: bool,
}

impl Remedy {
    fn mends(sentence: String) -> Self {
        Remedy { sentence, mends: true }
    }

    fn falls_short(sentence: String) -> Self {
        Remedy { sentence, mends: false }
    }
}

/// Looks for remedies of one design.
pub(super) struct Remedies<'a> {
    hir: &'a Hir,
    overrides: &'a Overrides,
    variants: Variants<'a>,
    now: Vec<Block>,
}

impl<'a> Remedies<'a> {
    pub(super) fn new(hir: &'a Hir, overrides: &'a Overrides, evaluated: &Evaluated) -> Self {
        let now = variants::blocks(evaluated);
        Remedies { hir, overrides, variants: Variants::new(hir, overrides, evaluated), now }
    }

    /// Sentences on what would make hold what fails of a block: what does, else how near one comes.
    pub(super) fn of(&mut self, fabrication: &Fabrication, asked: Asked) -> Vec<String> {
        let mut remedies: Vec<Remedy> = Vec::new();
        remedies.extend(self.levels(&fabrication.figure, asked));
        remedies.extend(self.parameters(&fabrication.figure, asked));
        match asked {
            Asked::Stock => remedies.extend(stock::remedies(fabrication)),
            Asked::Requirement(place) => {
                if let Some(requirement) = fabrication.requirements.get(place) {
                    remedies.extend(self.of_requirement(fabrication, place, requirement));
                }
            }
        }
        let found = remedies.iter().any(|remedy| remedy.mends);
        let mut sentences: Vec<String> = remedies.into_iter().map(|remedy| remedy.sentence).collect();
        if !found {
            sentences.push(self.last_resort(asked));
        }
        sentences
    }

    fn of_requirement(
        &self,
        fabrication: &Fabrication,
        place: usize,
        requirement: &RequirementResult,
    ) -> Vec<Remedy> {
        let mut remedies: Vec<Remedy> = Vec::new();
        remedies.extend(flatter(fabrication, requirement));
        match requirement.measure {
            Measure::BendRadius => {
                remedies.extend(grain::turned(fabrication, requirement));
                remedies.extend(self.thinner(fabrication, place));
            }
            Measure::Mass => {
                remedies.extend(self.thinner(fabrication, place));
                remedies.extend(material::lighter(fabrication, requirement));
            }
            _ => {}
        }
        remedies
    }

    /// What is left where nothing was found.
    fn last_resort(&self, asked: Asked) -> String {
        let loose = self.parameters_without_range();
        let limit = if asked == Asked::Stock { "use larger stock" } else { "change the limit" };
        match loose.first() {
            Some(name) => format!(
                "move the control points, or {limit}; with a range (`param {name}: … = … in … .. …`) `{name}` is tried \
                 out here too"
            ),
            None => format!("move the control points, or {limit}"),
        }
    }

    fn now(&self, figure: &str) -> Option<&Block> {
        self.now.iter().find(|block| block.figure == figure)
    }
}

/// How quads become flatter: by planarizing at all, or with a border that may move.
fn flatter(fabrication: &Fabrication, requirement: &RequirementResult) -> Option<Remedy> {
    let Elements::Panels(panels) = &fabrication.elements else { return None };
    let limit = match requirement.limit {
        super::LimitValue::Plain(limit) => Some(limit),
        super::LimitValue::Grain(_) => None,
    };
    let measure = requirement.measure;
    let too_flat = match measure {
        Measure::Planarity => matches!(limit, Some(Limit::AtMost(_) | Limit::Below(_))),
        Measure::Fold | Measure::DiagonalRatio => matches!(limit, Some(Limit::AtLeast(_) | Limit::Above(_))),
        Measure::BendRadius => matches!(limit, Some(Limit::AtMost(_) | Limit::Below(_))),
        _ => return None,
    };
    if too_flat && measure == Measure::Planarity {
        return Some(Remedy::mends(
            "1 is flat: to ask for flat boards write `require planarity >= 0.9998`".into(),
        ));
    }
    if too_flat {
        return None;
    }
    let sentence = match &panels.perturbation {
        None => "add `planarize: {}`: it moves vertices until the quads are flat enough",
        Some(options) if options.pin == Pin::Boundary => {
            "the border is held in place: `pin: corners` or `pin: none` lets it move"
        }
        Some(_) => return None,
    };
    Some(Remedy::mends(sentence.to_owned()))
}
