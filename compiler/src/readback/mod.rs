//! Reads NC text as a machine would and judges it: what moves, what it sweeps, whether that is the part and nothing
//! else. Shares no code with `export` or with the making of toolpaths: of `fabricate` it knows the figures of a
//! machine, the job, and the letters of the engraving font. Faults are plain data; nobody is told here.

mod checks;
mod cuts;
mod decode;
mod expected;
mod fault;
mod geometry;
mod header;
mod interpret;
mod lines;
mod rebuild;
#[cfg(test)]
mod tests;

pub use expected::Expected;
pub use fault::{Fault, FaultKind, TABLE as FAULTS};
pub use interpret::{Event, Motion, Move};

use glam::DVec2;
use interpret::Trace;

/// How far the swept outline may be from the cut outline, mm.
pub const OUTLINE_TOLERANCE: f64 = 0.01;

/// A program that was found good.
#[derive(Clone, Debug, PartialEq)]
pub struct Readback {
    /// The part's outline in program coordinates as the cutter leaves it: its full-depth path taken back by its
    /// radius, in mm, anticlockwise. Nearly straight corners may be one point or two.
    pub outline: Vec<DVec2>,
    /// Greatest distance from a corner of either outline, rebuilt or expected, to the other, mm.
    pub deviation: f64,
    /// The text that the engraved strokes spell.
    pub engraved: String,
    /// Every motion in order.
    pub moves: Vec<Move>,
}

/// Reads `text` and compares it with what was asked for.
///
/// # Errors
/// All faults found, in order of their lines; never empty.
pub fn read_back(text: &str, expected: &Expected) -> Result<Readback, Vec<Fault>> {
    let mut faults = Vec::new();
    let lines = lines::read(text, &mut faults);
    let trace: Trace = interpret::interpret(&lines, &mut faults);
    checks::all(&trace, &lines, expected, &mut faults);
    let engraved = decode::engraving(&trace, expected, &mut faults);
    let rebuilt = rebuild::outline(&trace, expected, &mut faults);
    faults.sort_by_key(|fault| fault.line);
    match rebuilt {
        Some(rebuilt) if faults.is_empty() => Ok(Readback {
            outline: rebuilt.outline,
            deviation: rebuilt.deviation,
            engraved,
            moves: trace.moves().copied().collect(),
        }),
        _ => Err(faults),
    }
}
