//! The cutter's centre stays outside the part, at its radius from the cut outline, at any depth.

use crate::readback::cuts::Cut;
use crate::readback::geometry::{inside, to_boundary};
use crate::readback::{Expected, Fault, FaultKind, OUTLINE_TOLERANCE};
use std::collections::BTreeSet;

pub(super) fn check(cuts: &[Cut], expected: &Expected, faults: &mut Vec<Fault>) {
    let mut seen = BTreeSet::new();
    for cut in cuts.iter().filter(|cut| !cut.engraves) {
        let mut nearest = f64::INFINITY;
        for pair in cut.piece.flat().windows(2) {
            // Passes repeat the same path: each stretch of it is measured once.
            if !seen.insert([pair[0].x, pair[0].y, pair[1].x, pair[1].y].map(f64::to_bits)) {
                continue;
            }
            let distance = to_boundary((pair[0], pair[1]), &expected.outline);
            nearest = nearest.min(if inside(pair[0], &expected.outline) { -distance } else { distance });
        }
        let into = expected.cutter_radius() - nearest;
        if into > OUTLINE_TOLERANCE {
            let message = format!("cuts {into:.3} mm into the part");
            faults.push(Fault::measured(FaultKind::Gouge, cut.made.line, into, message));
        }
    }
}
