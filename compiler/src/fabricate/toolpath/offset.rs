//! The path of a round tool's centre around a part: the exact outward offset of a simple polygon, with arcs at convex
//! corners. An inner corner that a round tool cannot cut sharp is refused, not rounded.

use super::Refusal;
use super::polygon::Polygon;
use glam::DVec2;

/// Most that a round tool may leave uncut in an inner corner, mm: half of what read-back allows.
pub(super) const LEFT_IN_CORNER: f64 = 0.005;

/// One edge of the outline moved out by the tool's radius.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    /// Start, seen anticlockwise around the part.
    pub(super) from: DVec2,
    /// End.
    pub(super) to: DVec2,
}

/// The closed path of the tool's centre, anticlockwise: side i, then an arc about corner i + 1 of this radius to side
/// i + 1 (nothing where the two sides meet).
#[derive(Clone, Debug)]
pub(super) struct CentrePath {
    pub(super) radius: f64,
    pub(super) sides: Vec<Side>,
}

/// Moves `outline` out by `radius`.
///
/// # Errors
/// An inner corner that would keep more than 0.005 mm of waste, or a tool too wide for a recess.
pub(super) fn outward(outline: &Polygon, radius: f64) -> Result<CentrePath, Refusal> {
    outward_with(outline, radius, LEFT_IN_CORNER)
}

/// The same with other leave to keep waste in inner corners, which a later pass takes.
///
/// # Errors
/// As [`outward`].
pub(super) fn outward_with(outline: &Polygon, radius: f64, leave: f64) -> Result<CentrePath, Refusal> {
    let n = outline.len();
    let mut sides: Vec<Side> = (0..n).map(|i| moved_out(outline, i, radius)).collect();
    for corner in 0..n {
        let before = (corner + n - 1) % n;
        let (u, v) = (outline.direction(before), outline.direction(corner));
        if u.perp_dot(v) < 0.0 {
            let joint = inner_joint(outline, corner, (u, v), radius, leave)?;
            sides[before].to = joint;
            sides[corner].from = joint;
        }
    }
    let path = CentrePath { radius, sides };
    check_clear(outline, &path)?;
    Ok(path)
}

fn moved_out(outline: &Polygon, i: usize, radius: f64) -> Side {
    let out = -outline.direction(i).perp() * radius;
    let (a, b) = outline.edge(i);
    Side { from: a + out, to: b + out }
}

/// Where the two moved sides at an inner corner cross. The tool stays `radius (1 / cos(φ/2) - 1)` away from the
/// corner, φ being the turn.
fn inner_joint(
    outline: &Polygon,
    corner: usize,
    (u, v): (DVec2, DVec2),
    radius: f64,
    leave: f64,
) -> Result<DVec2, Refusal> {
    let half_cosine = ((1.0 + u.dot(v)) / 2.0).max(0.0).sqrt();
    let left = radius / half_cosine - radius;
    if left > leave {
        return Err(Refusal::ConcaveCorner { corner, left, radius });
    }
    let bisector = -(u + v).perp() / (u + v).length();
    Ok(outline.corners()[corner] + bisector * (radius / half_cosine))
}

/// Every side still runs forwards, and neither it nor the tool at a corner comes nearer to any edge than the radius.
fn check_clear(outline: &Polygon, path: &CentrePath) -> Result<(), Refusal> {
    let n = outline.len();
    let slack = 1e-6;
    for (i, side) in path.sides.iter().enumerate() {
        let refused = Err(Refusal::ToolDoesNotFit { edge: i, diameter: 2.0 * path.radius });
        if (side.to - side.from).dot(outline.direction(i)) <= 0.0 {
            return refused;
        }
        let near = outline.distance_to_boundary(side.from, side.to);
        if near < path.radius - slack || outline.contains((side.from + side.to) / 2.0) {
            return refused;
        }
        // The arc about the next corner: no other edge may come into the tool while it swings around it.
        let next = path.sides[(i + 1) % n];
        for p in arc_points(outline.corners()[(i + 1) % n], side.to, next.from) {
            if outline.distance_to_boundary(p, p) < path.radius - slack {
                return refused;
            }
        }
    }
    Ok(())
}

/// Points of the arc from `a` to `b` (at most a half turn, anticlockwise) about `centre`: halved five times, so that
/// an edge between two of them is missed by a thousandth of the radius at most.
fn arc_points(centre: DVec2, a: DVec2, b: DVec2) -> Vec<DVec2> {
    let radius = centre.distance(a);
    let mut points = vec![a, b];
    for _ in 0..5 {
        if points[0].distance(points[1]) < 1e-2 * radius {
            break;
        }
        let mut finer = Vec::with_capacity(points.len() * 2);
        for pair in points.windows(2) {
            let middle = (pair[0] + pair[1]) / 2.0 - centre;
            let length = middle.length();
            // A half turn has its chord through the centre: the way out is the chord's outer normal.
            let chord = (pair[1] - pair[0]).perp() / (2.0 * radius);
            let out = if length > 1e-9 * radius { middle / length } else { -chord };
            finer.extend([pair[0], centre + out * radius]);
        }
        finer.push(b);
        points = finer;
    }
    points
}
