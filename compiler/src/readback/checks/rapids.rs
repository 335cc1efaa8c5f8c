//! Rapids stay at or above the safe height, except straight up to it, and never move Z together with X or Y.

use crate::readback::cuts::HEIGHT;
use crate::readback::interpret::{Motion, Trace};
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    let safe = expected.safe() - HEIGHT;
    for m in trace.moves().filter(|m| m.motion == Motion::Rapid) {
        let changes = |axis: usize| m.to[axis] != m.from[axis];
        let (sideways, vertical) = (changes(0) || changes(1), changes(2));
        if sideways && vertical {
            faults.push(Fault::new(
                FaultKind::RapidMixesAxes,
                m.line,
                "a rapid moves Z together with X or Y",
            ));
        }
        let ends = m.to[2].unwrap_or(f64::NEG_INFINITY);
        let starts = if sideways { m.from[2].unwrap_or(f64::NEG_INFINITY) } else { ends };
        let lowest = ends.min(starts);
        if lowest < safe {
            let message = format!("a rapid at Z {lowest:.3}, the safe height is {:.3}", expected.safe());
            faults.push(Fault::measured(FaultKind::RapidBelowSafe, m.line, lowest, message));
        }
    }
}
