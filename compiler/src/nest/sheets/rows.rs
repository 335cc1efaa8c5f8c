//! Which parts of a sheet may meet one that moves along an axis: those in the rows it runs through. The positions
//! themselves are the sheet's.

use super::layout::{Item, Shapes};

/// Items by the rows that they reach into. Rows run along an axis and are equally wide.
pub(super) struct Rows {
    width: f64,
    rows: Vec<Vec<usize>>,
}

impl Rows {
    /// Of items on a sheet of `size` across the axis.
    pub(super) fn of(shapes: &Shapes, items: &[Item], axis: usize, size: f64) -> Self {
        let count = (items.len() as f64).sqrt().ceil().max(1.0);
        let mut rows =
            Self { width: (size / count).max(f64::MIN_POSITIVE), rows: vec![Vec::new(); count as usize] };
        for (index, item) in items.iter().enumerate() {
            let (from, to) = reach(shapes, item, axis);
            for row in rows.between(from, to) {
                rows.rows[row].push(index);
            }
        }
        rows
    }

    /// The items in the rows from `from` to `to`, again and again where they reach into several.
    pub(super) fn near(&self, from: f64, to: f64) -> impl Iterator<Item = usize> {
        self.rows[self.between(from, to)].iter().flatten().copied()
    }

    fn between(&self, from: f64, to: f64) -> std::ops::RangeInclusive<usize> {
        let row = |at: f64| ((at / self.width).max(0.0) as usize).min(self.rows.len() - 1);
        row(from)..=row(to)
    }
}

/// From where to where an item reaches across an axis.
pub(super) fn reach(shapes: &Shapes, item: &Item, axis: usize) -> (f64, f64) {
    let chains = shapes.of(item).along(axis);
    (item.at[1 - axis] + chains.low(), item.at[1 - axis] + chains.high())
}
