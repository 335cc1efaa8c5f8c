//! Planks from the segments of a plane curve: what a [`Plank`] holds and the settings. How it is made is in `make`, its
//! end cuts are in `end`, and why one is refused is in `refusal`.

mod end;
mod make;
mod refusal;

use glam::{DVec2, DVec3};

use super::label::Label;
use super::material::Material;
use super::solid::Solid;

pub use end::CutPlane;
pub use make::{closed_planks, planks};
pub use refusal::{PlankError, PlankRefusal};

/// How far (mm) a point of a curve may lie off its plane for the curve to count as plane.
pub const PLANE_TOLERANCE: f64 = 1e-3;

/// The least length of a plank on its axis, mm. What is shorter is no plank, and so small a curve counts as straight within
/// [`PLANE_TOLERANCE`], however much it turns.
pub const LEAST_LENGTH: f64 = 1.0;

/// The most an end cut may be away from a square one, rad: 80 degrees. Beyond, a plank of depth 120 mm runs out into a
/// point of more than 680 mm.
pub const MOST_END_ANGLE: f64 = 80.0 * std::f64::consts::PI / 180.0;

/// How planks end where they meet the next one. The two outer ends of a curve are square, or cut to a plane.
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
    /// Where the first plank of an open curve begins; none for a square end at its first point. The plank is made
    /// longer or shorter to reach it.
    pub first: Option<CutPlane>,
    /// Where the last one ends.
    pub last: Option<CutPlane>,
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
    /// Length of the shorter of the two faces square to the plane of the curve, along its middle, mm.
    pub inner_length: f64,
    /// Length of the longer of the two, mm.
    pub outer_length: f64,
    /// At the start and the end, the angle from a square cut to the end cut, rad: half the turning angle of a mitred
    /// joint, positive counter-clockwise seen against `plane_normal`. The two at a joint are equal and opposite.
    pub mitres: [f64; 2],
    /// At the start and the end, how much the end cut leans out of square to the plane of the curve, rad: the tilt of
    /// the blade. Positive where the cut's normal, taken along the axis, leans towards `plane_normal`. 0 at joints.
    pub bevels: [f64; 2],
    /// The outline in the plane of the curve, around all of the plank: start right, end right, end left, start left, counter-clockwise. The
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
    /// The ring it is put up in, from 0: the planks at the supports (see `assembly`).
    pub ring: u32,
    /// Its place in the order of assembly, from 1.
    pub order: u32,
    /// Its centre of gravity in space, mm.
    pub centre: DVec3,
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

#[cfg(test)]
mod tests;
