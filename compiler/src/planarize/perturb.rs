//! The perturbation method as a whole: when to go on, when to change the objective, when to end.

use std::ops::ControlFlow;

use crate::geometry::QuadMesh;

use super::options::Perturbation;
use super::outcome::{Outcome, Progress, StopReason};
use super::search::Search;

/// Iterations without a better mesh before the objective changes; once more as many for each change made in vain.
const PATIENCE: u32 = 20;

/// Changes of the objective without a better mesh before the search ends.
const CHANGES: u32 = 4;

/// Moves the vertices of `mesh` so that its quads become flat: the paper's perturbation method (section 7.2;
/// GEOMETRY section 6a).
///
/// The search goes down a smooth objective: the q-norm (q = 8) of the deficits 1 − cos of all folds stands in for
/// 1 − worst. Its gradient is made of central differences, its direction is that of L-BFGS, with displacements
/// smoothed over the mesh so that neighbours move alike. Where the worst stalls it goes down the average for a
/// while. Which mesh is kept is decided by the true worst planarity (by the true mean where α is 0).
///
/// The mesh returned has a worst planarity no lower than the given one, no quad inverted that was not, and its
/// pinned vertices exactly where they were. `progress` is asked before each step; on `Break` the best mesh so far
/// is returned. The same input gives the same bits.
pub fn perturb(
    mesh: &QuadMesh,
    options: &Perturbation,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Outcome {
    let mut search = Search::new(mesh, options);
    let stop = run(&mut search, options, progress);
    search.into_outcome(stop)
}

fn run(
    search: &mut Search<'_>,
    options: &Perturbation,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> StopReason {
    if search.nothing_selected() {
        return StopReason::NothingSelected;
    }
    if let Some(reason) = search.reached() {
        return reason;
    }
    let (mut waited, mut changes) = (0, 0);
    loop {
        if search.iteration() >= options.iterations {
            return StopReason::IterationsUsed;
        }
        if progress(search.progress()).is_break() {
            return StopReason::Cancelled;
        }
        let moved = search.step();
        if moved && search.keep_if_better() {
            if let Some(reason) = search.reached() {
                return reason;
            }
            (waited, changes) = (0, 0);
        } else {
            waited += 1;
        }
        if !moved || waited >= PATIENCE * (1 + changes) {
            waited = 0;
            changes += 1;
            if changes > CHANGES {
                return StopReason::Stalled;
            }
            search.change_mode();
        }
    }
}
