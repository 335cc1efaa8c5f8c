//! Figures of polygons that share their edges: found, and reported where they must and do not.

use super::{FigureSource, Lowering};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::schema::SchemaKind;
use crate::ifs::{Automaton, GermShape, OpenEdge, PieceEdge, StateId, SurfaceJoins, surface_joins};
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
            if matches!(verdict, SurfaceJoins::Joined(_)) && only_quads(automaton, *state) {
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
        let name = &automaton.state(state).name;
        let refuse = |message: String| Diagnostic::new(Code::E0505, at, message).label(why);
        match verdict {
            SurfaceJoins::Joined(_) if only_quads(automaton, state) => None,
            SurfaceJoins::Joined(_) => {
                let message =
                    format!("a surface of polygons other than quads, as `{name}` is, is not available yet");
                Some(Diagnostic::new(Code::E0001, at, message).label(why).hint("draw it with quads"))
            }
            SurfaceJoins::Open(open) => Some(self.open_edge(automaton, name, open, at, why)),
            SurfaceJoins::NotPolygons { state } => {
                let drawn = &automaton.state(*state).name;
                Some(refuse(format!("`{name}` is no surface: `{drawn}` is not drawn as a polygon")))
            }
            SurfaceJoins::Unproved { .. } => {
                let message = format!("the pieces of `{name}` could not be proved to share their edges");
                Some(
                    refuse(message).note("the proof takes too many steps, or the polygon is never cut apart"),
                )
            }
        }
    }

    fn open_edge(
        &self,
        automaton: &Automaton,
        name: &str,
        open: &OpenEdge,
        at: Span,
        why: &str,
    ) -> Diagnostic {
        let piece = |edge: &PieceEdge| {
            let transform = &automaton.state(open.state).transforms[edge.transform];
            let corners = automaton.state(transform.target).germ.vertices.len();
            let edge = format!("{} to {}", edge.edge + 1, (edge.edge + 1) % corners + 1);
            (transform.name.clone(), edge)
        };
        let ((left, left_edge), (right, right_edge)) = (piece(&open.left), piece(&open.right));
        let message = format!(
            "the pieces of `{name}` do not share their edges: `{left}`, corners {left_edge}, does not fit `{right}`, corners {right_edge}"
        );
        let gap = self.gap_words(automaton, open.state, [&open.left_weights, &open.right_weights]);
        let mut diagnostic = Diagnostic::new(Code::E0505, at, message).label(why);
        let sides = [(open.left.transform, &open.left_weights), (open.right.transform, &open.right_weights)];
        for (transform, row) in sides {
            if let Some(span) = self.transform_span(open.state, transform) {
                let corner = self.place_words(automaton, open.state, row);
                diagnostic = diagnostic.also(span, format!("has a corner at {corner}"));
            }
        }
        diagnostic
            .note(format!("at level {} they are {gap} apart", open.level))
            .hint("give both pieces the same points along the edge; a `let` for a shared point makes sure")
    }
}

fn draws_polygons(automaton: &Automaton, state: StateId) -> bool {
    automaton.state(state).germ.shape == GermShape::Polygon
}

/// Whether every piece is drawn as a quad, and nothing on the way.
fn only_quads(automaton: &Automaton, state: StateId) -> bool {
    let quad = |id: &StateId| {
        let state = automaton.state(*id);
        state.germ.vertices.len() == 4 && state.keep.is_empty()
    };
    automaton.reachable(state).iter().all(quad)
}
