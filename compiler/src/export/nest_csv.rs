//! `nest.csv`: where each nested board lies, those on no sheet too.

use super::csv::{Cell, Table};
use super::number::Fixed;
use crate::nest::sheets::Placement;

/// The columns. `x_mm` and `y_mm` are where the lower left of the board's box, as its own drawing has it, lies on the
/// sheet; `rotation_deg` is about that point, anticlockwise.
pub const HEADERS: [&str; 10] = [
    "address",
    "alias",
    "figure",
    "material",
    "thickness_mm",
    "sheet",
    "x_mm",
    "y_mm",
    "rotation_deg",
    "status",
];

/// A nested board.
#[derive(Debug, Clone, PartialEq)]
pub struct Row<'a> {
    /// Address, alias, figure, material.
    pub texts: [&'a str; 4],
    /// mm.
    pub thickness: f64,
    /// The name of its sheet and where it lies on it; or why it lies on none.
    pub lies: Result<(&'a str, Placement), String>,
}

/// The list of `rows`, in their order.
#[must_use]
pub fn nest_csv(rows: &[Row<'_>]) -> String {
    let mut table = Table::new(&HEADERS);
    for row in rows {
        let mut cells: Vec<Cell<'_>> = row.texts.map(Cell::Text).into();
        cells.push(Cell::Number(Fixed::mm(row.thickness)));
        match &row.lies {
            Ok((sheet, placement)) => {
                let [x, y] = [placement.at.x, placement.at.y].map(|value| Cell::Number(Fixed::mm(value)));
                let degrees = Cell::Count(90 * u64::from(placement.quarter_turns));
                cells.extend([Cell::Text(sheet), x, y, degrees, Cell::Text("placed")]);
            }
            Err(why) => {
                cells.extend([Cell::Empty, Cell::Empty, Cell::Empty, Cell::Empty, Cell::Text(why)]);
            }
        }
        table.row(cells);
    }
    table.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    #[test]
    fn placed_and_not() {
        let texts = ["shell.0", "shell-00", "shell", "birch, 12"];
        let placement = Placement { part: 0, sheet: 0, quarter_turns: 2, at: DVec2::new(310.25, 250.0) };
        let rows = [
            Row { texts, thickness: 12.0, lies: Ok(("01", placement)) },
            Row { texts, thickness: 12.0, lies: Err("too large".to_owned()) },
        ];
        let text = nest_csv(&rows);
        let lines: Vec<&str> = text.lines().skip(1).collect();
        assert_eq!(lines[0], "shell.0,shell-00,shell,\"birch, 12\",12.000,01,310.250,250.000,180,placed");
        assert_eq!(lines[1], "shell.0,shell-00,shell,\"birch, 12\",12.000,,,,,too large");
    }
}
