//! Iterated function systems as exact matrices: the automaton of states, and what can be proved of it without points.
//!
//! Here live the matrices of barycentric weights, the automaton they form, counts of elements, contraction and joins.
//! No syntax, no placed points, no levels of a design; only `exact` is imported.

mod automaton;
mod contraction;
mod count;
mod difference;
mod equivalence;
mod germ;
mod joins;
mod matrix;
mod parts;
mod patch;
mod size_bound;
mod spectrum;
mod stated;
mod surface;
mod words;

pub use automaton::{
    Automaton, AutomatonError, Boundary, End, MAX_STATES, Side, State, StateId, StateSpace, StatedJoin,
    Transform,
};
pub use contraction::{Contraction, Norm, WORD_BUDGET, contraction};
pub use count::{Count, Drawn, count, drawn};
pub use difference::{difference_norm, step_factor};
pub use germ::{Germ, GermShape};
pub use joins::{Joins, OpenJoin, ROUNDING, is_rounding, joins, windows_join};
pub use matrix::{Matrix, MatrixError};
pub use patch::{Adjacency, Patch, PieceEdge};
pub use size_bound::{SizeBound, size_bound};
pub use stated::{Apart, Stated, stated_join};
pub use surface::{OpenEdge, SurfaceJoins, surface_joins};
pub use words::Word;

#[cfg(test)]
pub(crate) mod tests;
