//! The part as the cutter leaves it: the closed full-depth path taken back by the cutter's radius.

use super::Expected;
use super::cuts::Cut;
use super::geometry::{edges, to_segment};
use glam::DVec2;

/// The outline and how far it is from the one expected.
pub(super) struct Rebuilt {
    pub(super) outline: Vec<DVec2>,
    pub(super) deviation: f64,
}

/// One straight or round stretch of the path.
struct Stretch {
    from: DVec2,
    to: DVec2,
    centre: Option<DVec2>,
}

/// Rebuilds the outline of a part from the last closed way around it.
pub(super) fn outline(way: &[Cut], expected: &Expected, part: usize) -> Rebuilt {
    let path: Vec<Stretch> = way.iter().map(stretch).collect();
    let (radius, wanted) = (expected.cutter_radius(), &expected.parts[part].outline);
    let outline = corners(&merged(path, radius), radius);
    let deviation = farthest(&outline, wanted).max(farthest(wanted, &outline));
    Rebuilt { outline, deviation }
}

fn stretch(cut: &Cut) -> Stretch {
    let (from, to) = (cut.piece.from.truncate(), cut.piece.to.truncate());
    Stretch { from, to, centre: cut.piece.circle().map(|circle| circle.0) }
}

/// Straight stretches that go on in the same direction become one, around the closing too; a straight stretch too
/// short for an arc to be told from it becomes a point.
fn merged(path: Vec<Stretch>, radius: f64) -> Vec<Stretch> {
    let shortest = (8.0 * radius * 0.0006).sqrt();
    let mut out: Vec<Stretch> = Vec::new();
    for next in path {
        match out.last_mut() {
            Some(last) if goes_on(last, &next) => last.to = next.to,
            _ => out.push(next),
        }
    }
    if out.len() > 2
        && goes_on(&out[out.len() - 1], &out[0])
        && let Some(last) = out.pop()
    {
        out[0].from = last.from;
    }
    let length = |s: &Stretch| s.from.distance(s.to);
    let n = out.len();
    for i in 0..n {
        let (before, after) = ((i + n - 1) % n, (i + 1) % n);
        let flat = [before, i, after].into_iter().all(|k| out[k].centre.is_none());
        if flat
            && length(&out[i]) < shortest
            && length(&out[before]).min(length(&out[after])) > length(&out[i])
        {
            let middle = (out[i].from + out[i].to) / 2.0;
            (out[before].to, out[after].from) = (middle, middle);
            (out[i].from, out[i].to) = (middle, middle);
        }
    }
    out.retain(|s| s.from != s.to);
    out
}

fn goes_on(a: &Stretch, b: &Stretch) -> bool {
    let (u, v) = (a.to - a.from, b.to - b.from);
    let straight = a.centre.is_none() && b.centre.is_none() && u.dot(v) > 0.0;
    // The joint is within rounding of the straight line from start to end.
    straight && to_segment(a.to, (a.from, b.to)) < 0.0015
}

/// A corner at each arc's centre, and where two straight stretches meet, the joint taken back along their bisector.
fn corners(path: &[Stretch], radius: f64) -> Vec<DVec2> {
    let points: Vec<DVec2> = path.iter().map(|s| s.from).collect();
    let area: f64 = edges(&points).map(|(a, b)| (a - points[0]).perp_dot(b - points[0])).sum();
    let side = if area > 0.0 { 1.0 } else { -1.0 };
    let mut out = Vec::new();
    for (i, stretch) in path.iter().enumerate() {
        let next = &path[(i + 1) % path.len()];
        if let Some(centre) = stretch.centre {
            out.push(centre);
        } else if next.centre.is_none() {
            let (u, v) = ((stretch.to - stretch.from).normalize(), (next.to - next.from).normalize());
            let half_cosine = ((1.0 + u.dot(v)) / 2.0).max(1e-6).sqrt();
            let inwards = (u + v).normalize_or_zero().perp() * side;
            out.push(stretch.to + inwards * (radius / half_cosine));
        }
    }
    if side < 0.0 {
        out.reverse();
    }
    out
}

/// Greatest distance from a corner of `a` to the boundary of `b`.
fn farthest(a: &[DVec2], b: &[DVec2]) -> f64 {
    let to_b = |p: &DVec2| edges(b).map(|edge| to_segment(*p, edge)).fold(f64::INFINITY, f64::min);
    a.iter().map(to_b).fold(0.0, f64::max)
}
