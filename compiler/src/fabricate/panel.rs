//! Flat boards from the quads of a mesh: what a [`Panel`] holds, the settings, and why one is refused. How it is made
//! is in `make`, its solid in `thicken`. What a machine cuts (cut outlines, toolpaths) is not here.

mod make;
mod thicken;

use std::fmt;

use glam::{DVec2, DVec3};

use super::label::Label;
use super::material::Material;
use super::solid::Solid;
use crate::geometry::{Diagonal, UnrollError};

pub use make::panels;

/// Where the design surface lies in the thickness of a board. Outside is where the normals of the mesh point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The surface is the inner face: the board lies outside it.
    Inner,
    /// The surface is halfway between the faces.
    Centred,
    /// The surface is the outer face: the board lies inside it.
    Outer,
}

/// The direction of the grain in a board. The grain of a sheet runs along its length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grain {
    /// Along the first side AB, the direction in which rows are counted.
    U,
    /// Along the second side BC, the direction in which columns are counted.
    V,
    /// Any direction: boards may be turned on the sheet at will.
    Free,
}

/// How the quads of one figure become boards.
#[derive(Debug, Clone, PartialEq)]
pub struct PanelSettings {
    /// What they are cut from; it needs a thickness.
    pub material: Material,
    /// Length (along the grain) and width of the sheet, mm.
    pub board: (f64, f64),
    /// Where the design surface lies.
    pub side: Side,
    /// The direction of the grain.
    pub grain: Grain,
}

/// A flat board for one quad. Sides are numbered 0 (AB), 1 (BC), 2 (CD), 3 (DA).
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Address, alias, row and column.
    pub label: Label,
    /// Corners A, B, C, D of the planarized quad in space, mm.
    pub corners: [DVec3; 4],
    /// The diagonal it is split along: the one with the smaller fold.
    pub split: Diagonal,
    /// The design outline: the unrolled quad A, B, C, D counter-clockwise seen from outside, mm. The lower left of
    /// its box is the origin; along x runs the grain (side AB for [`Grain::U`], BC for [`Grain::V`]), or the longest
    /// side for [`Grain::Free`].
    pub outline: Vec<DVec2>,
    /// Lengths of the four sides, mm.
    pub edges: [f64; 4],
    /// The bevel (π − δ)/2 at each side, rad: positive on ridges, negative in valleys, none on the border
    /// (GEOMETRY section 8).
    pub bevels: [Option<f64>; 4],
    /// The address of the board across each side; none on the border.
    pub neighbours: [Option<String>; 4],
    /// Length of the diagonal it is split along, mm.
    pub diagonal: f64,
    /// The angle between the two triangles, rad.
    pub fold: f64,
    /// The cosine of GEOMETRY section 5: 1 is flat.
    pub planarity: f64,
    /// Distance of the diagonals by their mean length; none where they are parallel.
    pub diagonal_ratio: Option<f64>,
    /// The radius to which the flat board bends to follow the quad, mm; none for a flat one (GEOMETRY section 7).
    pub bend_radius: Option<f64>,
    /// The angle between the axis of that bend and the grain, rad, 0 ..= π/2; none for a flat board and for
    /// [`Grain::Free`].
    pub bend_axis_to_grain: Option<f64>,
    /// Area of the two triangles, mm².
    pub area: f64,
    /// mm.
    pub thickness: f64,
    /// kg; none where the material has no density.
    pub mass: Option<f64>,
    /// How far planarizing moved the corner it moved most, mm.
    pub moved: f64,
    /// The board in space, with its thickness, its sides square to its faces.
    pub solid: Solid,
}

impl Panel {
    /// The size of the box around the outline, mm.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        let (low, high) = super::fit::bounds(&self.outline);
        high - low
    }

    /// The least distance of two parallel lines with the outline between them, mm.
    #[must_use]
    pub fn least_width(&self) -> f64 {
        super::fit::least_width(&self.outline)
    }

    /// The interior angles of the outline at A, B, C, D, rad.
    #[must_use]
    pub fn angles(&self) -> [f64; 4] {
        let corner = |index: usize| self.outline.get(index % 4).copied().unwrap_or_default();
        [0, 1, 2, 3].map(|at| {
            let (out, back) = (corner(at + 1) - corner(at), corner(at + 3) - corner(at));
            libm::atan2(out.perp_dot(back), out.dot(back))
        })
    }
}

/// The boards of one figure and those that cannot be made. Both in the order of the quads.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Panels {
    /// The boards.
    pub panels: Vec<Panel>,
    /// The quads no board can be made for.
    pub refused: Vec<RefusedPanel>,
}

/// A quad no board can be made for.
#[derive(Debug, Clone, PartialEq)]
pub struct RefusedPanel {
    /// Address, alias, row and column.
    pub label: Label,
    /// Why.
    pub reason: PanelRefusal,
}

/// Why no board can be made for a quad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PanelRefusal {
    /// One of its corners is reflex.
    Dart,
    /// Three neighbouring corners lie on a line.
    CollinearCorner,
    /// Folded over a diagonal by a right angle or more, or crossing itself.
    FoldedOver,
    /// A side, a diagonal or the whole quad without length or area.
    Degenerate,
    /// It cannot be unrolled.
    Unroll(UnrollError),
    /// Larger than the sheet in every way the grain lets it lie. mm.
    TooLarge {
        /// The box around its outline as it is placed.
        size: DVec2,
        /// Length and width of the sheet.
        board: (f64, f64),
    },
}

impl fmt::Display for PanelRefusal {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dart => out.write_str("one of its corners is reflex"),
            Self::CollinearCorner => out.write_str("three of its corners lie on a line"),
            Self::FoldedOver => out.write_str("it is folded over a diagonal"),
            Self::Degenerate => out.write_str("it has no area, or a side without length"),
            Self::Unroll(reason) => reason.fmt(out),
            Self::TooLarge { size, board: (length, width) } => write!(
                out,
                "it measures {:.1}mm by {:.1}mm and does not fit a board of {length}mm by {width}mm",
                size.x, size.y
            ),
        }
    }
}

/// Why no boards at all can be made of a figure.
#[derive(Debug, Clone, PartialEq)]
pub enum PanelError {
    /// The material has no thickness, or one that is not above 0.
    NoThickness,
    /// The sheet has a side that is not above 0, mm.
    NoBoard {
        /// Length and width as given.
        board: (f64, f64),
    },
    /// The designed and the planarized mesh are not the same quads on the same vertices.
    DifferentMeshes,
    /// Not one label for each quad.
    WrongLabelCount {
        /// How many quads there are.
        quads: usize,
        /// How many labels.
        labels: usize,
    },
}

impl fmt::Display for PanelError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoThickness => out.write_str("boards need a material with a thickness above 0mm"),
            Self::NoBoard { board: (length, width) } => {
                write!(out, "a board of {length}mm by {width}mm has no area")
            }
            Self::DifferentMeshes => {
                out.write_str("the designed and the planarized surface have different quads")
            }
            Self::WrongLabelCount { quads, labels } => write!(out, "{labels} labels for {quads} quads"),
        }
    }
}

impl std::error::Error for PanelError {}

#[cfg(test)]
mod tests;
