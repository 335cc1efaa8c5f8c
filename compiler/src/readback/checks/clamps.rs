//! Below a clamp's top, no tool comes nearer to the clamp than its radius. A move that begins at an unknown height may be
//! anywhere down to where it ends.

use crate::readback::geometry::{inside, to_boundary};
use crate::readback::interpret::Trace;
use crate::readback::{Expected, Fault, FaultKind};
use glam::DVec2;

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    let spec = expected.machine.spec();
    for (index, clamp) in spec.clamps.iter().enumerate() {
        let (low, high) = (clamp.low, clamp.high);
        let corners = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
        for m in trace.moves() {
            let (Some(x), Some(y), Some(z)) = (m.to[0], m.to[1], m.to[2]) else { continue };
            let lowest = m.from[2].map_or(z, |from| from.min(z));
            if lowest >= expected.top() + clamp.height {
                continue;
            }
            let tool = spec.tools.iter().find(|tool| Some(tool.number) == m.tool);
            let radius = tool.map_or(0.0, |tool| tool.diameter / 2.0);
            let from = DVec2::new(m.from[0].unwrap_or(x), m.from[1].unwrap_or(y));
            let path = m.piece().map_or_else(|| vec![from, DVec2::new(x, y)], |piece| piece.flat());
            let touches =
                |a: DVec2, b: DVec2| inside(a, &corners) || to_boundary((a, b), &corners) < radius - 0.002;
            if path.windows(2).any(|pair| touches(pair[0], pair[1])) {
                let message = format!("a tool of radius {radius:.3} at Z {lowest:.3} touches clamp {index}");
                faults.push(Fault::measured(FaultKind::Clamp, m.line, lowest, message));
            }
        }
    }
}
