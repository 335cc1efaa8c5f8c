//! What is proved of the states that figures stand on, said at the lines they come from: contraction and joins.

use super::kind::{is_curve, keeping, no_curve, without_keep};
use super::places::{gap_words, place_words, weights};
use super::{FigureSource, Lowering};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::dimension::Dimension;
use crate::hir::evaluate::quantity_words_to;
use crate::hir::tree::ItemId;
use crate::ifs::{
    Automaton, Contraction, GermShape, Joins, StateId, StateSpace, contraction, joins, step_factor,
    windows_join,
};
use crate::plan::figure::{Depth, FigurePlan, PiecesPlan, Shape};
use crate::source::Span;
use std::collections::BTreeMap;

const ROUNDING_HINT: &str = "numbers such as `sqrt(3)` and most sines are rounded: all is well if the pieces are meant to meet; on control points, `on (…)`, such joins are exact";

type Planned = (FigurePlan, FigureSource);

/// What was proved of states so far, each once however many figures stand on it.
#[derive(Default)]
struct Proofs {
    pieces: BTreeMap<StateId, Joins>,
    windows: BTreeMap<StateId, Joins>,
}

impl Proofs {
    fn pieces(&mut self, automaton: &Automaton, state: StateId) -> Joins {
        self.pieces.entry(state).or_insert_with(|| joins(automaton, state)).clone()
    }

    fn windows(&mut self, automaton: &Automaton, state: StateId) -> Joins {
        self.windows.entry(state).or_insert_with(|| windows_join(automaton, state)).clone()
    }
}

impl Lowering<'_, '_> {
    /// Warns of every ifs a figure stands on that is not proved to contract.
    pub(super) fn check_contraction(&mut self, automaton: &Automaton, figures: &[Planned]) {
        let mut warned: Vec<Span> = Vec::new();
        for (state, item) in roots(figures) {
            let span = self.state_span(state);
            let verdict = contraction(automaton, state);
            if matches!(verdict, Contraction::Proved { .. }) || warned.contains(&span) {
                continue;
            }
            warned.push(span);
            // An ifs of the library is as it should be: what it is given here is not.
            let own = !self.hir.is_library(span.file);
            let at = if own { span } else { self.hir.item(item).name_span };
            self.warn_of_contraction(automaton, state, &verdict, at);
        }
    }

    fn warn_of_contraction(
        &mut self,
        automaton: &Automaton,
        state: StateId,
        verdict: &Contraction,
        span: Span,
    ) {
        let found = &automaton.state(state).name;
        let diagnostic = match verdict {
            Contraction::Proved { .. } => return,
            Contraction::Refuted { word } => {
                let word = word.display(automaton);
                let message = format!("`{found}` does not contract: repeating `{word}` never gets smaller");
                Diagnostic::new(Code::W0508, span, message)
                    .label("there is no limit figure for all control points")
                    .hint("move the images of the control points closer together, or use more transforms")
            }
            Contraction::Open { length, bound } => {
                let message = format!(
                    "`{found}` could not be proved to contract: after {length} steps pieces could still be {bound:.4} times as large"
                );
                Diagnostic::new(Code::W0509, span, message)
                    .label("not proved, and not refuted")
                    .hint("if the figure looks right at a high level, all is well")
            }
        };
        let factors = automaton.state(state).transforms.iter().map(|transform| {
            let factor = step_factor(automaton, state, transform);
            let factor = quantity_words_to(factor, Dimension::NUMBER, 6);
            format!("`{}` {factor}", transform.name)
        });
        let note = format!("factors of one step: {}", factors.collect::<Vec<_>>().join(", "));
        self.diagnostics.push(diagnostic.note(note));
    }

