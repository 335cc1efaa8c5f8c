//! Joins of polygon germs (GEOMETRY 3): whether the pieces of a surface share their edges at every level, for all control
//! points.
//!
//! At level 1 the edges that coincide are found, and the rim of the pieces is cut into the edges of the state's own
//! polygon. Then each edge is an automaton of its own, the chain of the pieces' edges along it, and two edges that are
//! glued must draw the same chain, run through backwards, at every level ([`super::equivalence`]).

use std::collections::BTreeSet;

use crate::exact::Rational;

use super::automaton::{Automaton, StateId};
use super::equivalence::{Claim, Equivalence, Placed, prove};
use super::germ::GermShape;
use super::parts::{Part, Parts};
use super::patch::{Adjacency, PieceEdge, Segment, coincident, patch, segments};

/// Edges that are compared with one another to find those that come nearest, at most.
const MOST_COMPARED: usize = 200;

/// Whether the pieces of a surface share their edges.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SurfaceJoins {
    /// They do, in this way.
    Joined(Adjacency),
    /// These two edges should be one, and are not.
    Open(OpenEdge),
    /// A state that the figure leads to is not drawn as a polygon.
    NotPolygons {
        /// The first such state.
        state: StateId,
    },
    /// They do at the levels looked at, but the proof needs more than is allowed.
    Unproved {
        /// How many levels were looked at.
        levels: u32,
    },
}

/// Two edges of pieces that are not one. Where no edges of a state's pieces coincide they are those that come nearest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OpenEdge {
    /// The state whose pieces they are of.
    pub state: StateId,
    /// The level of the state's figure at which they part, at least 1.
    pub level: u32,
    /// The edge of the one piece.
    pub left: PieceEdge,
    /// The edge of the other, which runs against it.
    pub right: PieceEdge,
    /// Weights of a vertex of the first on the state's control points.
    pub left_weights: Vec<Rational>,
    /// Weights of the vertex of the second that should be the same.
    pub right_weights: Vec<Rational>,
}

/// Whether the pieces of the surface of `state`, and of every state it leads to, share their edges.
///
/// # Panics
/// When the state is not of this automaton.
pub fn surface_joins(automaton: &Automaton, state: StateId) -> SurfaceJoins {
    let states = automaton.reachable(state);
    let polygon = |id: &StateId| automaton.state(*id).germ.shape == GermShape::Polygon;
    if let Some(state) = states.iter().find(|id| !polygon(id)) {
        return SurfaceJoins::NotPolygons { state: *state };
    }
    let mut adjacency = Adjacency::default();
    for id in states {
        let Some(segments) = segments(automaton, id) else { return SurfaceJoins::NotPolygons { state: id } };
        match patch(automaton, id, &segments) {
            Some(patch) => adjacency.patches.insert(id, patch),
            None => return open_at_once(id, &segments),
        };
    }
    proved(automaton, adjacency)
}

fn proved(automaton: &Automaton, adjacency: Adjacency) -> SurfaceJoins {
    let mut parts = Parts::with(adjacency);
    let glued: Vec<(StateId, PieceEdge, PieceEdge)> = parts
        .adjacency
        .patches
        .iter()
        .flat_map(|(id, patch)| patch.glued.iter().map(move |(left, right)| (*id, *left, *right)))
        .collect();
    let mut claims = Vec::new();
    for (id, left, right) in &glued {
        let mut place = |at: &PieceEdge| {
            let transform = &automaton.state(*id).transforms[at.transform];
            let node = parts.enter(automaton, transform.target, Part::Edge(at.edge))?;
            Some(Placed { node, matrix: transform.matrix.clone() })
        };
        if let (Some(left), Some(right)) = (place(left), place(right)) {
            claims.push(Claim { left, right, reversed: true });
        }
    }
    if claims.len() < glued.len() {
        return SurfaceJoins::Unproved { levels: 1 };
    }
    match prove(&parts.nodes, &claims) {
        Equivalence::Same => SurfaceJoins::Joined(parts.adjacency),
        Equivalence::Apart { claim, level, left: left_weights, right: right_weights } => {
            let (state, left, right) = glued[claim];
            let level = level + 1;
            SurfaceJoins::Open(OpenEdge { state, level, left, right, left_weights, right_weights })
        }
        // The one edge has more pieces along it than the other: somewhere along them a gap is open.
        Equivalence::Unlike { claim, .. } => {
            let state = glued[claim].0;
            segments(automaton, state)
                .map_or(SurfaceJoins::NotPolygons { state }, |segments| open_at_once(state, &segments))
        }
        Equivalence::Unproved { level } => SurfaceJoins::Unproved { levels: level + 1 },
    }
}

/// The two edges at level 1 that are glued to nothing and come nearest to each other.
fn open_at_once(state: StateId, segments: &[Segment]) -> SurfaceJoins {
    let pairs = coincident(segments);
    let glued: BTreeSet<usize> = pairs.iter().flat_map(|(a, b)| [*a, *b]).collect();
    let free: Vec<&Segment> = (0..segments.len())
        .filter(|place| !glued.contains(place))
        .map(|place| &segments[place])
        .take(MOST_COMPARED)
        .collect();
    let apart =
        |a: &[Rational], b: &[Rational]| -> Rational { a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum() };
    let mut nearest: Option<(Rational, OpenEdge)> = None;
    for (place, left) in free.iter().enumerate() {
        let others = free[place + 1..].iter().filter(|other| other.at.transform != left.at.transform);
        for right in others {
            let first = apart(&left.start, &right.end);
            let last = apart(&left.end, &right.start);
            let distance = &first + &last;
            if nearest.as_ref().is_some_and(|(least, _)| *least <= distance) {
                continue;
            }
            let (a, b) = if first > last { (&left.start, &right.end) } else { (&left.end, &right.start) };
            let (left_weights, right_weights) = (a.clone(), b.clone());
            let (left, right) = (left.at, right.at);
            nearest =
                Some((distance, OpenEdge { state, level: 1, left, right, left_weights, right_weights }));
        }
    }
    match nearest {
        Some((_, open)) => SurfaceJoins::Open(open),
        None => SurfaceJoins::Unproved { levels: 1 },
    }
}
