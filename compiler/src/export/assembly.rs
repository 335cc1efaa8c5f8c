//! `assembly.csv`: one row for each board and plank: what lies beside it across each edge, at which angle, and where it
//! lies in the building.

use glam::DVec3;

use super::csv::{Cell, Table};
use super::number::Fixed;

/// Decimals of the components of a unit vector.
const UNIT_DECIMALS: usize = 9;

/// What lies across an edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Its address.
    pub address: String,
    /// Which of its edges it is: `0` to `3` of a board, `start` or `end` of a plank; none where that one cannot be made.
    pub edge: Option<&'static str>,
    /// The angle between the two, rad: π where they go on straight, less on a ridge, more in a valley; none where it is
    /// not known.
    pub angle: Option<f64>,
}

/// A board or plank where it is put up. Edges 0 to 3 of a board are AB, BC, CD, DA; of a plank, 0 is its start and 1 its
/// end.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The IFS address.
    pub address: String,
    /// The short name, as engraved.
    pub alias: String,
    /// The figure it is part of.
    pub figure: String,
    /// The ring it is put up in, from 0.
    pub ring: u32,
    /// Its place in the order of assembly of its figure, from 1.
    pub order: u32,
    /// Across each edge; none on the border.
    pub joints: [Option<Joint>; 4],
    /// Where the origin of its outline lies in the building, mm.
    pub origin: DVec3,
    /// The unit vector along x of the outline.
    pub x: DVec3,
    /// The unit vector along y of the outline.
    pub y: DVec3,
}

/// The assembly list, in the order of the rows.
#[must_use]
pub fn assembly(rows: &[Row]) -> String {
    let mut headers: Vec<String> = ["address", "alias", "figure", "ring", "order"].map(str::to_owned).into();
    for edge in 0..4 {
        headers.extend([
            format!("neighbour_{edge}"),
            format!("neighbour_edge_{edge}"),
            format!("angle_{edge}_deg"),
        ]);
    }
    for (vector, unit) in [("origin", "_mm"), ("x_axis", ""), ("y_axis", "")] {
        headers.extend(["x", "y", "z"].map(|axis| format!("{vector}_{axis}{unit}")));
    }
    let headers: Vec<&str> = headers.iter().map(String::as_str).collect();
    let mut table = Table::new(&headers);
    for row in rows {
        table.row(cells(row));
    }
    table.finish()
}

fn cells(row: &Row) -> Vec<Cell<'_>> {
    let mut cells: Vec<Cell<'_>> =
        [&row.address, &row.alias, &row.figure].map(|text| Cell::Text(text)).into();
    cells.extend([row.ring, row.order].map(|count| Cell::Count(count.into())));
    for joint in &row.joints {
        match joint {
            None => cells.extend([Cell::Empty, Cell::Empty, Cell::Empty]),
            Some(joint) => cells.extend([
                Cell::Text(&joint.address),
                joint.edge.map_or(Cell::Empty, Cell::Text),
                joint.angle.map(Fixed::degrees).into(),
            ]),
        }
    }
    cells.extend(row.origin.to_array().map(|value| Cell::Number(Fixed::mm(value))));
    for vector in [row.x, row.y] {
        let unit = |value| Cell::Number(Fixed { value, decimals: UNIT_DECIMALS });
        cells.extend(vector.to_array().map(unit));
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_a_cell_under_each_header() {
        let joint = Joint { address: "=shell.1".to_owned(), edge: Some("2"), angle: Some(3.0) };
        let row = Row {
            address: "shell.0".to_owned(),
            alias: "shell-00".to_owned(),
            figure: "a, b".to_owned(),
            ring: 0,
            order: 7,
            joints: [None, Some(joint), None, None],
            origin: DVec3::new(1.0, -2.5, 1e-9),
            x: DVec3::X,
            y: DVec3::Z,
        };
        let text = assembly(&[row]);
        let (headers, cells) = text.split_once('\n').unwrap();
        assert!(headers.starts_with(
            "address,alias,figure,ring,order,neighbour_0,neighbour_edge_0,angle_0_deg,neighbour_1"
        ));
        assert_eq!(
            cells,
            "shell.0,shell-00,\"a, b\",0,7,,,,'=shell.1,2,171.8873,,,,,,,1.000,-2.500,0.000,\
             1.000000000,0.000000000,0.000000000,0.000000000,0.000000000,1.000000000\n"
        );
        assert_eq!(headers.split(',').count(), 26);
    }
}
