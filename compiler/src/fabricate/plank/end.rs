//! Where a plank ends: the plane of an end cut, seen from the plank's axis.

use glam::DVec3;

use super::{MOST_END_ANGLE, PlankRefusal};

/// A plane to which the first or the last end of a curve is cut. mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutPlane {
    /// A point of it.
    pub point: DVec3,
    /// Square to it; of any length above 0, and either way.
    pub normal: DVec3,
}

/// The directions of a plank: right-handed, unit vectors.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// From start to end.
    pub along: DVec3,
    /// In the plane of the curve: +y of the outline.
    pub left: DVec3,
    /// The normal of the plane of the curve.
    pub up: DVec3,
}

/// An end cut: it meets the line at y to the left and z up at `position + left · y + up · z` along the axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct EndCut {
    /// Where it meets the axis, mm from the start of the segment.
    pub position: f64,
    /// How far it runs ahead to the left.
    pub left: f64,
    /// How far it runs ahead upwards.
    pub up: f64,
    /// From a square cut to this one, in the plane of the curve, rad.
    pub mitre: f64,
    /// How much it leans out of square to that plane, rad.
    pub bevel: f64,
}

impl EndCut {
    /// The cut through a joint that turns by twice `mitre`.
    ///
    /// # Errors
    /// More than [`MOST_END_ANGLE`] from square.
    pub(super) fn at_joint(position: f64, mitre: f64) -> Result<Self, PlankRefusal> {
        not_steep(mitre.abs())?;
        Ok(Self { position, left: -libm::tan(mitre), up: 0.0, mitre, bevel: 0.0 })
    }

    /// The cut along a plane, of a plank whose segment begins at `start`.
    ///
    /// # Errors
    /// More than [`MOST_END_ANGLE`] from square.
    pub(super) fn along_plane(plane: &CutPlane, start: DVec3, frame: &Frame) -> Result<Self, PlankRefusal> {
        let normal = plane.normal.normalize_or_zero();
        let normal = if normal.dot(frame.along) < 0.0 { -normal } else { normal };
        let ahead = normal.dot(frame.along);
        let (left, up) = (normal.dot(frame.left), normal.dot(frame.up));
        not_steep(libm::atan2(libm::hypot(left, up), ahead))?;
        Ok(Self {
            position: normal.dot(plane.point - start) / ahead,
            left: -left / ahead,
            up: -up / ahead,
            mitre: libm::atan2(left, ahead),
            bevel: libm::atan2(up, libm::hypot(left, ahead)),
        })
    }

    /// Where it meets a line beside the axis.
    pub(super) fn at(&self, y: f64, z: f64) -> f64 {
        self.position + self.left * y + self.up * z
    }
}

fn not_steep(angle: f64) -> Result<(), PlankRefusal> {
    if angle <= MOST_END_ANGLE { Ok(()) } else { Err(PlankRefusal::TooSteep { angle }) }
}
