//! The distance of two polygons.

use glam::DVec2;

/// The distance of two simple polygons, 0 where they overlap.
pub(super) fn distance(first: &[DVec2], second: &[DVec2]) -> f64 {
    if holds(first, second[0]) || holds(second, first[0]) {
        return 0.0;
    }
    let sides = |corners: &[DVec2]| -> Vec<(DVec2, DVec2)> {
        (0..corners.len()).map(|side| (corners[side], corners[(side + 1) % corners.len()])).collect()
    };
    let others = sides(second);
    let mut least = f64::INFINITY;
    for side in sides(first) {
        for &other in &others {
            least = least.min(between_segments(side, other));
        }
    }
    least
}

/// Whether a polygon holds a point: a ray to the right crosses its sides an odd number of times.
fn holds(corners: &[DVec2], point: DVec2) -> bool {
    let mut inside = false;
    for (index, &from) in corners.iter().enumerate() {
        let to = corners[(index + 1) % corners.len()];
        if (from.y > point.y) != (to.y > point.y) {
            let x = from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y);
            inside ^= point.x < x;
        }
    }
    inside
}

fn between_segments(first: (DVec2, DVec2), second: (DVec2, DVec2)) -> f64 {
    let side = |line: (DVec2, DVec2), point: DVec2| (line.1 - line.0).perp_dot(point - line.0);
    let crosses = side(first, second.0) * side(first, second.1) < 0.0
        && side(second, first.0) * side(second, first.1) < 0.0;
    if crosses {
        return 0.0;
    }
    let to_segment = |point: DVec2, line: (DVec2, DVec2)| {
        let along = line.1 - line.0;
        let squared = along.length_squared();
        let share = if squared > 0.0 { ((point - line.0).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
        point.distance(line.0 + along * share)
    };
    [
        to_segment(first.0, second),
        to_segment(first.1, second),
        to_segment(second.0, first),
        to_segment(second.1, first),
    ]
    .into_iter()
    .fold(f64::INFINITY, f64::min)
}
