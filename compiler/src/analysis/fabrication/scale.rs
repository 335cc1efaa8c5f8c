//! `scale`: a model of the building. What a block makes is made of the figure's geometry times the scale; sections,
//! thickness, stock and tools stay what they are, and requirements are measured on what is made.

use super::Work;
use crate::geometry::QuadMesh;
use crate::hir::value::Value;
use glam::DVec3;

impl Work<'_> {
    /// The scale that the block asks for, 1 where it says none; `None` after a report.
    pub(super) fn scale_asked(&mut self) -> Option<f64> {
        let Some(scale) = self.setting("scale").and_then(|(_, value, _)| Value::number(value)) else {
            return Some(1.0);
        };
        if scale > 0.0 && scale <= 1.0 {
            return Some(scale);
        }
        let why = format!(
            "a model is larger than nothing and at most as large as the building, but `scale` is {scale}: \
             write `1/20` for a twentieth"
        );
        self.refuse("scale", &why);
        None
    }

    /// A surface at the block's scale.
    pub(super) fn scaled_mesh(&self, mut mesh: QuadMesh) -> QuadMesh {
        self.scale_points(&mut mesh.vertices);
        mesh
    }

    /// Points at the block's scale, about the origin.
    pub(super) fn scale_points(&self, points: &mut [DVec3]) {
        for point in points {
            *point *= self.scale;
        }
    }
}
