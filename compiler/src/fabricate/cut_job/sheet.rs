//! Several parts on one sheet of stock, as nesting places them. Plain data; who decides on places is elsewhere.

use super::CutJob;
use crate::fabricate::machine::Machine;
use glam::DVec2;

/// Most parts on a sheet.
pub const MAX_PARTS: usize = 1000;

/// By how much a part is turned on its sheet, anticlockwise seen from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Rotation {
    /// Not at all.
    #[default]
    None,
    /// 90 degrees.
    Quarter,
    /// 180 degrees.
    Half,
    /// 270 degrees.
    ThreeQuarters,
}

impl Rotation {
    /// In degrees.
    #[must_use]
    pub fn degrees(self) -> u32 {
        match self {
            Rotation::None => 0,
            Rotation::Quarter => 90,
            Rotation::Half => 180,
            Rotation::ThreeQuarters => 270,
        }
    }

    /// The vector turned; exact.
    #[must_use]
    pub fn turn(self, v: DVec2) -> DVec2 {
        match self {
            Rotation::None => v,
            Rotation::Quarter => v.perp(),
            Rotation::Half => -v,
            Rotation::ThreeQuarters => -v.perp(),
        }
    }
}

/// A part and where it lies on its sheet.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// The part.
    pub job: &'a CutJob,
    /// How its outline is turned.
    pub rotation: Rotation,
    /// Where the least X and Y of the turned outline come to lie, mm from the sheet's lower left corner.
    pub low: DVec2,
}

/// A sheet of stock and the parts to be cut out of it by one program.
#[derive(Clone, Debug)]
pub struct Sheet<'a> {
    /// What the sheet is called in the header, such as `birch-plywood-12.1`; empty for a part alone.
    pub name: String,
    /// The program's number in dialects that number programs, from 1.
    pub number: u32,
    /// The stock in X and Y, mm.
    pub stock: DVec2,
    /// The parts in the order they are cut in: one or more, all of the same thickness.
    pub parts: Vec<Placed<'a>>,
}

impl<'a> Sheet<'a> {
    /// A stock for one part alone, not turned: its outline [`Machine::border`] away from all edges.
    #[must_use]
    pub fn single(job: &'a CutJob, machine: &Machine) -> Sheet<'a> {
        let first = job.outline.first().copied().unwrap_or_default();
        let (low, high) =
            job.outline.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
        let border = DVec2::splat(machine.border());
        let part = Placed { job, rotation: Rotation::None, low: border };
        Sheet { name: String::new(), number: 1, stock: high - low + 2.0 * border, parts: vec![part] }
    }

    /// The thickness of stock and parts, mm; that of the first part.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.parts.first().map_or(0.0, |part| part.job.thickness)
    }
}
