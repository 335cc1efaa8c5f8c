//! All motion stays in the machine's travel: X and Y from the lower left of the stock, Z from the deepest cut.

use crate::readback::cuts::HEIGHT;
use crate::readback::interpret::Trace;
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    let travel = expected.machine.spec().envelope;
    let floor = expected.bottom();
    let ranges = [(0.0, travel.x), (0.0, travel.y), (floor, expected.bottom() + travel.z)];
    for m in trace.moves() {
        let bulge = m.piece().map(|piece| piece.bounds());
        for (axis, (least, greatest)) in ranges.into_iter().enumerate() {
            let Some(end) = m.to[axis] else { continue };
            let (low, high) = match bulge {
                Some((low, high)) if axis < 2 => (low[axis].min(end), high[axis].max(end)),
                _ => (end, end),
            };
            let outside = if low < least - HEIGHT { low } else { high };
            if outside < least - HEIGHT || outside > greatest + HEIGHT {
                let name = ['X', 'Y', 'Z'][axis];
                let message =
                    format!("{name} {outside:.3} is outside the travel {least:.3} to {greatest:.3}");
                faults.push(Fault::measured(FaultKind::Envelope, m.line, outside, message));
            }
        }
    }
}
