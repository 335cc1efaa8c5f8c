//! Convex polygons as two chains over an axis: how far one can be pushed towards another. The hull of a part stands for
//! it here, grown by half the gap, so that parts that touch are a gap apart.

use glam::DVec2;

/// How far a corner may stick out when a polygon is grown, in multiples of the distance: sharper ones are cut off.
const LONGEST_CORNER: f64 = 1.6;

/// Pieces that overlap by less than this along an axis pass each other, mm.
const PASSING: f64 = 1e-7;

/// Corners that differ by less than this in height count as level, mm.
const LEVEL: f64 = 1e-4;

/// A convex polygon seen along x: its left and right chains, both by rising y.
#[derive(Debug, Clone)]
pub(super) struct Chains {
    left: Vec<DVec2>,
    right: Vec<DVec2>,
    /// The least and the greatest x.
    ends: [f64; 2],
}

impl Chains {
    /// Of corners anticlockwise. Ends that are level but for rounding are made level, so that no chain has a step.
    fn of(corners: &[DVec2]) -> Self {
        let low = corners.iter().map(|corner| corner.y).fold(f64::INFINITY, f64::min);
        let high = corners.iter().map(|corner| corner.y).fold(f64::NEG_INFINITY, f64::max);
        let level = |corner: &DVec2| {
            let y = if corner.y < low + LEVEL { low } else { corner.y };
            DVec2::new(corner.x, if y > high - LEVEL { high } else { y })
        };
        let corners: Vec<DVec2> = corners.iter().map(level).collect();
        let side = |sign: f64| {
            let outer = |y: f64| {
                let level = (0..corners.len()).filter(|&index| corners[index].y == y);
                level.fold(0, |best, index| {
                    let better = corners[best].y != y || sign * corners[index].x > sign * corners[best].x;
                    if better { index } else { best }
                })
            };
            let step = if sign > 0.0 { 1 } else { corners.len() - 1 };
            walk(&corners, outer(low), outer(high), step)
        };
        let x = |chain: &[DVec2], sign: f64| {
            sign * chain.iter().map(|corner| sign * corner.x).fold(f64::NEG_INFINITY, f64::max)
        };
        let (left, right) = (side(-1.0), side(1.0));
        let ends = [x(&left, -1.0), x(&right, 1.0)];
        Self { left, right, ends }
    }

    pub(super) fn low(&self) -> f64 {
        self.left.first().map_or(0.0, |corner| corner.y)
    }

    pub(super) fn high(&self) -> f64 {
        self.left.last().map_or(0.0, |corner| corner.y)
    }

    pub(super) fn farthest_left(&self) -> f64 {
        self.ends[0]
    }

    pub(super) fn farthest_right(&self) -> f64 {
        self.ends[1]
    }

    /// The area between the y axis and the right chain, by its height.
    pub(super) fn mean_right(&self) -> f64 {
        let strips =
            self.right.windows(2).map(|pair| (pair[1].y - pair[0].y) * (pair[0].x + pair[1].x) / 2.0);
        strips.sum::<f64>() / (self.high() - self.low()).max(f64::MIN_POSITIVE)
    }

    /// The open interval of shifts along x by which `moving`, raised by `dy`, would overlap this polygon.
    pub(super) fn forbidden(&self, moving: &Chains, dy: f64) -> Option<(f64, f64)> {
        let (from, to) = self.beside(moving, dy)?;
        let before = -farthest(&self.left, &moving.right, dy, from, to, -1.0);
        Some((before, farthest(&self.right, &moving.left, dy, from, to, 1.0)))
    }

    /// The end of that interval.
    pub(super) fn past(&self, moving: &Chains, dy: f64) -> Option<f64> {
        let (from, to) = self.beside(moving, dy)?;
        Some(farthest(&self.right, &moving.left, dy, from, to, 1.0))
    }

    /// The heights that both have; none where they pass each other.
    fn beside(&self, moving: &Chains, dy: f64) -> Option<(f64, f64)> {
        let from = self.low().max(moving.low() + dy);
        let to = self.high().min(moving.high() + dy);
        (to - from > PASSING).then_some((from, to))
    }
}

fn walk(corners: &[DVec2], from: usize, to: usize, step: usize) -> Vec<DVec2> {
    let mut chain = vec![corners[from]];
    let mut at = from;
    while at != to {
        at = (at + step) % corners.len();
        chain.push(corners[at]);
    }
    chain
}

/// The greatest of `sign` · (fixed(y) − moving(y − dy)) for y from `from` to `to`. It is concave and made of straight
/// pieces, so it is greatest at an end of the range or at a corner.
fn farthest(fixed: &[DVec2], moving: &[DVec2], dy: f64, from: f64, to: f64, sign: f64) -> f64 {
    let at = |y: f64| sign * (x_at(fixed, y) - x_at(moving, y - dy));
    let mut best = at(from).max(at(to));
    for corner in fixed {
        if corner.y > from && corner.y < to {
            best = best.max(sign * (corner.x - x_at(moving, corner.y - dy)));
        }
    }
    for corner in moving {
        let y = corner.y + dy;
        if y > from && y < to {
            best = best.max(sign * (x_at(fixed, y) - corner.x));
        }
    }
    best
}

/// The x of a chain at a height; beyond its ends that of the end.
fn x_at(chain: &[DVec2], y: f64) -> f64 {
    let mut below = chain[0];
    if y <= below.y {
        return below.x;
    }
    for &above in &chain[1..] {
        if y <= above.y {
            let rise = above.y - below.y;
            return if rise > 0.0 { below.x + (above.x - below.x) * ((y - below.y) / rise) } else { above.x };
        }
        below = above;
    }
    below.x
}

