//! The quads of a surface as they are drawn: each by itself, or blocks of rows and columns where there are too many.

use glam::DVec3;

use crate::fabricate::label::Label;
use crate::geometry::QuadMesh;

/// The quads of a surface in blocks of `block` rows by `block` columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cells {
    /// Quads in a block's row; 1 where each is drawn by itself.
    pub(super) block: usize,
    /// Rows and columns of quads, where the surface has them.
    pub(super) grid: Option<(usize, usize)>,
    quads: usize,
}

/// A block: its first row and column, and those after its last. Without a grid all quads are one row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cell {
    rows: (usize, usize),
    columns: (usize, usize),
}

impl Cells {
    /// The quads with these labels, in at most about `most` blocks where they form a grid.
    pub(super) fn of(labels: &[Label], most: usize) -> Self {
        let grid = grid(labels);
        let block = grid.map_or(1, |(rows, columns)| {
            (1..).find(|&block| rows.div_ceil(block) * columns.div_ceil(block) <= most.max(1)).unwrap_or(1)
        });
        Self { block, grid, quads: labels.len() }
    }

    /// The blocks, row by row.
    pub(super) fn blocks(self) -> impl Iterator<Item = Cell> {
        let (rows, columns) = self.grid.unwrap_or((1, self.quads));
        let block = self.block;
        let cell = move |row: usize, column: usize| Cell {
            rows: (row, (row + block).min(rows)),
            columns: (column, (column + block).min(columns)),
        };
        let row_of = move |row: usize| (0..columns).step_by(block).map(move |column| cell(row, column));
        (0..rows).step_by(block).flat_map(row_of)
    }

    /// The quads of a block.
    pub(super) fn members(self, cell: Cell) -> impl Iterator<Item = usize> {
        let width = self.grid.map_or(self.quads, |(_, columns)| columns);
        (cell.rows.0..cell.rows.1)
            .flat_map(move |row| (cell.columns.0..cell.columns.1).map(move |column| row * width + column))
    }

    /// The outer corners of a block on a mesh of these quads.
    pub(super) fn corners(self, cell: Cell, mesh: &QuadMesh) -> [DVec3; 4] {
        let width = self.grid.map_or(self.quads, |(_, columns)| columns);
        let corner = |row: usize, column: usize, corner: usize| mesh.corners_of(row * width + column)[corner];
        let (top, bottom) = (cell.rows.0, cell.rows.1 - 1);
        let (left, right) = (cell.columns.0, cell.columns.1 - 1);
        [corner(top, left, 0), corner(bottom, left, 1), corner(bottom, right, 2), corner(top, right, 3)]
    }
}

/// Rows and columns, where the labels run through all of them row by row.
pub(super) fn grid(labels: &[Label]) -> Option<(usize, usize)> {
    let columns = labels.iter().take_while(|label| label.row == Some(0)).count();
    let rows = labels.len().checked_div(columns)?;
    let in_place = |(place, label): (usize, &Label)| {
        label.row == u32::try_from(place / columns).ok()
            && label.column == u32::try_from(place % columns).ok()
    };
    (rows * columns == labels.len() && labels.iter().enumerate().all(in_place)).then_some((rows, columns))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    fn labels(rows: u32, columns: u32) -> Vec<Label> {
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        places
            .map(|(row, column)| Label { row: Some(row), column: Some(column), ..Label::default() })
            .collect()
    }

    #[test]
    fn blocks_hold_every_quad_once() {
        let labels = labels(7, 5);
        let mesh = samples::flat_grid(8, 6, 10.0);
        assert_eq!(mesh.quads.len(), labels.len());
        for most in [100, 35, 12, 4, 1, 0] {
            let cells = Cells::of(&labels, most);
            let mut members: Vec<usize> = cells.blocks().flat_map(|cell| cells.members(cell)).collect();
            members.sort_unstable();
            assert_eq!(members, (0..35).collect::<Vec<_>>(), "{cells:?}");
            assert!(cells.blocks().count() <= most.max(1));
            let area: f64 = cells
                .blocks()
                .map(|cell| crate::geometry::QuadMeasure::of(cells.corners(cell, &mesh)).area)
                .sum();
            assert!((area - 3500.0).abs() < 1e-9);
        }
    }

    #[test]
    fn without_rows_every_quad_is_its_own() {
        let labels = vec![Label::default(); 3];
        let cells = Cells::of(&labels, 1);
        assert_eq!((cells.grid, cells.blocks().count()), (None, 3));
        assert_eq!(Cells::of(&[], 5).blocks().count(), 0);
        let mut wrong = super::tests::labels(2, 2);
        wrong.swap(0, 1);
        assert_eq!(grid(&wrong), None);
    }
}
