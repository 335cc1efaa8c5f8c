//! The way around a part as pieces in the direction of cutting: opened at a place, and parted into what is level and the
//! ramp that leads down to the next pass.

use super::offset::CentrePath;
use super::polygon::Polygon;
use crate::fabricate::machine::CutDirection;
use glam::DVec2;

/// The way around ends, and begins, on the longest side; a ramp before its end takes at most this part of the side
/// before it goes back around corners.
const SIDE_SHARE: f64 = 0.6;

/// One piece of the path in the direction of cutting.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) from: DVec2,
    pub(super) to: DVec2,
    /// Whether it is an arc around a corner.
    pub(super) arc: bool,
    /// The outline's edge it runs along; for an arc the one before its corner.
    pub(super) edge: usize,
    /// Its length, mm.
    pub(super) length: f64,
}

/// Where the way around begins and ends: on the side beside this edge, so far from the edge's first corner, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Opening {
    pub(super) edge: usize,
    pub(super) at: f64,
}

/// How far along its edge a point is, mm.
pub(super) fn along(outline: &Polygon, edge: usize, p: DVec2) -> f64 {
    outline.direction(edge).dot(p - outline.edge(edge).0)
}

/// On the longest side, the first of equals, so that a ramp of this length before it lies in the side's middle.
pub(super) fn opening(outline: &Polygon, path: &CentrePath, ramp: f64, direction: CutDirection) -> Opening {
    let length = |i: usize| path.sides[i].from.distance(path.sides[i].to);
    let edge = (1..path.sides.len()).fold(0, |best, i| if length(i) > length(best) { i } else { best });
    let after_middle = (ramp / length(edge)).min(SIDE_SHARE) / 2.0;
    let t = match direction {
        CutDirection::Conventional => 0.5 + after_middle,
        CutDirection::Climb => 0.5 - after_middle,
    };
    let side = path.sides[edge];
    Opening { edge, at: along(outline, edge, side.from + (side.to - side.from) * t) }
}

/// Once around from the opening and back to it.
pub(super) fn around(
    outline: &Polygon,
    path: &CentrePath,
    opening: Opening,
    direction: CutDirection,
) -> Vec<Piece> {
    let side = path.sides[opening.edge];
    let start =
        side.from + outline.direction(opening.edge) * (opening.at - along(outline, opening.edge, side.from));
    let pieces = anticlockwise(path, opening.edge, start);
    match direction {
        CutDirection::Conventional => pieces,
        CutDirection::Climb => {
            let backwards = |p: &Piece| Piece { from: p.to, to: p.from, ..*p };
            pieces.iter().rev().map(backwards).collect()
        }
    }
}

/// Once around from `start` on side `first`.
fn anticlockwise(path: &CentrePath, first: usize, start: DVec2) -> Vec<Piece> {
    let n = path.sides.len();
    let line =
        |edge: usize, from: DVec2, to: DVec2| Piece { from, to, arc: false, edge, length: from.distance(to) };
    let mut out = Vec::with_capacity(2 * n + 1);
    let mut from = start;
    for k in 0..n {
        let edge = (first + k) % n;
        let (here, next) = (path.sides[edge], path.sides[(edge + 1) % n]);
        out.push(line(edge, from, here.to));
        if here.to != next.from {
            let half_chord = here.to.distance(next.from) / (2.0 * path.radius);
            let length = 2.0 * path.radius * libm::asin(half_chord.min(1.0));
            out.push(Piece { from: here.to, to: next.from, arc: true, edge, length });
        }
        from = next.from;
    }
    out.push(line(first, from, start));
    out.retain(|piece| piece.from != piece.to);
    out
}

/// The pieces of the last `length` mm, and those before them. An arc that the cut would fall in goes to the last part
/// whole.
pub(super) fn ramp_and_rest(pieces: Vec<Piece>, length: f64) -> (Vec<Piece>, Vec<Piece>) {
    let (mut ramp, mut rest) = (Vec::new(), Vec::new());
    let mut left = length;
    for piece in pieces.into_iter().rev() {
        if left <= 1e-6 {
            rest.push(piece);
        } else if piece.arc || piece.length <= left + 1e-6 {
            ramp.push(piece);
            left -= piece.length;
        } else {
            let middle = piece.to + (piece.from - piece.to) * (left / piece.length);
            ramp.push(Piece { from: middle, length: left, ..piece });
            rest.push(Piece { to: middle, length: piece.length - left, ..piece });
            left = 0.0;
        }
    }
    ramp.reverse();
    rest.reverse();
    (ramp, rest)
}
