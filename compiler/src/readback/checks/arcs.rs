//! Both radii of an arc, from its centre to its start and to its end, agree within 0.002 mm.

use crate::readback::interpret::{Motion, Trace};
use crate::readback::{Fault, FaultKind};
use glam::DVec2;

/// Greatest difference of the two radii, mm, and a hair for the arithmetic.
const RADII: f64 = 0.002 + 1e-9;

pub(super) fn check(trace: &Trace, faults: &mut Vec<Fault>) {
    for m in trace.moves() {
        let (Motion::Arc { centre, .. }, Some(piece)) = (m.motion, m.piece()) else { continue };
        let radius = |p: DVec2| p.distance(centre);
        let (start, end) = (radius(piece.from.truncate()), radius(piece.to.truncate()));
        if (start - end).abs() > RADII || start.min(end) < 0.001 {
            let message = format!("an arc with radii {start:.4} and {end:.4} mm");
            faults.push(Fault::measured(FaultKind::ArcRadii, m.line, (start - end).abs(), message));
        }
    }
}
