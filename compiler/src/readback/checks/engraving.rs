//! Engraved grooves lie inside the part, at the clearance from its edge, are as deep as asked, and come before the
//! contour. What they spell is read in `decode`.

use crate::readback::cuts::{Cut, HEIGHT};
use crate::readback::geometry::{inside, to_boundary};
use crate::readback::{Expected, Fault, FaultKind};

/// Rounding of points may take this from the clearance, mm.
const ROUNDING: f64 = 0.002;

pub(super) fn check(cuts: &[Cut], expected: &Expected, faults: &mut Vec<Fault>) {
    let floor = expected.top() - expected.machine.spec().engrave_depth;
    let contour = cuts.iter().position(|cut| !cut.engraves).unwrap_or(cuts.len());
    for (i, cut) in cuts.iter().enumerate().filter(|(_, cut)| cut.engraves) {
        let (line, part) = (cut.made.line, &expected.parts[cut.part]);
        let margin = part.job.engraving.clearance + expected.machine.engraver().diameter / 2.0;
        for pair in cut.piece.flat().windows(2) {
            let distance = to_boundary((pair[0], pair[1]), &part.outline);
            let signed = if inside(pair[0], &part.outline) { distance } else { -distance };
            if signed < margin - ROUNDING {
                let message = format!("engraves {signed:.3} mm from the edge, {margin:.3} mm was asked for");
                faults.push(Fault::measured(FaultKind::EngravingOutside, line, signed, message));
                break;
            }
        }
        let z = cut.lowest();
        if (z - floor).abs() > HEIGHT {
            let message = format!("engraves at Z {z:.3}, {floor:.3} was asked for");
            faults.push(Fault::measured(FaultKind::EngravingDepth, line, z, message));
        }
        if i > contour {
            faults.push(Fault::new(FaultKind::EngravingOrder, line, "engraves after the contour was begun"));
        }
    }
}
