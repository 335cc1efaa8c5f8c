//! Where boards and planks lie in the building: the frame of their outlines in space.

use glam::{DVec2, DVec3};

use crate::fabricate::panel::Panel;
use crate::fabricate::plank::Plank;

/// A frame in space: the origin of an outline, mm, and the unit vectors along its x and y, which are square to each
/// other. The face that lies up looks along `normal`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) origin: DVec3,
    pub(super) x: DVec3,
    pub(super) y: DVec3,
    pub(super) normal: DVec3,
}

impl Frame {
    /// A point of the outline's plane in space, mm.
    pub(super) fn at(&self, point: DVec2) -> DVec3 {
        self.origin + self.x * point.x + self.y * point.y
    }

    /// The frame of a board's outline on the design surface. A board that follows a quad which is not quite flat lies in
    /// the plane square to the cross product of its diagonals, its middle in that of the corners.
    pub(super) fn of_panel(panel: &Panel) -> Frame {
        let [a, b, c, d] = panel.corners;
        let normal = (c - a).cross(d - b).normalize_or(DVec3::Z);
        let along = (b - a - normal * (b - a).dot(normal)).normalize_or(normal.any_orthonormal_vector());
        let side = (panel.design_outline[1] - panel.design_outline[0]).normalize_or(DVec2::X);
        // The direction that lies against the side AB as the x axis does in the outline.
        let x = along * side.x - normal.cross(along) * side.y;
        let y = normal.cross(x);
        let middle = panel.design_outline.iter().sum::<DVec2>() / 4.0;
        Frame { origin: (a + b + c + d) / 4.0 - x * middle.x - y * middle.y, x, y, normal }
    }

    /// The frame of a plank's outline in the plane of its curve.
    pub(super) fn of_plank(plank: &Plank) -> Frame {
        let x = (plank.axis[1] - plank.axis[0]).normalize_or(DVec3::X);
        let normal = plank.plane_normal;
        let y = normal.cross(x);
        // The outline is around all of the plank, whose end cuts may lean: its first corner along the axis is at 0.
        let ahead = plank.solid.vertices.iter().map(|&corner| (corner - plank.axis[0]).dot(x));
        let first = ahead.fold(f64::INFINITY, f64::min);
        Frame { origin: plank.axis[0] + x * first - y * (plank.depth / 2.0), x, y, normal }
    }
}
