//! [`SheetEvaluator`]: the grid of a product of two curves, A·C·Bᵀ window by window, on one grid of shared vertices.

use std::convert::Infallible;

use crate::ifs::Automaton;

use super::super::figure::SheetPlan;
use super::basis::{Basis, basis};
use super::combine::combine;

/// Rows of a tile that are worked on together, and a good size of tile for writers: a tile of 1025 columns stays in the
/// second cache.
pub const TILE_ROWS: usize = 16;

/// Doubles of a row that are worked on together, so that the source rows of very wide sheets stay in cache.
const TILE_WIDTH: usize = 4096;

/// One sheet or tensor product, ready to give its vertices: a grid of `rows()` × `columns()` points in millimetres, row
/// after row, u along the rows' index. Neighbouring windows share their vertices by index.
pub struct SheetEvaluator<'a> {
    plan: &'a SheetPlan,
    u: Basis,
    v: Basis,
    windows: (usize, usize),
    /// The vector instructions of this processor; results are the same bits with any.
    arch: pulp::Arch,
}

/// The rows Bᵀ·C of the window at hand, in a ring by net row.
struct Ring {
    rows: Vec<f64>,
    next_net_row: usize,
}

impl<'a> SheetEvaluator<'a> {
    /// Builds the two basis tables. The sheet must be one of a [`crate::plan::Plan`] on this automaton, which has
    /// proved its joins, and within a budget.
    ///
    /// # Panics
    /// When the states are not of this automaton or the net is smaller than a window.
    pub fn new(automaton: &Automaton, plan: &'a SheetPlan) -> SheetEvaluator<'a> {
        let u = basis(automaton, plan.u, plan.levels.0);
        let v = if (plan.u, plan.levels.0) == (plan.v, plan.levels.1) {
            u.clone()
        } else {
            basis(automaton, plan.v, plan.levels.1)
        };
        let windows = (plan.net_rows - u.columns + 1, plan.net_columns - v.columns + 1);
        SheetEvaluator { plan, u, v, windows, arch: pulp::Arch::new() }
    }

    /// Vertices along u.
    pub fn rows(&self) -> usize {
        self.windows.0 * (self.u.rows - 1) + 1
    }

    /// Vertices along v.
    pub fn columns(&self) -> usize {
        self.windows.1 * (self.v.rows - 1) + 1
    }

    /// Writes all vertices into `grid`, whose memory is used again where it suffices: fresh pages cost more than the
    /// evaluation. Tiles are made in cache and copied: faster than storing each row where it will lie, since a long
    /// copy need not read what it overwrites.
    pub fn fill(&self, grid: &mut Vec<[f64; 3]>) {
        grid.clear();
        grid.reserve_exact(self.rows() * self.columns());
        let Ok(()) = self.stream(TILE_ROWS, |_, tile| {
            grid.extend_from_slice(tile);
            Ok::<(), Infallible>(())
        });
    }

    /// Hands the vertices to `write` in tiles of `tile_rows` rows (the last one shorter), with the index of the tile's
    /// first row; one tile's memory is used throughout.
    ///
    /// # Errors
    /// The first error of `write`, which ends the evaluation.
    pub fn stream<E>(
        &self,
        tile_rows: usize,
        mut write: impl FnMut(usize, &[[f64; 3]]) -> Result<(), E>,
    ) -> Result<(), E> {
        let tile_rows = tile_rows.clamp(1, self.rows());
        let mut tile = vec![[0.0; 3]; tile_rows * self.columns()];
        let mut ring = self.ring();
        for first in (0..self.rows()).step_by(tile_rows) {
            let rows = tile_rows.min(self.rows() - first);
            let tile = &mut tile[..rows * self.columns()];
            self.fill_rows(&mut ring, first, tile.as_flattened_mut());
            write(first, tile)?;
        }
        Ok(())
    }

    fn ring(&self) -> Ring {
        Ring { rows: vec![0.0; self.u.columns * self.columns() * 3], next_net_row: 0 }
    }

    /// The window along u that row `row` of the grid belongs to, and the row's place in that window's basis.
    fn window_of_row(&self, row: usize) -> (usize, usize) {
        let window = (row / (self.u.rows - 1)).min(self.windows.0 - 1);
        (window, row - window * (self.u.rows - 1))
    }

    /// Fills whole rows from `first` on; calls must come with rising rows.
    fn fill_rows(&self, ring: &mut Ring, first: usize, out: &mut [f64]) {
        let width = self.columns() * 3;
        let rows = out.len() / width;
        let mut done = 0;
        while done < rows {
            let (window, local) = self.window_of_row(first + done);
            let last = self.u.rows - usize::from(window + 1 < self.windows.0);
            let block = (last - local).min(rows - done).min(TILE_ROWS);
            self.advance(ring, window);
            self.fill_block(ring, window, local, &mut out[done * width..(done + block) * width]);
            done += block;
        }
    }

    /// Rows of one window, column tile by column tile, so that the source rows stay in the first cache.
    fn fill_block(&self, ring: &Ring, window: usize, local: usize, out: &mut [f64]) {
        let (width, points) = (self.columns() * 3, self.u.columns);
        for left in (0..width).step_by(TILE_WIDTH) {
            let right = (left + TILE_WIDTH).min(width);
            for (row, out) in out.chunks_exact_mut(width).enumerate() {
                combine(self.arch, &mut out[left..right], self.u.row(local + row), |i| {
                    let place = (window + i) % points * width;
                    &ring.rows[place + left..place + right]
                });
            }
        }
    }

    /// Brings the ring to the net rows of a window.
    fn advance(&self, ring: &mut Ring, window: usize) {
        let (width, points) = (self.columns() * 3, self.u.columns);
        for net_row in ring.next_net_row.max(window)..window + points {
            let place = net_row % points * width;
            self.fill_net_row(net_row, &mut ring.rows[place..place + width]);
        }
        ring.next_net_row = ring.next_net_row.max(window + points);
    }

    /// One net row, refined along v: Σ_j B[c][j] · C[row][window + j] for every vertex c along v.
    fn fill_net_row(&self, net_row: usize, out: &mut [f64]) {
        let columns = self.plan.net_columns;
        let points = &self.plan.net[net_row * columns..(net_row + 1) * columns];
        for (column, vertex) in out.chunks_exact_mut(3).enumerate() {
            let window = (column / (self.v.rows - 1)).min(self.windows.1 - 1);
            let weights = self.v.row(column - window * (self.v.rows - 1));
            vertex.fill(0.0);
            for (weight, point) in weights.iter().zip(&points[window..]) {
                for (total, coordinate) in vertex.iter_mut().zip(point) {
                    *total += weight * coordinate;
                }
            }
        }
    }
}
