//! No cut takes more material below earlier cuts along the same path than its tool's step-down. Where no earlier cut
//! ran, the stock's upper face is what is cut from. Beside an earlier cut by less than the finishing allowance, or than
//! a tenth of the tool's diameter, the tool takes a sliver and no slot.

use crate::readback::cuts::{Cut, HEIGHT};
use crate::readback::geometry::Piece;
use crate::readback::{Expected, Fault, FaultKind};
use glam::DVec2;

/// An earlier cut this near, mm, has cleared the place: the path's own rounding, and a hair.
const NEAR: f64 = 0.005;

/// `cuts`: those on one part, in order.
pub(in crate::readback) fn check(cuts: &[Cut], expected: &Expected, faults: &mut Vec<Fault>) {
    let boxes: Vec<(DVec2, DVec2)> = cuts.iter().map(|cut| cut.piece.bounds()).collect();
    for (i, cut) in cuts.iter().enumerate() {
        let Some(tool) = expected.machine.spec().tools.iter().find(|t| Some(t.number) == cut.made.tool)
        else {
            continue;
        };
        let most = tool.max_step_down + HEIGHT;
        if expected.top() - cut.lowest() <= most {
            continue;
        }
        let sliver = expected.machine.spec().allowance.max(tool.diameter / 10.0) + NEAR;
        let earlier: Vec<Piece> =
            (0..i).filter(|&j| overlap(boxes[i], boxes[j], sliver)).map(|j| cuts[j].piece).collect();
        let mut step = deepest_step(&cut.piece, &earlier, expected.top(), NEAR);
        if step > most {
            step = deepest_step(&cut.piece, &earlier, expected.top(), sliver);
        }
        if step > most {
            let message =
                format!("takes {step:.3} mm at once, tool {} bears {:.3}", tool.number, tool.max_step_down);
            faults.push(Fault::measured(FaultKind::StepDown, cut.made.line, step, message));
        }
    }
}

fn overlap(a: (DVec2, DVec2), b: (DVec2, DVec2), near: f64) -> bool {
    a.0.cmple(b.1 + near).all() && b.0.cmple(a.1 + near).all()
}

/// Most material in front of the tool along the piece, mm. Both its depth and the floor left by each earlier piece
/// change evenly, so ends, quarters, and where earlier pieces end are all the places to look at.
fn deepest_step(piece: &Piece, earlier: &[Piece], top: f64, near: f64) -> f64 {
    let mut places = vec![0.0, 0.25, 0.5, 0.75, 1.0];
    for end in earlier.iter().flat_map(|e| [e.from, e.to]) {
        let (t, distance) = piece.nearest(end.truncate());
        if distance <= near {
            places.push(t);
        }
    }
    let step = |t: f64| {
        let p = piece.at(t);
        let floor = |e: &Piece| {
            let (t, distance) = e.nearest(p.truncate());
            (distance <= near).then(|| plunged(e, t))
        };
        earlier.iter().filter_map(floor).fold(top, f64::min) - p.z
    };
    places.into_iter().map(step).fold(0.0, f64::max)
}

/// Height that a piece left behind at `t`: a plunge leaves its lower end.
fn plunged(piece: &Piece, t: f64) -> f64 {
    if piece.length() == 0.0 { piece.from.z.min(piece.to.z) } else { piece.at(t).z }
}
