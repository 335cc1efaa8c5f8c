//! Planks out of bars of one length: what is asked for and what comes out. How a bar is filled is in `fill`, how
//! planks follow one another on it in `row`, and how few bars there can be in `bound`.
//!
//! The axis of a bar runs along x from its raw left end. A cut leans by an angle from square, positive anticlockwise as
//! for the mitres of planks. Planks may be turned end for end and over; a plank whose start leans like the end before it
//! shares its cut.

mod bound;
mod fill;
mod row;

use std::fmt;

pub use bound::least_bars;

/// Raw bars and the saw, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stock {
    /// Of a raw bar.
    pub length: f64,
    /// Across the bar, in the plane of the mitres.
    pub depth: f64,
    /// What the blade takes, square to the cut.
    pub kerf: f64,
    /// What is left aside at each end of a raw bar.
    pub trim: f64,
}

/// A plank to be cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plank {
    /// Between the end cuts on the axis, mm.
    pub length: f64,
    /// How its start and its end lean, rad.
    pub mitres: [f64; 2],
}

/// A plank on a bar.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    /// Which plank.
    pub plank: usize,
    /// Whether its end comes first.
    pub end_first: bool,
    /// Whether it is turned over about its axis.
    pub turned_over: bool,
    /// Where its first and its second cut meet the axis, mm from the raw left end of the bar.
    pub at: [f64; 2],
    /// How these cuts lean, rad.
    pub leans: [f64; 2],
}

/// One stroke of the saw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Where the face it makes meets the axis, mm: that of the plank before it, or else of the one after it.
    pub at: f64,
    /// How it leans, rad.
    pub lean: f64,
    /// The plank before it, whose end it makes.
    pub before: Option<usize>,
    /// The plank after it, whose start it makes.
    pub after: Option<usize>,
}

/// One bar with its planks from left to right.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bar {
    /// The planks.
    pub planks: Vec<Placed>,
    /// The strokes of the saw.
    pub cuts: Vec<Cut>,
    /// What is left at the right end, on its shorter face, the trim with it, mm.
    pub offcut: f64,
}

/// A plank no bar is long enough for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TooLong {
    /// Which plank.
    pub plank: usize,
    /// The length of bar it takes, mm.
    pub needed: f64,
    /// What a bar has between its trims, mm.
    pub room: f64,
}

impl fmt::Display for TooLong {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            out,
            "it takes {:.1}mm of a bar, which has {:.1}mm between its trimmed ends",
            self.needed, self.room
        )
    }
}

/// Planks out of bars.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sawn {
    /// The bars.
    pub bars: Vec<Bar>,
    /// Planks that are longer than a bar.
    pub too_long: Vec<TooLong>,
}

/// Cuts planks out of as few bars as it finds. Ties go to the plank that comes first.
#[must_use]
pub fn saw(planks: &[Plank], stock: &Stock) -> Sawn {
    fill::saw(planks, stock)
}

#[cfg(test)]
mod tests;
