//! Paths and distances as read-back needs them, in its own words: pieces of motion, polygons, and how near they come.

use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Flattened arcs stay this near to the arc, mm.
const SAGITTA: f64 = 0.0005;

/// A straight or circular piece of motion; Z changes evenly along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Start, mm.
    pub from: DVec3,
    /// End, mm.
    pub to: DVec3,
    arc: Option<Arc>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Arc {
    centre: DVec2,
    radius: f64,
    start: f64,
    /// Signed turn, anticlockwise positive.
    sweep: f64,
}

impl Piece {
    pub(super) fn straight(from: DVec3, to: DVec3) -> Piece {
        Piece { from, to, arc: None }
    }

    /// An arc from `from` to `to` about `centre`; a full turn if both are the same.
    pub(super) fn arc(from: DVec3, to: DVec3, centre: DVec2, clockwise: bool) -> Piece {
        let (a, b) = (from.truncate() - centre, to.truncate() - centre);
        let start = libm::atan2(a.y, a.x);
        let ahead = turn(libm::atan2(b.y, b.x) - start);
        let sweep = match (clockwise, from.truncate() == to.truncate()) {
            (false, true) => TAU,
            (true, true) => -TAU,
            (false, false) => ahead,
            (true, false) => ahead - TAU,
        };
        Piece { from, to, arc: Some(Arc { centre, radius: a.length(), start, sweep }) }
    }

    /// Centre and radius if it is an arc.
    pub(super) fn circle(&self) -> Option<(DVec2, f64)> {
        self.arc.map(|arc| (arc.centre, arc.radius))
    }

    /// Length in X and Y, mm.
    pub(super) fn length(&self) -> f64 {
        self.arc.map_or(self.from.truncate().distance(self.to.truncate()), |arc| arc.radius * arc.sweep.abs())
    }

    /// The place at `t` from 0 to 1.
    pub(super) fn at(&self, t: f64) -> DVec3 {
        let straight = self.from + (self.to - self.from) * t;
        match self.arc {
            _ if t == 0.0 => self.from,
            _ if t == 1.0 => self.to,
            None => straight,
            Some(arc) => {
                let angle = arc.start + arc.sweep * t;
                let out = DVec2::new(libm::cos(angle), libm::sin(angle));
                (arc.centre + arc.radius * out).extend(straight.z)
            }
        }
    }

    /// Where along the piece, seen from above, it is nearest to `p`, and how near, mm.
    pub(super) fn nearest(&self, p: DVec2) -> (f64, f64) {
        let Some(arc) = self.arc else {
            let t = along(p, (self.from.truncate(), self.to.truncate()));
            return (t, p.distance(self.at(t).truncate()));
        };
        let out = p - arc.centre;
        let angle = turn((libm::atan2(out.y, out.x) - arc.start) * arc.sweep.signum());
        let t = angle / arc.sweep.abs();
        let candidates = [0.0, 1.0, if t <= 1.0 { t } else { 0.0 }];
        let measured = candidates.map(|t| (t, p.distance(self.at(t).truncate())));
        measured.into_iter().fold(measured[0], |best, next| if next.1 < best.1 { next } else { best })
    }

    /// Corners of a polyline, seen from above, that stays within 0.0005 mm of the piece.
    pub(super) fn flat(&self) -> Vec<DVec2> {
        let Some(arc) = self.arc else { return vec![self.from.truncate(), self.to.truncate()] };
        let step = 2.0 * libm::acos((1.0 - SAGITTA / arc.radius.max(SAGITTA)).clamp(-1.0, 1.0));
        let n = (arc.sweep.abs() / step).ceil().clamp(1.0, 10_000.0);
        (0..=n as u32).map(|i| self.at(f64::from(i) / n).truncate()).collect()
    }

    /// Least and greatest X and Y.
    pub(super) fn bounds(&self) -> (DVec2, DVec2) {
        let first = self.from.truncate();
        self.flat().into_iter().fold((first, first), |(low, high), p| (low.min(p), high.max(p)))
    }
}

/// An angle brought to [0, 2π).
fn turn(angle: f64) -> f64 {
    let angle = angle % TAU;
    if angle < 0.0 { angle + TAU } else { angle }
}

/// A segment.
pub(super) type Segment = (DVec2, DVec2);

/// Parameter of the segment's point nearest to `p`.
fn along(p: DVec2, (a, b): Segment) -> f64 {
    let d = b - a;
    let square = d.length_squared();
    if square > 0.0 { ((p - a).dot(d) / square).clamp(0.0, 1.0) } else { 0.0 }
}

/// Distance from `p` to the segment, mm.
pub(super) fn to_segment(p: DVec2, s: Segment) -> f64 {
    p.distance(s.0 + (s.1 - s.0) * along(p, s))
}

/// Distance between two segments, mm; 0 if they cross.
pub(super) fn between(s: Segment, t: Segment) -> f64 {
    let turn = |a: DVec2, b: DVec2, p: DVec2| (b - a).perp_dot(p - a);
    let apart = |a: f64, b: f64| (a > 0.0) != (b > 0.0);
    if apart(turn(s.0, s.1, t.0), turn(s.0, s.1, t.1)) && apart(turn(t.0, t.1, s.0), turn(t.0, t.1, s.1)) {
        return 0.0;
    }
    to_segment(s.0, t).min(to_segment(s.1, t)).min(to_segment(t.0, s)).min(to_segment(t.1, s))
}

/// The edges of a polygon.
pub(super) fn edges(polygon: &[DVec2]) -> impl Iterator<Item = Segment> {
    polygon.iter().copied().zip(polygon.iter().copied().cycle().skip(1))
}

/// Distance from a segment to the polygon's boundary, mm.
pub(super) fn to_boundary(s: Segment, polygon: &[DVec2]) -> f64 {
    edges(polygon).map(|edge| between(s, edge)).fold(f64::INFINITY, f64::min)
}

/// Whether `p` lies inside, by its winding number.
pub(super) fn inside(p: DVec2, polygon: &[DVec2]) -> bool {
    let mut winding = 0;
    for (a, b) in edges(polygon) {
        let left = (b - a).perp_dot(p - a);
        if a.y <= p.y && b.y > p.y && left > 0.0 {
            winding += 1;
        } else if a.y > p.y && b.y <= p.y && left < 0.0 {
            winding -= 1;
        }
    }
    winding != 0
}
