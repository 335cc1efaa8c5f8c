//! Where the alias and its marks lie on a part, for who draws them. The strokes are those that the program engraves.

use super::lettering;
use super::polygon::Polygon;
use super::{CutJob, Refusal};
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
    let outline = Polygon::try_new(&job.outline)?;
    // Placed as in the stock, so that rounding chooses the same place.
    let border = machine.map_or(0.0, Machine::border);
    let shift = DVec2::splat(border) - outline.bounds().0;
    let width = machine.map_or(WIDTH, |machine| machine.engraver().diameter);
    let strokes = lettering::place_strokes(job, width, &outline.shifted(shift))?.into_strokes();
    let back = |stroke: Stroke| stroke.into_iter().map(|point| point - shift).collect();
    Ok(strokes.into_iter().map(back).collect())
}
