//! Modes are set before the first motion: millimetres, XY plane, absolute, feed per minute, no compensation, no
//! length offset left over, no canned cycle, and the machine's work offset, which nothing changes later.

use crate::readback::interpret::Trace;
use crate::readback::{Expected, Fault, FaultKind};

const MODES: [i64; 7] = [21, 17, 90, 94, 40, 49, 80];

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    let line = trace.moves().next().map_or(0, |m| m.line);
    let work_offset = i64::from(expected.machine.spec().work_offset.code());
    for mode in MODES.into_iter().chain([work_offset]) {
        if !trace.modes.contains(&mode) {
            faults.push(Fault::new(
                FaultKind::Modes,
                line,
                format!("G{mode} is not set before the first motion"),
            ));
        }
    }
    for &other in trace.modes.iter().filter(|&&g| (54..=59).contains(&g) && g != work_offset) {
        let message = format!("G{other} is set, the machine's work offset is G{work_offset}");
        faults.push(Fault::new(FaultKind::Modes, line, message));
    }
    for &(line, mode) in &trace.late_modes {
        faults.push(Fault::new(FaultKind::Modes, line, format!("G{mode} is set after the first motion")));
    }
}
