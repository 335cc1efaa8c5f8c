//! Which motion cuts, and what for: engraving or contour.

use super::Expected;
use super::geometry::{Piece, inside};
use super::interpret::{Move, Trace};

/// Heights that differ by less are the same, mm: two roundings to the third decimal, and a hair.
pub(super) const HEIGHT: f64 = 0.0015;

/// Feed motion below the stock's upper face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut<'a> {
    pub(super) made: &'a Move,
    pub(super) piece: Piece,
    pub(super) engraves: bool,
}

impl Cut<'_> {
    /// Its lowest Z.
    pub(super) fn lowest(&self) -> f64 {
        self.piece.from.z.min(self.piece.to.z)
    }
}

/// All cuts in order. With one tool for both, shallow motion inside the part is engraving.
pub(super) fn cuts<'a>(trace: &'a Trace, expected: &Expected) -> Vec<Cut<'a>> {
    let (cutter, engraver) = (expected.machine.cutter().number, expected.machine.engraver().number);
    let shallow = expected.top() - expected.machine.spec().engrave_depth - HEIGHT;
    let cut = |made: &'a Move| {
        let piece = made.piece()?;
        let lowest = piece.from.z.min(piece.to.z);
        let engraves = if cutter == engraver {
            lowest >= shallow && inside(piece.at(0.5).truncate(), &expected.outline)
        } else {
            made.tool == Some(engraver)
        };
        (lowest < expected.top() - HEIGHT).then_some(Cut { made, piece, engraves })
    };
    trace.moves().filter_map(cut).collect()
}
