//! The parts on one sheet while it is being packed: where another one fits, and pushing all together.

use glam::DVec2;

use super::convex::Shape;
use super::rows::{Rows, reach};

/// Room given up so that rounding makes nothing overlap, mm.
pub(super) const SLACK: f64 = 1e-8;

/// Room taken so that what fits exactly still does, mm. Less than what the check leaves to rounding.
pub(super) const EXACT: f64 = 5e-7;

/// All parts in all their orientations.
pub(super) struct Shapes {
    /// For each part, its orientations: by half turns or by quarter turns; none where it cannot be placed.
    pub(super) all: Vec<Vec<Shape>>,
}

impl Shapes {
    /// The shape of an item.
    pub(super) fn of(&self, item: &Item) -> &Shape {
        &self.all[item.part][item.turn]
    }
}

/// A part in one of its orientations, shifted by `at`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Item {
    pub(super) part: usize,
    pub(super) turn: usize,
    pub(super) at: DVec2,
}

/// A sheet of `size`, which is that of the raw sheet less its margins, grown by the gap. Its lower left is the origin.
#[derive(Debug, Clone)]
pub(super) struct Layout {
    pub(super) size: DVec2,
    pub(super) items: Vec<Item>,
}

impl Layout {
    pub(super) fn area(&self, shapes: &Shapes) -> f64 {
        self.items.iter().map(|item| shapes.of(item).area).sum()
    }

    /// Pushes every part down and to the left as far as it goes, again and again.
    pub(super) fn compact(&mut self, shapes: &Shapes, rounds: usize) {
        for _ in 0..rounds {
            for axis in [1, 0] {
                let start = |item: &Item| item.at[axis] + shapes.of(item).low[axis];
                self.items.sort_by(|a, b| start(a).total_cmp(&start(b)).then(a.part.cmp(&b.part)));
                let rows = Rows::of(shapes, &self.items, axis, self.size[1 - axis]);
                for index in 0..self.items.len() {
                    self.items[index].at[axis] = self.pushed(shapes, &rows, axis, index);
                }
            }
        }
    }

    /// How far an item goes back along an axis, past nothing. Only the items before it in order can be in its way
    /// at its start; those after it may reach beside it.
    fn pushed(&self, shapes: &Shapes, rows: &Rows, axis: usize, index: usize) -> f64 {
        let item = &self.items[index];
        let shape = shapes.of(item);
        let moving = shape.along(axis);
        let now = item.at[axis];
        let mut least = -shape.low[axis];
        let (from, to) = reach(shapes, item, axis);
        for other in rows.near(from, to).filter(|&other| other != index) {
            let other = &self.items[other];
            let fixed = shapes.of(other).along(axis);
            if other.at[axis] + fixed.farthest_right() - moving.farthest_left() <= least {
                continue;
            }
            let raised = item.at[1 - axis] - other.at[1 - axis];
            let Some((before, past)) = fixed.forbidden(moving, raised) else { continue };
            if before + other.at[axis] < now {
                least = least.max(past + other.at[axis] + SLACK);
            }
        }
        least.min(now)
    }

    /// The least x at which a shape fits at the height `y`; none beyond `most`.
    fn leftmost(
        &self,
        shapes: &Shapes,
        rows: &Rows,
        shape: &Shape,
        y: f64,
        most: f64,
        taken: &mut Vec<(f64, f64)>,
    ) -> Option<f64> {
        let mut x = -shape.low.x;
        let end = (self.size.x - shape.high.x).min(most);
        if x > end {
            return None;
        }
        taken.clear();
        let moving = shape.along(0);
        for item in rows.near(y + moving.low(), y + moving.high()).map(|index| &self.items[index]) {
            let fixed = shapes.of(item).along(0);
            if item.at.x + fixed.farthest_left() - moving.farthest_right() > end {
                continue;
            }
            if let Some((before, past)) = fixed.forbidden(moving, y - item.at.y) {
                taken.push((before + item.at.x, past + item.at.x));
            }
        }
        taken.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        for &(before, past) in taken.iter() {
            if before >= x + SLACK {
                break;
            }
            if past > x {
                x = past + SLACK;
            }
        }
        (x <= end).then_some(x)
    }

    /// Where a part fits so that it reaches least far along x, then y; none where it does not fit.
    pub(super) fn place(&self, shapes: &Shapes, part: usize) -> Option<Item> {
        let rows = Rows::of(shapes, &self.items, 0, self.size.y);
        let mut best: Option<(f64, Item)> = None;
        let mut heights = Vec::new();
        let mut taken = Vec::new();
        for (turn, shape) in shapes.all[part].iter().enumerate() {
            let (low, high) = (-shape.low.y, self.size.y - shape.high.y);
            if low > high {
                continue;
            }
            heights.clear();
            heights.extend([low, high]);
            for item in &self.items {
                let fixed = shapes.of(item);
                let (bottom, top) = (fixed.along(0).low(), fixed.along(0).high());
                heights.extend([
                    item.at.y + top - shape.along(0).low() + SLACK,
                    item.at.y + bottom - shape.along(0).high() - SLACK,
                    item.at.y + fixed.low.y - shape.low.y,
                    item.at.y + fixed.high.y - shape.high.y,
                ]);
            }
            heights.retain(|&y| y >= low && y <= high);
            heights.sort_unstable_by(f64::total_cmp);
            heights.dedup();
            for &y in &heights {
                let most = best.as_ref().map_or(f64::INFINITY, |(reach, _)| reach - shape.high.x - SLACK);
                if let Some(x) = self.leftmost(shapes, &rows, shape, y, most, &mut taken) {
                    best = Some((x + shape.high.x, Item { part, turn, at: DVec2::new(x, y) }));
                }
            }
        }
        best.map(|(_, item)| item)
    }
}
