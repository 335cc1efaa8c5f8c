//! `cutlist.csv`: one row for each board and plank, refused ones too.

use super::csv::{Cell, Table};
use super::part::Part;

/// The columns. Where the cut list of a plank has three lengths, the one between the end cuts on the axis comes first.
pub const HEADERS: [&str; 40] = [
    "address",
    "alias",
    "figure",
    "material",
    "length_mm",
    "inner_length_mm",
    "outer_length_mm",
    "width_mm",
    "thickness_mm",
    "area_m2",
    "mass_kg",
    "edge_0_mm",
    "edge_1_mm",
    "edge_2_mm",
    "edge_3_mm",
    "bevel_0_deg",
    "bevel_1_deg",
    "bevel_2_deg",
    "bevel_3_deg",
    "edge_cut",
    "relief_0_mm",
    "relief_1_mm",
    "relief_2_mm",
    "relief_3_mm",
    "mitre_start_deg",
    "mitre_end_deg",
    "bevel_start_deg",
    "bevel_end_deg",
    "diagonal_mm",
    "fold_deg",
    "planarity",
    "bend_radius_mm",
    "moved_mm",
    "grain",
    "ring",
    "order",
    "sheet",
    "files",
    "status",
    "scale",
];

/// The cut list of `parts`, in their order. Several files in a cell are parted by `; `. A board without a bend says
/// `flat`.
#[must_use]
pub fn cut_list(parts: &[Part]) -> String {
    let mut table = Table::new(&HEADERS);
    for part in parts {
        let files = part.files.join("; ");
        table.row(cells(part, &files));
    }
    table.finish()
}

fn cells<'a>(part: &'a Part, files: &'a str) -> Vec<Cell<'a>> {
    let mut cells: Vec<Cell<'_>> =
        [&part.address, &part.alias, &part.figure, &part.material].map(|text| Cell::Text(text)).into();
    cells.extend(
        [
            part.length_mm,
            part.inner_length_mm,
            part.outer_length_mm,
            part.width_mm,
            part.thickness_mm,
            part.area_m2,
            part.mass_kg,
        ]
        .map(Cell::from),
    );
    cells.extend((0..4).map(|side| Cell::from(part.edges_mm.map(|edges| edges[side]))));
    cells.extend(part.bevels_deg.map(Cell::from));
    cells.push(part.edge_cut.map_or(Cell::Empty, Cell::Text));
    cells.extend((0..4).map(|corner| Cell::from(part.relief_mm.map(|relief| relief[corner]))));
    for ends in [part.mitres_deg, part.end_bevels_deg] {
        cells.extend((0..2).map(|end| Cell::from(ends.map(|angles| angles[end]))));
    }
    cells.extend([part.diagonal_mm, part.fold_deg, part.planarity].map(Cell::from));
    cells.push(match part.bend_radius_mm {
        Some(radius) => Cell::Number(radius),
        None if part.fold_deg.is_some() => Cell::Text("flat"),
        None => Cell::Empty,
    });
    cells.push(part.moved_mm.into());
    cells.push(part.grain.map_or(Cell::Empty, Cell::Text));
    let count = |number: Option<u32>| number.map_or(Cell::Empty, |number| Cell::Count(number.into()));
    cells.extend([count(part.ring), count(part.order)]);
    cells.push(part.sheet.as_deref().map_or(Cell::Empty, Cell::Text));
    cells.push(Cell::Text(files));
    cells.push(Cell::Text(&part.status));
    cells.push(Cell::Number(part.scale));
    cells
}

#[cfg(test)]
mod tests;
