//! Tests of matrices, automata, counts, contraction and joins.

mod automata;
mod contractions;
pub(crate) mod fixtures;
mod joining;
mod sizes;
mod stating;
pub(crate) mod surfaces;
