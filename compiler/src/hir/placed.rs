//! Values of figures that are more than one ifs on plain control points: chains of windows, closed and rational nets,
//! surfaces swept along a path. No evaluation of them: that is the matter of `plan`.

use super::value::{Instance, Level};
use crate::source::Span;

/// An ifs on a list of control points, window by window, closed, or with weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The ifs.
    pub ifs: Instance,
    /// Coordinates in mm.
    pub points: Vec<[f64; 3]>,
    /// A weight above 0 for each point, where one of them has one.
    pub weights: Option<Vec<f64>>,
    /// 2 or 3.
    pub dimension: u8,
    /// Whether every window of the list is used, or the list is just one window.
    pub windows: bool,
    /// Whether the windows go round.
    pub closed: bool,
}

/// The product of two ifs on a grid of control points that is closed or has weights.
#[derive(Clone, Debug, PartialEq)]
pub struct Net {
    /// The ifs along the rows' order.
    pub u: Instance,
    /// The ifs along a row.
    pub v: Instance,
    /// The grid.
    pub grid: ControlGrid,
    /// Whether every window of the net is used, or the net is just one window.
    pub windows: bool,
    /// Whether the net goes round in u and in v.
    pub closed: (bool, bool),
}

/// A grid of control points.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlGrid {
    /// Row by row, coordinates in mm.
    pub points: Vec<[f64; 3]>,
    /// A weight above 0 for each point, where one of them has one.
    pub weights: Option<Vec<f64>>,
    /// How many rows.
    pub rows: usize,
    /// How many columns.
    pub columns: usize,
}

/// A list of control points.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlList {
    /// Coordinates in mm.
    pub points: Vec<[f64; 3]>,
    /// A weight above 0 for each point, where one of them has one.
    pub weights: Option<Vec<f64>>,
    /// 2 or 3; all points have the same number of coordinates.
    pub dimension: u8,
}

/// A curve that a surface is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// What it is called: `rail` or `profile`.
    pub role: &'static str,
    /// The curve.
    pub chain: Chain,
    /// Its own level, where it has one.
    pub level: Option<Level>,
    /// Where it is given.
    pub span: Span,
}

/// A profile swept along a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Swept {
    /// The profile.
    pub profile: Arm,
    /// The path.
    pub path: SweptPath,
}

/// How a profile is moved.
#[derive(Clone, Debug, PartialEq)]
pub enum SweptPath {
    /// Along a rail.
    Rail(Arm, SweptRule),
    /// Round an axis.
    Turn {
        /// A point of the axis, mm.
        point: [f64; 3],
        /// Its direction, of length 1.
        direction: [f64; 3],
        /// The angle, rad.
        angle: f64,
        /// Whether it is a full turn.
        full: bool,
        /// How many steps.
        segments: u32,
    },
    /// Along a vector, mm, in equal pieces.
    Straight {
        /// The vector.
        vector: [f64; 3],
        /// How many pieces.
        pieces: u32,
    },
}

/// How a rail and a profile make a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum SweptRule {
    /// `translation`
    Sum,
    /// `scale_translation`, with a number above 0 for each control point of the rail.
    Scaled(Vec<f64>),
    /// `projective_sum`
    Projective,
}
