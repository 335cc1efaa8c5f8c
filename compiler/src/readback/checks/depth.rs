//! No cut is deeper than thickness and cut-through, none deeper than its tool's flutes.

use crate::readback::cuts::{Cut, HEIGHT};
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(cuts: &[Cut], expected: &Expected, faults: &mut Vec<Fault>) {
    for cut in cuts {
        let (z, line) = (cut.lowest(), cut.made.line);
        if z < expected.bottom() - HEIGHT {
            let message = format!("cuts at Z {z:.3}, the deepest cut is {:.3}", expected.bottom());
            faults.push(Fault::measured(FaultKind::TooDeep, line, z, message));
        }
        let tool = expected.machine.spec().tools.iter().find(|t| Some(t.number) == cut.made.tool);
        let depth = expected.top() - z;
        if let Some(tool) = tool.filter(|tool| depth > tool.flute_length + HEIGHT) {
            let message =
                format!("{depth:.3} mm deep, tool {} has flutes of {:.3}", tool.number, tool.flute_length);
            faults.push(Fault::measured(FaultKind::FluteLength, line, depth, message));
        }
    }
}
