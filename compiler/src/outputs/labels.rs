//! The sheets of labels of a design.

use super::selection::Selection;
use crate::analysis::{Analysis, Elements};
use crate::export::labels::{Label, PER_SHEET, Sheet};
use crate::export::number::fixed;
use crate::fabricate::fit;
use glam::DVec2;

/// The labels of all boards and planks that are wanted, on sheets, each with its name in the output folder.
pub(super) fn sheets(analysis: &Analysis, selection: &Selection) -> Vec<(String, Sheet)> {
    let mut labels = Vec::new();
    for made in &analysis.fabrications {
        match &made.elements {
            Elements::Panels(made) => labels.extend(made.panels.iter().map(|panel| {
                label(&panel.label, &made.settings.material.name, &panel.outline, panel.thickness)
            })),
            Elements::Planks(made) => {
                labels.extend(made.planks.iter().map(|plank| {
                    label(&plank.label, &made.settings.material.name, &plank.outline, plank.width)
                }))
            }
        }
    }
    labels.retain(|label| selection.takes(&label.address, &label.alias));
    let count = labels.len().div_ceil(PER_SHEET);
    let sheets = labels.chunks(PER_SHEET).zip(1..).map(|(labels, number)| {
        let title = format!("{}: labels, sheet {number} of {count}", analysis.design_name());
        let name = if number == 1 { "labels.svg".to_owned() } else { format!("labels-{number}.svg") };
        (name, Sheet { title, labels: labels.to_vec() })
    });
    sheets.collect()
}

fn label(names: &crate::fabricate::label::Label, material: &str, outline: &[DVec2], thickness: f64) -> Label {
    let (low, high) = fit::bounds(outline);
    let size = |value: f64| fixed(value, 1).unwrap_or_default();
    let (length, width) = (size(high.x - low.x), size(high.y - low.y));
    Label {
        address: names.address.clone(),
        alias: names.alias.clone(),
        about: format!("{material} {length} x {width} x {} mm", size(thickness)),
        outline: outline.to_vec(),
    }
}
