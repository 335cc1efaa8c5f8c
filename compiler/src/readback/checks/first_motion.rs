//! At the start, and after each tool change, the machine may stand anywhere: the first motion is Z alone to the safe
//! height. No feed motion starts or ends at an unknown position.

use crate::readback::cuts::HEIGHT;
use crate::readback::interpret::{Event, Motion, Trace};
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    let mut first = true;
    for event in &trace.events {
        let Event::Move(m) = event else {
            first |= matches!(event, Event::ToolChange { .. });
            continue;
        };
        let rises = m.motion == Motion::Rapid
            && m.to[0] == m.from[0]
            && m.to[1] == m.from[1]
            && m.to[2].is_some_and(|z| (z - expected.safe()).abs() < HEIGHT);
        if first && !rises {
            let message =
                format!("the first motion is not Z alone to the safe height {:.3}", expected.safe());
            faults.push(Fault::new(FaultKind::FirstMotion, m.line, message));
        }
        if m.motion != Motion::Rapid && m.piece().is_none() {
            faults.push(Fault::new(
                FaultKind::UnknownPosition,
                m.line,
                "feed motion from an unknown position",
            ));
        }
        first = false;
    }
}
