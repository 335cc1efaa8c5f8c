//! The design worked out again with a level or a parameter changed: each variant once, for everything that fails, within
//! a budget for the whole design.

use super::Asked;
use super::planarized::Planarized;
use crate::analysis::evaluate;
use crate::analysis::fabrication::{Elements, Fabrication};
use crate::analysis::requirements::RequirementResult;
use crate::analysis::watch::{Quietly, Watch};
use crate::diagnostic::Severity;
use crate::hir::evaluate::{Limits, Overrides, Planarizing};
use crate::hir::scalar::Scalar;
use crate::hir::tree::Hir;
use crate::plan::lower::Lowered;
use std::collections::BTreeMap;

/// How many elements may be worked out in all from each purse: all together take about a second.
const MOST_ELEMENTS: u64 = 160_000;

/// What a variant costs beside its elements, in elements: the evaluation of the text.
const EACH_VARIANT: u64 = 150;

/// What planarizing an element costs, in elements.
const PLANARIZING: u64 = 150;

/// How many times as many iterations are tried.
pub(super) const MORE_ITERATIONS: u64 = 4;

/// What the budget is kept apart for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purse {
    /// Other levels.
    Levels,
    /// Other values of parameters.
    Parameters,
    /// What holds on quads as they are designed, planarized to see whether it holds then.
    Confirmations,
    /// Other ways to planarize.
    Flatness,
}

/// What a change that holds on quads as they are designed comes to where they are planarized.
pub(super) enum Confirmed {
    /// The design with it, planarized as it asks.
    Planarized(Variant),
    /// It has errors then.
    Faulty,
    /// Planarizing so many takes too long to be tried.
    TooLong,
}

/// What is changed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Change {
    /// The levels of a figure, by so many.
    Level(String, i32),
    /// A parameter, by so many steps.
    Parameter(String, i64),
    /// How a figure is planarized.
    Planarized(String, Planarized),
}

/// What a block gives.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// The figure's name.
    pub(super) figure: String,
    /// The level in words where it is the same for all of the figure's parts: `level 3`.
    pub(super) level: Option<String>,
    /// How many elements it has.
    pub(super) elements: usize,
    /// How many of them are too large for what they are cut from.
    pub(super) too_large: usize,
    /// The requirements in order, measured.
    pub(super) requirements: Vec<RequirementResult>,
}

impl Block {
    /// Whether what is asked holds.
    pub(super) fn holds(&self, asked: Asked) -> bool {
        match asked {
            Asked::Stock => self.too_large == 0,
            Asked::Requirement(place) => {
                // Where nothing is measured, nothing is mended.
                let result = self.requirements.get(place).map(|requirement| &requirement.result);
                result.is_some_and(|result| result.total > 0 && result.holds())
            }
        }
    }
}

/// A variant of the design, worked out.
#[derive(Clone, Debug)]
pub(super) struct Variant {
    /// Its blocks, in the order of the design.
    pub(super) blocks: Vec<Block>,
    /// Whether it was planarized as the design asks.
    pub(super) planarized: bool,
}

impl Variant {
    /// What the block of this figure gives.
    pub(super) fn block(&self, figure: &str) -> Option<&Block> {
        self.blocks.iter().find(|block| block.figure == figure)
    }

    /// What follows on a number that was measured on quads as they are designed, and not as they will be built.
    pub(super) fn said_before(&self) -> &'static str {
        if self.planarized { "" } else { " before planarizing" }
    }
}

/// The variants tried so far.
pub(super) struct Variants<'a> {
    hir: &'a Hir,
    overrides: &'a Overrides,
    /// Elements of all figures of the design as it is.
    elements: u64,
    /// Whether the design planarizes.
    planarizes: bool,
    /// What is left in each purse.
    left: [u64; 4],
    tried: BTreeMap<(Change, bool), Option<Variant>>,
    watch: &'a mut dyn Watch,
}

impl<'a> Variants<'a> {
    pub(super) fn new(
        hir: &'a Hir,
        overrides: &'a Overrides,
        (plan, fabrications): (Option<&Lowered>, &[Fabrication]),
        watch: &'a mut dyn Watch,
    ) -> Self {
        let counts = plan.iter().flat_map(|plan| &plan.counts);
        let planarizes = fabrications.iter().any(|made| match &made.elements {
            Elements::Panels(panels) => panels.planarizing.is_some(),
            Elements::Planks(_) => false,
        });
        let elements = counts.map(|count| count.elements).sum();
        let left = [MOST_ELEMENTS, MOST_ELEMENTS, MOST_ELEMENTS, 2 * MOST_ELEMENTS];
        Variants { hir, overrides, elements, planarizes, left, tried: BTreeMap::new(), watch }
    }

    /// Whether the design planarizes.
    pub(super) fn planarizes(&self) -> bool {
        self.planarizes
    }

    /// How many more variants of so many elements can be tried, with other parameters or other levels.
    pub(super) fn affordable(&self, purse: Purse, elements: u64, planarized: bool) -> u64 {
        self.left[purse as usize] / cost(elements, self.each(planarized))
    }

    /// How many values of each of so many parameters can be tried in either direction from the beginning on.
    pub(super) fn share(&self, parameters: usize, planarized: bool) -> u64 {
        MOST_ELEMENTS / cost(self.elements, self.each(planarized)) / (2 * parameters as u64).max(1)
    }

    /// What an element costs, in elements that are not planarized.
    fn each(&self, planarized: bool) -> u64 {
        if planarized && self.planarizes { PLANARIZING } else { 1 }
    }