    /// Whether the pieces of every ifs are proved to meet where they must; a figure whose pieces need not, and do not,
    /// becomes one of separate pieces.
    pub(super) fn check_joins(&mut self, automaton: &Automaton, figures: &mut [Planned]) -> bool {
        let mut proofs = Proofs::default();
        let mut good = true;
        let uses = self.evaluator.must_join().to_vec();
        let mut said: Vec<(Span, StateId)> = Vec::new();
        for used in uses {
            let Some(state) = self.states.find(&used.ifs) else { continue };
            if automaton.state(state).germ.shape == GermShape::Polygon {
                continue;
            }
            let verdict = proofs.pieces(automaton, state);
            let at = self.state_span(state);
            if !is_curve(automaton, state, &verdict) && !said.contains(&(at, state)) {
                said.push((at, state));
                good = false;
                let diagnostic = self.open(automaton, state, &verdict, used.span, &used.why);
                self.diagnostics.push(diagnostic);
            } else {
                self.warn_of_rounding(automaton, state, &verdict, used.span);
            }
        }
        for (figure, source) in figures {
            good &= self.figure_joins(automaton, figure, source, &mut proofs, &said);
        }
        good
    }

    fn figure_joins(
        &mut self,
        automaton: &Automaton,
        figure: &mut FigurePlan,
        source: &FigureSource,
        proofs: &mut Proofs,
        said: &[(Span, StateId)],
    ) -> bool {
        let named = self.hir.item(source.item).name_span;
        match &figure.shape {
            Shape::Curve { state, points, level, dimension } => {
                let verdict = proofs.pieces(automaton, *state);
                if is_curve(automaton, *state, &verdict) {
                    self.warn_of_rounding(automaton, *state, &verdict, named);
                    return true;
                }
                if said.iter().any(|(_, other)| other == state) {
                    return false;
                }
                let made = self.hir.fabricates.iter().find(|block| block.figure == source.item);
                let Some(block) = made else {
                    figure.shape = Shape::Pieces(PiecesPlan {
                        state: *state,
                        points: points.clone(),
                        dimension: *dimension,
                        depth: Depth::Level(*level),
                    });
                    return true;
                };
                let why = format!("{} are made of what holds together", block.kind.name());
                let diagnostic = self.open(automaton, *state, &verdict, block.figure_span, &why);
                if !self.diagnostics.contains(&diagnostic) {
                    self.diagnostics.push(diagnostic);
                }
                false
            }
            Shape::Pieces(_) | Shape::Patchwork(_) => true,
            shape => {
                let mut good = true;
                for used in shape.uses().into_iter().filter(|used| used.has_neighbours(automaton)) {
                    let verdict = proofs.windows(automaton, used.state);
                    if verdict == Joins::Joined {
                        continue;
                    }
                    let at = self.place_of_use(used.state, source.made).unwrap_or(named);
                    self.warn_of_rounding(automaton, used.state, &verdict, at);
                    if verdict.hold() {
                        continue;
                    }
                    let falls = if shape.is_curve() { "chain" } else { "sheet" };
                    let diagnostic = self.open_windows(automaton, used.state, &verdict, falls, at);
                    if !self.diagnostics.contains(&diagnostic) {
                        self.diagnostics.push(diagnostic);
                    }
                    good = false;
                }
                good
            }
        }
    }

    /// Where an ifs is named whose pieces must join: of several places, the one in this figure.
    fn place_of_use(&self, state: StateId, made: Span) -> Option<Span> {
        let instance = self.states.instances.get(state.index())?;
        let uses = || self.evaluator.must_join().iter().filter(|used| used.ifs == *instance);
        let inside = |at: Span| at.file == made.file && made.start <= at.start && at.end <= made.end;
        uses().find(|used| inside(used.span)).or_else(|| uses().next()).map(|used| used.span)
    }