/// A part in one orientation, grown by half the gap. Its box is that of the part grown by half the gap, which is what
/// must lie on the sheet grown by as much.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    along: [Chains; 2],
    /// The lower corner of the box.
    pub(super) low: DVec2,
    /// The upper corner of the box.
    pub(super) high: DVec2,
    /// Area of the part itself.
    pub(super) area: f64,
}

impl Shape {
    /// Of an outline, turned by so many quarters about the origin.
    pub(super) fn of(outline: &[DVec2], quarter_turns: u8, half_gap: f64, area: f64) -> Self {
        let turned: Vec<DVec2> = outline.iter().map(|&corner| turn(corner, quarter_turns)).collect();
        let hull = hull(turned);
        let low = hull.iter().fold(DVec2::INFINITY, |low, &corner| low.min(corner));
        let high = hull.iter().fold(DVec2::NEG_INFINITY, |high, &corner| high.max(corner));
        let grown = grown(&hull, half_gap);
        let mirrored: Vec<DVec2> = grown.iter().rev().map(|corner| DVec2::new(corner.y, corner.x)).collect();
        let along = [Chains::of(&grown), Chains::of(&mirrored)];
        Self { along, low: low - half_gap, high: high + half_gap, area }
    }

    /// As it is seen for shifts along x (0) or y (1).
    pub(super) fn along(&self, axis: usize) -> &Chains {
        &self.along[axis]
    }

    pub(super) fn size(&self) -> DVec2 {
        self.high - self.low
    }
}

/// A point turned anticlockwise about the origin by so many quarters.
pub(super) fn turn(point: DVec2, quarter_turns: u8) -> DVec2 {
    match quarter_turns % 4 {
        0 => point,
        1 => DVec2::new(-point.y, point.x),
        2 => -point,
        _ => DVec2::new(point.y, -point.x),
    }
}

/// The convex hull, anticlockwise, without points on its sides (Andrew's monotone chain, 1979).
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., before, last] = chain.as_slice() {
                if (*last - *before).perp_dot(point - *last) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut points.iter().copied());
    hull.extend(half(&mut points.iter().rev().copied()));
    hull
}

/// A convex polygon with each side moved out by `distance`, sharp corners cut off: it holds every point within the
/// distance.
fn grown(corners: &[DVec2], distance: f64) -> Vec<DVec2> {
    let count = corners.len();
    let mut out = Vec::with_capacity(2 * count);
    for (index, &corner) in corners.iter().enumerate() {
        let before = (corner - corners[(index + count - 1) % count]).normalize_or(DVec2::X);
        let after = (corners[(index + 1) % count] - corner).normalize_or(DVec2::X);
        let (first, second) = (-before.perp(), -after.perp());
        let between = (first + second).normalize_or(before);
        // The tip lies this many distances away from the corner.
        let reach = 1.0 / between.dot(first).max(1e-6);
        if reach <= LONGEST_CORNER {
            out.push(corner + between * (distance * reach));
            continue;
        }
        // Cut off square to the middle, at LONGEST_CORNER distances.
        for (normal, along) in [(first, before), (second, -after)] {
            let cosine = between.dot(normal);
            let slope = between.dot(along);
            let slide = (LONGEST_CORNER - cosine) / slope;
            out.push(corner + (normal + along * slide) * distance);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(side: f64) -> Shape {
        let corners = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)].map(|(x, y)| DVec2::new(x, y));
        Shape::of(&corners, 0, 2.0, side * side)
    }

    #[test]
    fn squares_keep_twice_the_half_gap() {
        let (fixed, moving) = (square(100.0), square(50.0));
        for axis in [0, 1] {
            let (before, past) = fixed.along(axis).forbidden(moving.along(axis), 10.0).unwrap();
            assert!((before + 54.0).abs() < 1e-9 && (past - 104.0).abs() < 1e-9, "{before} {past}");
            assert!(fixed.along(axis).forbidden(moving.along(axis), 104.0).is_none());
        }
    }

    #[test]
    fn a_hull_leaves_dents_and_points_on_sides_out() {
        let dented = [(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)];
        let hull = hull(dented.map(|(x, y)| DVec2::new(x, y)).to_vec());
        assert_eq!(hull, [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)].map(|(x, y)| DVec2::new(x, y)));
    }

    #[test]
    fn a_needle_grows_by_its_distance_and_little_more() {
        let needle = [(0.0, 0.0), (100.0, -1.0), (100.0, 1.0)].map(|(x, y)| DVec2::new(x, y));
        let grown = grown(&needle, 3.0);
        let low = grown.iter().map(|corner| corner.x).fold(f64::INFINITY, f64::min);
        assert!((-3.0 * LONGEST_CORNER - 1e-9..=-3.0).contains(&low), "{low}");
        // Every point within the distance is inside.
        for step in 0..360 {
            let angle = f64::from(step).to_radians();
            for corner in needle {
                let point = corner + 2.999 * DVec2::new(libm::cos(angle), libm::sin(angle));
                let inside = (0..grown.len()).all(|side| {
                    let (from, to) = (grown[side], grown[(side + 1) % grown.len()]);
                    (to - from).perp_dot(point - from) >= 0.0
                });
                assert!(inside, "{point}");
            }
        }
    }
}
