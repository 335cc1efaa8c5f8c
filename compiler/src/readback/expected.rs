//! What a program is held against: the parts and the machine as figures, and where the parts must lie.

use crate::fabricate::cut_job::{CutJob, Rotation, Sheet};
use crate::fabricate::machine::Machine;
use glam::DVec2;

/// What a program must cut, and on what.
#[derive(Clone, Debug)]
pub struct Expected<'a> {
    /// The parts in the order they were asked for; at least one.
    pub parts: Vec<ExpectedPart<'a>>,
    /// The machine they are to be cut on.
    pub machine: &'a Machine,
    /// The stock in X and Y, mm.
    pub stock: DVec2,
    /// Its thickness, mm.
    pub thickness: f64,
    /// What the sheet is called; empty for a part alone.
    pub sheet: String,
    /// The program's number in dialects that number programs.
    pub number: u32,
}

/// One of the parts.
#[derive(Clone, Debug)]
pub struct ExpectedPart<'a> {
    /// What was asked for.
    pub job: &'a CutJob,
    /// The cut outline in program coordinates, mm, anticlockwise.
    pub outline: Vec<DVec2>,
    /// By how many degrees it is turned.
    pub turned: u32,
}

impl<'a> Expected<'a> {
    /// A part alone, placed as programs must: its outline one stock margin, one cutter diameter and the finishing
    /// allowance from all edges of its stock. Worked out here, not taken from the program that is to be judged.
    #[must_use]
    pub fn new(job: &'a CutJob, machine: &'a Machine) -> Expected<'a> {
        let spec = machine.spec();
        let border = DVec2::splat(spec.stock_margin + machine.cutter().diameter + spec.allowance);
        let (low, high) = bounds(&job.outline);
        let outline = job.outline.iter().map(|&p| p - low + border).collect();
        let parts = vec![ExpectedPart { job, outline, turned: 0 }];
        let stock = high - low + 2.0 * border;
        Expected { parts, machine, stock, thickness: job.thickness, sheet: String::new(), number: 1 }
    }

    /// The parts of a sheet, turned and moved as it says.
    #[must_use]
    pub fn of_sheet(sheet: &Sheet<'a>, machine: &'a Machine) -> Expected<'a> {
        let part = |placed: &crate::fabricate::cut_job::Placed<'a>| {
            let turned: Vec<DVec2> = placed.job.outline.iter().map(|&p| turned(p, placed.rotation)).collect();
            let shift = placed.low - bounds(&turned).0;
            let outline = turned.iter().map(|&p| p + shift).collect();
            ExpectedPart { job: placed.job, outline, turned: placed.rotation.degrees() }
        };
        Expected {
            parts: sheet.parts.iter().map(part).collect(),
            machine,
            stock: sheet.stock,
            thickness: sheet.parts.first().map_or(0.0, |placed| placed.job.thickness),
            sheet: sheet.name.clone(),
            number: sheet.number,
        }
    }

    /// Radius of the cutter, mm.
    pub(super) fn cutter_radius(&self) -> f64 {
        self.machine.cutter().diameter / 2.0
    }

    /// Z of the stock's upper face.
    pub(super) fn top(&self) -> f64 {
        self.machine.top(self.thickness)
    }

    /// Z of the deepest cut asked for.
    pub(super) fn bottom(&self) -> f64 {
        self.machine.bottom(self.thickness)
    }

    /// Z of free travel.
    pub(super) fn safe(&self) -> f64 {
        self.machine.safe_z(self.thickness)
    }

    /// Z of the upper side of tabs, where there are to be some.
    pub(super) fn tab_top(&self) -> Option<f64> {
        self.machine.tab_top(self.thickness)
    }
}

impl ExpectedPart<'_> {
    /// Least and greatest X and Y.
    pub(super) fn bounds(&self) -> (DVec2, DVec2) {
        bounds(&self.outline)
    }
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)))
}

fn turned(p: DVec2, rotation: Rotation) -> DVec2 {
    match rotation {
        Rotation::None => p,
        Rotation::Quarter => DVec2::new(-p.y, p.x),
        Rotation::Half => DVec2::new(-p.x, -p.y),
        Rotation::ThreeQuarters => DVec2::new(p.y, -p.x),
    }
}
