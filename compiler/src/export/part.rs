//! One board or plank as lists and reports give it: the same figures in the cut list and in the report.

use serde::Serialize;

use super::number::Fixed;
use crate::fabricate::label::Label;
use crate::fabricate::panel::{Grain, Panel};
use crate::fabricate::plank::Plank;

/// A board or plank, or one that was refused. What does not apply is none: null in JSON, an empty cell in CSV.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Part {
    /// The IFS address.
    pub address: String,
    /// The short name, as engraved.
    pub alias: String,
    /// The figure it is part of.
    pub figure: String,
    /// The name of its material.
    pub material: String,
    /// What the figure was scaled by: 1 for the building. The lengths here are those of what is made.
    pub scale: Fixed,
    /// Of a board, along x of its outline; of a plank, on the axis.
    pub length_mm: Option<Fixed>,
    /// The shorter face of a plank.
    pub inner_length_mm: Option<Fixed>,
    /// The longer face of a plank.
    pub outer_length_mm: Option<Fixed>,
    /// Of a board, along y of its outline; of a plank, in the plane of the curve.
    pub width_mm: Option<Fixed>,
    /// Of a board its thickness; of a plank, square to the plane of the curve.
    pub thickness_mm: Option<Fixed>,
    /// Of the outline.
    pub area_m2: Option<Fixed>,
    /// Where the material has a density.
    pub mass_kg: Option<Fixed>,
    /// The four sides of a board.
    pub edges_mm: Option<[Fixed; 4]>,
    /// The bevel at each side of a board; none on the border.
    pub bevels_deg: [Option<Fixed>; 4],
    /// The end cuts of a plank, at its start and its end.
    pub mitres_deg: Option<[Fixed; 2]>,
    /// The addresses of its neighbours: across each side of a board; before and after a plank.
    pub neighbours: Vec<Option<String>>,
    /// The diagonal a board is split along.
    pub diagonal_mm: Option<Fixed>,
    /// The angle between the two triangles of a board.
    pub fold_deg: Option<Fixed>,
    /// The cosine; 1 is flat.
    pub planarity: Option<Fixed>,
    /// None for a flat board and for planks.
    pub bend_radius_mm: Option<Fixed>,
    /// How far planarizing moved the corner it moved most.
    pub moved_mm: Option<Fixed>,
    /// `u`, `v`, `free`, or `axis` for planks.
    pub grain: Option<&'static str>,
    /// The sheet it is nested on.
    pub sheet: Option<String>,
    /// The files made for it, in the output folder.
    pub files: Vec<String>,
    /// `made`, or why not.
    pub status: String,
}

impl Part {
    /// The figures of a board. Scale, files, sheet and status are the caller's: 1, empty, none and `made`.
    #[must_use]
    pub fn of_panel(panel: &Panel, figure: &str, material: &str, grain: Grain) -> Self {
        let size = panel.size();
        Self {
            length_mm: Some(Fixed::mm(size.x)),
            width_mm: Some(Fixed::mm(size.y)),
            thickness_mm: Some(Fixed::mm(panel.thickness)),
            area_m2: Some(Fixed::square_metres(panel.area)),
            mass_kg: panel.mass.map(Fixed::kilograms),
            edges_mm: Some(panel.edges.map(Fixed::mm)),
            bevels_deg: panel.bevels.map(|bevel| bevel.map(Fixed::degrees)),
            neighbours: panel.neighbours.to_vec(),
            diagonal_mm: Some(Fixed::mm(panel.diagonal)),
            fold_deg: Some(Fixed::degrees(panel.fold)),
            planarity: Some(Fixed::planarity(panel.planarity)),
            bend_radius_mm: panel.bend_radius.map(Fixed::mm),
            moved_mm: Some(Fixed::mm(panel.moved)),
            grain: Some(match grain {
                Grain::U => "u",
                Grain::V => "v",
                Grain::Free => "free",
            }),
            ..Self::named(&panel.label, figure, material, "made")
        }
    }

    /// The figures of a plank. Scale, files, sheet and status are the caller's: 1, empty, none and `made`.
    #[must_use]
    pub fn of_plank(plank: &Plank, figure: &str, material: &str) -> Self {
        Self {
            length_mm: Some(Fixed::mm(plank.length)),
            inner_length_mm: Some(Fixed::mm(plank.inner_length)),
            outer_length_mm: Some(Fixed::mm(plank.outer_length)),
            width_mm: Some(Fixed::mm(plank.depth)),
            thickness_mm: Some(Fixed::mm(plank.width)),
            area_m2: Some(Fixed::square_metres(plank.length * plank.depth)),
            mass_kg: plank.mass.map(Fixed::kilograms),
            mitres_deg: Some(plank.mitres.map(Fixed::degrees)),
            neighbours: plank.neighbours.to_vec(),
            grain: Some("axis"),
            ..Self::named(&plank.label, figure, material, "made")
        }
    }

    /// A part that was refused: its names and the reason.
    #[must_use]
    pub fn refused(label: &Label, figure: &str, material: &str, reason: &str) -> Self {
        Self::named(label, figure, material, &format!("refused: {reason}"))
    }

    fn named(label: &Label, figure: &str, material: &str, status: &str) -> Self {
        Self {
            address: label.address.clone(),
            alias: label.alias.clone(),
            figure: figure.to_owned(),
            material: material.to_owned(),
            scale: Fixed::ratio(1.0),
            length_mm: None,
            inner_length_mm: None,
            outer_length_mm: None,
            width_mm: None,
            thickness_mm: None,
            area_m2: None,
            mass_kg: None,
            edges_mm: None,
            bevels_deg: [None; 4],
            mitres_deg: None,
            neighbours: Vec::new(),
            diagonal_mm: None,
            fold_deg: None,
            planarity: None,
            bend_radius_mm: None,
            moved_mm: None,
            grain: None,
            sheet: None,
            files: Vec::new(),
            status: status.to_owned(),
        }
    }
}
