//! There is one program end, nothing follows it, and there the tool is at the safe height with the spindle off.

use crate::readback::cuts::HEIGHT;
use crate::readback::interpret::{Event, Trace};
use crate::readback::lines::Line;
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(trace: &Trace, lines: &[Line], expected: &Expected, faults: &mut Vec<Fault>) {
    // A mark of the tape's end is no part of the program.
    let last = lines.iter().rfind(|line| !line.percent).map_or(0, |line| line.number);
    let end = |event: &Event| if let Event::End { line } = event { Some(*line) } else { None };
    let ends: Vec<usize> = trace.events.iter().filter_map(end).collect();
    if ends.len() != 1 {
        let message = format!("has {} program ends", ends.len());
        faults.push(Fault::measured(FaultKind::ProgramEnd, last, ends.len() as f64, message));
    }
    if let Some(&line) = ends.first().filter(|&&line| line != last) {
        faults.push(Fault::new(FaultKind::ProgramEnd, line, "something follows the program end"));
    }
    if let Some(speed) = trace.turning_at_end {
        faults.push(Fault::measured(FaultKind::SpindleOnAtEnd, last, speed, "ends with the spindle turning"));
    }
    if trace.last_z.is_none_or(|z| z < expected.safe() - HEIGHT) {
        let message = format!("does not end at the safe height {:.3}", expected.safe());
        let (kind, measured) = (FaultKind::EndHeight, trace.last_z);
        faults.push(Fault { kind, line: last, tool: None, message, measured });
    }
}
