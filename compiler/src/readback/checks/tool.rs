//! A tool that the job needs is loaded in feed motion, its own length offset is active in all motion, and tools are
//! changed with the spindle off at the safe height.

use crate::fabricate::machine::LengthOffset;
use crate::readback::cuts::HEIGHT;
use crate::readback::interpret::{Event, Motion, Trace};
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    let known = [expected.machine.cutter().number, expected.machine.engraver().number];
    // Where the operator sets Z zero with each tool, there is no offset.
    let by_hand = expected.machine.spec().dialect.profile().length_offset == LengthOffset::ByHand;
    for m in trace.moves() {
        if m.motion != Motion::Rapid && m.tool.is_none_or(|tool| !known.contains(&tool)) {
            let message = match m.tool {
                Some(tool) => format!("feed motion with tool {tool}, which the job does not use"),
                None => "feed motion without a tool".to_owned(),
            };
            faults.push(Fault::new(FaultKind::ToolNotLoaded, m.line, message));
        }
        if !by_hand && m.tool.is_some() && m.offset != m.tool {
            faults.push(Fault::new(
                FaultKind::ToolLength,
                m.line,
                "motion without the tool's own length offset",
            ));
        }
    }
    for event in &trace.events {
        let Event::ToolChange { line, turning, z } = *event else { continue };
        if turning {
            faults.push(Fault::new(FaultKind::ToolChange, line, "a tool change while the spindle turns"));
        }
        if let Some(z) = z.filter(|z| *z < expected.safe() - HEIGHT) {
            let message = format!("a tool change at Z {z:.3}, below the safe height");
            faults.push(Fault::measured(FaultKind::ToolChange, line, z, message));
        }
    }
}
