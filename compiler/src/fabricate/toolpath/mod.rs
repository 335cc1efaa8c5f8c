//! Toolpaths for flat parts cut out of stock with a vertical tool: engrave first, outer contours last, all as typed
//! moves. No NC text is written here (`export::nc`) and none is read back (`readback`).
//!
//! Stock lies with its lower left corner on the program's X and Y origin. A part alone lies in the middle of a stock
//! cut for it, never turned; parts on a sheet lie where the [`Sheet`] says.

mod clamps;
mod contour;
mod engraving;
mod lead;
mod lettering;
mod offset;
mod passes;
mod place;
mod polygon;
mod program;
mod refusal;
mod tabs;
#[cfg(test)]
pub(crate) mod tests;

pub use engraving::{engraving, engraving_on_sheet};
pub use program::{Header, PartHeader, PlacedPart, Program, Step, Turn};
pub use refusal::{PartRefusal, Refusal};

use super::cut_job::{CutJob, MAX_CORNERS, Sheet};
use super::machine::{Fixing, MAX_LENGTH, Machine, Tool};
use glam::{DVec2, DVec3};
#[cfg(test)]
use polygon::Polygon;

/// The toolpath of one part: engraving, then the outer contour with the tool's radius compensated.
///
/// # Errors
/// A [`Refusal`] naming what about the part, the tools or the machine does not fit.
pub fn program(job: &CutJob, machine: &Machine) -> Result<Program, Refusal> {
    sheet(&Sheet::single(job, machine), machine).map_err(|refused| refused.refusal)
}

/// The toolpath of all parts of a sheet: all are engraved, then all contours are cut, both in the order of the parts.
///
/// # Errors
/// The first part that cannot be cut, and why; parts that lie too near to each other or to the sheet's edge.
pub fn sheet(sheet: &Sheet, machine: &Machine) -> Result<Program, PartRefusal> {
    let of = |part: usize| move |refusal: Refusal| PartRefusal { part, refusal };
    let thickness = sheet.thickness();
    for (i, part) in sheet.parts.iter().enumerate() {
        check_thickness(part.job, thickness, machine).map_err(of(i))?;
    }
    let outlines = place::outlines(sheet, machine)?;
    let mut patterns = Vec::with_capacity(outlines.len());
    for (i, (part, outline)) in sheet.parts.iter().zip(&outlines).enumerate() {
        patterns.push(lettering::place(part.job, machine, outline).map_err(of(i))?);
    }
    let mut steps = Steps { out: Vec::new(), machine, thickness };
    steps.change_tool(machine.engraver());
    patterns.iter().for_each(|pattern| lettering::engrave(&mut steps, pattern));
    if machine.cutter().number != machine.engraver().number {
        steps.out.push(Step::SpindleOff);
        steps.change_tool(machine.cutter());
    }
    for i in 0..outlines.len() {
        contour::cut(&mut steps, &outlines, i, sheet.stock).map_err(of(i))?;
    }
    steps.out.push(Step::SpindleOff);
    clamps::check(&steps).map_err(of(0))?;
    let parts = sheet.parts.iter().zip(outlines).zip(&patterns);
    Ok(Program {
        header: header(sheet),
        parts: parts
            .map(|((part, outline), pattern)| PlacedPart {
                header: PartHeader::of(part),
                outline: outline.into_corners(),
                engraved_height: pattern.height,
            })
            .collect(),
        steps: steps.out,
    })
}

fn header(sheet: &Sheet) -> Header {
    let first = sheet.parts.first().map(|part| part.job);
    Header {
        sheet: sheet.name.clone(),
        number: sheet.number,
        design: first.map_or_else(String::new, |job| job.design.clone()),
        design_hash: first.map_or_else(String::new, |job| job.design_hash.clone()),
        stock: sheet.stock.extend(sheet.thickness()),
    }
}

/// The steps so far, and what every part of a program needs to add to them.
struct Steps<'a> {
    out: Vec<Step>,
    machine: &'a Machine,
    thickness: f64,
}

impl Steps<'_> {
    /// Tool in, Z to the safe height with its length taken into account, spindle on and up to speed.
    fn change_tool(&mut self, tool: &Tool) {
        let safe = self.machine.safe_z(self.thickness);
        let seconds = self.machine.spec().spin_up;
        self.out.extend([
            Step::LoadTool { number: tool.number },
            Step::RapidZ { z: safe },
            Step::SpindleOn { speed: tool.spindle },
            Step::Dwell { seconds },
        ]);
    }

    fn top(&self) -> f64 {
        self.machine.top(self.thickness)
    }

    fn retract(&mut self) {
        self.out.push(Step::RapidZ { z: self.machine.safe_z(self.thickness) });
    }

    fn rapid(&mut self, to: DVec2) {
        self.out.push(Step::RapidXY { to });
    }

    fn line(&mut self, to: DVec3, feed: f64) {
        self.out.push(Step::Line { to, feed });
    }

    fn note(&mut self, text: String) {
        self.out.push(Step::Note { text });
    }
}

fn check_thickness(job: &CutJob, stock: f64, machine: &Machine) -> Result<(), Refusal> {
    let thickness = job.thickness;
    if !(thickness.is_finite() && (0.1..=1000.0).contains(&thickness)) {
        return Err(Refusal::Thickness { thickness });
    }
    if thickness != stock {
        return Err(Refusal::OtherThickness { thickness, stock });
    }
    let spec = machine.spec();
    if spec.engrave_depth > thickness / 2.0 {
        return Err(Refusal::EngravingTooDeep { depth: spec.engrave_depth, thickness });
    }
    match spec.fixing {
        Fixing::OnionSkin { thickness: skin } if skin > thickness / 2.0 => {
            return Err(Refusal::SkinTooThick { skin, thickness });
        }
        Fixing::Tabs { height, .. } if height > thickness => {
            return Err(Refusal::TabsTooHigh { height, thickness });
        }
        _ => {}
    }
    let (needed, tool) = (machine.top(thickness) - machine.bottom(thickness), machine.cutter());
    if needed > tool.flute_length {
        return Err(Refusal::FluteTooShort { tool: tool.number, needed, length: tool.flute_length });
    }
    Ok(())
}
