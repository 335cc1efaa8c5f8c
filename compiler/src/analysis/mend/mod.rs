//! What would mend a requirement that fails, or elements that are too large: sentences with numbers.
//!
//! `variants` works the design out again with something changed, within a budget for the whole design; `levels` and
//! `parameters` look through such variants; `material`, `grain` and `stock` work with the elements that are there.

mod flatness;
mod grain;
mod levels;
mod material;
mod parameters;
mod planarized;
mod stock;
mod text;
mod variants;

use super::fabrication::Fabrication;
use super::requirements::RequirementResult;
use super::watch::Watch;
use crate::diagnostic::{Fix, Hint};
use crate::hir::evaluate::Overrides;
use crate::hir::schema::Measure;
use crate::hir::tree::Hir;
use crate::plan::lower::Lowered;
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
    /// The changes of the text that do it, each of which is enough; empty where no text stands for it.
    fixes: Vec<Fix>,
    worth: Worth,
}

impl Remedy {
    fn mends(sentence: String) -> Self {
        Remedy { sentence, fixes: Vec::new(), worth: Worth::Mends }
    }

    fn falls_short(sentence: String) -> Self {
        Remedy { sentence, fixes: Vec::new(), worth: Worth::FallsShort }
    }

    fn with(self, fixes: impl IntoIterator<Item = Fix>) -> Self {
        Remedy { fixes: fixes.into_iter().collect(), ..self }
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
        (plan, fabrications): (Option<&Lowered>, &[Fabrication]),
        watch: &'a mut dyn Watch,
    ) -> Self {
        let now = variants::blocks(plan, fabrications);
        let variants = Variants::new(hir, overrides, (plan, fabrications), watch);
        Remedies { hir, overrides, variants, now }
    }

    /// What would make hold what fails of a block, in sentences with the changes of the text that do it: what does, else
    /// how near one comes.
    pub(super) fn of(&mut self, fabrication: &Fabrication, asked: Asked) -> Vec<Hint> {
        let mut remedies: Vec<Remedy> = Vec::new();
        remedies.extend(self.levels(&fabrication.figure, asked));
        remedies.extend(self.parameters(&fabrication.figure, asked));
        match asked {
            Asked::Stock => remedies.extend(self.larger_stock(fabrication)),
            Asked::Requirement(place) => {
                if let Some(requirement) = fabrication.requirements.get(place) {
                    remedies.extend(self.of_requirement(fabrication, place, requirement));
                }
            }
        }
        let found = remedies.iter().any(|remedy| remedy.worth < Worth::FallsShort);
        remedies.sort_by_key(|remedy| remedy.worth);
        let hints = remedies.into_iter().map(|remedy| Hint { text: remedy.sentence, fixes: remedy.fixes });
        let mut sentences: Vec<Hint> = hints.collect();
        if !found {
            let measure = match asked {
                Asked::Stock => None,
                Asked::Requirement(place) => fabrication.requirements.get(place).map(|asked| asked.measure),
            };
            sentences.push(Hint { text: self.last_resort(measure), fixes: Vec::new() });
        }
        sentences
    }

    fn of_requirement(
        &mut self,
        fabrication: &Fabrication,
        place: usize,
        requirement: &RequirementResult,
    ) -> Vec<Remedy> {
        let mut remedies: Vec<Remedy> = Vec::new();
        remedies.extend(self.flatter(fabrication, place, requirement));
        match requirement.measure {
            Measure::BendRadius => {
                remedies.extend(self.grain_turned(fabrication, requirement));
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
