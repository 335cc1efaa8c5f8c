//! The assembly list: boards and planks with their neighbours and their places in the building.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use glam::DVec3;

use super::Selection;
use super::place::Frame;
use crate::analysis::{Analysis, Elements};
use crate::export::assembly::{Joint, Row};
use crate::fabricate::label::Label;
use crate::fabricate::panel::Panel;
use crate::fabricate::plank::Plank;

/// What the edges of a board are called.
const EDGES: [&str; 4] = ["0", "1", "2", "3"];

/// The rows of all boards and planks that are wanted; their neighbours are named whether they are wanted or not.
pub(super) fn rows(analysis: &Analysis, selection: &Selection) -> Vec<Row> {
    let mut rows = Vec::new();
    for made in &analysis.fabrications {
        let figure = made.figure.as_str();
        match &made.elements {
            Elements::Panels(made) => {
                rows.extend(made.panels.iter().map(|panel| board(panel, figure)));
            }
            Elements::Planks(made) => {
                let known = made.planks.iter().map(|plank| (plank.label.address.as_str(), plank)).collect();
                rows.extend(made.planks.iter().map(|plank| beam(plank, &known, figure)));
            }
        }
    }
    rows.retain(|row| selection.takes(&row.address, &row.alias));
    rows
}

fn board(panel: &Panel, figure: &str) -> Row {
    let joint = |side: usize| {
        let address = panel.neighbours[side].clone()?;
        let back = panel.neighbour_sides[side].and_then(|back| EDGES.get(usize::from(back)).copied());
        let angle = panel.bevels[side].map(|bevel| PI - 2.0 * bevel);
        Some(Joint { address, edge: back, angle })
    };
    let joints = [joint(0), joint(1), joint(2), joint(3)];
    row(&panel.label, figure, (panel.ring, panel.order), joints, Frame::of_panel(panel))
}

fn beam(plank: &Plank, known: &BTreeMap<&str, &Plank>, figure: &str) -> Row {
    let along = |plank: &Plank| (plank.axis[1] - plank.axis[0]).normalize_or_zero();
    let joint = |end: usize| {
        let address = plank.neighbours[end].clone()?;
        let other = known.get(address.as_str());
        let angle = other.map(|other| {
            let (here, there): (DVec3, DVec3) = (along(plank), along(other));
            PI - libm::atan2(here.cross(there).length(), here.dot(there))
        });
        Some(Joint { address, edge: other.map(|_| ["end", "start"][end]), angle })
    };
    let joints = [joint(0), joint(1), None, None];
    row(&plank.label, figure, (plank.ring, plank.order), joints, Frame::of_plank(plank))
}

fn row(
    label: &Label,
    figure: &str,
    (ring, order): (u32, u32),
    joints: [Option<Joint>; 4],
    frame: Frame,
) -> Row {
    let (address, alias, figure) = (label.address.clone(), label.alias.clone(), figure.to_owned());
    Row { address, alias, figure, ring, order, joints, origin: frame.origin, x: frame.x, y: frame.y }
}
