//! Rectangular grids of points and the quad meshes they make.

use glam::DVec3;

use super::error::MeshError;
use super::mesh::QuadMesh;

/// A grid of points, row after row: the point of row `i` and column `j` is `points[i * columns + j]`. mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// How many rows (index `i`, parameter u).
    pub rows: usize,
    /// How many columns (index `j`, parameter v).
    pub columns: usize,
    /// `rows * columns` points.
    pub points: Vec<DVec3>,
}

/// In which directions a grid closes on itself, its last points being neighbours of its first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Closed {
    /// The last row joins the first.
    pub rows: bool,
    /// The last column joins the first.
    pub columns: bool,
}

impl Closed {
    /// Open in both directions.
    pub const NONE: Self = Self { rows: false, columns: false };
}

impl Grid {
    /// A grid after its checks.
    ///
    /// # Errors
    /// Another number of points than `rows * columns`, coordinates that are not finite or beyond 1000 km.
    pub fn try_new(rows: usize, columns: usize, points: Vec<DVec3>) -> Result<Self, MeshError> {
        let wanted = rows.saturating_mul(columns);
        if points.len() != wanted {
            return Err(MeshError::WrongPointCount { wanted, given: points.len() });
        }
        MeshError::check_points(&points)?;
        Ok(Self { rows, columns, points })
    }

    /// The point of row `i` and column `j`, both within the grid.
    #[must_use]
    pub fn at(&self, i: usize, j: usize) -> DVec3 {
        self.points[i * self.columns + j]
    }

    /// How many quads the grid has in each direction.
    #[must_use]
    pub fn quad_counts(&self, closed: Closed) -> (usize, usize) {
        let count = |points: usize, closed: bool| if closed { points } else { points.saturating_sub(1) };
        (count(self.rows, closed.rows), count(self.columns, closed.columns))
    }

    /// The mesh of the grid, points and vertices numbered alike. Quad (i, j) has the corners (i, j), (i+1, j),
    /// (i+1, j+1), (i, j+1); quads run row after row. Neighbours share vertices by index; no distance is looked at.
    ///
    /// # Errors
    /// Fewer than two points in an open direction or three in a closed one, more points than a mesh can number.
    pub fn to_mesh(&self, closed: Closed) -> Result<QuadMesh, MeshError> {
        self.clone().into_mesh(closed)
    }

    /// As [`Grid::to_mesh`], with the grid's own points as the vertices: nothing is copied.
    ///
    /// # Errors
    /// As [`Grid::to_mesh`].
    pub fn into_mesh(self, closed: Closed) -> Result<QuadMesh, MeshError> {
        for (given, closed) in [(self.rows, closed.rows), (self.columns, closed.columns)] {
            let needed = if closed { 3 } else { 2 };
            if given < needed {
                return Err(MeshError::TooFewPoints { given, needed });
            }
        }
        if u32::try_from(self.points.len()).is_err() {
            return Err(MeshError::TooLarge { count: self.points.len() });
        }
        let (down, across) = self.quad_counts(closed);
        let index = |i: usize, j: usize| ((i % self.rows) * self.columns + j % self.columns) as u32;
        let mut quads = Vec::with_capacity(down * across);
        for i in 0..down {
            for j in 0..across {
                quads.push([index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)]);
            }
        }
        MeshError::check_points(&self.points)?;
        // Every edge of a grid lies between at most two of its quads, so the sorting check of edges is not needed.
        Ok(QuadMesh { vertices: self.points, quads })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    #[test]
    fn quads_in_row_major_order() {
        let mesh = samples::flat_grid(3, 4, 1.0);
        assert_eq!(mesh.quads.len(), 6);
        assert_eq!(mesh.quads[0], [0, 4, 5, 1]);
        assert_eq!(mesh.quads[5], [6, 10, 11, 7]);
    }

    #[test]
    fn closed_grids_wrap_by_index() {
        let grid = samples::grid(4, 3, |i, j| DVec3::new(i, j, 0.0));
        let around = grid.to_mesh(Closed { rows: true, columns: false }).unwrap();
        assert_eq!(around.quads.len(), 8);
        assert_eq!(around.quads[7], [10, 1, 2, 11]);
        assert_eq!(around.vertices.len(), 12);
        let across = grid.to_mesh(Closed { rows: false, columns: true }).unwrap();
        assert_eq!(across.quads[2], [2, 5, 3, 0]);
    }

    #[test]
    fn refuses_what_is_not_a_grid() {
        let points = vec![DVec3::ZERO; 5];
        assert_eq!(
            Grid::try_new(2, 3, points.clone()),
            Err(MeshError::WrongPointCount { wanted: 6, given: 5 })
        );
        let line = Grid::try_new(1, 5, points).unwrap();
        assert_eq!(line.to_mesh(Closed::NONE), Err(MeshError::TooFewPoints { given: 1, needed: 2 }));
        let pair = samples::grid(2, 5, |i, j| DVec3::new(i, j, 0.0));
        assert_eq!(
            pair.to_mesh(Closed { rows: true, columns: false }),
            Err(MeshError::TooFewPoints { given: 2, needed: 3 })
        );
        assert!(Grid::try_new(usize::MAX, 3, Vec::new()).is_err());
    }
}
