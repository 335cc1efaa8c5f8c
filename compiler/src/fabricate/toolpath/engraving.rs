//! Where the alias and its marks lie on a part, for who draws them. The strokes are those that the program engraves.

use super::lettering;
use super::polygon::Polygon;
use super::{CutJob, Refusal};
use crate::fabricate::cut_job::{Placed, Rotation};
use crate::fabricate::engrave::Stroke;
use crate::fabricate::machine::Machine;
use glam::DVec2;

/// The width of a stroke where no machine says it, mm.
const WIDTH: f64 = 1.0;

/// The strokes of the alias, the up mark before it and the tick of edge 0, in the coordinates of the job's outline, mm:
/// as `machine` engraves them, or with strokes of 1 mm where there is none.
///
/// # Errors
/// As `program`, as far as it is about the outline and the engraving.
pub fn engraving(job: &CutJob, machine: Option<&Machine>) -> Result<Vec<Stroke>, Refusal> {
    // Placed as in the stock, so that rounding chooses the same place.
    let low = DVec2::splat(machine.map_or(0.0, Machine::border));
    let strokes = engraving_on_sheet(&Placed { job, rotation: Rotation::None, low }, machine)?;
    let back = Polygon::try_new(&job.outline)?.bounds().0 - low;
    Ok(strokes.into_iter().map(|stroke| stroke.into_iter().map(|point| point + back).collect()).collect())
}

/// The same strokes of a part on a sheet, in the coordinates of the sheet, mm.
///
/// # Errors
/// As `sheet`, as far as it is about the outline and the engraving.
pub fn engraving_on_sheet(part: &Placed, machine: Option<&Machine>) -> Result<Vec<Stroke>, Refusal> {
    let turned: Vec<DVec2> = part.job.outline.iter().map(|&point| part.rotation.turn(point)).collect();
    let turned = Polygon::try_new(&turned)?;
    let width = machine.map_or(WIDTH, |machine| machine.engraver().diameter);
    let outline = turned.shifted(part.low - turned.bounds().0);
    Ok(lettering::place_strokes(part.job, width, &outline)?.into_strokes())
}
