//! Figures of polygons that share their edges: found, and reported where they must and do not.

use super::kind::{keeping, keeps, no_surface, without_keep};
use super::places::{gap_words, place_words};
use super::{FigureSource, Lowering};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::schema::SchemaKind;
use crate::ifs::{Automaton, GermShape, OpenEdge, StateId, SurfaceJoins, surface_joins};
use crate::plan::figure::{FigurePlan, PatchworkPlan, Shape};
use crate::source::Span;
use std::collections::BTreeMap;

impl Lowering<'_, '_> {
    /// Makes a patchwork of every figure of quads that share their edges; whether all do that must.
    pub(super) fn find_patchworks(
        &mut self,
        automaton: &Automaton,
        figures: &mut [(FigurePlan, FigureSource)],
    ) -> bool {
        let mut known: BTreeMap<StateId, SurfaceJoins> = BTreeMap::new();
        let mut good = true;
        let uses = self.evaluator.must_join().to_vec();
        let mut needed: Vec<(StateId, Span, String)> = Vec::new();
        for used in uses {
            let Some(state) = self.states.find(&used.ifs) else { continue };
            if draws_polygons(automaton, state) {
                needed.push((state, used.span, used.why));
            }
        }
        for (figure, source) in figures {
            let Shape::Curve { state, points, level, dimension } = &figure.shape else { continue };
            if !draws_polygons(automaton, *state) {
                continue;
            }
            let panels = self
                .hir
                .fabricates
                .iter()
                .find(|block| block.figure == source.item && block.kind == SchemaKind::Panels);
            if let Some(block) = panels {
                needed.push((*state, block.figure_span, "panels need to know their neighbours".to_owned()));
            }
            let verdict = known.entry(*state).or_insert_with(|| surface_joins(automaton, *state));
            let whole = only_quads(automaton, *state) && keeping(automaton, *state).is_none();
            if whole && matches!(verdict, SurfaceJoins::Joined(_)) {
                let (state, points, level, dimension) = (*state, points.clone(), *level, *dimension);
                figure.shape = Shape::Patchwork(PatchworkPlan { state, points, level, dimension });
            }
        }
        // One mistake, said where it matters first.
        let mut said: Vec<StateId> = Vec::new();
        for (state, at, why) in needed {
            if said.contains(&state) {
                continue;
            }
            let verdict = known.entry(state).or_insert_with(|| surface_joins(automaton, state)).clone();
            let Some(diagnostic) = self.not_a_surface(automaton, state, &verdict, at, &why) else { continue };
            good = false;
            said.push(state);
            self.diagnostics.push(diagnostic);
        }
        good
    }

    fn not_a_surface(
        &self,
        automaton: &Automaton,
        state: StateId,
        verdict: &SurfaceJoins,
        at: Span,
        why: &str,
    ) -> Option<Diagnostic> {
        if let Some(keeping) = keeping(automaton, state) {
            return Some(without_keep(
                automaton,
                keeping,
                Diagnostic::new(Code::E0505, at, keeps(automaton, state, keeping, "surface")).label(why),
            ));
        }
        let Some(message) = no_surface(automaton, state, verdict) else {
            if only_quads(automaton, state) {
                return None;
            }
            let name = &automaton.state(state).name;
            let message =
                format!("a surface of polygons other than quads, as `{name}` is, is not available yet");
            return Some(Diagnostic::new(Code::E0001, at, message).label(why).hint("draw it with quads"));
        };
        let diagnostic = Diagnostic::new(Code::E0505, at, message).label(why);
        Some(match verdict {
            SurfaceJoins::Open(open) => self.at_open_edge(automaton, open, diagnostic),
            SurfaceJoins::Unproved { .. } => {
                diagnostic.note("the proof takes too many steps, or the polygon is never cut apart")
            }
            SurfaceJoins::Joined(_) | SurfaceJoins::NotPolygons { .. } => diagnostic,
        })
    }

    /// With where the corners lie that should be one.
    fn at_open_edge(&self, automaton: &Automaton, open: &OpenEdge, mut diagnostic: Diagnostic) -> Diagnostic {
        let parting = automaton.state(open.state);
        let sides = [(open.left.transform, &open.left_weights), (open.right.transform, &open.right_weights)];
        for (transform, row) in sides {
            if let Some(span) = self.transform_span(open.state, transform) {
                diagnostic = diagnostic.also(span, format!("has a corner at {}", place_words(parting, row)));
            }
        }
        let gap = gap_words(parting, [&open.left_weights, &open.right_weights]);
        diagnostic
            .note(format!("at level {} they are {gap} apart", open.level))
            .hint("give both pieces the same points along the edge; a `let` for a shared point makes sure")
    }
}

fn draws_polygons(automaton: &Automaton, state: StateId) -> bool {
    automaton.state(state).germ.shape == GermShape::Polygon
}

/// Whether every piece is drawn as a quad.
fn only_quads(automaton: &Automaton, state: StateId) -> bool {
    automaton.reachable(state).iter().all(|id| automaton.state(*id).germ.vertices.len() == 4)
}
