//! Meshes that tests of this room and of the rooms above it use.

use glam::DVec3;

use super::grid::{Closed, Grid};
use super::mesh::QuadMesh;

/// A grid whose point (i, j) is `point(i, j)`.
pub(crate) fn grid(rows: usize, columns: usize, point: impl Fn(f64, f64) -> DVec3) -> Grid {
    let points = (0..rows * columns).map(|k| point((k / columns) as f64, (k % columns) as f64)).collect();
    Grid::try_new(rows, columns, points).unwrap()
}

/// An open mesh whose point (i, j) is `point(i, j)`.
pub(crate) fn mesh(rows: usize, columns: usize, point: impl Fn(f64, f64) -> DVec3) -> QuadMesh {
    grid(rows, columns, point).to_mesh(Closed::NONE).unwrap()
}

/// A flat square grid in the xy plane.
pub(crate) fn flat_grid(rows: usize, columns: usize, edge: f64) -> QuadMesh {
    mesh(rows, columns, |i, j| DVec3::new(i * edge, j * edge, 0.0))
}

/// The corners of a flat square, counter-clockwise from above.
pub(crate) fn square(edge: f64) -> [DVec3; 4] {
    [(0.0, 0.0), (edge, 0.0), (edge, edge), (0.0, edge)].map(|(x, y)| DVec3::new(x, y, 0.0))
}
