//! Drawings of boards and planks: for each a DXF with the design outline, the cut outline, the engraved strokes and
//! notes, each operation, tool and depth on a layer of its own. Coordinates are those of the outline, seen from the face
//! that lies up.

use glam::DVec2;

use super::parts::drawing_path;
use super::programs::{Block, cutting};
use super::{Content, Output};
use crate::analysis::Elements;
use crate::export::dxf::{Colour, Drawing};
use crate::export::number::fixed;
use crate::fabricate::cut_job::{CutJob, Sheet};
use crate::fabricate::machine::{Machine, Tool};
use crate::fabricate::toolpath::engraving;

/// The layers that are the same in every drawing.
pub(super) const DESIGN: &str = "DESIGN";
pub(super) const NOTES: &str = "NOTES";

/// The drawing of every board that is wanted.
pub(super) fn drawings(blocks: &[Block<'_>]) -> Vec<Output> {
    blocks.iter().flat_map(block).collect()
}

fn block(block: &Block<'_>) -> Vec<Output> {
    let machines = block.machines();
    let mut designs = designs(&block.made.elements);
    let mut outputs = Vec::new();
    for (_, job) in block.jobs() {
        // Jobs are in the order of the elements, which may be more.
        let Some((_, design, material)) = designs.find(|(address, _, _)| *address == job.address) else {
            continue;
        };
        let machine = cutting(&machines, |machine| Sheet::single(job, machine));
        let drawing = drawing(job, design, material, machine);
        outputs.push(Output {
            path: drawing_path(&job.address),
            kind: "drawing",
            address: Some(job.address.clone()),
            content: Content::Drawing(drawing),
        });
    }
    outputs
}

/// Address, design outline and material of each element.
pub(super) fn designs(elements: &Elements) -> Box<dyn Iterator<Item = (&str, &[DVec2], &str)> + '_> {
    match elements {
        Elements::Panels(made) => Box::new(made.panels.iter().map(|panel| {
            (
                panel.label.address.as_str(),
                panel.design_outline.as_slice(),
                made.settings.material.name.as_str(),
            )
        })),
        Elements::Planks(made) => Box::new(made.planks.iter().map(|plank| {
            (plank.label.address.as_str(), plank.outline.as_slice(), made.settings.material.name.as_str())
        })),
    }
}

fn drawing(job: &CutJob, design: &[DVec2], material: &str, machine: Option<&Machine>) -> Drawing {
    let mut drawing = Drawing::default();
    let layer = drawing.layer(DESIGN, Colour::Grey);
    drawing.outline(layer, design);
    let (cut, engraved) = (cut_layer(job.thickness, machine), engraved_layer(machine));
    let layer = drawing.layer(&cut, Colour::Red);
    drawing.outline(layer, &job.outline);
    // Where the alias has no room and there is no machine to refuse it for that, the notes still say it.
    let layer = drawing.layer(&engraved, Colour::Blue);
    for stroke in engraving(job, machine).unwrap_or_default() {
        drawing.stroke(layer, &stroke);
    }
    notes(&mut drawing, job, material);
    drawing
}

/// `CUT T1 straight cutter 18.5mm`, or `CUT` where no machine is known.
pub(super) fn cut_layer(thickness: f64, machine: Option<&Machine>) -> String {
    machine.map_or_else(
        || "CUT".to_owned(),
        |machine| {
            let depth = machine.top(thickness) - machine.bottom(thickness);
            layer_name("CUT", machine.cutter(), depth)
        },
    )
}

/// `ENGRAVE T2 engraver 0.4mm`, or `ENGRAVE` where no machine is known.
pub(super) fn engraved_layer(machine: Option<&Machine>) -> String {
    machine.map_or_else(
        || "ENGRAVE".to_owned(),
        |machine| layer_name("ENGRAVE", machine.engraver(), machine.spec().engrave_depth),
    )
}

/// The layer of an operation with a tool down to a depth in mm: `CUT T1 straight cutter 18.5mm`.
pub(super) fn layer_name(operation: &str, tool: &Tool, depth: f64) -> String {
    let depth = fixed(depth, 3).unwrap_or_default();
    let depth = depth.trim_end_matches('0').trim_end_matches('.');
    format!("{operation} T{} {} {depth}mm", tool.number, tool.name)
}

/// The numbers of the edges along them, and below the part what its program's header says too.
fn notes(drawing: &mut Drawing, job: &CutJob, material: &str) {
    let layer = drawing.layer(NOTES, Colour::Green);
    let first = job.outline.first().copied().unwrap_or_default();
    let (low, high) = job.outline.iter().fold((first, first), |(low, high), &at| (low.min(at), high.max(at)));
    let height = ((high - low).min_element() / 25.0).clamp(1.0, 10.0);
    for (edge, &from) in job.outline.iter().enumerate() {
        let to = job.outline[(edge + 1) % job.outline.len()];
        let along = (to - from).normalize_or_zero();
        let at = (from + to) / 2.0 + along.perp() * (0.5 * height) - along * (0.4 * height);
        drawing.text(layer, at, height, along.to_angle(), &edge.to_string());
    }
    let thickness = fixed(job.thickness, 1).unwrap_or_default();
    let about = [
        format!("{} ({})", job.address, job.alias),
        format!("{material}, {thickness} mm, face up: {}", job.face_up),
    ];
    for (line, text) in about.iter().chain(&job.notes).enumerate() {
        let below = height * (2.0 + 1.6 * line as f64);
        drawing.text(layer, DVec2::new(low.x, low.y - below), height, 0.0, text);
    }
}
