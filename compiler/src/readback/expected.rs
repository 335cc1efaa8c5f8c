//! What a program is held against: the job and the machine as figures, and where the part must lie.

use crate::fabricate::cut_job::CutJob;
use crate::fabricate::machine::Machine;
use glam::DVec2;

/// What a program must cut, and on what.
#[derive(Clone, Debug)]
pub struct Expected<'a> {
    /// What was asked for.
    pub job: &'a CutJob,
    /// The machine it is to be cut on.
    pub machine: &'a Machine,
    /// The cut outline in program coordinates, mm, anticlockwise.
    pub outline: Vec<DVec2>,
    /// The stock in X and Y, mm.
    pub stock: DVec2,
}

impl<'a> Expected<'a> {
    /// Places the part as programs must: its lower left one stock margin and one cutter diameter from the origin.
    /// Worked out here from the job, not taken from the program that is to be judged.
    #[must_use]
    pub fn new(job: &'a CutJob, machine: &'a Machine) -> Expected<'a> {
        let first = job.outline.first().copied().unwrap_or_default();
        let low = job.outline.iter().fold(first, |low, &p| low.min(p));
        let high = job.outline.iter().fold(first, |high, &p| high.max(p));
        let border = DVec2::splat(machine.spec().stock_margin + machine.cutter().diameter);
        let outline = job.outline.iter().map(|&p| p - low + border).collect();
        Expected { job, machine, outline, stock: high - low + 2.0 * border }
    }

    /// Radius of the cutter, mm.
    pub(super) fn cutter_radius(&self) -> f64 {
        self.machine.cutter().diameter / 2.0
    }

    /// Z of the stock's upper face.
    pub(super) fn top(&self) -> f64 {
        self.machine.top(self.job.thickness)
    }

    /// Z of the deepest cut asked for.
    pub(super) fn bottom(&self) -> f64 {
        self.machine.bottom(self.job.thickness)
    }

    /// Z of free travel.
    pub(super) fn safe(&self) -> f64 {
        self.machine.safe_z(self.job.thickness)
    }
}
