//! Dihedral angles where two boards meet, and the bevels they ask for.

use glam::DVec3;

use super::mesh::QuadMesh;
use super::planarity::Diagonal;
use super::topology::MeshEdge;

/// How two triangles meet at an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dihedral {
    /// The interior angle δ, measured through the inside (against the normals): π where the two go on flat, less
    /// on a ridge, more in a valley. rad, in 0 ..= 2π.
    pub interior: f64,
}

impl Dihedral {
    /// The angle at the edge from `p` to `q` between the triangle (p, q, left) and the triangle (q, p, right),
    /// both counter-clockwise seen from outside. None where one of them has no area.
    #[must_use]
    pub fn between(p: DVec3, q: DVec3, left: DVec3, right: DVec3) -> Option<Self> {
        let along = (q - p).try_normalize()?;
        let first = (q - p).cross(left - p).try_normalize()?;
        let second = (p - q).cross(right - q).try_normalize()?;
        let turn = libm::atan2(first.cross(second).dot(along), first.dot(second));
        Some(Self { interior: std::f64::consts::PI - turn })
    }

    /// The bevel β = (π − δ)/2 each of the two boards gets: negative in valleys. rad (GEOMETRY section 8).
    #[must_use]
    pub fn bevel(self) -> f64 {
        (std::f64::consts::PI - self.interior) / 2.0
    }
}

/// The dihedral angle at an edge of the mesh, between the triangles which lie at it after the quads are split along
/// `splits` (one for each quad). None on the boundary, where the quads face different sides, and where a triangle
/// has no area.
#[must_use]
pub fn edge_dihedral(mesh: &QuadMesh, edge: &MeshEdge, splits: &[Diagonal]) -> Option<Dihedral> {
    let second = edge.second.filter(|_| edge.consistent)?;
    let apex = |quad: u32, side: u8| {
        let split = splits.get(quad as usize)?;
        let corner = split.apex_of_side(usize::from(side));
        Some(mesh.corners_of(quad as usize)[corner])
    };
    let left = apex(edge.first.quad, edge.first.side)?;
    let right = apex(second.quad, second.side)?;
    let [p, q] = edge.vertices.map(|vertex| mesh.vertices[vertex as usize]);
    Dihedral::between(p, q, left, right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    fn roof(height: f64) -> QuadMesh {
        samples::mesh(3, 2, |i, j| DVec3::new(i * 100.0, j * 100.0, if i == 1.0 { height } else { 0.0 }))
    }

    fn ridge_of(mesh: &QuadMesh, split: Diagonal) -> Dihedral {
        let topology = mesh.topology().unwrap();
        let edge = topology.edges.iter().find(|edge| edge.second.is_some()).unwrap();
        edge_dihedral(mesh, edge, &[split; 2]).unwrap()
    }

    #[test]
    fn ridges_bevel_up_and_valleys_down() {
        for split in [Diagonal::Ac, Diagonal::Bd] {
            let ridge = ridge_of(&roof(100.0), split);
            assert!((ridge.interior - FRAC_PI_2).abs() < 1e-12);
            assert!((ridge.bevel() - FRAC_PI_4).abs() < 1e-12);
            let valley = ridge_of(&roof(-100.0), split);
            assert!((valley.interior - 3.0 * FRAC_PI_2).abs() < 1e-12);
            assert!((valley.bevel() + FRAC_PI_4).abs() < 1e-12);
            assert_eq!(ridge_of(&roof(0.0), split), Dihedral { interior: PI });
        }
    }

    #[test]
    fn measured_to_the_triangle_at_the_edge() {
        let mut mesh = roof(100.0);
        mesh.vertices[5].z = 40.0;
        let ac = ridge_of(&mesh, Diagonal::Ac);
        let bd = ridge_of(&mesh, Diagonal::Bd);
        assert!((ac.interior - bd.interior).abs() > 1e-3);
    }

    #[test]
    fn none_at_the_boundary() {
        let mesh = roof(50.0);
        let topology = mesh.topology().unwrap();
        let none =
            topology.edges.iter().filter(|edge| edge_dihedral(&mesh, edge, &[Diagonal::Ac; 2]).is_none());
        assert_eq!(none.count(), 6);
        assert_eq!(Dihedral::between(DVec3::ZERO, DVec3::X, DVec3::X * 2.0, DVec3::Y), None);
    }

    proptest! {
        #[test]
        fn the_same_from_either_side(tilt in -1.5f64..1.5, other in -1.5f64..1.5) {
            let point = |angle: f64, side: f64| DVec3::new(0.0, side * libm::cos(angle), libm::sin(angle));
            let (left, right) = (point(tilt, 1.0), point(other, -1.0));
            let one = Dihedral::between(DVec3::ZERO, DVec3::X, left, right).unwrap();
            let two = Dihedral::between(DVec3::X, DVec3::ZERO, right, left).unwrap();
            prop_assert!((one.interior - two.interior).abs() < 1e-12);
            prop_assert!((one.interior - (PI + tilt + other)).abs() < 1e-12);
        }
    }
}
