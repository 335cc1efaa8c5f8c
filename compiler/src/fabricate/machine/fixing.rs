//! What holds a part while its contour is cut, and where clamps stand. Plain data with its own checks.

use super::MAX_LENGTH;
use super::faults::{Faults, FigureUnit};

/// Most tabs a contour may have.
const MOST_TABS: u32 = 100;

/// What keeps the part in place to the end of its contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fixing {
    /// The table holds the part itself, by vacuum or screws: the contour is cut through all around.
    Held,
    /// Bridges between part and waste, left at the lower face.
    Tabs {
        /// How many.
        count: u32,
        /// Their width at the part, mm.
        width: f64,
        /// Their height over the stock's lower face, mm.
        height: f64,
    },
    /// A layer left under the whole contour.
    OnionSkin {
        /// Its thickness, mm.
        thickness: f64,
    },
}

impl Fixing {
    pub(super) fn check(self, faults: &mut Faults) {
        match self {
            Fixing::Held => {}
            Fixing::Tabs { count, width, height } => {
                let range = (1.0, f64::from(MOST_TABS));
                faults.within("count of tabs", f64::from(count), range, FigureUnit::Plain);
                faults.length("width of tabs", width, 0.1, 1000.0);
                faults.length("height of tabs", height, 0.1, 1000.0);
            }
            Fixing::OnionSkin { thickness } => {
                faults.length("onion skin", thickness, 0.05, 1000.0);
            }
        }
    }
}

/// A clamp on the stock: a box that no tool may touch. Coordinates are those of the program, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clamp {
    /// Its least X and Y.
    pub low: glam::DVec2,
    /// Its greatest X and Y.
    pub high: glam::DVec2,
    /// Its height over the stock's upper face.
    pub height: f64,
}

impl Clamp {
    pub(super) fn check(&self, safe_height: f64, faults: &mut Faults) {
        for (what, low, high) in
            [("length of a clamp", self.low.x, self.high.x), ("width of a clamp", self.low.y, self.high.y)]
        {
            faults.length("place of a clamp", low, -MAX_LENGTH, MAX_LENGTH);
            faults.length(what, high - low, 0.1, MAX_LENGTH);
        }
        // Below the safe height by something, so that travel at it is free.
        faults.length("height of a clamp", self.height, 0.0, safe_height - 1.0);
    }
}
