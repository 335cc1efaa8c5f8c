//! A feed is set before feed motion, is within the tool's, and never drives the tool down into material faster than
//! its plunge feed.

use crate::readback::cuts::HEIGHT;
use crate::readback::interpret::{Motion, Move, Trace};
use crate::readback::{Expected, Fault, FaultKind};

pub(super) fn check(trace: &Trace, expected: &Expected, faults: &mut Vec<Fault>) {
    for m in trace.moves().filter(|m| m.motion != Motion::Rapid) {
        let Some(feed) = m.feed.filter(|&feed| feed > 0.0) else {
            faults.push(Fault::new(FaultKind::FeedMissing, m.line, "feed motion without a feed"));
            continue;
        };
        let tool = expected.machine.spec().tools.iter().find(|t| Some(t.number) == m.tool);
        let Some(tool) = tool else { continue };
        let greatest = tool.feed * 60.0;
        if feed > greatest + 0.001 {
            let message = format!("feed {feed:.3} mm/min, tool {} bears {greatest:.3}", tool.number);
            faults.push(Fault::measured(FaultKind::FeedRange, m.line, feed, message));
        }
        let (down, greatest) = (downward_speed(m, feed, expected.top()), tool.plunge * 60.0);
        if down > greatest * 1.005 + 0.001 {
            let message = format!("goes down at {down:.3} mm/min, tool {} bears {greatest:.3}", tool.number);
            faults.push(Fault::measured(FaultKind::PlungeRange, m.line, down, message));
        }
    }
}

/// Vertical part of the feed of a move that goes down into the stock, mm/min; 0 for any other. Depths near the last
/// decimal say nothing about a slope.
fn downward_speed(m: &Move, feed: f64, top: f64) -> f64 {
    let Some(piece) = m.piece() else { return 0.0 };
    let down = piece.from.z - piece.to.z;
    if down < 0.01 || piece.to.z >= top - HEIGHT {
        return 0.0;
    }
    let length = piece.length();
    feed * down / (length * length + down * down).sqrt()
}
