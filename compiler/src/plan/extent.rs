//! How large a figure of separate pieces is: its bounding box, and its smallest and largest element.

use std::convert::Infallible;

use crate::ifs::Automaton;

use super::evaluate::PiecesEvaluator;
use super::figure::PiecesPlan;
use super::size::{SizeMeasure, SizeRange};

/// Where a figure lies and how large its elements are, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The least coordinates.
    pub low: [f64; 3],
    /// The greatest coordinates.
    pub high: [f64; 3],
    /// Diameters of its elements, kept ones among them; none where all are points.
    pub sizes: Option<SizeRange>,
}

impl Extent {
    /// Whether every coordinate is a number of at most this size.
    pub fn is_within(&self, largest: f64) -> bool {
        self.low.iter().chain(&self.high).all(|value| value.abs() <= largest)
    }
}

/// Measures a figure of a [`super::Plan`] on this automaton, within a budget. A coordinate that is no number makes the
/// whole box none.
pub fn extent(automaton: &Automaton, pieces: &PiecesPlan) -> Extent {
    let mut out = Extent { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3], sizes: None };
    let mut vertices = Vec::new();
    let mut numbers = true;
    let Ok(()) = PiecesEvaluator::new(automaton, pieces).stream(|tile| {
        for axis in 0..3 {
            let values = tile.axis(axis);
            out.low[axis] = values.iter().copied().fold(out.low[axis], f64::min);
            out.high[axis] = values.iter().copied().fold(out.high[axis], f64::max);
            numbers &= values.iter().all(|value| value.is_finite());
        }
        for element in tile.elements() {
            tile.copy_vertices(&element, &mut vertices);
            let size = SizeMeasure::Size.of(&element.drawn.shape, &vertices);
            out.sizes = [out.sizes, size].into_iter().flatten().reduce(SizeRange::with);
        }
        Ok::<(), Infallible>(())
    });
    if !numbers {
        (out.low, out.high) = ([f64::NAN; 3], [f64::NAN; 3]);
    }
    out
}
