//! Why a plank, or all planks of a curve, cannot be made: the reasons and their words.

use std::fmt;

use super::{LEAST_LENGTH, MOST_END_ANGLE};

/// Why no plank can be made for a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlankRefusal {
    /// The segment is shorter than [`LEAST_LENGTH`]. mm.
    TooShort {
        /// Its length.
        length: f64,
    },
    /// The gaps, or the planes it is cut to, leave less than [`LEAST_LENGTH`] of its axis. mm.
    NothingLeft {
        /// The length the axis would have; below 0 where the cuts pass each other.
        length: f64,
    },
    /// Its two end cuts meet within the section: one of its edges would have no length. mm.
    CutsCross {
        /// The length of the shortest edge, 0 or less.
        inner_length: f64,
    },
    /// An end cut is further from square than [`MOST_END_ANGLE`].
    TooSteep {
        /// The angle from a square cut, rad.
        angle: f64,
    },
    /// It is longer than a bar. mm.
    TooLong {
        /// The length of bar it takes.
        needed: f64,
        /// The length of a bar.
        stock: f64,
    },
}

impl fmt::Display for PlankRefusal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooShort { length: 0.0 } => out.write_str("its segment of the curve has no length"),
            Self::TooShort { length } => write!(
                out,
                "its segment of the curve is {}, and a plank is at least {LEAST_LENGTH}mm long",
                match *length {
                    length if length < 0.0005 => "shorter than 0.001mm".to_owned(),
                    length => format!("{length:.3}mm long"),
                }
            ),
            Self::NothingLeft { length } if *length > 0.0 => write!(
                out,
                "its end cuts leave too little of it: its axis would be {length:.3}mm long, and {LEAST_LENGTH}mm is the least"
            ),
            Self::NothingLeft { length } => {
                write!(out, "its end cuts leave nothing of it: its axis would be {length:.1}mm long")
            }
            Self::CutsCross { inner_length } => {
                write!(out, "its end cuts cross: the inner face would be {inner_length:.1}mm long")
            }
            Self::TooSteep { angle } => write!(
                out,
                "an end would be cut at {:.1}deg from square, and {:.0}deg is the most",
                angle.to_degrees(),
                MOST_END_ANGLE.to_degrees()
            ),
            Self::TooLong { needed, stock } => {
                write!(out, "it takes {needed:.1}mm of a bar of {stock}mm")
            }
        }
    }
}

/// Why no planks at all can be made of a curve.
#[derive(Debug, Clone, PartialEq)]
pub enum PlankError {
    /// Fewer than two points.
    TooFewPoints,
    /// A coordinate is not finite.
    NotFinite {
        /// The index of the point.
        point: usize,
    },
    /// The curve does not lie in a plane.
    NotPlanar {
        /// How far a point lies off it, mm.
        deviation: f64,
    },
    /// A size of the section or the stock is not above 0, or the gap is below 0.
    NoSection {
        /// Which one.
        what: &'static str,
        /// As given, mm.
        value: f64,
    },
    /// A curve that goes round has no ends to cut to a plane.
    NoEnds,
    /// Not one label for each segment.
    WrongLabelCount {
        /// How many segments there are.
        segments: usize,
        /// How many labels.
        labels: usize,
    },
}

impl fmt::Display for PlankError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewPoints => out.write_str("a curve needs two points to have planks"),
            Self::NotFinite { point } => write!(out, "point {point} has a coordinate that is not finite"),
            Self::NotPlanar { deviation } => {
                write!(out, "planks need a curve in one plane; a point lies {deviation:.3}mm off it")
            }
            Self::NoSection { what, value } => {
                let least = if what.starts_with("gap") { "is 0mm or more" } else { "is above 0mm" };
                write!(out, "the {what} {least}, but here it is {value}mm")
            }
            Self::NoEnds => out.write_str("a curve that goes round has no ends to cut to a plane"),
            Self::WrongLabelCount { segments, labels } => {
                write!(out, "{labels} labels for {segments} segments")
            }
        }
    }
}

impl std::error::Error for PlankError {}
