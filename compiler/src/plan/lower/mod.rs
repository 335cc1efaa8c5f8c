//! From the values of a design to its plan: states, matrices, figures, with a diagnostic at the line of whatever cannot
//! be planned.

mod alone;
mod joins;
mod kind;
mod patchwork;
mod places;
mod shapes;
mod soundness;
mod stated;
mod states;
mod until;

use super::budget::{self, BudgetError, FigureCount};
use super::extent::{Extent, extent};
use super::figure::{FigurePlan, Plan, PlanError, Shape};
use crate::diagnostic::{Code, Diagnostic};
use crate::geometry::LARGEST_COORDINATE;
use crate::hir::evaluate::{Evaluator, Overrides};
use crate::hir::size::Until;
use crate::hir::tree::{Hir, ItemId, ItemKind};
use crate::hir::value::{self, Value};
use crate::source::Span;
use states::States;

pub use alone::alone;
pub use kind::{FigureKind, figure_kind};

/// Where a figure of the plan comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigureSource {
    /// The figure item.
    pub item: ItemId,
    /// Its place, when the item is a list of figures.
    pub index: Option<u32>,
    /// Where its level is said.
    pub level_span: Span,
    /// The size its level was found by, where it was.
    pub until: Option<Until>,
    /// The expression that made it.
    pub made: Span,
}

/// A plan with the places its figures come from.
#[derive(Clone, Debug)]
pub struct Lowered {
    /// The plan.
    pub plan: Plan,
    /// One for each figure of the plan.
    pub sources: Vec<FigureSource>,
    /// One for each figure of the plan.
    pub counts: Vec<FigureCount>,
    /// One for each figure of the plan: how large it is, where it is of separate pieces.
    pub extents: Vec<Option<Extent>>,
}

/// The plan of all figures a design declares; `None` after a report of an error.
pub fn lower<'h>(
    hir: &'h Hir,
    evaluator: &mut Evaluator<'h>,
    overrides: &Overrides,
) -> (Option<Lowered>, Vec<Diagnostic>) {
    let mut lowering = Lowering {
        hir,
        evaluator,
        overrides,
        states: States::default(),
        diagnostics: Vec::new(),
        failed: false,
    };
    let mut figures = Vec::new();
    // An ifs is checked for all its parameters before a figure asks for some of them: one mistake, said once.
    for (id, _) in hir.project_items().filter(|(_, item)| matches!(item.kind, ItemKind::Ifs(_))) {
        lowering.evaluator.check_symbolically(id);
    }
    for (id, item) in hir.own_items() {
        match &item.kind {
            ItemKind::Figure(_) => figures.extend(lowering.figure(id)),
            ItemKind::Param(_) | ItemKind::Let(_) => {
                lowering.failed |= lowering.evaluator.global(id).is_err()
            }
            _ => {}
        }
    }
    // A figure of another file is a figure of the design where the design makes something of it.
    for block in &hir.fabricates {
        if hir.item(block.figure).name_span.file != hir.root {
            figures.extend(lowering.figure(block.figure));
        }
    }
    lowering.enter_stated();
    let lowered = lowering.plan(figures);
    (lowered, lowering.diagnostics)
}

/// E0707 of a figure, without the way out.
pub(crate) fn out_of_reach(figure: &FigurePlan, at: Span) -> Diagnostic {
    let reach = LARGEST_COORDINATE / 1e6;
    let message = format!("`{figure}` reaches further than {reach} km from the origin");
    Diagnostic::new(Code::E0707, at, message).label("too large")
}

struct Lowering<'a, 'h> {
    hir: &'h Hir,
    evaluator: &'a mut Evaluator<'h>,
    overrides: &'a Overrides,
    states: States,
    diagnostics: Vec<Diagnostic>,
    failed: bool,
}

impl Lowering<'_, '_> {
    fn figure(&mut self, id: ItemId) -> Vec<(FigurePlan, FigureSource)> {
        let name = self.hir.item(id).name.clone();
        let shift = self.level_shift(&name);
        let Ok(value) = self.evaluator.global(id) else {
            self.failed = true;
            return Vec::new();
        };
        let figures: Vec<(Option<u32>, &value::Figure)> = match &value {
            Value::Figure(figure) => vec![(None, figure.as_ref())],
            Value::List(list) => list
                .iter()
                .enumerate()
                .filter_map(|(index, value)| match value {
                    Value::Figure(figure) => Some((Some(index as u32), figure.as_ref())),
                    _ => None,
                })
                .collect(),
            _ => Vec::new(),
        };
        let mut planned = Vec::new();
        for (index, figure) in figures {
            match self.one(id, &name, index, figure, shift) {
                Some(done) => planned.push(done),
                None => self.failed = true,
            }
        }
        planned
    }

