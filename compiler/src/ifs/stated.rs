//! Joins as they are stated (GEOMETRY 3): adjacency `join left.end = right.start` and incidence `join start = left.start`.
//!
//! Both sides are a part of a state on points of this one: B_b·T_t for the boundary b of a piece, U·B_b for the state's
//! own boundary after one step. The join holds when the two draw the same at every level, for all control points.

use crate::exact::Rational;

use super::automaton::{Automaton, End, Side, State, StateId, StatedJoin, Transform};
use super::equivalence::{Claim, Equivalence, Placed, prove};
use super::matrix::Matrix;
use super::parts::{Part, Parts};

/// What is known of a stated join.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stated {
    /// It holds at every level.
    Holds,
    /// Two vertices that should be one.
    Apart(Apart),
    /// The two sides draw different kinds or numbers of things.
    Unlike {
        /// The level of the state's figure at which they differ, at least 1.
        level: u32,
    },
    /// The proof needs more than is allowed.
    Unproved {
        /// The level of the state's figure that was reached.
        level: u32,
    },
}

/// Where a stated join fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Apart {
    /// The level of the state's figure at which the two sides part, at least 1.
    pub level: u32,
    /// Weights of the left side's vertex on the state's control points.
    pub left_weights: Vec<Rational>,
    /// Weights of the right side's vertex.
    pub right_weights: Vec<Rational>,
}

/// Whether a join that is stated of `state` holds.
///
/// # Panics
/// When the state is not of this automaton, or the join is none of the state's.
pub fn stated_join(automaton: &Automaton, state: StateId, join: &StatedJoin) -> Stated {
    let mut parts = Parts::default();
    let sides =
        [join.left, join.right].map(|side| placed(automaton, automaton.state(state), side, &mut parts));
    let [Some(left), Some(right)] = sides else { return Stated::Unlike { level: 1 } };
    match prove(&parts.nodes, &[Claim { left, right, reversed: false }]) {
        Equivalence::Same => Stated::Holds,
        Equivalence::Apart { level, left, right, .. } => {
            Stated::Apart(Apart { level: level + 1, left_weights: left, right_weights: right })
        }
        Equivalence::Unlike { level, .. } => Stated::Unlike { level: level + 1 },
        Equivalence::Unproved { level } => Stated::Unproved { level: level + 1 },
    }
}

/// A side as a part on the state's points; `None` for an end of what is no chain at every level.
fn placed(automaton: &Automaton, state: &State, side: Side, parts: &mut Parts) -> Option<Placed> {
    let (target, part, matrix): (StateId, Part, Matrix) = match side {
        Side::Piece { transform, boundary } => {
            let piece = &state.transforms[transform];
            let boundary = &automaton.state(piece.target).boundaries[boundary];
            (boundary.target, Part::Whole, boundary.matrix.product(&piece.matrix).ok()?)
        }
        Side::Own { boundary, transform } => {
            let boundary = &state.boundaries[boundary];
            let step = &automaton.state(boundary.target).transforms[transform];
            (step.target, Part::Whole, step.matrix.product(&boundary.matrix).ok()?)
        }
        Side::PieceEnd { transform, end } => {
            let piece = &state.transforms[transform];
            (piece.target, Part::of(end), piece.matrix.clone())
        }
        Side::OwnEnd(end) => {
            let piece: &Transform = match end {
                End::Start => state.transforms.first()?,
                End::Finish => state.transforms.last()?,
            };
            (piece.target, Part::of(end), piece.matrix.clone())
        }
    };
    Some(Placed { node: parts.enter(automaton, target, part)?, matrix })
}
