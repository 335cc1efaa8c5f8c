//! Measuring, unrolling and placing the quads of a mesh: from a mesh to its panels.

use glam::{DVec2, DVec3};

use super::edges::{EdgeOffsets, Edges, Vanished, area, moved_out};
use super::flat::FlatBoard;
use super::thicken::Bending;
use super::together::Together;
use super::{Face, Grain, Panel, PanelError, PanelRefusal, PanelSettings, Panels, RefusedPanel};
use crate::fabricate::fit;
use crate::fabricate::label::Label;
use crate::fabricate::solid::Solid;
use crate::geometry::{
    Diagonal, QuadMeasure, QuadMesh, Topology, UnrolledQuad, Verdict, edge_dihedral, unroll,
};

/// Sides whose lengths differ by less than this fraction count as equally long, so that rounding does not choose.
const SIDE_TIE: f64 = 1e-9;

/// Makes a board of each quad of `planarized`, which has the quads of `designed` on vertices that may have moved.
/// `labels` has one entry for each quad.
///
/// # Errors
/// No thickness, no sheet, meshes that differ in their quads, a wrong number of labels. A quad which cannot be made
/// is in [`Panels::refused`], with its reason.
pub fn panels(
    designed: &QuadMesh,
    planarized: &QuadMesh,
    labels: &[Label],
    settings: &PanelSettings,
) -> Result<Panels, PanelError> {
    let thickness = check(designed, planarized, labels, settings)?;
    let topology = planarized.topology().map_err(|_| PanelError::DifferentMeshes)?;
    let measures: Vec<QuadMeasure> =
        (0..planarized.quads.len()).map(|quad| QuadMeasure::of(planarized.corners_of(quad))).collect();
    let splits: Vec<Diagonal> = measures.iter().map(|measure| measure.split).collect();
    let maker = Maker { designed, planarized, labels, settings, thickness, topology, measures, splits };
    let mut made = Panels::default();
    let mut quads = Vec::with_capacity(labels.len());
    for (quad, label) in labels.iter().enumerate() {
        match maker.panel(quad) {
            Ok(panel) => {
                made.panels.push(panel);
                quads.push(quad);
            }
            Err(reason) => made.refused.push(RefusedPanel { label: label.clone(), reason }),
        }
    }
    let together = Together { mesh: planarized, topology: &maker.topology, quads: &quads };
    together.compare_corners(&mut made, settings.side.faces(thickness));
    together.put_in_order(&mut made.panels);
    Ok(made)
}

/// What can be said before any quad is looked at; the thickness.
fn check(
    designed: &QuadMesh,
    planarized: &QuadMesh,
    labels: &[Label],
    settings: &PanelSettings,
) -> Result<f64, PanelError> {
    let thickness = settings.material.thickness.filter(|thickness| *thickness > 0.0 && thickness.is_finite());
    let Some(thickness) = thickness else { return Err(PanelError::NoThickness) };
    let (length, width) = settings.board;
    if !(length > 0.0 && width > 0.0) {
        return Err(PanelError::NoBoard { board: settings.board });
    }
    if designed.quads != planarized.quads || designed.vertices.len() != planarized.vertices.len() {
        return Err(PanelError::DifferentMeshes);
    }
    if labels.len() != planarized.quads.len() {
        return Err(PanelError::WrongLabelCount { quads: planarized.quads.len(), labels: labels.len() });
    }
    Ok(thickness)
}

/// What every board of a figure is made from.
struct Maker<'a> {
    designed: &'a QuadMesh,
    planarized: &'a QuadMesh,
    labels: &'a [Label],
    settings: &'a PanelSettings,
    thickness: f64,
    topology: Topology,
    measures: Vec<QuadMeasure>,
    splits: Vec<Diagonal>,
}

