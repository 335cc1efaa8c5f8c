//! Boards and planks as lists and reports give them.

use super::Output;
use super::names::safe_file_name;
use crate::analysis::{Analysis, Elements, Fabrication};
use crate::export::number::Fixed;
use crate::export::part::Part;
use std::collections::BTreeMap;

/// The parts of each fabricate block: made ones in order, then refused ones. Each names those of the outputs that are for
/// it alone.
pub(super) fn parts(analysis: &Analysis, outputs: &[Output]) -> Vec<Vec<Part>> {
    let mut files: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for output in outputs {
        if let Some(address) = &output.address {
            files.entry(address).or_default().push(&output.path);
        }
    }
    analysis.fabrications.iter().map(|made| block(made, &files)).collect()
}

fn block(made: &Fabrication, files: &BTreeMap<&str, Vec<&str>>) -> Vec<Part> {
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
    for part in &mut parts {
        let own = files.get(part.address.as_str());
        part.files.extend(own.into_iter().flatten().map(|path| (*path).to_owned()));
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

/// Where the drawing of a board lies in the output folder.
pub(super) fn drawing_path(address: &str) -> String {
    format!("boards/{}", safe_file_name(address, "dxf"))
}
