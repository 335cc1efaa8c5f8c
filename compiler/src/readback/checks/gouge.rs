//! The cutter's centre stays outside every part, at its radius from the cut outline, at any depth.

use crate::readback::cuts::Cut;
use crate::readback::geometry::{inside, to_boundary};
use crate::readback::{Expected, ExpectedPart, Fault, FaultKind, OUTLINE_TOLERANCE};
use glam::DVec2;
use std::collections::BTreeSet;

pub(super) fn check(cuts: &[Cut], expected: &Expected, faults: &mut Vec<Fault>) {
    let radius = expected.cutter_radius();
    let boxes: Vec<(DVec2, DVec2)> = expected.parts.iter().map(ExpectedPart::bounds).collect();
    let mut seen = BTreeSet::new();
    for cut in cuts.iter().filter(|cut| !cut.engraves) {
        let (low, high) = cut.piece.bounds();
        let near = |b: &(DVec2, DVec2)| (b.0 - high).max(low - b.1).max_element() < radius;
        let parts: Vec<usize> = (0..boxes.len()).filter(|&i| near(&boxes[i])).collect();
        let mut nearest = f64::INFINITY;
        for pair in cut.piece.flat().windows(2) {
            // Passes repeat the same path: each stretch of it is measured once.
            if !seen.insert([pair[0].x, pair[0].y, pair[1].x, pair[1].y].map(f64::to_bits)) {
                continue;
            }
            for outline in parts.iter().map(|&i| &expected.parts[i].outline) {
                let distance = to_boundary((pair[0], pair[1]), outline);
                nearest = nearest.min(if inside(pair[0], outline) { -distance } else { distance });
            }
        }
        let into = radius - nearest;
        if into > OUTLINE_TOLERANCE {
            let message = format!("cuts {into:.3} mm into the part");
            faults.push(Fault::measured(FaultKind::Gouge, cut.made.line, into, message));
        }
    }
}
