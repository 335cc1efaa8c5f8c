//! The quad mesh: vertices and the four corners of each quad. Who neighbours whom is in `topology`.

use glam::DVec3;

use super::error::MeshError;
use super::topology::Topology;

/// A mesh of quads with shared vertices, in millimetres.
///
/// The corners of a quad are A, B, C, D in order around it, counter-clockwise seen from outside. Side `k` of a
/// quad runs from corner `k` to corner `k + 1` (side 3 from D to A). Build it with [`QuadMesh::try_new`]; code
/// that changes the fields afterwards keeps what `try_new` checks.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadMesh {
    /// Positions, mm.
    pub vertices: Vec<DVec3>,
    /// Indices into `vertices`.
    pub quads: Vec<[u32; 4]>,
}

impl QuadMesh {
    /// A mesh after its checks. Quads of no area, and vertices no quad uses, are allowed.
    ///
    /// # Errors
    /// Indices out of range, coordinates that are not finite or beyond 1000 km, edges of more than two quads, more than `u32::MAX`
    /// vertices or quads.
    pub fn try_new(vertices: Vec<DVec3>, quads: Vec<[u32; 4]>) -> Result<Self, MeshError> {
        let limit = u32::MAX as usize;
        if let Some(&count) = [vertices.len(), quads.len()].iter().find(|&&count| count > limit) {
            return Err(MeshError::TooLarge { count });
        }
        MeshError::check_points(&vertices)?;
        for (quad, corners) in quads.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&corner| corner as usize >= vertices.len()) {
                return Err(MeshError::VertexOutOfRange { quad, vertex, vertices: vertices.len() });
            }
        }
        Topology::try_new(&quads)?;
        Ok(Self { vertices, quads })
    }

    /// The positions of a quad's corners A, B, C, D. `quad` is below `quads.len()`.
    #[must_use]
    pub fn corners_of(&self, quad: usize) -> [DVec3; 4] {
        self.quads[quad].map(|corner| self.vertices[corner as usize])
    }

    /// Edges and neighbours. Takes O(n log n): keep the result where it is used more than once.
    ///
    /// # Errors
    /// An edge of more than two quads; never for a mesh that came from [`QuadMesh::try_new`].
    pub fn topology(&self) -> Result<Topology, MeshError> {
        Topology::try_new(&self.quads)
    }

    /// The vertices at an end of an edge which only one quad has, ascending.
    ///
    /// # Errors
    /// As [`QuadMesh::topology`].
    pub fn boundary_vertices(&self) -> Result<Vec<u32>, MeshError> {
        let mut found: Vec<u32> = self
            .topology()?
            .edges
            .iter()
            .filter(|edge| edge.second.is_none())
            .flat_map(|edge| edge.vertices)
            .collect();
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }

    /// The vertices used by exactly one quad, ascending: the four corners of an open grid.
    #[must_use]
    pub fn corners(&self) -> Vec<u32> {
        let mut uses = vec![0u32; self.vertices.len()];
        for corners in &self.quads {
            for (position, corner) in corners.iter().enumerate() {
                if !corners[..position].contains(corner) {
                    uses[*corner as usize] += 1;
                }
            }
        }
        (0u32..).zip(uses).filter(|&(_, count)| count == 1).map(|(vertex, _)| vertex).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    #[test]
    fn refuses_what_is_not_a_mesh() {
        let square = samples::square(100.0).to_vec();
        assert_eq!(
            QuadMesh::try_new(square.clone(), vec![[0, 1, 2, 4]]),
            Err(MeshError::VertexOutOfRange { quad: 0, vertex: 4, vertices: 4 })
        );
        for (bad, error) in [
            (f64::NAN, MeshError::NotFinite { vertex: 2 }),
            (f64::INFINITY, MeshError::NotFinite { vertex: 2 }),
            (-1e10, MeshError::TooFar { vertex: 2 }),
        ] {
            let mut vertices = square.clone();
            vertices[2].y = bad;
            assert_eq!(QuadMesh::try_new(vertices, vec![[0, 1, 2, 3]]), Err(error));
        }
        assert_eq!(
            QuadMesh::try_new(square, vec![[0, 1, 2, 3]; 3]),
            Err(MeshError::TooManyQuadsAtEdge { vertices: [0, 1] })
        );
    }

    #[test]
    fn open_grid_has_a_rim_and_four_corners() {
        let mesh = samples::flat_grid(4, 3, 100.0);
        assert_eq!(mesh.boundary_vertices().unwrap(), vec![0, 1, 2, 3, 5, 6, 8, 9, 10, 11]);
        assert_eq!(mesh.corners(), vec![0, 2, 9, 11]);
    }

    #[test]
    fn unused_vertices_are_neither_rim_nor_corner() {
        let mut vertices = samples::square(100.0).to_vec();
        vertices.push(DVec3::ZERO);
        let mesh = QuadMesh::try_new(vertices, vec![[0, 1, 2, 3]]).unwrap();
        assert_eq!(mesh.boundary_vertices().unwrap(), vec![0, 1, 2, 3]);
        assert_eq!(mesh.corners(), vec![0, 1, 2, 3]);
    }
}
