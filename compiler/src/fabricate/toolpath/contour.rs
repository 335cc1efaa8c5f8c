//! Passes around the outer contour: down a ramp along the longest edge, around, and once more over the ramp at full
//! depth. The tool's centre never leaves the offset path, so all it cuts beside the contour is waste.

use super::offset::CentrePath;
use super::program::{Step, Turn};
use super::{Refusal, Steps};
use crate::fabricate::machine::CutDirection;
use glam::DVec2;

/// Gentle ramp: 1 in 10, as long as the edge has room.
const GENTLE_SLOPE: f64 = 0.1;
/// Steepest ramp; shorter edges take more passes instead.
const STEEPEST_SLOPE: f64 = 0.25;
/// Part of the longest edge a ramp may take: it stays clear of both corners.
const RAMP_SHARE: f64 = 0.6;
/// Most passes a contour may take.
const MOST_PASSES: f64 = 200.0;
/// Most sides over all passes: keeps programs readable by machines and by read-back.
const MOST_SIDES: f64 = 10_000.0;
/// Height above the stock where the descent slows from feed to plunge, mm.
pub(super) const APPROACH: f64 = 1.0;

/// One piece of the closed path in the direction of cutting.
struct Piece {
    to: DVec2,
    /// Whether it is an arc around a corner.
    arc: bool,
}

/// Where a contour's ramp lies and what is cut after it.
struct Loop {
    ramp_from: DVec2,
    ramp_to: DVec2,
    /// From the end of the ramp around to its start.
    around: Vec<Piece>,
    turn: Turn,
}

/// Cuts the contour down to thickness + cut-through in equal passes.
///
/// # Errors
/// `NoRoomForRamp` if the longest edge is so short that more than 200 passes, or 10,000 sides in all, were needed.
pub(super) fn cut(steps: &mut Steps, path: &CentrePath) -> Result<(), Refusal> {
    let tool = steps.machine.cutter();
    let (top, bottom) = (steps.top(), steps.machine.bottom(steps.thickness));
    let depth = top - bottom;
    let longest = path.sides.iter().map(|s| s.from.distance(s.to)).fold(0.0, f64::max);
    let room = RAMP_SHARE * longest;
    let passes =
        (depth / tool.max_step_down - 1e-9).ceil().max((depth / (room * STEEPEST_SLOPE) - 1e-9).ceil());
    if passes > MOST_PASSES || passes * path.sides.len() as f64 > MOST_SIDES {
        return Err(Refusal::NoRoomForRamp { longest, passes });
    }
    let step = depth / passes;
    let ramp = room.min(step / GENTLE_SLOPE);
    let way = run(path, ramp, steps.machine.spec().direction);

    // Downwards no faster than the plunge feed.
    let ramp_feed = tool.feed.min(tool.plunge * (ramp * ramp + step * step).sqrt() / step);
    let (feed, plunge) = (tool.feed, tool.plunge);
    steps.note(format!("outer contour, passes: {passes:.0}"));
    steps.rapid(way.ramp_from);
    steps.line(way.ramp_from.extend(top + APPROACH), feed);
    steps.line(way.ramp_from.extend(top), plunge);
    let mut z = top;
    for pass in 1..=passes as u32 {
        z = if f64::from(pass) == passes { bottom } else { top - step * f64::from(pass) };
        steps.line(way.ramp_to.extend(z), ramp_feed);
        for piece in &way.around {
            let to = piece.to.extend(z);
            steps.out.push(if piece.arc {
                Step::Arc { to, radius: path.radius, turn: way.turn, feed }
            } else {
                Step::Line { to, feed }
            });
        }
    }
    steps.line(way.ramp_to.extend(z), feed);
    steps.retract();
    Ok(())
}

/// Opens the closed path at a ramp of this length in the middle of its longest side (the first of equals).
fn run(path: &CentrePath, ramp: f64, direction: CutDirection) -> Loop {
    let n = path.sides.len();
    let length = |i: usize| path.sides[i].from.distance(path.sides[i].to);
    let longest = (1..n).fold(0, |best, i| if length(i) > length(best) { i } else { best });
    let side = path.sides[longest];
    let middle = (side.from + side.to) / 2.0;
    let half = (side.to - side.from) * (ramp / (2.0 * length(longest)));
    // Anticlockwise, from side to side with arcs between; clockwise is the same read backwards.
    let mut points: Vec<Piece> = vec![Piece { to: middle + half, arc: false }];
    for k in 0..n {
        let (here, next) = (path.sides[(longest + k) % n], path.sides[(longest + k + 1) % n]);
        points.push(Piece { to: here.to, arc: false });
        if here.to != next.from {
            points.push(Piece { to: next.from, arc: true });
        }
    }
    points.push(Piece { to: middle - half, arc: false });
    match direction {
        CutDirection::Conventional => {
            let around = points.split_off(1);
            Loop { ramp_from: middle - half, ramp_to: middle + half, around, turn: Turn::Anticlockwise }
        }
        CutDirection::Climb => {
            let backwards = |pair: &[Piece]| Piece { to: pair[0].to, arc: pair[1].arc };
            let around = points.windows(2).rev().map(backwards).collect();
            Loop { ramp_from: middle + half, ramp_to: middle - half, around, turn: Turn::Clockwise }
        }
    }
}
