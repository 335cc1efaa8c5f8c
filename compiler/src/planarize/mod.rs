//! Moving the vertices of a quad mesh so that its quads become flat: the paper's perturbation method
//! (GEOMETRY section 6a). Imports geometry only.
//!
//! It keeps the mesh's connectivity, never returns a worse mesh than it was given, and knows nothing of boards,
//! requirements or files.

mod field;
mod lbfgs;
mod options;
mod outcome;
mod perturb;
mod search;
mod selection;
mod smoothing;

#[cfg(test)]
mod tests;

pub use options::{MAX_ITERATIONS, OptionsError, Perturbation, Pin};
pub use outcome::{IterationRecord, Moved, Outcome, Progress, StopReason};
pub use perturb::perturb;
