//! `stock.csv`: which planks are sawn from which bar, in order, with every cut; those that are longer than a bar too.

use super::csv::{Cell, Table};
use super::number::Fixed;
use crate::nest::bars::{Bar, Placed, Stock};

/// The columns. Cuts are told by where the plank's face meets the axis, from the raw left end of the bar, and by how
/// they lean from square, anticlockwise, and how the blade is tilted beside. `first_cut` is `raw` for the bar's own end, `shared` where one stroke makes it
/// and the face before it, else `own`; so is `second_cut`. A plank lies `as drawn`, `end first`, `turned over`, or both.
/// The offcut is told with the last plank of a bar.
pub const HEADERS: [&str; 22] = [
    "bar",
    "material",
    "depth_mm",
    "width_mm",
    "bar_length_mm",
    "kerf_mm",
    "place",
    "address",
    "alias",
    "figure",
    "length_mm",
    "first_cut",
    "first_cut_mm",
    "first_cut_deg",
    "first_cut_tilt_deg",
    "second_cut",
    "second_cut_mm",
    "second_cut_deg",
    "second_cut_tilt_deg",
    "lies",
    "offcut_mm",
    "status",
];

/// Bars of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Bars<'a> {
    /// The name of the material.
    pub material: &'a str,
    /// Raw bars and saw.
    pub stock: &'a Stock,
    /// Each with its name.
    pub bars: Vec<(&'a str, &'a Bar)>,
    /// Address, alias and figure of each plank, and its length, mm.
    pub planks: Vec<([&'a str; 3], f64)>,
    /// Planks that are longer than a bar, and why.
    pub too_long: Vec<(usize, String)>,
}

/// The list of all bars, in their order.
#[must_use]
pub fn stock_csv(kinds: &[Bars<'_>]) -> String {
    let mut table = Table::new(&HEADERS);
    for kind in kinds {
        for (name, bar) in &kind.bars {
            for (place, placed) in bar.planks.iter().enumerate() {
                table.row(row(kind, name, bar, place, placed));
            }
        }
        for (plank, why) in &kind.too_long {
            let mut cells = vec![Cell::Empty];
            cells.extend(of_kind(kind));
            cells.push(Cell::Empty);
            cells.extend(of_plank(kind, *plank));
            cells.extend((0..10).map(|_| Cell::Empty));
            cells.push(Cell::Text(why));
            table.row(cells);
        }
    }
    table.finish()
}

fn of_kind<'a>(kind: &Bars<'a>) -> Vec<Cell<'a>> {
    let mut cells = vec![Cell::Text(kind.material)];
    let sizes = [kind.stock.depth, kind.stock.width, kind.stock.length, kind.stock.kerf];
    cells.extend(sizes.map(|size| Cell::Number(Fixed::mm(size))));
    cells
}

fn of_plank<'a>(kind: &Bars<'a>, plank: usize) -> Vec<Cell<'a>> {
    let Some((texts, length)) = kind.planks.get(plank) else { return vec![Cell::Empty; 4] };
    let mut cells: Vec<Cell<'_>> = texts.map(Cell::Text).into();
    cells.push(Cell::Number(Fixed::mm(*length)));
    cells
}

fn row<'a>(kind: &Bars<'a>, name: &'a str, bar: &Bar, place: usize, placed: &Placed) -> Vec<Cell<'a>> {
    let mut cells = vec![Cell::Text(name)];
    cells.extend(of_kind(kind));
    cells.push(Cell::Count(place as u64 + 1));
    cells.extend(of_plank(kind, placed.plank));
    for end in [0, 1] {
        cells.push(Cell::Text(made_by(bar, placed, end)));
        cells.push(Cell::Number(Fixed::mm(placed.at[end])));
        cells.push(Cell::Number(Fixed::degrees(placed.leans[end])));
        cells.push(Cell::Number(Fixed::degrees(placed.tilts[end])));
    }
    cells.push(Cell::Text(match (placed.end_first, placed.turned_over) {
        (false, false) => "as drawn",
        (true, false) => "end first",
        (false, true) => "turned over",
        (true, true) => "end first and turned over",
    }));
    let last = place + 1 == bar.planks.len();
    cells.push(if last { Cell::Number(Fixed::mm(bar.offcut)) } else { Cell::Empty });
    cells.push(Cell::Text("placed"));
    cells
}

/// How a face of a plank comes about.
fn made_by(bar: &Bar, placed: &Placed, end: usize) -> &'static str {
    let plank = Some(placed.plank);
    let cut = bar.cuts.iter().find(|cut| if end == 0 { cut.after == plank } else { cut.before == plank });
    match cut {
        None => "raw",
        Some(cut) if cut.before.is_some() && cut.after.is_some() => "shared",
        Some(_) => "own",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nest::bars::{Plank, saw};

    #[test]
    fn a_bar_of_mitred_planks_in_turn() {
        let stock = Stock { length: 1000.0, depth: 100.0, width: 27.0, kerf: 4.0, trim: 0.0 };
        let lean = libm::atan(0.1);
        let planks = [Plank { length: 400.0, mitres: [-lean, lean], bevels: [0.0, 0.0] }; 2];
        let sawn = saw(&planks, &stock);
        let kind = Bars {
            material: "spruce",
            stock: &stock,
            bars: vec![("bar-1", &sawn.bars[0])],
            planks: vec![(["a.0", "a-0", "a"], 400.0), (["a.1", "a-1", "a"], 400.0)],
            too_long: vec![(1, "too long".to_owned())],
        };
        let text = stock_csv(&[kind]);
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.iter().all(|line| line.split(',').count() == HEADERS.len()), "{text}");
        assert_eq!(
            lines[1],
            "bar-1,spruce,100.000,27.000,1000.000,4.000,1,a.0,a-0,a,400.000,own,5.000,-5.7106,0.0000,shared,405.000,5.7106,0.0000,as \
             drawn,,placed"
        );
        assert_eq!(
            lines[2],
            "bar-1,spruce,100.000,27.000,1000.000,4.000,2,a.1,a-1,a,400.000,shared,409.020,5.7106,0.0000,own,809.020,-5.7106,0.0000,turned \
             over,181.960,placed"
        );
        assert_eq!(lines[3], ",spruce,100.000,27.000,1000.000,4.000,,a.1,a-1,a,400.000,,,,,,,,,,,too long");
    }
}