impl Maker<'_> {
    fn panel(&self, quad: usize) -> Result<Panel, PanelRefusal> {
        let measure = &self.measures[quad];
        let corners = self.planarized.corners_of(quad);
        let (planarity, fold) = convex(measure)?;
        let unrolled = unroll(corners, measure.split).map_err(PanelRefusal::Unroll)?;
        let (design, x_axis) = placed(&unrolled, &measure.edges, self.settings.grain);
        let bevels = [0, 1, 2, 3].map(|side| self.bevel(quad, side));
        let outlines = self.outlines(design, bevels)?;
        self.check_size(&outlines.cut)?;
        let bend_radius = unrolled.bend.radius();
        let grain_known = self.settings.grain != Grain::Free;
        let solid =
            Bending::of(&corners, &outlines.design, measure.split).bend(self.flat(&outlines, measure.split));
        let volume = outlines.volume(self.settings.edges, self.thickness);
        let across = self.topology.neighbours(quad);
        Ok(Panel {
            label: self.labels[quad].clone(),
            corners,
            split: measure.split,
            outline: outlines.cut.to_vec(),
            design_outline: outlines.design,
            top_outline: outlines.top,
            bottom_outline: outlines.bottom,
            edge_cut: self.settings.edges,
            offsets: outlines.offsets,
            edges: measure.edges,
            bevels,
            neighbours: across.map(|across| Some(self.labels.get(across?.quad as usize)?.address.clone())),
            neighbour_sides: across.map(|across| Some(across?.side)),
            relief: [0.0; 4],
            corner_gaps: [0.0; 4],
            ring: 0,
            order: 0,
            diagonal: measure.diagonals[usize::from(measure.split == Diagonal::Bd)],
            fold,
            planarity,
            diagonal_ratio: measure.diagonal_ratio,
            bend_radius,
            bend_axis_to_grain: bend_radius.filter(|_| grain_known).map(|_| unrolled.bend.angle_to(x_axis)),
            area: measure.area,
            thickness: self.thickness,
            volume,
            mass: self.settings.material.density.map(|density| density * volume),
            centre: solid.centre(),
            moved: self.moved(quad, corners),
            solid,
        })
    }

    /// The outlines of a board with these bevels, in one frame, the lower left of the cut one at the origin.
    fn outlines(&self, design: [DVec2; 4], bevels: [Option<f64>; 4]) -> Result<Outlines, PanelRefusal> {
        let faces = self.settings.side.faces(self.thickness);
        let offsets = bevels.map(|bevel| self.settings.edges.offsets(bevel, faces));
        let face = |face: Face, distances: [f64; 4]| {
            moved_out(&design, distances).map_err(|vanished| match vanished {
                Vanished::Side(side, _) => {
                    let bevel = bevels.iter().flatten().fold(0.0, |most: f64, bevel| most.max(bevel.abs()));
                    PanelRefusal::SideVanishes { face, side, bevel }
                }
                Vanished::Corner(corner) => PanelRefusal::NoCorner { sides: [(corner + 3) % 4, corner] },
            })
        };
        let top = face(Face::Top, offsets.map(|offset| offset.top))?;
        let bottom = face(Face::Bottom, offsets.map(|offset| offset.bottom))?;
        let cut = face(Face::Top, offsets.map(EdgeOffsets::cut))?;
        let (low, _) = fit::bounds(&cut);
        let [design, top, bottom, cut] =
            [design, top, bottom, cut].map(|outline| outline.map(|corner| corner - low));
        Ok(Outlines { design, top, bottom, cut, offsets })
    }

    fn flat(&self, outlines: &Outlines, split: Diagonal) -> Solid {
        let board = FlatBoard {
            design: &outlines.design,
            top: &outlines.top,
            bottom: &outlines.bottom,
            offsets: &outlines.offsets,
            faces: self.settings.side.faces(self.thickness),
            split,
        };
        match self.settings.edges {
            Edges::Stepped => board.stepped().unwrap_or_else(|| board.straight()),
            Edges::Square | Edges::Bevelled => board.straight(),
        }
    }

    fn check_size(&self, outline: &[DVec2]) -> Result<(), PanelRefusal> {
        let (length, width) = self.settings.board;
        let fits = match self.settings.grain {
            Grain::Free => fit::fits_turned(outline, length, width),
            Grain::U | Grain::V => fit::fits_as_it_lies(outline, length, width),
        };
        let (low, high) = fit::bounds(outline);
        if fits {
            Ok(())
        } else {
            Err(PanelRefusal::TooLarge { size: high - low, board: self.settings.board })
        }
    }

    fn bevel(&self, quad: usize, side: usize) -> Option<f64> {
        let edge = self.topology.quad_edges[quad][side]?;
        let edge = &self.topology.edges[edge as usize];
        Some(edge_dihedral(self.planarized, edge, &self.splits)?.bevel())
    }

    fn moved(&self, quad: usize, corners: [DVec3; 4]) -> f64 {
        let before = self.designed.corners_of(quad);
        corners.iter().zip(before).map(|(now, then)| now.distance(then)).fold(0.0, f64::max)
    }
}

/// Planarity and fold of a convex quad; the reason for any other.
fn convex(measure: &QuadMeasure) -> Result<(f64, f64), PanelRefusal> {
    match measure.verdict {
        Verdict::Convex => measure.planarity.zip(measure.fold()).ok_or(PanelRefusal::Degenerate),
        Verdict::Dart => Err(PanelRefusal::Dart),
        Verdict::CollinearCorner => Err(PanelRefusal::CollinearCorner),
        Verdict::FoldedOver => Err(PanelRefusal::FoldedOver),
        Verdict::Degenerate => Err(PanelRefusal::Degenerate),
    }
}

/// The unrolled quad turned so that the side along the grain, or the longest, runs along x; and the x axis in the
/// frame of the unrolled corners.
fn placed(unrolled: &UnrolledQuad, edges: &[f64; 4], grain: Grain) -> ([DVec2; 4], DVec2) {
    let side = match grain {
        Grain::U => 0,
        Grain::V => 1,
        Grain::Free => longest(edges),
    };
    let flat = &unrolled.corners;
    let x = (flat[(side + 1) % 4] - flat[side]).normalize_or(DVec2::X);
    (flat.map(|corner| DVec2::new(x.dot(corner - flat[side]), x.perp_dot(corner - flat[side]))), x)
}

/// The outlines of one board, in one frame, mm.
struct Outlines {
    design: [DVec2; 4],
    top: [DVec2; 4],
    bottom: [DVec2; 4],
    cut: [DVec2; 4],
    offsets: [EdgeOffsets; 4],
}

impl Outlines {
    /// Of the board between them, mm³. Between faces whose sides are parallel the area changes with the square of the
    /// height, so Simpson's rule is exact.
    fn volume(&self, edges: Edges, thickness: f64) -> f64 {
        let (top, bottom) = (area(&self.top), area(&self.bottom));
        match edges {
            Edges::Square | Edges::Stepped => (top + bottom) / 2.0 * thickness,
            Edges::Bevelled => {
                let middle = [0, 1, 2, 3].map(|corner| self.top[corner].midpoint(self.bottom[corner]));
                (top + 4.0 * area(&middle) + bottom) / 6.0 * thickness
            }
        }
    }
}

/// The longest side, the first of equals.
fn longest(edges: &[f64; 4]) -> usize {
    (1..4).fold(0, |best, side| if edges[side] > edges[best] * (1.0 + SIDE_TIE) { side } else { best })
}