    fn open(
        &self,
        automaton: &Automaton,
        state: StateId,
        verdict: &Joins,
        at: Span,
        why: &str,
    ) -> Diagnostic {
        let diagnostic = Diagnostic::new(Code::E0505, at, no_curve(automaton, state, verdict)).label(why);
        if let Some(keeping) = keeping(automaton, state) {
            return without_keep(automaton, keeping, diagnostic);
        }
        if let Joins::NotSegments { state } = verdict {
            return match self.germ_span(*state) {
                Some(germ) => diagnostic.also(germ, "what is drawn of it"),
                None => diagnostic,
            };
        }
        let Joins::Open(open) = verdict else {
            return diagnostic.note("the proof takes too many steps");
        };
        let parting = automaton.state(open.state);
        let (left, right) = (&parting.transforms[open.left].name, &parting.transforms[open.right].name);
        let mut diagnostic = diagnostic;
        if let (Some(first), Some(second)) =
            (self.transform_span(open.state, open.left), self.transform_span(open.state, open.right))
        {
            let end = place_words(parting, &open.left_weights);
            let start = place_words(parting, &open.right_weights);
            diagnostic =
                diagnostic.also(first, format!("ends at {end}")).also(second, format!("starts at {start}"));
        }
        let gap = gap_words(parting, [&open.left_weights, &open.right_weights]);
        diagnostic = diagnostic.note(format!("at level {} they are {gap} apart", open.level));
        diagnostic.hint(match parting.space {
            StateSpace::Control => {
                format!("give the last image of `{left}` and the first image of `{right}` the same point")
            }
            _ => format!(
                "let the map of `{right}` take the start of the germ to where that of `{left}` takes its end, and write the transforms in the order along the curve"
            ),
        })
    }

    fn open_windows(
        &self,
        automaton: &Automaton,
        state: StateId,
        verdict: &Joins,
        falls: &str,
        at: Span,
    ) -> Diagnostic {
        let name = &automaton.state(state).name;
        let points = if falls == "chain" { "list" } else { "net" };
        let message = format!("neighbouring windows of the {points} do not meet with `{name}`");
        let mut diagnostic =
            Diagnostic::new(Code::E0506, at, message).label(format!("this {falls} falls into pieces"));
        if let Joins::Open(open) = verdict {
            let mut names = automaton.state(state).point_names.clone();
            names.push("the next point".to_owned());
            let left = weights(&open.left_weights, &names);
            let right = weights(&open.right_weights, &names);
            diagnostic = diagnostic.note(format!("a window ends at {left}, the next one starts at {right}"));
            if let Some(germ) = self.germ_span(state) {
                diagnostic = diagnostic.also(germ, "what is drawn of each window");
            }
        }
        diagnostic.hint(match falls {
            "chain" => "use a B-spline such as `bspline3`, or place the ifs on just one window",
            _ => "use a B-spline such as `bspline3`, or `tensor` on a net of just one window",
        })
    }

    /// Says once of an ifs that its pieces are one curve but for rounding.
    fn warn_of_rounding(&mut self, automaton: &Automaton, state: StateId, verdict: &Joins, at: Span) {
        let Joins::Rounded(widest) = verdict else { return };
        let own = self.state_span(state);
        let span = if self.hir.is_library(own.file) { at } else { own };
        if self.diagnostics.iter().any(|said| said.code == Code::W0546 && said.span == span) {
            return;
        }
        let name = &automaton.state(state).name;
        let gap = gap_words(automaton.state(widest.state), [&widest.left_weights, &widest.right_weights]);
        let message = format!("the pieces of `{name}` meet only to within rounding, not exactly");
        let diagnostic = Diagnostic::new(Code::W0546, span, message)
            .label("taken as one curve")
            .note(format!("where they meet they are at most {gap} apart at the first levels"))
            .hint(ROUNDING_HINT);
        self.diagnostics.push(diagnostic);
    }

    pub(super) fn state_span(&self, state: StateId) -> Span {
        let instance = self.states.instances.get(state.index());
        instance.map_or(Span::default(), |instance| self.hir.item(instance.ifs).name_span)
    }
}

/// Every state a figure stands on, with the first figure that does.
fn roots(figures: &[Planned]) -> Vec<(StateId, ItemId)> {
    let mut roots = BTreeMap::new();
    for (figure, source) in figures {
        for used in figure.shape.uses() {
            roots.entry(used.state).or_insert(source.item);
        }
    }
    roots.into_iter().collect()
}
