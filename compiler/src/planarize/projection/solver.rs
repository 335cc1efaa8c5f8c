//! The solver as a whole: Gauss–Newton steps from the design, their length, what is kept, and when it ends.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{QuadMeasure, QuadMesh, Verdict};
use crate::planarize::faces::Face;
use crate::planarize::outcome::{IterationRecord, Outcome, Progress, StopReason};
use crate::planarize::{Projection, selection};

use super::constraints::{Constraint, Goal, Row, constraints, merit};
use super::displacement::Displacement;
use super::step::step;

/// How close to the design displacements are held, one after the other: the first that reaches the goal is taken.
const CLOSENESS: [f64; 3] = [50.0, 12.0, 200.0];

/// By what closeness grows, how often, to come nearer to the design once the goal was reached.
const CLOSER: (f64, usize) = (4.0, 3);

/// The part of the displacement that such an attempt must save to be kept.
const SAVING: f64 = 0.05;

/// How often a step is halved before it is given up.
const HALVINGS: u32 = 6;

/// When an attempt is given up.
#[derive(Clone, Copy)]
struct Effort {
    /// The most steps.
    steps: usize,
    /// The part of the squared excess that a step must take away to count as progress.
    progress: f64,
    /// Steps without progress that end it.
    patience: u32,
}

/// To reach the goal at all.
const REACH: Effort = Effort { steps: usize::MAX, progress: 0.02, patience: 2 };

/// To reach it once more, nearer to the design.
const APPROACH: Effort = Effort { steps: 8, progress: 0.3, patience: 1 };

/// Moves the vertices of `mesh` so that its quads become flat: Gauss–Newton on the distances of the diagonals, each
/// step the fairest displacement that brings all of them within the goal (GEOMETRY section 6b).
///
/// Fair is the displacement, never the surface: it has the least Σ|(L + κ)d|², with L the graph Laplacian. A step that
/// would invert a quad, or that leaves more excess than there was, is halved. The design is started from three times
/// at most, with displacements of other reach. Once the goal is reached, it is tried with displacements that are held
/// closer to the design, and what moves vertices least is taken.
///
/// The mesh returned has a worst planarity no lower than the given one (and no larger diagonal ratio where one is asked
/// for), no quad inverted that was not, and its pinned vertices exactly where they were. Quads folded over at the start
/// are left as they are. Where nothing is pinned the vertices of each connected part keep their centre. `progress` is
/// asked before each step; on `Break` the best mesh so far is returned. The same input gives the same bits.
pub fn project(
    mesh: &QuadMesh,
    options: &Projection,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Outcome {
    let mut solver = Solver::new(mesh, options);
    let stop = solver.run(progress);
    solver.into_outcome(stop)
}

struct Solver<'a> {
    start: &'a QuadMesh,
    options: &'a Projection,
    goal: Goal,
    first: Vec<QuadMeasure>,
    held: Vec<bool>,
    constraints: Vec<Constraint>,
    /// The quads with a corner that may move.
    faces: Vec<Face>,
    /// Those of them that count for the goal.
    counted: Vec<usize>,
    best: Vec<DVec3>,
    best_merit: f64,
    best_iteration: u32,
    history: Vec<IterationRecord>,
}

/// What one attempt came to.
enum Attempt {
    Reached(StopReason),
    Interrupted(StopReason),
    Stalled,
}

impl<'a> Solver<'a> {
    fn new(start: &'a QuadMesh, options: &'a Projection) -> Self {
        let first = measures(start, &start.vertices);
        let held = selection::held(start, &first, options.pin);
        let goal = Goal::new(options.threshold, options.diagonal_ratio);
        let constraints = constraints(start, &first, &held);
        let movable = |quad: &usize| start.quads[*quad].iter().any(|&corner| !held[corner as usize]);
        let touched: Vec<usize> = (0..start.quads.len()).filter(movable).collect();
        let best_merit = merit(&constraints, &start.vertices, &goal);
        Self {
            history: vec![record(&first)],
            faces: touched.iter().map(|&quad| Face::new(start, &first[quad], quad)).collect(),
            counted: touched.into_iter().filter(|&quad| first[quad].verdict == Verdict::Convex).collect(),
            best: start.vertices.clone(),
            best_iteration: 0,
            best_merit,
            constraints,
            goal,
            held,
            first,
            start,
            options,
        }
    }

    fn run(&mut self, progress: &mut dyn FnMut(Progress) -> ControlFlow<()>) -> StopReason {
        if self.first.iter().all(|measure| self.goal.holds_for(measure)) {
            return StopReason::NothingSelected;
        }
        if let Some(reason) = self.reached(&self.first) {
            return reason;
        }
        for closeness in CLOSENESS {
            let Some(fairness) = Displacement::new(self.start, &self.held, closeness) else {
                return StopReason::TooLarge;
            };
            match self.attempt(&fairness, REACH, progress) {
                Attempt::Reached(reason) => {
                    self.come_closer(closeness, reason, progress);
                    return reason;
                }
                Attempt::Interrupted(reason) => return reason,
                Attempt::Stalled => {}
            }
        }
        StopReason::Stalled
    }

    /// Looks for vertices nearer to the design that reach the goal as well, and as far, with greater and greater
    /// closeness.
    fn come_closer(
        &mut self,
        closeness: f64,
        reason: StopReason,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) {
        let (factor, times) = CLOSER;
        let mut closeness = closeness;
        for _ in 0..times {
            closeness *= factor;
            let Some(fairness) = Displacement::new(self.start, &self.held, closeness) else { return };
            let (best, merit) = (self.best.clone(), self.best_merit);
            let (at, made) = (self.best_iteration, self.history.len());
            let ended = self.attempt(&fairness, APPROACH, progress);
            let saved = 1.0 - self.displacement(&self.best) / self.displacement(&best);
            let reached = matches!(ended, Attempt::Reached(again) if again == reason);
            if !reached || saved < SAVING {
                (self.best, self.best_merit, self.best_iteration) = (best, merit, at);
                self.history.truncate(made);
            }
        }
    }

