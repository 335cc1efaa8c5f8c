//! Toolpaths for one flat part cut out of stock with a vertical tool: engrave first, outer contour last, all as typed
//! moves. No NC text is written here (`export::nc`) and none is read back (`readback`).
//!
//! Stock lies with its lower left corner on the program's X and Y origin. The part lies in it with the machine's stock
//! margin and one cutter diameter around it, never turned.

mod contour;
mod engraving;
mod lettering;
mod offset;
mod polygon;
mod program;
mod refusal;
#[cfg(test)]
pub(crate) mod tests;

pub use engraving::engraving;
pub use program::{Header, Program, Step, Turn};
pub use refusal::Refusal;

use super::cut_job::{CutJob, MAX_CORNERS};
use super::machine::{MAX_LENGTH, Machine, Tool};
use glam::{DVec2, DVec3};
use polygon::Polygon;

/// The toolpath of one part: engraving, then the outer contour with the tool's radius compensated.
///
/// # Errors
/// A [`Refusal`] naming what about the part, the tools or the machine does not fit.
pub fn program(job: &CutJob, machine: &Machine) -> Result<Program, Refusal> {
    check_thickness(job, machine)?;
    let outline = Polygon::try_new(&job.outline)?;
    let diameter = machine.cutter().diameter;
    let border = DVec2::splat(machine.spec().stock_margin + diameter);
    let (low, high) = outline.bounds();
    let placed = outline.shifted(border - low);
    let stock = high - low + 2.0 * border;
    check_envelope(job, machine, stock - border)?;

    let path = offset::outward(&placed, diameter / 2.0)?;
    let pattern = lettering::place(job, machine, &placed)?;
    let mut steps = Steps { out: Vec::new(), machine, thickness: job.thickness };
    steps.change_tool(machine.engraver());
    lettering::engrave(&mut steps, &pattern);
    if machine.cutter().number != machine.engraver().number {
        steps.out.extend([Step::SpindleOff]);
        steps.change_tool(machine.cutter());
    }
    contour::cut(&mut steps, &path)?;
    steps.out.push(Step::SpindleOff);
    let header = Header {
        address: job.address.clone(),
        alias: job.alias.clone(),
        design: job.design.clone(),
        design_hash: job.design_hash.clone(),
        stock: stock.extend(job.thickness),
        face_up: job.face_up.clone(),
        notes: job.notes.clone(),
    };
    Ok(Program {
        header,
        placed_outline: placed.into_corners(),
        engraved_height: pattern.height,
        steps: steps.out,
    })
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

fn check_thickness(job: &CutJob, machine: &Machine) -> Result<(), Refusal> {
    let thickness = job.thickness;
    if !(thickness.is_finite() && (0.1..=1000.0).contains(&thickness)) {
        return Err(Refusal::Thickness { thickness });
    }
    let spec = machine.spec();
    if spec.engrave_depth > thickness / 2.0 {
        return Err(Refusal::EngravingTooDeep { depth: spec.engrave_depth, thickness });
    }
    let (needed, tool) = (thickness + spec.cut_through, machine.cutter());
    if needed > tool.flute_length {
        return Err(Refusal::FluteTooShort { tool: tool.number, needed, length: tool.flute_length });
    }
    Ok(())
}

/// `reach`: the greatest X and Y the cutter's centre may need, generously.
fn check_envelope(job: &CutJob, machine: &Machine, reach: DVec2) -> Result<(), Refusal> {
    let spec = machine.spec();
    let z = machine.safe_z(job.thickness) - machine.bottom(job.thickness);
    for (axis, needed, travel) in
        [('x', reach.x, spec.envelope.x), ('y', reach.y, spec.envelope.y), ('z', z, spec.envelope.z)]
    {
        if !(needed <= travel && needed <= MAX_LENGTH) {
            return Err(Refusal::Envelope { axis, needed, travel });
        }
    }
    Ok(())
}
