//! The manners of packing that are tried, which of them is taken, and what is done to save a sheet afterwards.

use glam::DVec2;

use super::convex::Shape;
use super::layout::{EXACT, Layout, Shapes};
use super::stack::stack;
use super::strips::{Manner, strips};
use super::{Nested, Part, Placement, Reason, Sheet, Unplaced, area};

/// How often all parts of a sheet are pushed together.
const ROUNDS: usize = 3;

/// On how many of the emptiest other sheets room is looked for.
const EMPTIEST: usize = 48;

/// What is tried.
const MANNERS: [Manner; 4] = [
    Manner { axis: 0, standing: false },
    Manner { axis: 1, standing: true },
    Manner { axis: 1, standing: false },
    Manner { axis: 0, standing: true },
];

pub(super) fn nest(parts: &[Part], sheet: &Sheet) -> Nested {
    let half_gap = sheet.gap / 2.0;
    let room = grown_room(sheet);
    let mut nested = Nested::default();
    let mut shapes = Shapes { all: Vec::with_capacity(parts.len()) };
    let mut placeable = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        match orientations(part, sheet) {
            Ok(found) => {
                shapes.all.push(found);
                placeable.push(index);
            }
            Err(reason) => {
                shapes.all.push(Vec::new());
                nested.unplaced.push(Unplaced { part: index, reason });
            }
        }
    }
    let sheets = best(&shapes, &placeable, room);
    nested.sheets = sheets.len();
    for (number, layout) in sheets.iter().enumerate() {
        let mut items = layout.items.clone();
        items.sort_by_key(|item| item.part);
        nested.placements.extend(items.iter().map(|item| Placement {
            part: item.part,
            sheet: number,
            quarter_turns: quarters(shapes.all[item.part].len(), item.turn),
            at: item.at + sheet.margin - half_gap,
        }));
    }
    nested
}

fn quarters(orientations: usize, turn: usize) -> u8 {
    (if orientations == 4 { turn } else { 2 * turn }) as u8
}

/// The room on a sheet for parts that are grown by half the gap.
fn grown_room(sheet: &Sheet) -> DVec2 {
    sheet.room() + sheet.gap + EXACT
}

/// A part as it may be turned; the reason where it fits in no way.
pub(super) fn orientations(part: &Part, sheet: &Sheet) -> Result<Vec<Shape>, Reason> {
    let (half_gap, room) = (sheet.gap / 2.0, grown_room(sheet));
    let area = area(&part.outline);
    let finite = part.outline.iter().all(|corner| corner.is_finite());
    if part.outline.len() < 3 || !finite || area <= 0.0 || !area.is_finite() {
        return Err(Reason::NoArea);
    }
    let count = if part.any_quarter { 4 } else { 2 };
    let shape = |turn| Shape::of(&part.outline, quarters(count, turn), half_gap, area);
    let shapes: Vec<Shape> = (0..count).map(shape).collect();
    if shapes.iter().any(|shape| shape.size().cmple(room).all()) {
        return Ok(shapes);
    }
    let size = shapes.first().map_or(DVec2::ZERO, |shape| shape.size() - sheet.gap);
    Err(Reason::TooLarge { size, room: sheet.room() })
}

/// The manner that takes the fewest sheets; of equals the one whose emptiest sheet is emptiest, then the first.
fn best(shapes: &Shapes, parts: &[usize], room: DVec2) -> Vec<Layout> {
    let free = parts.iter().any(|&part| shapes.all[part].len() == 4);
    let mut best: Option<(usize, f64, Vec<Layout>)> = None;
    for manner in MANNERS.into_iter().filter(|manner| free || !manner.standing) {
        let sheets = stack(strips(shapes, parts, manner, room), manner, room);
        let least = sheets.iter().map(|sheet| sheet.area(shapes)).fold(f64::INFINITY, f64::min);
        let better = best.as_ref().is_none_or(|(count, area, _)| (sheets.len(), least) < (*count, *area));
        if better {
            best = Some((sheets.len(), least, sheets));
        }
    }
    let mut sheets = best.map_or_else(Vec::new, |(_, _, sheets)| sheets);
    for sheet in &mut sheets {
        sheet.compact(shapes, ROUNDS);
    }
    save(shapes, &mut sheets);
    sheets
}

/// Moves the parts of the emptiest sheet, the largest first, to where there is room on fuller ones, again while that
/// empties a sheet. It ends with the first part that finds no room.
fn save(shapes: &Shapes, sheets: &mut Vec<Layout>) {
    loop {
        sheets.sort_by(|a, b| b.area(shapes).total_cmp(&a.area(shapes)));
        let Some(mut last) = sheets.pop() else { return };
        let area = |item: &super::layout::Item| shapes.of(item).area;
        last.items.sort_by(|a, b| area(b).total_cmp(&area(a)).then(a.part.cmp(&b.part)));
        let stuck = last.items.iter().position(|item| !moved(shapes, sheets, item.part));
        last.items.drain(..stuck.unwrap_or(last.items.len()));
        if !last.items.is_empty() {
            last.compact(shapes, ROUNDS);
            sheets.push(last);
            return;
        }
    }
}

/// Whether one of the emptiest sheets, which are the last, has room for a part; it lies there then.
fn moved(shapes: &Shapes, sheets: &mut [Layout], part: usize) -> bool {
    sheets.iter_mut().rev().take(EMPTIEST).any(|sheet| {
        let placed = sheet.place(shapes, part);
        sheet.items.extend(placed);
        placed.is_some()
    })
}
