//! One board or plank as lists and reports give it: the same figures in the cut list and in the report.

use glam::DVec2;
use serde::Serialize;

use super::number::Fixed;
use crate::fabricate::label::Label;
use crate::fabricate::panel::{Edges, Grain, Panel};
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
    /// Of the design outline of a board; of a plank, length by depth.
    pub area_m2: Option<Fixed>,
    /// Where the material has a density.
    pub mass_kg: Option<Fixed>,
    /// The four sides of a board.
    pub edges_mm: Option<[Fixed; 4]>,
    /// The bevel at each side of a board; none on the border.
    pub bevels_deg: [Option<Fixed>; 4],
    /// `square`, `bevelled` or `stepped`: how the edges of a board are cut.
    pub edge_cut: Option<&'static str>,
    /// How far the outer face of a board (of stepped edges, the outer half) reaches out of the design outline.
    pub top_offsets_mm: Option<[Fixed; 4]>,
    /// The same of its inner face or half.
    pub bottom_offsets_mm: Option<[Fixed; 4]>,
    /// How much of each corner of a board is to be cut back where four or more meet.
    pub relief_mm: Option<[Fixed; 4]>,
    /// How far each corner of a board stops short of its neighbours there.
    pub corner_gaps_mm: Option<[Fixed; 4]>,
    /// The end cuts of a plank in the plane of the curve, at its start and its end.
    pub mitres_deg: Option<[Fixed; 2]>,
    /// How much they lean out of square to that plane.
    pub end_bevels_deg: Option<[Fixed; 2]>,
    /// The addresses of its neighbours: across each side of a board; before and after a plank.
    pub neighbours: Vec<Option<String>>,
    /// Which side of that board it is; for boards.
    pub neighbour_edges: Vec<Option<u8>>,
    /// The ring it is put up in, from 0: those on the supports.
    pub ring: Option<u32>,
    /// Its place in the order of assembly of the block, from 1.
    pub order: Option<u32>,
    /// Its centre of gravity in space.
    pub centre_mm: Option<[Fixed; 3]>,
    /// What a machine cuts: corners counter-clockwise seen from outside, the lower left of their box at the origin.
    pub outline_mm: Vec<[Fixed; 2]>,
    /// The design outline of a board, in the same frame.
    pub design_outline_mm: Vec<[Fixed; 2]>,
    /// The outline of its outer face or half.
    pub top_outline_mm: Vec<[Fixed; 2]>,
    /// The outline of its inner face or half.
    pub bottom_outline_mm: Vec<[Fixed; 2]>,
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
            edge_cut: Some(match panel.edge_cut {
                Edges::Square => "square",
                Edges::Bevelled => "bevelled",
                Edges::Stepped => "stepped",
            }),
            top_offsets_mm: Some(panel.offsets.map(|offset| Fixed::mm(offset.top))),
            bottom_offsets_mm: Some(panel.offsets.map(|offset| Fixed::mm(offset.bottom))),
            relief_mm: Some(panel.relief.map(Fixed::mm)),
            corner_gaps_mm: Some(panel.corner_gaps.map(Fixed::mm)),
            neighbours: panel.neighbours.to_vec(),
            neighbour_edges: panel.neighbour_sides.to_vec(),
            ring: Some(panel.ring),
            order: Some(panel.order),
            centre_mm: Some(panel.centre.to_array().map(Fixed::mm)),
            outline_mm: points(&panel.outline),
            design_outline_mm: points(&panel.design_outline),
            top_outline_mm: points(&panel.top_outline),
            bottom_outline_mm: points(&panel.bottom_outline),
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
            end_bevels_deg: Some(plank.bevels.map(Fixed::degrees)),
            neighbours: plank.neighbours.to_vec(),
            ring: Some(plank.ring),
            order: Some(plank.order),
            centre_mm: Some(plank.centre.to_array().map(Fixed::mm)),
            outline_mm: points(&plank.outline),
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
            edge_cut: None,
            top_offsets_mm: None,
            bottom_offsets_mm: None,
            relief_mm: None,
            corner_gaps_mm: None,
            mitres_deg: None,
            end_bevels_deg: None,
            neighbours: Vec::new(),
            neighbour_edges: Vec::new(),
            ring: None,
            order: None,
            centre_mm: None,
            outline_mm: Vec::new(),
            design_outline_mm: Vec::new(),
            top_outline_mm: Vec::new(),
            bottom_outline_mm: Vec::new(),
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

fn points(outline: &[DVec2]) -> Vec<[Fixed; 2]> {
    outline.iter().map(|corner| corner.to_array().map(Fixed::mm)).collect()
}