    /// By how much the levels of a figure are read higher or lower.
    fn level_shift(&self, name: &str) -> i32 {
        match &self.overrides.level_shift {
            Some((figure, shift)) if figure == name => *shift,
            _ => 0,
        }
    }

    fn one(
        &mut self,
        item: ItemId,
        name: &str,
        index: Option<u32>,
        figure: &value::Figure,
        shift: i32,
    ) -> Option<(FigurePlan, FigureSource)> {
        let (shape, level_span) = self.shape(name, figure, shift)?;
        let plan = FigurePlan { name: name.to_owned(), index, shape };
        let until = figure.level.and_then(|level| level.until);
        Some((plan, FigureSource { item, index, level_span, until, made: figure.span }))
    }

    fn plan(&mut self, mut figures: Vec<(FigurePlan, FigureSource)>) -> Option<Lowered> {
        let automaton = self.automaton()?;
        if !self.find_patchworks(&automaton, &mut figures) {
            return None;
        }
        self.check_contraction(&automaton, &figures);
        let joined = self.check_joins(&automaton, &mut figures);
        let stated = self.check_stated(&automaton);
        if self.failed || !joined || !stated || !self.find_levels(&automaton, &mut figures) {
            return None;
        }
        let (plans, sources): (Vec<FigurePlan>, Vec<FigureSource>) = figures.into_iter().unzip();
        let plan = match Plan::try_new(automaton, plans) {
            Ok(plan) => plan,
            Err(error) => {
                self.refused(&error, &sources);
                return None;
            }
        };
        match budget::check(&plan, self.evaluator.limits().elements) {
            Ok(counts) => {
                if !self.sound(&plan, &sources, &counts) {
                    return None;
                }
                let extents = self.extents(&plan, &sources)?;
                Some(Lowered { plan, sources, counts, extents })
            }
            Err(error) => {
                self.over_budget(&plan, &error, &sources);
                None
            }
        }
    }

    /// How large the figures of separate pieces are; `None` after a report of one that is too large.
    fn extents(&mut self, plan: &Plan, sources: &[FigureSource]) -> Option<Vec<Option<Extent>>> {
        let mut extents = Vec::new();
        let mut good = true;
        for (figure, source) in plan.figures().iter().zip(sources) {
            let extent = match &figure.shape {
                Shape::Pieces(pieces) => Some(extent(plan.automaton(), pieces)),
                _ => None,
            };
            if extent.is_some_and(|extent| !extent.is_within(LARGEST_COORDINATE)) {
                let hint = "let the transforms make smaller copies, or take a lower level";
                self.diagnostics.push(out_of_reach(figure, source.level_span).hint(hint));
                good = false;
            }
            extents.push(extent);
        }
        good.then_some(extents)
    }

    /// What joins and placement leave over: coordinates beyond all bounds.
    fn refused(&mut self, error: &PlanError, sources: &[FigureSource]) {
        let span = sources.first().map_or(Span::default(), |source| self.hir.item(source.item).name_span);
        let diagnostic = Diagnostic::new(Code::E0604, span, error.to_string()).label("cannot be planned");
        self.diagnostics.push(diagnostic);
    }

    fn over_budget(&mut self, plan: &Plan, error: &BudgetError, sources: &[FigureSource]) {
        let (BudgetError::TooDeep { figure, .. } | BudgetError::TooMany { figure, .. }) = error;
        let place = plan.figures().iter().position(|planned| planned.to_string() == *figure);
        let span =
            place.and_then(|place| sources.get(place)).map_or(Span::default(), |source| source.level_span);
        let (message, hint) = match error {
            BudgetError::TooDeep { level, .. } => (
                format!("level {level} is deeper than {}", budget::MAX_LEVEL),
                format!("the deepest level is {}", budget::MAX_LEVEL),
            ),
            BudgetError::TooMany { elements, limit, fits, .. } => {
                let count = match elements {
                    Some(elements) => format!("{elements} elements"),
                    None => "more elements than can be counted".to_owned(),
                };
                let fits = match fits {
                    Some(level) => format!("the largest level that fits is {level}"),
                    None => "no level fits: use fewer figures or smaller nets".to_owned(),
                };
                (format!("this asks for {count}; the limit is {limit}"), fits)
            }
        };
        let diagnostic = Diagnostic::new(Code::E0701, span, message).label("too deep");
        // A short word is the number or a name for it.
        let level = match error {
            BudgetError::TooDeep { .. } => Some(budget::MAX_LEVEL),
            BudgetError::TooMany { fits, .. } => *fits,
        };
        self.diagnostics.push(match level.filter(|_| span.end - span.start <= 3) {
            Some(level) => diagnostic.fix(hint, span, level.to_string()),
            None => diagnostic.hint(hint),
        });
    }
}
