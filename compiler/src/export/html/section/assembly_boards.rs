//! The assembly map of boards: rows and columns unrolled, each field with its name; in tiles that can be read on paper.

use glam::DVec2;

use crate::export::html::cells::grid;
use crate::export::html::document::{PanelShapes, SurfaceShape};
use crate::export::html::draw::paper::{Anchor, letters, rectangle, svg, text_width};
use crate::export::html::markup::Markup;
use crate::export::html::number::{coordinate, count, counted};
use crate::export::html::table::{Cell, Column, table};
use crate::fabricate::label::Label;

/// Boards named one by one, at most.
const MOST_NAMED: usize = 2000;

/// Columns and rows of a tile, at most.
const TILE: (usize, usize) = (16, 20);

const WIDTH: f64 = 178.0;
const LEFT: f64 = 12.0;
const HEAD: f64 = 6.0;

/// Writes the maps of all surfaces.
pub(in crate::export::html) fn assembly(page: &mut Markup, panels: &PanelShapes<'_>) {
    let made: std::collections::BTreeSet<&str> =
        panels.panels.iter().map(|panel| panel.label.address.as_str()).collect();
    for surface in &panels.surfaces {
        if panels.surfaces.len() > 1 {
            page.texts("h3", &[], &surface.name);
        }
        match grid(surface.labels) {
            Some(size) if surface.labels.len() <= MOST_NAMED => {
                tiles(page, surface, size, &|label| made.contains(label.address.as_str()))
            }
            Some(size) => overview(page, surface, size),
            None => listed(page, surface.labels),
        }
    }
}

/// What all aliases of some labels start with, up to a hyphen.
pub(super) fn common_start(labels: &[Label]) -> &str {
    let mut labels = labels.iter().map(|label| label.alias.as_str());
    let Some(first) = labels.next() else { return "" };
    let shared = labels.fold(first.len(), |shared, alias| {
        first.bytes().zip(alias.bytes()).take(shared).take_while(|(a, b)| a == b).count()
    });
    let end = first.as_bytes()[..shared].iter().rposition(|byte| *byte == b'-').map_or(0, |place| place + 1);
    &first[..end]
}

fn tiles(
    page: &mut Markup,
    surface: &SurfaceShape<'_>,
    (rows, columns): (usize, usize),
    made: &dyn Fn(&Label) -> bool,
) {
    let start = common_start(surface.labels);
    let even = |count: usize, most: usize| count.div_ceil(count.div_ceil(most).max(1));
    let (wide, high) = (even(columns, TILE.0), even(rows, TILE.1));
    let text = format!(
        "{} in {} and {}, unrolled. {}The first number is the row, the second the column; edge 0 of a board is its left side here, and edges 1, 2 and 3 follow counter-clockwise seen from outside.",
        counted(surface.labels.len(), "board"),
        counted(rows, "row"),
        counted(columns, "column"),
        if start.is_empty() { String::new() } else { format!("Every alias starts with “{start}”. ") }
    );
    page.texts("p", &[], &text);
    for top in (0..rows).step_by(high) {
        for left in (0..columns).step_by(wide) {
            let (bottom, right) = ((top + high).min(rows), (left + wide).min(columns));
            page.element("figure", &[("class", "sheet")], |page| {
                tile(page, surface, start, ((top, bottom), (left, right)), (columns, wide), made);
                if rows > high || columns > wide {
                    let caption = format!("Rows {top} to {}, columns {left} to {}.", bottom - 1, right - 1);
                    page.texts("figcaption", &[], &caption);
                }
            });
        }
    }
}

fn tile(
    page: &mut Markup,
    surface: &SurfaceShape<'_>,
    start: &str,
    ((top, bottom), (left, right)): ((usize, usize), (usize, usize)),
    (columns, wide): (usize, usize),
    made: &dyn Fn(&Label) -> bool,
) {
    let width = ((WIDTH - LEFT) / wide as f64).min(24.0);
    let height = (width * 0.85).min(11.0);
    let longest = surface.labels.iter().map(|label| label.alias.len() - start.len()).max().unwrap_or(1);
    let size = ((width - 1.0) / text_width(&"0".repeat(longest), 1.0)).min(3.0);
    let paper = (LEFT + width * (right - left) as f64 + 1.0, HEAD + height * (bottom - top) as f64 + 1.0);
    svg(page, paper, "Assembly map", |page| {
        for column in left..right {
            let x = LEFT + width * ((column - left) as f64 + 0.5);
            letters(page, DVec2::new(x, HEAD - 1.6), 2.6, Anchor::Middle, "note", &column.to_string());
        }
        for row in top..bottom {
            let y = HEAD + height * (row - top) as f64;
            letters(
                page,
                DVec2::new(LEFT - 2.0, y + height / 2.0 + 0.9),
                2.6,
                Anchor::End,
                "note",
                &row.to_string(),
            );
            for column in left..right {
                let Some(label) = surface.labels.get(row * columns + column) else { continue };
                let corner = DVec2::new(LEFT + width * (column - left) as f64, y);
                let class = if made(label) { "cell" } else { "cell refused" };
                rectangle(page, corner, DVec2::new(width, height), class);
                let at = corner + DVec2::new(width / 2.0, height / 2.0 + size * 0.35);
                page_alias(page, at, size, &label.alias[start.len()..]);
            }
        }
        letters(page, DVec2::new(0.0, HEAD - 1.6), 2.6, Anchor::Start, "note", "row");
    });
}