    /// The design with a figure planarized otherwise; `None` where that takes too long.
    pub(super) fn planarized(&mut self, figure: &str, how: Planarized) -> Option<Confirmed> {
        let each = match how {
            Planarized::Iterations(_) => PLANARIZING * MORE_ITERATIONS,
            _ => PLANARIZING,
        };
        if self.left[Purse::Flatness as usize] < cost(self.elements, each) {
            return None;
        }
        let change = Change::Planarized(figure.to_owned(), how);
        let found = self.from((Purse::Flatness, each), &change, None, true).cloned();
        Some(found.map_or(Confirmed::Faulty, Confirmed::Planarized))
    }

    /// The design with a change; `None` where it has errors, or where the budget is used up. Where sizes are judged
    /// without planarizing, which takes most of the time, what is found is to be [confirmed](Self::confirmed).
    pub(super) fn with(
        &mut self,
        change: &Change,
        value: Option<&Scalar>,
        planarized: bool,
    ) -> Option<&Variant> {
        let purse = match change {
            Change::Parameter(..) => Purse::Parameters,
            Change::Level(..) | Change::Planarized(..) => Purse::Levels,
        };
        self.from((purse, self.each(planarized)), change, value, planarized)
    }

    /// The design with a change, of so many elements, planarized as it asks.
    pub(super) fn confirmed(&mut self, change: &Change, value: Option<&Scalar>, elements: u64) -> Confirmed {
        let known = self.tried.contains_key(&(change.clone(), true));
        if !known && self.affordable(Purse::Confirmations, elements, true) == 0 {
            return Confirmed::TooLong;
        }
        match self.from((Purse::Confirmations, self.each(true)), change, value, true) {
            Some(variant) => Confirmed::Planarized(variant.clone()),
            None => Confirmed::Faulty,
        }
    }

    /// What was found with so many steps of a parameter, in order.
    pub(super) fn tried_of(
        &self,
        parameter: &str,
        planarized: bool,
    ) -> impl Iterator<Item = (i64, &Variant)> {
        let planarized = planarized || !self.planarizes;
        self.tried.iter().filter_map(move |((change, how), variant)| match change {
            Change::Parameter(name, steps) if name == parameter && *how == planarized => {
                Some((*steps, variant.as_ref()?))
            }
            _ => None,
        })
    }

    fn from(
        &mut self,
        purse: (Purse, u64),
        change: &Change,
        value: Option<&Scalar>,
        planarized: bool,
    ) -> Option<&Variant> {
        let key = (change.clone(), planarized || !self.planarizes);
        if !self.tried.contains_key(&key) {
            let variant = self.work_out(purse, change, value, key.1);
            self.tried.insert(key.clone(), variant);
        }
        self.tried.get(&key)?.as_ref()
    }

    fn work_out(
        &mut self,
        (purse, each): (Purse, u64),
        change: &Change,
        value: Option<&Scalar>,
        planarized: bool,
    ) -> Option<Variant> {
        let left = self.left[purse as usize];
        if left < cost(0, each) || self.watch.step().is_break() {
            return None;
        }
        let mut overrides = self.overrides.clone();
        overrides.planarizing = if planarized { Planarizing::AsAsked } else { Planarizing::Never };
        match change {
            Change::Level(figure, shift) => overrides.level_shift = Some((figure.clone(), *shift)),
            Change::Parameter(name, _) => {
                overrides.values.insert(name.clone(), value?.clone());
            }
            Change::Planarized(figure, how) => {
                overrides.planarizing = Planarizing::With { figure: figure.clone(), setting: how.setting() };
            }
        }
        let most = (left / each).min(overrides.limits.elements);
        overrides.limits =
            Limits { elements: most, boards: overrides.limits.boards.min(most), ..overrides.limits };
        let evaluated = evaluate(self.hir, &overrides, &mut Quietly(self.watch));
        let counts = evaluated.plan.iter().flat_map(|plan| &plan.counts);
        let elements = counts.map(|count| count.elements).sum();
        self.left[purse as usize] = left.saturating_sub(cost(elements, each));
        let complete = evaluated.fabrications.len() == self.hir.fabricates.len();
        let sound = evaluated.diagnostics.iter().all(|found| found.severity() != Severity::Error);
        (complete && sound)
            .then(|| Variant { blocks: blocks(evaluated.plan.as_ref(), &evaluated.fabrications), planarized })
    }
}

/// What a variant of so many elements costs, each of them so much.
fn cost(elements: u64, each: u64) -> u64 {
    elements.saturating_mul(each).saturating_add(EACH_VARIANT)
}

/// What the blocks of a design give.
pub(super) fn blocks(plan: Option<&Lowered>, fabrications: &[Fabrication]) -> Vec<Block> {
    fabrications.iter().map(|made| block(plan, made)).collect()
}

fn block(plan: Option<&Lowered>, made: &Fabrication) -> Block {
    let figures = plan.iter().flat_map(|lowered| lowered.plan.figures());
    let mut levels: Vec<String> = figures
        .filter(|figure| figure.name == made.figure)
        .map(|figure| figure.shape.level_words())
        .collect();
    levels.dedup();
    let level = match levels.as_slice() {
        [one] if !one.is_empty() => Some(format!("level {one}")),
        _ => None,
    };
    Block {
        figure: made.figure.clone(),
        level,
        elements: made.elements.total(),
        too_large: made.elements.too_large().len(),
        requirements: made.requirements.clone(),
    }
}
