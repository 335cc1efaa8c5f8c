//! Planks from the segments of a plane curve: what a [`Plank`] holds, the settings, and why one is refused. How it is
//! made is in `make`.

mod make;

use std::fmt;

use glam::{DVec2, DVec3};

use super::label::Label;
use super::material::Material;
use super::solid::Solid;

pub use make::{closed_planks, planks};

/// How far (mm) a point of a curve may lie off its plane for the curve to count as plane.
pub const PLANE_TOLERANCE: f64 = 1e-3;

/// How planks end where they meet the next one. The two outer ends of a curve are always square.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// Square to the plank, through the joint on the axis: where the curve turns, the inner faces would overlap and
    /// the outer faces stand open by depth · tan(turning angle / 2) / 2 each.
    Square,
    /// Cut along the bisector of the joint, so that the two ends lie flat against each other.
    Mitred,
}

/// How the segments of one curve become planks.
#[derive(Debug, Clone, PartialEq)]
pub struct PlankSettings {
    /// What they are cut from. Its thickness is not looked at: the section says it.
    pub material: Material,
    /// Size of the section in the plane of the curve, mm. The axis runs through the middle.
    pub depth: f64,
    /// Size of the section square to that plane, mm.
    pub width: f64,
    /// How planks end at joints.
    pub ends: Ends,
    /// The opening left at each joint, measured square to the end cuts, mm: half of it comes off each of the two
    /// planks.
    pub gap: f64,
    /// Length of the bars planks are cut from, mm.
    pub stock: f64,
}

/// A plank along one segment of a curve. Seen against `plane_normal`, left is the plank's +y.
#[derive(Debug, Clone, PartialEq)]
pub struct Plank {
    /// Address and alias.
    pub label: Label,
    /// Where the axis starts and ends, at the end cuts, mm.
    pub axis: [DVec3; 2],
    /// Unit normal of the plane of the curve, the same for all its planks.
    pub plane_normal: DVec3,
    /// Length between the end cuts on the axis, mm.
    pub length: f64,
    /// Length of the shorter of the two faces square to the plane of the curve, mm.
    pub inner_length: f64,
    /// Length of the longer of the two, mm.
    pub outer_length: f64,
    /// At the start and the end, the angle from a square cut to the end cut, rad: half the turning angle of a mitred
    /// joint, positive counter-clockwise seen against `plane_normal`. The two at a joint are equal and opposite.
    pub mitres: [f64; 2],
    /// The outline in the plane of the curve: start right, end right, end left, start left, counter-clockwise. The
    /// axis runs along x, the depth along y; the lower left of its box is the origin. mm.
    pub outline: Vec<DVec2>,
    /// Size of the section in the plane of the curve, mm.
    pub depth: f64,
    /// Size of the section square to that plane, mm.
    pub width: f64,
    /// kg; none where the material has no density.
    pub mass: Option<f64>,
    /// The addresses of the planks before and after.
    pub neighbours: [Option<String>; 2],
    /// The plank in space.
    pub solid: Solid,
}

/// The planks of one curve and those that cannot be made. Both in the order of the curve.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Planks {
    /// The planks.
    pub planks: Vec<Plank>,
    /// The segments no plank can be made for.
    pub refused: Vec<RefusedPlank>,
}

/// A segment no plank can be made for.
#[derive(Debug, Clone, PartialEq)]
pub struct RefusedPlank {
    /// Address and alias.
    pub label: Label,
    /// Why.
    pub reason: PlankRefusal,
}

/// Why no plank can be made for a segment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlankRefusal {
    /// The segment has no length.
    NoLength,
    /// Its two end cuts meet within the depth: one of its faces would have no length. mm.
    CutsCross {
        /// The length that face would have, 0 or less.
        inner_length: f64,
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
            Self::NoLength => out.write_str("its segment of the curve has no length"),
            Self::CutsCross { inner_length } => {
                write!(out, "its end cuts cross: the inner face would be {inner_length:.1}mm long")
            }
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
            Self::WrongLabelCount { segments, labels } => {
                write!(out, "{labels} labels for {segments} segments")
            }
        }
    }
}

impl std::error::Error for PlankError {}

#[cfg(test)]
mod tests;
