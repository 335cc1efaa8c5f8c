//! In feed motion the spindle turns, at a speed in the machine's range, and has had time to reach it.

use crate::readback::interpret::{Motion, Trace};
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    let spec = expected.machine.spec();
    let (slow, fast) = (spec.spindle_range.0 * 60.0, spec.spindle_range.1 * 60.0);
    for m in trace.moves().filter(|m| m.motion != Motion::Rapid) {
        let Some(speed) = m.spindle else {
            faults.push(Fault::new(FaultKind::SpindleOff, m.line, "feed motion while the spindle stands"));
            continue;
        };
        if speed < slow - 0.001 || speed > fast + 0.001 {
            let message = format!("spindle at {speed:.3} rpm, the machine turns {slow:.3} to {fast:.3}");
            faults.push(Fault::measured(FaultKind::SpindleRange, m.line, speed, message));
        }
        if m.waited < spec.spin_up - 0.001 {
            let message =
                format!("feed motion {:.3} s after spindle start, it needs {:.3} s", m.waited, spec.spin_up);
            faults.push(Fault::measured(FaultKind::SpindleSpinUp, m.line, m.waited, message));
        }
    }
}
