//! Levels by size (LANGUAGE 6): what `until` says, before any element is measured.

use crate::source::Span;

use super::tree;

/// What is measured of an element, mm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SizeMeasure {
    /// Its sides: the segment itself, the sides of a polygon, the axis of a strut.
    Edge,
    /// The length of a segment or strut.
    Length,
    /// Its diameter: the largest distance between two of its vertices; of a strut, the length of its axis.
    Size,
}

impl SizeMeasure {
    /// All of them.
    pub const ALL: [SizeMeasure; 3] = [SizeMeasure::Edge, SizeMeasure::Length, SizeMeasure::Size];

    /// The measure of this word.
    pub fn named(word: &str) -> Option<SizeMeasure> {
        SizeMeasure::ALL.into_iter().find(|measure| measure.word() == word)
    }

    /// As the language writes it.
    pub fn word(self) -> &'static str {
        match self {
            SizeMeasure::Edge => "edge",
            SizeMeasure::Length => "length",
            SizeMeasure::Size => "size",
        }
    }

    /// What it is, in a line for people.
    pub fn doc(self) -> &'static str {
        match self {
            SizeMeasure::Edge => {
                "the sides of each element: a segment itself, the sides of a polygon, the axis of a strut"
            }
            SizeMeasure::Length => "the length of each segment or strut",
            SizeMeasure::Size => {
                "the largest distance between two vertices of an element; of a strut, the length of its axis"
            }
        }
    }
}

/// A size that elements must not pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeBound {
    /// What is measured.
    pub measure: SizeMeasure,
    /// The largest size, mm.
    pub most: f64,
    /// Whether the largest itself is too large.
    pub strict: bool,
}

impl SizeBound {
    /// Whether this size is small enough.
    pub fn holds(&self, size: f64) -> bool {
        if self.strict { size < self.most } else { size <= self.most }
    }
}

/// `until …`, worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Until {
    /// Whether every branch stops on its own.
    pub each: bool,
    /// The largest size.
    pub bound: SizeBound,
    /// The smallest size, where there is one, mm.
    pub least: Option<f64>,
}

/// `until …` as an expression.
#[derive(Clone, Debug)]
pub struct UntilExpr {
    /// Whether every branch stops on its own.
    pub each: bool,
    /// What is measured.
    pub measure: SizeMeasure,
    /// A comparison with a largest size, or a range.
    pub limit: tree::Limit,
    /// From the measure to the end of its limit.
    pub span: Span,
}
