//! A checked simple polygon, and distances to it. Only what toolpaths need; no offsets (see `offset`).

use super::MAX_CORNERS;
use super::Refusal;
use crate::fabricate::machine::MAX_LENGTH;
use glam::DVec2;

/// Shortest edge, and least distance between edges that do not meet, mm: ten steps of the third decimal.
const LEAST_LENGTH: f64 = 0.01;

/// A simple, anticlockwise polygon with at least three corners.
#[derive(Clone, Debug)]
pub(super) struct Polygon {
    corners: Vec<DVec2>,
}

impl Polygon {
    /// # Errors
    /// What keeps the corners from being a simple anticlockwise polygon with edges of at least 0.01 mm.
    pub(super) fn try_new(corners: &[DVec2]) -> Result<Polygon, Refusal> {
        let bad = |reason: String| Err(Refusal::Outline { reason });
        let n = corners.len();
        if !(3..=MAX_CORNERS).contains(&n) {
            return bad(format!("has {n} corners, must have 3 to {MAX_CORNERS}"));
        }
        if let Some(i) = corners.iter().position(|p| !(p.is_finite() && p.abs().max_element() <= MAX_LENGTH))
        {
            return bad(format!("has corner {i} out of range"));
        }
        let polygon = Polygon { corners: corners.to_vec() };
        for i in 0..n {
            let (a, b) = polygon.edge(i);
            if a.distance(b) < LEAST_LENGTH {
                return bad(format!("has edge {i} shorter than {LEAST_LENGTH} mm"));
            }
        }
        if let Some((i, j)) = polygon.touching_edges() {
            return bad(format!("touches or crosses itself at edges {i} and {j}"));
        }
        if polygon.doubled_area() <= 0.0 {
            return bad("runs clockwise".to_owned());
        }
        Ok(polygon)
    }

    /// Number of corners and of edges.
    pub(super) fn len(&self) -> usize {
        self.corners.len()
    }

    pub(super) fn corners(&self) -> &[DVec2] {
        &self.corners
    }

    pub(super) fn into_corners(self) -> Vec<DVec2> {
        self.corners
    }

    /// Edge `i` modulo their number, from its first to its second corner.
    pub(super) fn edge(&self, i: usize) -> (DVec2, DVec2) {
        let n = self.corners.len();
        (self.corners[i % n], self.corners[(i + 1) % n])
    }

    /// Unit direction of edge `i`.
    pub(super) fn direction(&self, i: usize) -> DVec2 {
        let (a, b) = self.edge(i);
        (b - a) / a.distance(b)
    }

    pub(super) fn shifted(&self, by: DVec2) -> Polygon {
        Polygon { corners: self.corners.iter().map(|&p| p + by).collect() }
    }

    /// Least and greatest coordinates.
    pub(super) fn bounds(&self) -> (DVec2, DVec2) {
        let first = self.corners[0];
        self.corners.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)))
    }

    /// Area centroid. Taken about the first corner, so it keeps its digits far from the origin.
    pub(super) fn centroid(&self) -> DVec2 {
        let o = self.corners[0];
        let mut sum = DVec2::ZERO;
        for i in 0..self.len() {
            let (a, b) = self.edge(i);
            sum += (a - o).perp_dot(b - o) * ((a - o) + (b - o));
        }
        o + sum / (3.0 * self.doubled_area())
    }

    fn doubled_area(&self) -> f64 {
        let o = self.corners[0];
        (0..self.len()).map(|i| self.edge(i)).map(|(a, b)| (a - o).perp_dot(b - o)).sum()
    }

    /// Whether `p` lies inside, by counting crossings of the ray towards +X.
    pub(super) fn contains(&self, p: DVec2) -> bool {
        let crosses = |&i: &usize| {
            let (a, b) = self.edge(i);
            (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
        };
        (0..self.len()).filter(crosses).count() % 2 == 1
    }

    /// Least distance from the segment to any edge, mm.
    pub(super) fn distance_to_boundary(&self, a: DVec2, b: DVec2) -> f64 {
        (0..self.len()).map(|i| segment_distance((a, b), self.edge(i))).fold(f64::INFINITY, f64::min)
    }

    /// Two edges that come closer than [`LEAST_LENGTH`] without being neighbours, or neighbours folded onto each other.
    fn touching_edges(&self) -> Option<(usize, usize)> {
        let n = self.len();
        for i in 0..n {
            let (u, v) = (self.direction(i), self.direction(i + 1));
            if u.dot(v) < 0.0 && u.perp_dot(v).abs() < 1e-3 {
                return Some((i, (i + 1) % n));
            }
            for j in i + 2..n {
                let neighbours = i == 0 && j == n - 1;
                if !neighbours && segment_distance(self.edge(i), self.edge(j)) < LEAST_LENGTH {
                    return Some((i, j));
                }
            }
        }
        None
    }
}

/// Distance from `p` to the segment.
pub(super) fn point_distance(p: DVec2, (a, b): (DVec2, DVec2)) -> f64 {
    let d = b - a;
    let length_squared = d.length_squared();
    if length_squared == 0.0 {
        return p.distance(a);
    }
    let t = ((p - a).dot(d) / length_squared).clamp(0.0, 1.0);
    p.distance(a + t * d)
}

/// Distance between two segments, 0 if they cross.
pub(super) fn segment_distance(s: (DVec2, DVec2), t: (DVec2, DVec2)) -> f64 {
    let side = |(a, b): (DVec2, DVec2), p: DVec2| (b - a).perp_dot(p - a);
    let parted = |s: (DVec2, DVec2), t: (DVec2, DVec2)| side(s, t.0) * side(s, t.1) >= 0.0;
    if !parted(s, t) && !parted(t, s) {
        return 0.0;
    }
    let ends =
        [point_distance(s.0, t), point_distance(s.1, t), point_distance(t.0, s), point_distance(t.1, s)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}
