//! Moving the vertices of a quad mesh so that its quads become flat: the paper's perturbation method, and
//! the faster projection (GEOMETRY section 6). Imports geometry only.
//!
//! Both keep the mesh's connectivity, never return a worse mesh than they were given, and know nothing of boards,
//! requirements or files.

mod faces;
mod field;
mod lbfgs;
mod method;
mod options;
mod outcome;
mod perturb;
mod projection;
mod search;
mod selection;
mod smoothing;

#[cfg(test)]
mod tests;

pub use method::Method;
pub use options::{MAX_ITERATIONS, OptionsError, Perturbation, Pin, Projection};
pub use outcome::{IterationRecord, Moved, Outcome, Progress, StopReason};
pub use perturb::perturb;
pub use projection::project;
