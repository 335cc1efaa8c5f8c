//! The state of the search: present and best point, one step, and what is kept. When to end is in `perturb`.

use glam::DVec3;

use crate::geometry::{QuadMeasure, QuadMesh};

use super::field::{Field, Weights};
use super::lbfgs::{self, Memory};
use super::options::Perturbation;
use super::outcome::{IterationRecord, Outcome, Progress, StopReason};
use super::selection::Selection;
use super::smoothing::Smoothing;

/// The decrease a step must bring, as a part of what the slope promises (Armijo 1966).
const SUFFICIENT: f64 = 1e-4;

/// How often a step is halved before it is given up.
const HALVINGS: u32 = 40;

/// How good a point of the search is, by true figures of the quads that change. Higher is better.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
struct Rank {
    worst: f64,
    mean: f64,
}

/// Which objective the search goes down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// The weights as given.
    Given,
    /// The average alone.
    Average,
}

pub(super) struct Search<'a> {
    start: &'a QuadMesh,
    options: &'a Perturbation,
    /// Measures of the start, for what a quad was.
    first: Vec<QuadMeasure>,
    /// Measures of the present point.
    measures: Vec<QuadMeasure>,
    present: QuadMesh,
    selection: Selection,
    field: Field,
    smoothing: Smoothing,
    memory: Memory,
    /// The gradient at the present point, where it is known.
    slope: Option<Vec<DVec3>>,
    mode: Mode,
    best: Vec<DVec3>,
    best_rank: Rank,
    best_iteration: u32,
    history: Vec<IterationRecord>,
}

impl<'a> Search<'a> {
    /// A search that starts from `start`.
    pub(super) fn new(start: &'a QuadMesh, options: &'a Perturbation) -> Self {
        let first: Vec<QuadMeasure> = measures_of(start);
        let selection = Selection::new(start, &first, options.select, options.pin);
        let mut search = Self {
            start,
            options,
            measures: first.clone(),
            present: start.clone(),
            field: Field::new(start, &first, &selection, options.step),
            smoothing: Smoothing::new(start, &selection.free),
            memory: Memory::default(),
            slope: None,
            mode: Mode::Given,
            best: start.vertices.clone(),
            best_rank: Rank { worst: -1.0, mean: -1.0 },
            best_iteration: 0,
            history: Vec::new(),
            first,
            selection,
        };
        search.best_rank = search.rank(&search.measures);
        search.record();
        search
    }

    /// Whether no quad falls short of `select`.
    pub(super) fn nothing_selected(&self) -> bool {
        !self.selection.selected.contains(&true)
    }

    /// Iterations made.
    pub(super) fn iteration(&self) -> u32 {
        u32::try_from(self.history.len() - 1).unwrap_or(u32::MAX)
    }

    /// What the caller is told.
    pub(super) fn progress(&self) -> Progress {
        let IterationRecord { worst, mean } = self.history[self.history.len() - 1];
        Progress { iteration: self.iteration(), iterations: self.options.iterations, worst, mean }
    }

    /// The reason to end if at the present point every selected quad that can change is flat enough.
    pub(super) fn reached(&self) -> Option<StopReason> {
        let short = |quad: usize| {
            let planarity = self.measures[quad].planarity.unwrap_or(-1.0);
            self.selection.selected[quad] && planarity < self.options.threshold
        };
        if self.selection.touched.iter().any(|&quad| short(quad as usize)) {
            return None;
        }
        let left = (0..self.measures.len()).any(short);
        Some(if left { StopReason::OnlyPinnedLeft } else { StopReason::Reached })
    }

    fn weights(&self) -> Weights {
        match self.mode {
            Mode::Given => Weights { worst: self.options.worst, average: self.options.average },
            Mode::Average => Weights { worst: 0.0, average: 1.0 },
        }
    }

    /// Goes on with the other objective: to the average from the best point, and back from wherever that led.
    pub(super) fn change_mode(&mut self) {
        self.memory.clear();
        self.slope = None;
        self.mode = match self.mode {
            Mode::Given => {
                self.present.vertices.clone_from(&self.best);
                self.measure();
                Mode::Average
            }
            Mode::Average => Mode::Given,
        };
    }

