//! The fast solver (GEOMETRY section 6b): Gauss–Newton steps on the planarity of the quads, each the fairest
//! displacement that makes them flat.

mod cholesky;
mod constraints;
mod displacement;
mod dissection;
mod solver;
mod step;

pub use solver::project;

#[cfg(test)]
mod tests;
