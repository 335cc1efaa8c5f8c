//! Edges of a quad mesh, the one or two quads at each, and the neighbour across each side of a quad.
//! Indices only: no position is looked at.

use super::error::MeshError;

/// A side of a quad: side `k` runs from its corner `k` to its corner `k + 1` (side 3 from D to A).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct EdgeUse {
    /// The quad.
    pub quad: u32,
    /// 0 for AB, 1 for BC, 2 for CD, 3 for DA.
    pub side: u8,
}

/// An edge of the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MeshEdge {
    /// Its ends, in the order in which `first` runs along it.
    pub vertices: [u32; 2],
    /// The quad with the lower index.
    pub first: EdgeUse,
    /// The quad on the other side; none on the boundary.
    pub second: Option<EdgeUse>,
    /// Whether `second` runs along it the other way round, as it does where both quads face the same side.
    pub consistent: bool,
}

/// The edges of a mesh and where each quad has them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topology {
    /// Every edge once, sorted by its ends (the lower index first). A side of a quad that starts and ends in the
    /// same vertex is no edge.
    pub edges: Vec<MeshEdge>,
    /// For each quad the indices into `edges` of its sides AB, BC, CD, DA.
    pub quad_edges: Vec<[Option<u32>; 4]>,
}

impl Topology {
    /// Finds edges and neighbours of `quads`.
    ///
    /// # Errors
    /// An edge which more than two sides of quads use.
    pub fn try_new(quads: &[[u32; 4]]) -> Result<Self, MeshError> {
        let mut sides = sides_by_ends(quads);
        sides.sort_unstable();
        let mut edges = Vec::with_capacity(sides.len() / 2 + 1);
        let mut quad_edges = vec![[None; 4]; quads.len()];
        for shared in sides.chunk_by(|left, right| left.0 == right.0) {
            let (ends, first, second) = match *shared {
                [(ends, first)] => (ends, first, None),
                [(ends, first), (_, second)] => (ends, first, Some(second)),
                [(ends, _), ..] => return Err(MeshError::TooManyQuadsAtEdge { vertices: ends }),
                [] => continue,
            };
            let index = u32::try_from(edges.len()).map_err(|_| MeshError::TooLarge { count: edges.len() })?;
            for &(_, side) in shared {
                quad_edges[side.quad as usize][usize::from(side.side)] = Some(index);
            }
            let start = start_of(quads, first);
            let vertices = if start == ends[0] { ends } else { [ends[1], ends[0]] };
            let consistent = second.is_none_or(|side| start_of(quads, side) != start);
            edges.push(MeshEdge { vertices, first, second, consistent });
        }
        Ok(Self { edges, quad_edges })
    }

    /// The side of the quad that lies across `side` (0..4) of `quad`; none on the boundary.
    #[must_use]
    pub fn neighbour(&self, quad: usize, side: usize) -> Option<EdgeUse> {
        let edge = self.edges[self.quad_edges[quad][side]? as usize];
        let own = edge.first.quad as usize == quad && usize::from(edge.first.side) == side;
        if own { edge.second } else { Some(edge.first) }
    }

    /// The neighbours across AB, BC, CD and DA.
    #[must_use]
    pub fn neighbours(&self, quad: usize) -> [Option<EdgeUse>; 4] {
        [0, 1, 2, 3].map(|side| self.neighbour(quad, side))
    }
}

/// Every side with two different ends, keyed by them, the lower first.
fn sides_by_ends(quads: &[[u32; 4]]) -> Vec<([u32; 2], EdgeUse)> {
    let mut sides = Vec::with_capacity(quads.len() * 4);
    for (quad, corners) in (0u32..).zip(quads) {
        for (side, &start) in (0u8..).zip(corners) {
            let end = corners[(usize::from(side) + 1) % 4];
            if start != end {
                sides.push(([start.min(end), start.max(end)], EdgeUse { quad, side }));
            }
        }
    }
    sides
}

fn start_of(quads: &[[u32; 4]], side: EdgeUse) -> u32 {
    quads[side.quad as usize][usize::from(side.side)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Closed, samples};
    use proptest::prelude::*;

    #[test]
    fn neighbours_in_a_grid() {
        let topology = samples::flat_grid(4, 4, 100.0).topology().unwrap();
        // Quads are numbered row by row, three to a row; A→B goes to the next row.
        let centre = topology.neighbours(4).map(|side| side.map(|side| (side.quad, side.side)));
        assert_eq!(centre, [Some((3, 2)), Some((7, 3)), Some((5, 0)), Some((1, 1))]);
        let corner = topology.neighbours(0).map(|side| side.map(|side| side.quad));
        assert_eq!(corner, [None, Some(3), Some(1), None]);
        assert!(topology.edges.iter().all(|edge| edge.consistent));
    }

    #[test]
    fn a_quad_turned_over_is_seen() {
        let topology = Topology::try_new(&[[0, 1, 2, 3], [1, 2, 5, 4]]).unwrap();
        let shared = topology.edges.iter().find(|edge| edge.second.is_some()).unwrap();
        assert_eq!(shared.vertices, [1, 2]);
        assert!(!shared.consistent);
    }

    #[test]
    fn a_torus_has_no_boundary() {
        let grid = samples::grid(5, 4, |i, j| glam::DVec3::new(i, j, 0.0));
        let mesh = grid.to_mesh(Closed { rows: true, columns: true }).unwrap();
        let topology = mesh.topology().unwrap();
        assert_eq!((mesh.quads.len(), topology.edges.len()), (20, 40));
        assert!(topology.edges.iter().all(|edge| edge.second.is_some() && edge.consistent));
        assert!(mesh.boundary_vertices().unwrap().is_empty() && mesh.corners().is_empty());
    }

    proptest! {
        #[test]
        fn edges_of_a_grid_are_counted_and_mutual(rows in 2usize..9, columns in 2usize..9) {
            let mesh = samples::flat_grid(rows, columns, 10.0);
            let topology = mesh.topology().unwrap();
            prop_assert_eq!(topology.edges.len(), rows * (columns - 1) + columns * (rows - 1));
            for quad in 0..mesh.quads.len() {
                for side in 0..4 {
                    if let Some(other) = topology.neighbour(quad, side) {
                        let back = topology.neighbour(other.quad as usize, usize::from(other.side)).unwrap();
                        prop_assert_eq!((back.quad as usize, usize::from(back.side)), (quad, side));
                    }
                }
            }
        }
    }
}