fn page_alias(page: &mut Markup, at: DVec2, size: f64, text: &str) {
    let [x, y, size] = [at.x, at.y, size].map(coordinate);
    let attributes = [
        ("class", "cell-text"),
        ("x", x.as_str()),
        ("y", &y),
        ("font-size", &size),
        ("text-anchor", "middle"),
    ];
    page.texts("text", &attributes, text);
}

/// Too many boards to name: how their names follow from their place.
fn overview(page: &mut Markup, surface: &SurfaceShape<'_>, (rows, columns): (usize, usize)) {
    let named = |place: usize| surface.labels.get(place).map_or("", |label| label.alias.as_str());
    let text = format!(
        "{} in {} and {}: too many to name one by one here. An alias is the name of the figure, the row and the column, both counted from 0.",
        counted(surface.labels.len(), "board"),
        counted(rows, "row"),
        counted(columns, "column"),
    );
    page.texts("p", &[], &text);
    let scale = (WIDTH - 60.0) / columns as f64;
    let scale = scale.min(120.0 / rows as f64);
    let size = DVec2::new(columns as f64 * scale, rows as f64 * scale);
    let corner = DVec2::new((WIDTH - size.x) / 2.0, 14.0);
    page.element("figure", &[("class", "sheet")], |page| {
        svg(page, (WIDTH, size.y + 28.0), "Rows and columns", |page| {
            rectangle(page, corner, size, "cell");
            // Lines at every tenth row and column, or hundredth.
            let step = |count: usize| if count > 300 { 100 } else { 10 };
            for column in (0..=columns).step_by(step(columns)) {
                let x = corner.x + column as f64 * scale;
                crate::export::html::draw::paper::line(
                    page,
                    DVec2::new(x, corner.y),
                    DVec2::new(x, corner.y + size.y),
                    "grid",
                );
            }
            for row in (0..=rows).step_by(step(rows)) {
                let y = corner.y + row as f64 * scale;
                crate::export::html::draw::paper::line(
                    page,
                    DVec2::new(corner.x, y),
                    DVec2::new(corner.x + size.x, y),
                    "grid",
                );
            }
            rectangle(page, corner, size, "outline");
            let ends = corner + size;
            let corners = [
                (corner + DVec2::new(0.0, -2.0), Anchor::Middle, named(0)),
                (DVec2::new(ends.x, corner.y - 2.0), Anchor::Middle, named(columns - 1)),
                (DVec2::new(corner.x, ends.y + 4.5), Anchor::Middle, named((rows - 1) * columns)),
                (DVec2::new(ends.x, ends.y + 4.5), Anchor::Middle, named(rows * columns - 1)),
            ];
            for (at, anchor, name) in corners {
                letters(page, at, 3.0, anchor, "cell-text", name);
            }
            let middle = (corner + ends) / 2.0;
            letters(
                page,
                DVec2::new(middle.x, corner.y - 8.0),
                2.8,
                Anchor::Middle,
                "note",
                &format!("{} columns", count(columns)),
            );
            letters(
                page,
                DVec2::new(corner.x - 3.0, middle.y),
                2.8,
                Anchor::End,
                "note",
                &format!("{} rows", count(rows)),
            );
        });
        let caption = format!(
            "Lines at every {} row and column; the boards at the corners by their aliases.",
            if rows.max(columns) > 300 { "hundredth" } else { "tenth" }
        );
        page.texts("figcaption", &[], &caption);
    });
}

/// A surface without rows and columns: its boards in the order of their addresses.
fn listed(page: &mut Markup, labels: &[Label]) {
    let text = format!(
        "{} that do not lie in rows and columns. {}",
        counted(labels.len(), "board"),
        if labels.len() > MOST_NAMED {
            format!("The first {}; cutlist.csv has all.", count(MOST_NAMED))
        } else {
            String::new()
        }
    );
    page.texts("p", &[], text.trim());
    let columns = [
        Column::text("Alias", ""),
        Column::text("Address", ""),
        Column::text("Alias", ""),
        Column::text("Address", ""),
    ];
    table(page, "dense", "", &columns, |rows| {
        for pair in labels[..labels.len().min(MOST_NAMED)].chunks(2) {
            rows.row(pair.iter().flat_map(|label| [Cell::Name(&label.alias), Cell::Text(&label.address)]));
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_aliases_share_ends_at_a_hyphen() {
        let labels = |aliases: &[&str]| -> Vec<Label> {
            aliases.iter().map(|alias| Label { alias: (*alias).to_owned(), ..Label::default() }).collect()
        };
        assert_eq!(common_start(&labels(&["shell-00-01", "shell-00-02", "shell-07-02"])), "shell-");
        assert_eq!(common_start(&labels(&["vault-2-05", "vault-2-15"])), "vault-2-");
        assert_eq!(common_start(&labels(&["a", "b"])), "");
        assert_eq!(common_start(&labels(&["é-1", "ê-1"])), "");
        assert_eq!(common_start(&[]), "");
    }
}
