//! What an ifs is where it is placed (LANGUAGE 9): a curve, a surface, or a figure of separate pieces; and which joint is
//! open then. In words, for what is reported and for what an editor tells.

use super::places::{gap_words, place_words};
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use crate::ifs::{
    Automaton, GermShape, Joins, OpenEdge, OpenJoin, PieceEdge, StateId, SurfaceJoins, joins, surface_joins,
};

/// What an ifs is where it is placed on control points at a level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FigureKind {
    /// Its pieces meet end to start, or do so but for rounding.
    Curve {
        /// Whether only but for rounding.
        rounded: bool,
    },
    /// Its pieces share their edges.
    Surface,
    /// Its pieces are separate: why, as a sentence without its stop.
    Figure {
        /// Which joint is open, or what is drawn.
        why: String,
    },
}

/// What a state is where it is placed.
///
/// # Panics
/// When the state is not of this automaton.
pub fn figure_kind(automaton: &Automaton, state: StateId) -> FigureKind {
    match automaton.state(state).germ.shape {
        GermShape::Polygon => kind_of_polygons(automaton, state),
        _ => kind_of_segments(automaton, state),
    }
}

fn kind_of_segments(automaton: &Automaton, state: StateId) -> FigureKind {
    let verdict = joins(automaton, state);
    if is_curve(automaton, state, &verdict) {
        return FigureKind::Curve { rounded: matches!(verdict, Joins::Rounded(_)) };
    }
    let mut why = no_curve(automaton, state, &verdict);
    if let (Joins::Open(open), None) = (&verdict, keeping(automaton, state)) {
        why += &format!("; {}", apart_words(automaton, open));
    }
    FigureKind::Figure { why }
}

/// `at level 1 they are at m and b, 1/2 a - 1/2 b apart`
fn apart_words(automaton: &Automaton, open: &OpenJoin) -> String {
    parted(automaton, open.state, open.level, [&open.left_weights, &open.right_weights])
}

fn parted(automaton: &Automaton, state: StateId, level: u32, rows: [&[Rational]; 2]) -> String {
    let state = automaton.state(state);
    let [left, right] = rows.map(|row| place_words(state, row));
    format!("at level {level} these lie at {left} and at {right}, {} apart", gap_words(state, rows))
}

fn kind_of_polygons(automaton: &Automaton, state: StateId) -> FigureKind {
    if let Some(keeping) = keeping(automaton, state) {
        return FigureKind::Figure { why: keeps(automaton, state, keeping, "surface") };
    }
    let verdict = surface_joins(automaton, state);
    let Some(mut why) = no_surface(automaton, state, &verdict) else { return FigureKind::Surface };
    if let SurfaceJoins::Open(open) = &verdict {
        let rows = [&open.left_weights[..], &open.right_weights];
        why += &format!("; {}", parted(automaton, open.state, open.level, rows));
    }
    FigureKind::Figure { why }
}

/// Whether a state of these joins is a curve: what it keeps on the way would be more than one.
pub(super) fn is_curve(automaton: &Automaton, state: StateId, verdict: &Joins) -> bool {
    verdict.hold() && keeping(automaton, state).is_none()
}

/// The first state a figure leads to that keeps something.
pub(super) fn keeping(automaton: &Automaton, state: StateId) -> Option<StateId> {
    automaton.reachable(state).into_iter().find(|id| !automaton.state(*id).keep.is_empty())
}

pub(super) fn keeps(automaton: &Automaton, state: StateId, keeping: StateId, what: &str) -> String {
    let (name, keeping) = (&automaton.state(state).name, &automaton.state(keeping).name);
    format!("`{name}` is no {what}: `{keeping}` keeps what it draws on the way")
}

/// With the way out where a state keeps something.
pub(super) fn without_keep(automaton: &Automaton, keeping: StateId, diagnostic: Diagnostic) -> Diagnostic {
    let keeping = &automaton.state(keeping).name;
    diagnostic.hint(format!("leave `keep` out of `{keeping}`, or draw what it keeps by an ifs of its own"))
}

/// Why a state that is no curve is none.
pub(super) fn no_curve(automaton: &Automaton, state: StateId, verdict: &Joins) -> String {
    let name = &automaton.state(state).name;
    if let Some(keeping) = keeping(automaton, state) {
        return keeps(automaton, state, keeping, "curve");
    }
    match verdict {
        Joins::NotSegments { state } => {
            format!("`{name}` is no curve: `{}` is not drawn as segments", automaton.state(*state).name)
        }
        Joins::Open(open) => {
            let transforms = &automaton.state(open.state).transforms;
            let (left, right) = (&transforms[open.left].name, &transforms[open.right].name);
            format!("the pieces of `{name}` do not meet: `{left}` does not end where `{right}` starts")
        }
        Joins::Joined | Joins::Rounded(_) | Joins::Unproved { .. } => {
            format!("the pieces of `{name}` could not be proved to meet")
        }
    }
}

/// Why a state that is no surface is none.
pub(super) fn no_surface(automaton: &Automaton, state: StateId, verdict: &SurfaceJoins) -> Option<String> {
    let name = &automaton.state(state).name;
    match verdict {
        SurfaceJoins::Joined(_) => None,
        SurfaceJoins::Open(open) => {
            let [(left, left_edge), (right, right_edge)] =
                [&open.left, &open.right].map(|edge| edge_words(automaton, open, edge));
            Some(format!(
                "the pieces of `{name}` do not share their edges: `{left}`, corners {left_edge}, does not fit `{right}`, corners {right_edge}"
            ))
        }
        SurfaceJoins::NotPolygons { state } => {
            let drawn = &automaton.state(*state).name;
            Some(format!("`{name}` is no surface: `{drawn}` is not drawn as a polygon"))
        }
        SurfaceJoins::Unproved { .. } => {
            Some(format!("the pieces of `{name}` could not be proved to share their edges"))
        }
    }
}

/// The name of a piece's transform, and its edge as `1 to 2`.
fn edge_words<'a>(automaton: &'a Automaton, open: &OpenEdge, edge: &PieceEdge) -> (&'a str, String) {
    let transform = &automaton.state(open.state).transforms[edge.transform];
    let corners = automaton.state(transform.target).germ.vertices.len();
    (&transform.name, format!("{} to {}", edge.edge + 1, (edge.edge + 1) % corners + 1))
}
