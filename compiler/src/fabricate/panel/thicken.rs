//! The closed solid of a board: its quad, split in two, offset to both faces.

use glam::DVec3;

use super::Side;
use crate::fabricate::solid::Solid;
use crate::geometry::Diagonal;

/// The solid of the quad A, B, C, D (mm, convex, folded by less than a right angle over `split`) in `thickness`.
///
/// Each face is two triangles, parallel to those of the quad and the full thickness apart: the corners beside the
/// diagonal move along the normal of their triangle, those on it along the mitre (n + n′)/(1 + n·n′) of both normals.
pub(super) fn thicken(corners: [DVec3; 4], split: Diagonal, thickness: f64, side: Side) -> Solid {
    let triangles = split.triangles();
    let normals = triangles
        .map(|[a, b, c]| (corners[b] - corners[a]).cross(corners[c] - corners[a]).normalize_or_zero());
    let mut offsets = [(normals[0] + normals[1]) / (1.0 + normals[0].dot(normals[1])); 4];
    for (triangle, normal) in triangles.into_iter().zip(normals) {
        offsets[triangle[1]] = normal;
    }
    let (inside, outside) = match side {
        Side::Inner => (0.0, thickness),
        Side::Centred => (-thickness / 2.0, thickness / 2.0),
        Side::Outer => (-thickness, 0.0),
    };
    let face = |distance: f64| [0, 1, 2, 3].map(|corner| corners[corner] + offsets[corner] * distance);
    Solid::between(face(inside), face(outside), triangles)
}
