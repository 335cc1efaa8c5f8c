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
use super::requirements::{LimitValue, RequirementResult};
use super::watch::Watch;
use crate::fabricate::checks::Limit;
use crate::hir::evaluate::Overrides;
use crate::hir::schema::Measure;
use crate::hir::tree::Hir;
use crate::planarize::{Pin, StopReason};
use variants::{Block, Variants};

/// What fails of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asked {
    /// The requirement at this place.
    Requirement(usize),
    /// That every element can be cut from the raw board or bar.
    Stock,
}

/// How much a remedy does, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Worth {
    /// It mends what fails.
    Mends,
    /// It does, and something else then fails.
    Breaks,
    /// It only says how near one comes.
    FallsShort,
}

/// A way to mend what fails.
struct Remedy {
    /// One sentence.
    sentence: String,
    worth: Worth,
}

impl Remedy {
    fn mends(sentence: String) -> Self {
        Remedy { sentence, worth: Worth::Mends }
    }

    fn falls_short(sentence: String) -> Self {
        Remedy { sentence, worth: Worth::FallsShort }
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
    pub(super) fn new(
        hir: &'a Hir,
        overrides: &'a Overrides,
        evaluated: &Evaluated,
        watch: &'a mut dyn Watch,
    ) -> Self {
        let now = variants::blocks(evaluated);
        Remedies { hir, overrides, variants: Variants::new(hir, overrides, evaluated, watch), now }
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
        let found = remedies.iter().any(|remedy| remedy.worth < Worth::FallsShort);
        remedies.sort_by_key(|remedy| remedy.worth);
        let mut sentences: Vec<String> = remedies.into_iter().map(|remedy| remedy.sentence).collect();
        if !found {
            let measure = match asked {
                Asked::Stock => None,
                Asked::Requirement(place) => fabrication.requirements.get(place).map(|asked| asked.measure),
            };
            sentences.push(self.last_resort(measure));
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

    /// What is left where nothing was found; no measure: raw boards or bars are too small.
    fn last_resort(&self, measure: Option<Measure>) -> String {
        let mut sentence = match measure {
            None => "move the control points, or use larger raw boards or bars".to_owned(),
            Some(Measure::Angle) => "the angles stay about the same at every level: move the control points so that the \
                                     two directions of the surface cross nearer to a right angle, or change the limit"
                .to_owned(),
            Some(_) => "move the control points, or change the limit".to_owned(),
        };
        if let Some(name) = self.parameters_without_range().first() {
            let of = format!("`param {name}: … = … in … .. …`");
            sentence = format!("{sentence}; with a range ({of}) values of {name} are tried out too");
        }
        sentence
    }

    fn now(&self, figure: &str) -> Option<&Block> {
        self.now.iter().find(|block| block.figure == figure)
    }
}

/// How quads become flatter: by planarizing at all, or with a border that may move.
fn flatter(fabrication: &Fabrication, requirement: &RequirementResult) -> Option<Remedy> {
    let Elements::Panels(panels) = &fabrication.elements else { return None };
    let limit = match requirement.limit {
        LimitValue::Plain(limit) => Some(limit),
        LimitValue::Grain(_) => None,
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
    let Some(options) = &panels.planarizing else {
        let sentence = "`planarize: {}` moves vertices to make the quads flatter: add it to the block";
        return Some(Remedy::mends(sentence.to_owned()));
    };
    let outcomes = || panels.figures.iter().filter_map(|figure| figure.outcome.as_ref());
    let mut ways = Vec::new();
    if outcomes().any(|outcome| outcome.stop == StopReason::IterationsUsed) {
        let more = u64::from(options.iterations()).saturating_mul(4).max(100);
        ways.push(format!(
            "planarizing has used up its {} iterations: `iterations: {more}` lets it go on",
            options.iterations()
        ));
    }
    if options.pin() == Pin::Boundary {
        ways.push("the border is held in place: `pin: corners` or `pin: none` lets it move".to_owned());
    }
    (!ways.is_empty()).then(|| Remedy::mends(ways.join("; ")))
}
