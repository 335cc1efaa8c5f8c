//! What a run of a method hands back, and what it says on the way.

use glam::DVec3;

use super::faces::inverted;
use crate::geometry::{MeshSummary, QuadMeasure, QuadMesh};

/// Said before each iteration; an answer of `Break` ends the search with the best mesh so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Iterations made so far.
    pub iteration: u32,
    /// The most there will be.
    pub iterations: u32,
    /// Worst planarity at this point of the search.
    pub worst: Option<f64>,
    /// Mean planarity at this point of the search.
    pub mean: Option<f64>,
}

/// One point of the convergence plot: the true figures of the whole mesh, not the smooth ones of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IterationRecord {
    /// Worst planarity.
    pub worst: Option<f64>,
    /// Mean planarity.
    pub mean: Option<f64>,
}

/// Why the search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopReason {
    /// Every selected quad has the planarity asked for.
    Reached,
    /// All iterations were used.
    IterationsUsed,
    /// Neither the worst nor the average got better any more.
    Stalled,
    /// The caller said stop.
    Cancelled,
    /// No quad falls short of `select`.
    NothingSelected,
    /// Every selected quad that may change has the planarity asked for; others that fall short have no vertex that
    /// may move.
    OnlyPinnedLeft,
    /// All others are flat enough; what falls short was folded over at the start, which projection does not unfold.
    OnlyFoldedLeft,
    /// The mesh is too large for projection's system of equations; nothing was moved.
    TooLarge,
}

/// How far vertices moved.
#[derive(Debug, Clone, PartialEq)]
pub struct Moved {
    /// For each vertex, mm.
    pub distances: Vec<f64>,
    /// The longest, mm.
    pub max: f64,
    /// Their mean over all vertices, pinned ones too; mm.
    pub mean: f64,
    /// How many vertices moved at all.
    pub count: usize,
}

impl Moved {
    /// The distances between vertices of the same index.
    pub(super) fn between(before: &[DVec3], after: &[DVec3]) -> Self {
        let distances: Vec<f64> = before.iter().zip(after).map(|(from, to)| from.distance(*to)).collect();
        let max = distances.iter().copied().fold(0.0, f64::max);
        let mean = distances.iter().sum::<f64>() / distances.len().max(1) as f64;
        let count = distances.iter().filter(|&&distance| distance > 0.0).count();
        Self { distances, max, mean, count }
    }
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The mesh with its vertices moved; same quads.
    pub mesh: QuadMesh,
    /// The start, then the figures after each iteration.
    pub history: Vec<IterationRecord>,
    /// Iterations made.
    pub iterations: u32,
    /// The iteration whose mesh is returned; 0 is the start.
    pub best_iteration: u32,
    /// Why it ended.
    pub stop: StopReason,
    /// The mesh as it was given.
    pub before: MeshSummary,
    /// The mesh as it is returned.
    pub after: MeshSummary,
    /// How far vertices moved.
    pub moved: Moved,
    /// How many quads are inverted that were not: 0, whatever is given.
    pub inverted: usize,
}

impl Outcome {
    /// What became of `start`, whose quads measured `first`, when its vertices went to `best`.
    pub(super) fn of(
        start: &QuadMesh,
        first: Vec<QuadMeasure>,
        best: Vec<DVec3>,
        history: Vec<IterationRecord>,
        best_iteration: u32,
        stop: StopReason,
    ) -> Outcome {
        let moved = Moved::between(&start.vertices, &best);
        let inverted = inverted(start, &first, &best);
        let mesh = QuadMesh { vertices: best, quads: start.quads.clone() };
        Outcome {
            after: MeshSummary::of(&mesh),
            before: MeshSummary::of_measures(first),
            mesh,
            iterations: u32::try_from(history.len() - 1).unwrap_or(u32::MAX),
            history,
            best_iteration,
            stop,
            moved,
            inverted,
        }
    }
}
