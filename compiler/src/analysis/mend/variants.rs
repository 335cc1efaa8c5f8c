//! The design worked out again with a level or a parameter changed: each variant once, for everything that fails, within
//! a budget for the whole design.

use super::Asked;
use crate::analysis::evaluate;
use crate::analysis::fabrication::{Elements, Fabrication};
use crate::analysis::requirements::RequirementResult;
use crate::analysis::watch::{Quietly, Watch};
use crate::diagnostic::Severity;
use crate::hir::evaluate::{Limits, Overrides};
use crate::hir::scalar::Scalar;
use crate::hir::tree::Hir;
use crate::plan::lower::Lowered;
use std::collections::BTreeMap;

/// How many elements may be worked out in all while levels are tried, and again as many while parameters are: both
/// together take about half a second.
const MOST_ELEMENTS: u64 = 160_000;

/// What a variant costs beside its elements, in elements: the evaluation of the text.
const EACH_VARIANT: u64 = 150;

/// What planarizing an element costs, in elements.
const PLANARIZING: u64 = 150;

/// What the budget is kept apart for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purse {
    /// Other levels.
    Levels,
    /// Other values of parameters.
    Parameters,
}

/// What is changed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Change {
    /// The levels of a figure, by so many.
    Level(String, i32),
    /// A parameter, by so many steps.
    Parameter(String, i64),
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

/// The variants tried so far.
pub(super) struct Variants<'a> {
    hir: &'a Hir,
    overrides: &'a Overrides,
    /// Elements of all figures of the design as it is.
    elements: u64,
    /// Whether the design planarizes.
    planarizes: bool,
    /// What is left for levels and for parameters.
    left: [u64; 2],
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
        let left = [MOST_ELEMENTS; 2];
        Variants { hir, overrides, elements, planarizes, left, tried: BTreeMap::new(), watch }
    }

    /// How many more variants of so many elements can be tried, with other parameters or other levels.
    pub(super) fn affordable(&self, purse: Purse, elements: u64, planarized: bool) -> u64 {
        self.left[purse as usize] / self.cost(elements, planarized)
    }

    /// How many values of each of so many parameters can be tried in either direction from the beginning on.
    pub(super) fn share(&self, parameters: usize, planarized: bool) -> u64 {
        MOST_ELEMENTS / self.cost(self.elements, planarized) / (2 * parameters as u64).max(1)
    }

    fn cost(&self, elements: u64, planarized: bool) -> u64 {
        let each = if planarized && self.planarizes { PLANARIZING } else { 1 };
        elements.saturating_mul(each).saturating_add(EACH_VARIANT)
    }

    /// The design with a change; `None` where it has errors, or where the budget is used up. Sizes can be judged without
    /// planarizing, which takes most of the time.
    pub(super) fn with(
        &mut self,
        change: &Change,
        value: Option<&Scalar>,
        planarized: bool,
    ) -> Option<&Variant> {
        let key = (change.clone(), planarized || !self.planarizes);
        if !self.tried.contains_key(&key) {
            let variant = self.work_out(change, value, key.1);
            self.tried.insert(key.clone(), variant);
        }
        self.tried.get(&key)?.as_ref()
    }

    fn work_out(&mut self, change: &Change, value: Option<&Scalar>, planarized: bool) -> Option<Variant> {
        let purse = match change {
            Change::Level(..) => Purse::Levels,
            Change::Parameter(..) => Purse::Parameters,
        };
        if self.affordable(purse, 0, planarized) == 0 || self.watch.step().is_break() {
            return None;
        }
        let left = self.left[purse as usize];
        let mut overrides = self.overrides.clone();
        match change {
            Change::Level(figure, shift) => overrides.level_shift = Some((figure.clone(), *shift)),
            Change::Parameter(name, _) => {
                overrides.values.insert(name.clone(), value?.clone());
            }
        }
        overrides.leave_unplanarized = !planarized;
        let each = if planarized && self.planarizes { PLANARIZING } else { 1 };
        let most = (left / each).min(overrides.limits.elements);
        overrides.limits =
            Limits { elements: most, boards: overrides.limits.boards.min(most), ..overrides.limits };
        let evaluated = evaluate(self.hir, &overrides, &mut Quietly(self.watch));
        let counts = evaluated.plan.iter().flat_map(|plan| &plan.counts);
        let elements = counts.map(|count| count.elements).sum();
        self.left[purse as usize] = left.saturating_sub(self.cost(elements, planarized));
        let complete = evaluated.fabrications.len() == self.hir.fabricates.len();
        let sound = evaluated.diagnostics.iter().all(|found| found.severity() != Severity::Error);
        (complete && sound)
            .then(|| Variant { blocks: blocks(evaluated.plan.as_ref(), &evaluated.fabrications), planarized })
    }
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
