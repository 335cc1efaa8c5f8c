//! Drawings of nested sheets: for each a DXF with the raw board, and its boards as they lie: design outlines, cut
//! outlines and engraved strokes on the layers of the drawings of boards. The lower left of the sheet is the origin.

use super::drawings::{DESIGN, NOTES, cut_layer, designs, engraved_layer};
use super::nests::{Nests, SheetNest};
use super::programs::{Block, cutting};
use super::sheet_programs::{block_of, is_wanted, laid_out};
use super::sheets::sheet_path;
use super::{Content, Output};
use crate::export::dxf::{Colour, Drawing};
use crate::export::number::fixed;
use crate::fabricate::cut_job::{Placed, Sheet};
use crate::fabricate::fit::bounds;
use crate::fabricate::toolpath::engraving_on_sheet;
use glam::DVec2;
use std::collections::BTreeMap;

/// The layer of the raw board.
const SHEET: &str = "SHEET";

/// The drawing of every sheet.
pub(super) fn drawings(blocks: &[Block<'_>], nests: &Nests) -> Vec<Output> {
    let outlines = blocks.iter().flat_map(|block| designs(&block.made.elements));
    let outlines: BTreeMap<&str, &[DVec2]> =
        outlines.map(|(address, outline, _)| (address, outline)).collect();
    let sheets = nests.sheets.iter().flat_map(|nest| (0..nest.nested.sheets).map(move |sheet| (nest, sheet)));
    sheets
        .filter(|(nest, place)| is_wanted(blocks, nest, *place))
        .map(|(nest, place)| {
            let drawing = drawing(blocks, nest, &laid_out(blocks, nest, place), &outlines);
            Output::of_design(&sheet_path(&nest.names[place], "dxf"), "drawing", Content::Drawing(drawing))
        })
        .collect()
}

fn drawing(
    blocks: &[Block<'_>],
    nest: &SheetNest,
    sheet: &Sheet<'_>,
    designs: &BTreeMap<&str, &[DVec2]>,
) -> Drawing {
    let machines = block_of(blocks, nest).map(Block::machines).unwrap_or_default();
    let machine = cutting(&machines, |_| sheet.clone());
    let mut drawing = Drawing::default();
    let layer = drawing.layer(SHEET, Colour::Black);
    let DVec2 { x, y } = sheet.stock;
    drawing.outline(layer, &[DVec2::ZERO, DVec2::new(x, 0.0), sheet.stock, DVec2::new(0.0, y)]);
    let design = drawing.layer(DESIGN, Colour::Grey);
    let cut = drawing.layer(&cut_layer(nest.thickness, machine), Colour::Red);
    let engraved = drawing.layer(&engraved_layer(machine), Colour::Blue);
    let notes = drawing.layer(NOTES, Colour::Green);
    for part in &sheet.parts {
        let outline = designs.get(part.job.address.as_str()).copied().unwrap_or_default();
        drawing.outline(design, &lying(part, outline));
        drawing.outline(cut, &lying(part, &part.job.outline));
        // Where the alias has no room and there is no machine to refuse it for that, the notes still say it.
        for stroke in engraving_on_sheet(part, machine).unwrap_or_default() {
            drawing.stroke(engraved, &stroke);
        }
        let (low, high) = bounds(&lying(part, &part.job.outline));
        let height = ((high - low).min_element() / 25.0).clamp(1.0, 10.0);
        // Beside the lower left corner, where nothing is engraved.
        drawing.text(notes, low + DVec2::splat(1.5 * height), height, 0.0, &part.job.address);
    }
    let thickness = fixed(nest.thickness, 1).unwrap_or_default();
    let about = format!("sheet {}: {}, {thickness} mm", sheet.name, nest.material);
    drawing.text(notes, DVec2::new(0.0, -30.0), 15.0, 0.0, &about);
    drawing
}

/// Points of a board, in the coordinates of its outline, where they lie on the sheet.
fn lying(part: &Placed<'_>, points: &[DVec2]) -> Vec<DVec2> {
    let turned = |points: &[DVec2]| points.iter().map(|&point| part.rotation.turn(point)).collect::<Vec<_>>();
    let shift = part.low - bounds(&turned(&part.job.outline)).0;
    turned(points).into_iter().map(|point| point + shift).collect()
}
