//! At full depth the cutter comes to every point of the cut outline: on its last way around, nothing is left standing
//! along it but tabs.
//!
//! The distance to one straight stretch of path is convex, so an edge's stretch whose two ends are near enough to the
//! same stretch of path is near enough all along; what is not shown so is halved.

use crate::readback::cuts::Cut;
use crate::readback::geometry::{Segment, between, edges, to_segment};
use crate::readback::{Expected, Fault, FaultKind, OUTLINE_TOLERANCE};

/// Stretches of an edge shorter than this, mm, are judged by their ends.
const SHORTEST: f64 = 1e-4;

/// `way`: the last closed way around the part.
pub(in crate::readback) fn check(way: &[Cut], expected: &Expected, part: usize, faults: &mut Vec<Fault>) {
    let mut path: Vec<Segment> = Vec::new();
    for cut in way {
        path.extend(cut.piece.flat().windows(2).map(|pair| (pair[0], pair[1])));
    }
    let reach = expected.cutter_radius() + OUTLINE_TOLERANCE;
    for (i, edge) in edges(&expected.parts[part].outline).enumerate() {
        let near: Vec<Segment> = path.iter().copied().filter(|&s| between(s, edge) <= reach).collect();
        if let Some(left) = left_standing(edge, &near, reach) {
            let left = left - expected.cutter_radius();
            let message = format!("the cutter stays {left:.3} mm away from edge {i} at full depth");
            faults.push(Fault::measured(FaultKind::Uncut, 0, left, message));
        }
    }
}

/// The distance to the path of a point of the edge that is farther than `reach` from it, if there is one.
fn left_standing(edge: Segment, path: &[Segment], reach: f64) -> Option<f64> {
    let mut open = vec![edge];
    while let Some((a, b)) = open.pop() {
        for end in [a, b] {
            let distance = path.iter().map(|&s| to_segment(end, s)).fold(f64::INFINITY, f64::min);
            if distance > reach {
                return Some(distance);
            }
        }
        let shown = path.iter().any(|&s| to_segment(a, s) <= reach && to_segment(b, s) <= reach);
        if !shown && a.distance(b) > SHORTEST {
            let middle = (a + b) / 2.0;
            open.extend([(middle, b), (a, middle)]);
        }
    }
    None
}
