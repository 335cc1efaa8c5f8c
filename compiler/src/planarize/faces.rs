//! What every quad was at the start, and whether a step would invert one.

use glam::DVec3;

use crate::geometry::planarity::corner_normals;
use crate::geometry::{QuadMeasure, QuadMesh, Verdict};

/// A quad as it was at the start.
pub(super) struct Face {
    /// Its corners.
    pub(super) corners: [usize; 4],
    /// The vector area it started with: a quad that turns away from it is inverted.
    start: DVec3,
    was: Verdict,
}

impl Face {
    /// The quad `quad` of `start`, whose measure is `measure`.
    pub(super) fn new(start: &QuadMesh, measure: &QuadMeasure, quad: usize) -> Self {
        let normals = corner_normals(start.corners_of(quad));
        Self {
            corners: start.quads[quad].map(|corner| corner as usize),
            start: normals[0] + normals[2],
            was: measure.verdict,
        }
    }

    /// Whether the quad is not inverted, unless it was: a convex one is convex and not turned over against its start,
    /// and none has lost its shape.
    pub(super) fn admits(&self, vertices: &[DVec3]) -> bool {
        let corners = self.corners.map(|corner| vertices[corner]);
        if !corners.iter().all(|corner| corner.is_finite()) {
            return false;
        }
        let normals = corner_normals(corners);
        let upright = (normals[0] + normals[2]).dot(self.start) > 0.0;
        match (self.was, QuadMeasure::of(corners).verdict) {
            (Verdict::FoldedOver, Verdict::Convex | Verdict::Dart | Verdict::FoldedOver) => true,
            (Verdict::Dart, Verdict::Dart) | (_, Verdict::Convex) => upright,
            _ => false,
        }
    }
}

/// How many quads of `start` that were not inverted are so in a mesh with these vertices. 0 after planarizing.
pub(super) fn inverted(start: &QuadMesh, measures: &[QuadMeasure], vertices: &[DVec3]) -> usize {
    let faces = measures.iter().enumerate().filter(|(_, measure)| {
        !matches!(measure.verdict, Verdict::Degenerate | Verdict::CollinearCorner | Verdict::FoldedOver)
    });
    faces.filter(|(quad, measure)| !Face::new(start, measure, *quad).admits(vertices)).count()
}
