//! The cut list, as far as it is good to read on paper; cutlist.csv has all of it.

use crate::export::html::markup::Markup;
use crate::export::html::number::{count, shown};
use crate::export::html::table::{Cell, Column, table};
use crate::export::number::Fixed;
use crate::export::part::Part;
use crate::export::report::Fabrication;

/// Rows, at most.
pub(in crate::export::html) const MOST_ROWS: usize = 2000;

/// Writes it.
pub(in crate::export::html) fn cut_list(page: &mut Markup, fabrication: &Fabrication, at: &str) {
    let made: Vec<(usize, &Part)> =
        fabrication.parts.iter().enumerate().filter(|(_, part)| part.status == "made").collect();
    let planks = fabrication.kind == "planks";
    let section = made.first().map(|(_, part)| section_words(part, planks)).unwrap_or_default();
    let shown_rows = made.len().min(MOST_ROWS);
    let rest = match made.len() > MOST_ROWS {
        true => format!("The first {} of {}; all are in cutlist.csv. ", count(MOST_ROWS), count(made.len())),
        false => String::new(),
    };
    let conventions = match planks {
        true => {
            "The inner and outer length are those of the faces square to the plane of the curve; mitres are measured from a square cut."
        }
        false => {
            "Edges 0 to 3 go round the outline, edge 0 along the rows. A bevel is positive on a ridge and negative in a valley; edges on the border have none. Length and width are those of the box round the outline, the length along the grain."
        }
    };
    let text = format!("{section}{rest}{conventions} Addresses, neighbours and files are in cutlist.csv.");
    page.texts("p", &[], &text);
    let columns = if planks { PLANKS.to_vec() } else { BOARDS.to_vec() };
    table(page, "dense", &format!("{at}/parts"), &columns, |rows| {
        for (place, part) in made.into_iter().take(shown_rows) {
            let cells = if planks { plank(part) } else { board(part) };
            rows.row_of(place, std::iter::once(Cell::Name(&part.alias)).chain(cells));
        }
    });
}

fn section_words(part: &Part, planks: bool) -> String {
    let size = |number: Option<Fixed>| {
        let text = number.map_or_else(String::new, |number| shown(number.value, 1));
        text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
    };
    match planks {
        true => format!("Section {} × {} mm. ", size(part.width_mm), size(part.thickness_mm)),
        false => format!("All {} mm thick. ", size(part.thickness_mm)),
    }
}

const BOARDS: [Column; 15] = [
    Column::text("Alias", "alias"),
    Column::number("Length", "mm", "length_mm"),
    Column::number("Width", "mm", "width_mm"),
    Column::number("Area", "m²", "area_m2"),
    Column::number("Mass", "kg", "mass_kg"),
    Column::number("Edge 0", "mm", "edges_mm/0"),
    Column::number("Edge 1", "mm", "edges_mm/1"),
    Column::number("Edge 2", "mm", "edges_mm/2"),
    Column::number("Edge 3", "mm", "edges_mm/3"),
    Column::number("Bevel 0", "deg", "bevels_deg/0"),
    Column::number("Bevel 1", "deg", "bevels_deg/1"),
    Column::number("Bevel 2", "deg", "bevels_deg/2"),
    Column::number("Bevel 3", "deg", "bevels_deg/3"),
    Column::number("Fold", "deg", "fold_deg"),
    Column::number("Moved", "mm", "moved_mm"),
];

fn board(part: &Part) -> Vec<Cell<'static>> {
    let mut cells = vec![
        Cell::Number(part.length_mm, 1),
        Cell::Number(part.width_mm, 1),
        Cell::Number(part.area_m2, 4),
        Cell::Number(part.mass_kg, 2),
    ];
    cells.extend((0..4).map(|side| Cell::Number(part.edges_mm.map(|edges| edges[side]), 1)));
    cells.extend(part.bevels_deg.map(|bevel| Cell::Number(bevel, 2)));
    cells.extend([Cell::Number(part.fold_deg, 2), Cell::Number(part.moved_mm, 1)]);
    cells
}

const PLANKS: [Column; 8] = [
    Column::text("Alias", "alias"),
    Column::number("Length on the axis", "mm", "length_mm"),
    Column::number("Inner length", "mm", "inner_length_mm"),
    Column::number("Outer length", "mm", "outer_length_mm"),
    Column::number("Mitre at the start", "deg", "mitres_deg/0"),
    Column::number("Mitre at the end", "deg", "mitres_deg/1"),
    Column::number("Area", "m²", "area_m2"),
    Column::number("Mass", "kg", "mass_kg"),
];

fn plank(part: &Part) -> Vec<Cell<'static>> {
    let mitre = |end: usize| part.mitres_deg.map(|mitres| mitres[end]);
    vec![
        Cell::Number(part.length_mm, 1),
        Cell::Number(part.inner_length_mm, 1),
        Cell::Number(part.outer_length_mm, 1),
        Cell::Number(mitre(0), 2),
        Cell::Number(mitre(1), 2),
        Cell::Number(part.area_m2, 4),
        Cell::Number(part.mass_kg, 2),
    ]
}
