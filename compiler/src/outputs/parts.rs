//! Boards and planks as lists and reports give them.

use super::names::safe_file_name;
use super::selection::{Format, Selection};
use crate::analysis::{Analysis, Elements, Fabrication};
use crate::export::number::Fixed;
use crate::export::part::Part;

/// The parts of each fabricate block: made ones in order, then refused ones, each with the files that the selection
/// makes for it.
pub(super) fn parts(analysis: &Analysis, selection: &Selection) -> Vec<Vec<Part>> {
    analysis.fabrications.iter().map(|made| block(made, selection)).collect()
}

fn block(made: &Fabrication, selection: &Selection) -> Vec<Part> {
    let programs = selection.makes(Format::Nc) && made.settings.iter().any(|(name, _, _)| *name == "machine");
    let figure = made.figure.as_str();
    let mut parts: Vec<Part> = match &made.elements {
        Elements::Panels(panels) => {
            let (material, grain) = (&panels.settings.material.name, panels.settings.grain);
            panels.panels.iter().map(|panel| Part::of_panel(panel, figure, material, grain)).collect()
        }
        Elements::Planks(planks) => {
            let material = &planks.settings.material.name;
            planks.planks.iter().map(|plank| Part::of_plank(plank, figure, material)).collect()
        }
    };
    for part in parts.iter_mut().filter(|part| selection.takes(&part.address, &part.alias)) {
        part.files.extend(programs.then(|| program_path(&part.address)));
        part.files.extend(selection.makes(Format::Dxf).then(|| drawing_path(&part.address)));
    }
    match &made.elements {
        Elements::Panels(panels) => parts.extend(panels.refused.iter().map(|refused| {
            let material = &panels.settings.material.name;
            Part::refused(&refused.label, figure, material, &refused.reason.to_string())
        })),
        Elements::Planks(planks) => parts.extend(planks.refused.iter().map(|refused| {
            let material = &planks.settings.material.name;
            Part::refused(&refused.label, figure, material, &refused.reason.to_string())
        })),
    }
    for part in &mut parts {
        part.scale = Fixed::ratio(made.scale);
    }
    parts
}

/// Where the NC program of a board lies in the output folder.
pub(super) fn program_path(address: &str) -> String {
    format!("boards/{}", safe_file_name(address, "nc"))
}

/// Where the drawing of a board lies in the output folder.
pub(super) fn drawing_path(address: &str) -> String {
    format!("boards/{}", safe_file_name(address, "dxf"))
}