    /// One step downhill; false if there is none.
    pub(super) fn step(&mut self) -> bool {
        let weights = self.weights();
        let gradient =
            self.slope.take().unwrap_or_else(|| self.field.gradient(&self.present.vertices, weights));
        let mut found = self.line_search(&gradient, weights);
        if found.is_none() && !self.memory.is_empty() {
            self.memory.clear();
            found = self.line_search(&gradient, weights);
        }
        let Some(vertices) = found else { return false };
        let next = self.field.gradient(&vertices, weights);
        let mut change = next.clone();
        lbfgs::add(&mut change, -1.0, &gradient);
        let mut moved = vertices.clone();
        lbfgs::add(&mut moved, -1.0, &self.present.vertices);
        self.memory.remember(moved, change);
        self.slope = Some(next);
        self.present.vertices = vertices;
        self.measure();
        self.record();
        true
    }

    /// The vertices after a step along the search direction which lowers the objective enough and inverts nothing.
    fn line_search(&self, gradient: &[DVec3], weights: Weights) -> Option<Vec<DVec3>> {
        let direction = self.memory.direction(gradient, &self.smoothing);
        let slope = lbfgs::dot(gradient, &direction);
        let longest = direction.iter().map(|part| part.length()).fold(0.0, f64::max);
        if !(slope < 0.0 && longest.is_finite()) {
            return None;
        }
        let start = self.field.value(&self.present.vertices, weights);
        let mut length = if self.memory.is_empty() { self.options.move_length / longest } else { 1.0 };
        for _ in 0..HALVINGS {
            let mut trial = self.present.vertices.clone();
            lbfgs::add(&mut trial, length, &direction);
            if self.field.admits(&trial)
                && self.field.value(&trial, weights) <= start + SUFFICIENT * length * slope
            {
                return Some(trial);
            }
            length /= 2.0;
        }
        None
    }

    /// Measures the quads which may have changed.
    fn measure(&mut self) {
        for &quad in &self.selection.touched {
            self.measures[quad as usize] = QuadMeasure::of(self.present.corners_of(quad as usize));
        }
    }

    fn record(&mut self) {
        let planarities = || self.measures.iter().filter_map(|measure| measure.planarity);
        let count = planarities().count();
        self.history.push(IterationRecord {
            worst: planarities().reduce(f64::min),
            mean: (count > 0).then(|| planarities().sum::<f64>() / count as f64),
        });
    }

    /// The worst and the mean planarity of the touched quads, without those which were no quad of four convex
    /// corners at the start and still are none. One that loses its planarity counts as −1.
    fn rank(&self, measures: &[QuadMeasure]) -> Rank {
        let (mut worst, mut sum, mut count) = (1.0f64, 0.0, 0usize);
        for quad in self.selection.touched.iter().map(|&quad| quad as usize) {
            let planarity = measures[quad].planarity;
            if planarity.is_some() || self.first[quad].planarity.is_some() {
                let planarity = planarity.unwrap_or(-1.0);
                worst = worst.min(planarity);
                sum += planarity;
                count += 1;
            }
        }
        Rank { worst, mean: sum / count.max(1) as f64 }
    }

    /// Selects what has come to fall short, and keeps the present point if it is the best so far or the goal.
    pub(super) fn keep_if_better(&mut self) -> bool {
        self.grow();
        let (rank, best) = (self.rank(&self.measures), self.best_rank);
        let better = if self.options.worst > 0.0 { rank > best } else { rank.mean > best.mean };
        let kept = rank.worst >= self.rank(&self.first).worst && (better || self.reached().is_some());
        if kept {
            self.best.clone_from(&self.present.vertices);
            self.best_rank = rank;
            self.best_iteration = self.iteration();
        }
        kept
    }

    /// Selects quads that have come to fall short of `select` on the way.
    fn grow(&mut self) {
        let Self { selection, measures, start, options, .. } = self;
        let touched = selection.touched.clone();
        let present = touched.iter().map(|&quad| (quad as usize, measures[quad as usize].planarity));
        if selection.grow(start, options.select, present) {
            self.slope = None;
            self.field = Field::new(self.start, &self.first, &self.selection, self.options.step);
            self.smoothing = Smoothing::new(self.start, &self.selection.free);
            let best = QuadMesh { vertices: self.best.clone(), quads: self.start.quads.clone() };
            self.best_rank = self.rank(&measures_of(&best));
        }
    }

    /// The best point, and how it was found.
    pub(super) fn into_outcome(self, stop: StopReason) -> Outcome {
        Outcome::of(self.start, self.first, self.best, self.history, self.best_iteration, stop)
    }
}

fn measures_of(mesh: &QuadMesh) -> Vec<QuadMeasure> {
    (0..mesh.quads.len()).map(|quad| QuadMeasure::of(mesh.corners_of(quad))).collect()
}
