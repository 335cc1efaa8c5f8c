//! Which of the two methods, with its parameters.

use std::ops::ControlFlow;

use crate::geometry::QuadMesh;

use super::options::{Perturbation, Pin, Projection};
use super::outcome::{Outcome, Progress};
use super::{perturb, project};

/// A method of planarizing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// The paper's perturbation.
    Perturbation(Perturbation),
    /// The fast solver.
    Projection(Projection),
}

impl Method {
    /// Which vertices do not move.
    #[must_use]
    pub fn pin(&self) -> Pin {
        match self {
            Self::Perturbation(options) => options.pin,
            Self::Projection(options) => options.pin,
        }
    }

    /// The most steps it makes.
    #[must_use]
    pub fn iterations(&self) -> u32 {
        match self {
            Self::Perturbation(options) => options.iterations,
            Self::Projection(options) => options.iterations,
        }
    }

    /// The planarity it aims at.
    #[must_use]
    pub fn threshold(&self) -> f64 {
        match self {
            Self::Perturbation(options) => options.threshold,
            Self::Projection(options) => options.threshold,
        }
    }

    /// Moves the vertices of `mesh`: [`perturb`] or [`project`].
    pub fn run(&self, mesh: &QuadMesh, progress: &mut dyn FnMut(Progress) -> ControlFlow<()>) -> Outcome {
        match self {
            Self::Perturbation(options) => perturb(mesh, options, progress),
            Self::Projection(options) => project(mesh, options, progress),
        }
    }
}