    /// How far vertices lie from the design, all together.
    fn displacement(&self, vertices: &[DVec3]) -> f64 {
        vertices.iter().zip(&self.start.vertices).map(|(now, then)| now.distance(*then)).sum()
    }

    /// Goes from the design as far as it gets with displacements of one reach.
    fn attempt(
        &mut self,
        fairness: &Displacement,
        effort: Effort,
        progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Attempt {
        let mut present = self.start.vertices.clone();
        let mut excess = merit(&self.constraints, &present, &self.goal);
        let mut waited = 0;
        for _ in 0..effort.steps {
            if waited >= effort.patience {
                break;
            }
            if self.iteration() >= self.options.iterations {
                return Attempt::Interrupted(StopReason::IterationsUsed);
            }
            if progress(self.progress()).is_break() {
                return Attempt::Interrupted(StopReason::Cancelled);
            }
            let rows: Vec<Row> =
                self.constraints.iter().filter_map(|quad| quad.row(&present, &self.goal)).collect();
            let displacement = step(&fairness.placed(rows), fairness);
            let Some((next, left)) = self.take(&present, excess, &displacement, fairness) else {
                return Attempt::Stalled;
            };
            waited = if left <= excess * (1.0 - effort.progress) { 0 } else { waited + 1 };
            (present, excess) = (next, left);
            let found = measures(self.start, &present);
            self.history.push(record(&found));
            let reached = self.reached(&found);
            let kept = self.keep_if_better(&present, excess, &found, reached.is_some());
            if let Some(reason) = reached.filter(|_| kept) {
                return Attempt::Reached(reason);
            }
        }
        Attempt::Stalled
    }

    /// The vertices after a step, and what excess is left: the whole step, or a half, a quarter … of it.
    fn take(
        &self,
        present: &[DVec3],
        excess: f64,
        displacement: &[DVec3],
        fairness: &Displacement,
    ) -> Option<(Vec<DVec3>, f64)> {
        let mut length = 1.0;
        for _ in 0..=HALVINGS {
            let trial = fairness.moved(present, length, displacement);
            if self.faces.iter().all(|face| face.admits(&trial)) {
                let left = merit(&self.constraints, &trial, &self.goal);
                if left < excess {
                    return Some((trial, left));
                }
            }
            length /= 2.0;
        }
        None
    }

    /// The reason to end if every quad that can become flat is flat enough.
    fn reached(&self, measures: &[QuadMeasure]) -> Option<StopReason> {
        if self.counted.iter().any(|&quad| !self.goal.holds_for(&measures[quad])) {
            return None;
        }
        let short = || measures.iter().filter(|measure| !self.goal.holds_for(measure));
        Some(if short().any(|measure| measure.verdict == Verdict::FoldedOver) {
            StopReason::OnlyFoldedLeft
        } else if short().next().is_some() {
            StopReason::OnlyPinnedLeft
        } else {
            StopReason::Reached
        })
    }

    /// Whether these vertices are the best from now on.
    fn keep_if_better(
        &mut self,
        present: &[DVec3],
        excess: f64,
        measures: &[QuadMeasure],
        reached: bool,
    ) -> bool {
        let worst = |measures: &[QuadMeasure]| {
            let of = |quad: &usize| measures[*quad].planarity.unwrap_or(-1.0);
            self.counted.iter().map(of).fold(1.0, f64::min)
        };
        let ratio = |measures: &[QuadMeasure]| {
            let of = |quad: &usize| measures[*quad].diagonal_ratio.unwrap_or(0.0);
            self.counted.iter().map(of).fold(0.0, f64::max)
        };
        let no_worse = worst(measures) >= worst(&self.first)
            && (self.options.diagonal_ratio.is_none() || ratio(measures) <= ratio(&self.first))
            && record(measures).worst >= self.history[0].worst;
        let better = no_worse && (excess < self.best_merit || reached);
        if better {
            self.best.copy_from_slice(present);
            self.best_merit = excess;
            self.best_iteration = self.iteration();
        }
        better
    }

    fn iteration(&self) -> u32 {
        u32::try_from(self.history.len() - 1).unwrap_or(u32::MAX)
    }

    fn progress(&self) -> Progress {
        let IterationRecord { worst, mean } = self.history[self.history.len() - 1];
        Progress { iteration: self.iteration(), iterations: self.options.iterations, worst, mean }
    }

    fn into_outcome(self, stop: StopReason) -> Outcome {
        Outcome::of(self.start, self.first, self.best, self.history, self.best_iteration, stop)
    }
}

fn measures(mesh: &QuadMesh, vertices: &[DVec3]) -> Vec<QuadMeasure> {
    let corners = mesh.quads.iter().map(|quad| quad.map(|corner| vertices[corner as usize]));
    corners.map(QuadMeasure::of).collect()
}

fn record(measures: &[QuadMeasure]) -> IterationRecord {
    let planarities = || measures.iter().filter_map(|measure| measure.planarity);
    let count = planarities().count();
    IterationRecord {
        worst: planarities().reduce(f64::min),
        mean: (count > 0).then(|| planarities().sum::<f64>() / count as f64),
    }
}
