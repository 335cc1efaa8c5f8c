//! Passes around the outer contour: down a ramp along the path, around, and once more over the ramp at full depth. The
//! tool's centre never leaves the offset path, so all it cuts beside the contour is waste.

use super::offset::CentrePath;
use super::program::{Step, Turn};
use super::{Refusal, Steps};
use crate::fabricate::machine::CutDirection;
use glam::DVec2;

/// Gentle ramp: 1 in 10, as long as the path has room.
const GENTLE_SLOPE: f64 = 0.1;
/// Steepest ramp; shorter paths take more passes instead.
const STEEPEST_SLOPE: f64 = 0.25;
/// Part of the path a ramp may take.
const RAMP_SHARE: f64 = 0.5;
/// A ramp that takes up to this part of the longest side lies in its middle, clear of both corners; a longer one begins
/// there and goes on around corners.
const SIDE_SHARE: f64 = 0.6;
/// Most passes a contour may take.
const MOST_PASSES: f64 = 200.0;
/// Most sides over all passes: keeps programs readable by machines and by read-back.
const MOST_SIDES: f64 = 10_000.0;
/// Height above the stock where the descent slows from feed to plunge, mm.
pub(super) const APPROACH: f64 = 1.0;

/// One piece of the path in the direction of cutting.
#[derive(Clone, Copy)]
struct Piece {
    from: DVec2,
    to: DVec2,
    /// Whether it is an arc around a corner.
    arc: bool,
    /// Its length, mm.
    length: f64,
}

/// Cuts the contour down to thickness + cut-through in equal passes.
///
/// # Errors
/// `TooManyPasses` if more than 200 passes, or 10,000 sides in all, were needed.
pub(super) fn cut(steps: &mut Steps, path: &CentrePath) -> Result<(), Refusal> {
    let tool = steps.machine.cutter();
    let (top, bottom) = (steps.top(), steps.machine.bottom(steps.thickness));
    let depth = top - bottom;
    let around: f64 = anticlockwise(path, 0, path.sides[0].from).iter().map(|p| p.length).sum();
    let room = RAMP_SHARE * around;
    let passes =
        (depth / tool.max_step_down - 1e-9).ceil().max((depth / (room * STEEPEST_SLOPE) - 1e-9).ceil());
    if passes > MOST_PASSES || passes * path.sides.len() as f64 > MOST_SIDES {
        return Err(Refusal::TooManyPasses { passes, sides: path.sides.len() });
    }
    let step = depth / passes;
    let direction = steps.machine.spec().direction;
    let (ramp, rest) =
        split(run(path, room.min(step / GENTLE_SLOPE), direction), room.min(step / GENTLE_SLOPE));
    let ramp_length: f64 = ramp.iter().map(|p| p.length).sum();

    // Downwards no faster than the plunge feed.
    let ramp_feed = tool.feed.min(tool.plunge * (ramp_length * ramp_length + step * step).sqrt() / step);
    let (feed, plunge) = (tool.feed, tool.plunge.min(tool.feed));
    let start = ramp[0].from;
    steps.note(format!("outer contour, passes: {passes:.0}"));
    steps.rapid(start);
    steps.line(start.extend(top + APPROACH), feed);
    steps.line(start.extend(top), plunge);
    let mut go = |piece: &Piece, z: f64, feed: f64| {
        let (to, radius) = (piece.to.extend(z), path.radius);
        let turn = match direction {
            CutDirection::Climb => Turn::Clockwise,
            CutDirection::Conventional => Turn::Anticlockwise,
        };
        steps.out.push(if piece.arc {
            Step::Arc { to, radius, turn, feed }
        } else {
            Step::Line { to, feed }
        });
    };
    for pass in 1..=passes as u32 {
        let above = top - step * f64::from(pass - 1);
        let z = if f64::from(pass) == passes { bottom } else { top - step * f64::from(pass) };
        let mut gone = 0.0;
        for (i, piece) in ramp.iter().enumerate() {
            gone += piece.length;
            let last = i + 1 == ramp.len();
            go(piece, if last { z } else { above + (z - above) * (gone / ramp_length) }, ramp_feed);
        }
        rest.iter().for_each(|piece| go(piece, z, feed));
    }
    ramp.iter().for_each(|piece| go(piece, bottom, feed));
    steps.retract();
    Ok(())
}

/// The whole path in the direction of cutting, opened where a ramp of this length is to begin: so that it lies in the
/// middle of the longest side (the first of equals) if it has room there.
fn run(path: &CentrePath, ramp: f64, direction: CutDirection) -> Vec<Piece> {
    let length = |i: usize| path.sides[i].from.distance(path.sides[i].to);
    let longest = (1..path.sides.len()).fold(0, |best, i| if length(i) > length(best) { i } else { best });
    let side = path.sides[longest];
    let before_middle = (ramp / length(longest)).min(SIDE_SHARE) / 2.0;
    let at = |t: f64| side.from + (side.to - side.from) * t;
    match direction {
        CutDirection::Conventional => anticlockwise(path, longest, at(0.5 - before_middle)),
        CutDirection::Climb => {
            let backwards = |p: &Piece| Piece { from: p.to, to: p.from, ..*p };
            anticlockwise(path, longest, at(0.5 + before_middle)).iter().rev().map(backwards).collect()
        }
    }
}

/// Once around from `start` on side `first`.
fn anticlockwise(path: &CentrePath, first: usize, start: DVec2) -> Vec<Piece> {
    let n = path.sides.len();
    let line = |from: DVec2, to: DVec2| Piece { from, to, arc: false, length: from.distance(to) };
    let mut out = Vec::with_capacity(2 * n + 1);
    let mut from = start;
    for k in 0..n {
        let (here, next) = (path.sides[(first + k) % n], path.sides[(first + k + 1) % n]);
        out.push(line(from, here.to));
        if here.to != next.from {
            let half_chord = here.to.distance(next.from) / (2.0 * path.radius);
            let length = 2.0 * path.radius * libm::asin(half_chord.min(1.0));
            out.push(Piece { from: here.to, to: next.from, arc: true, length });
        }
        from = next.from;
    }
    out.push(line(from, start));
    out.retain(|piece| piece.from != piece.to);
    out
}

/// The pieces of the first `length` mm, and the rest. An arc that the cut would fall in goes to the first part whole.
fn split(pieces: Vec<Piece>, length: f64) -> (Vec<Piece>, Vec<Piece>) {
    let (mut first, mut rest) = (Vec::new(), Vec::new());
    let mut left = length;
    for piece in pieces {
        if left <= 1e-6 {
            rest.push(piece);
        } else if piece.arc || piece.length <= left + 1e-6 {
            first.push(piece);
            left -= piece.length;
        } else {
            let middle = piece.from + (piece.to - piece.from) * (left / piece.length);
            first.push(Piece { to: middle, length: left, ..piece });
            rest.push(Piece { from: middle, length: piece.length - left, ..piece });
            left = 0.0;
        }
    }
    (first, rest)
}
