//! Flat boards from the quads of a mesh: what a [`Panel`] holds and the settings. How it is made is in `make`, its
//! edges and outlines in `edges`, its solid in `flat` and `thicken`, corners of four and more boards in `relief`, and why one is
//! refused in `refusal`; what boards have to do with each other is in `together`. Toolpaths are not here.

mod edges;
mod flat;
mod make;
mod refusal;
mod relief;
mod thicken;
mod together;

use glam::{DVec2, DVec3};

use super::label::Label;
use super::material::Material;
use super::solid::Solid;
use crate::geometry::Diagonal;

pub use edges::{EdgeOffsets, Edges};
pub use make::panels;
pub use refusal::{PanelError, PanelRefusal};
pub use relief::{Corner, RELIEF_TOLERANCE};

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

impl Side {
    /// Where the inner and the outer face of a board of this thickness lie, mm along the normal from the surface.
    #[must_use]
    pub fn faces(self, thickness: f64) -> (f64, f64) {
        match self {
            Self::Inner => (0.0, thickness),
            Self::Centred => (-thickness / 2.0, thickness / 2.0),
            Self::Outer => (-thickness, 0.0),
        }
    }
}

/// A face of a board.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Face {
    /// The outer one, where the normals of the mesh point.
    Top,
    /// The inner one.
    Bottom,
}

impl Face {
    /// As people name it: `outer` or `inner`.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Top => "outer",
            Self::Bottom => "inner",
        }
    }
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
    /// How the edges are cut.
    pub edges: Edges,
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
    /// The cut outline: what a machine cuts, each side of the design outline moved out by the larger of its two
    /// offsets. A, B, C, D counter-clockwise seen from outside, mm. The lower left of its box is the origin; along x
    /// runs the grain (side AB for [`Grain::U`], BC for [`Grain::V`]), or the longest side for [`Grain::Free`].
    pub outline: Vec<DVec2>,
    /// The design outline: the unrolled quad, its sides as long as in space. In the frame of `outline`, mm.
    pub design_outline: [DVec2; 4],
    /// The outline of the outer face (of a stepped edge, of the outer half), in the frame of `outline`, mm.
    pub top_outline: [DVec2; 4],
    /// The outline of the inner face (of a stepped edge, of the inner half), in the frame of `outline`, mm.
    pub bottom_outline: [DVec2; 4],
    /// How the edges are cut.
    pub edge_cut: Edges,
    /// How far the two faces reach beside the design outline at each side.
    pub offsets: [EdgeOffsets; 4],
    /// Lengths of the four sides of the design outline, mm.
    pub edges: [f64; 4],
    /// The bevel (π − δ)/2 at each side, rad: positive on ridges, negative in valleys, none on the border
    /// (GEOMETRY section 8).
    pub bevels: [Option<f64>; 4],
    /// The address of the board across each side; none on the border.
    pub neighbours: [Option<String>; 4],
    /// Which side (0 to 3) of that board it is; none on the border.
    pub neighbour_sides: [Option<u8>; 4],
    /// How much of each corner A, B, C, D has to be cut back along its edges, mm, once the edges are bevelled: where
    /// four or more boards meet and this one reaches past its neighbours (see `relief`). 0 where nothing has to be.
    pub relief: [f64; 4],
    /// How far each corner stops short of its neighbours there, mm; 0 where it does not.
    pub corner_gaps: [f64; 4],
    /// The ring it is put up in, from 0: the boards at the supports (see `assembly`).
    pub ring: u32,
    /// Its place in the order of assembly, from 1.
    pub order: u32,
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
    /// Area of the design outline, mm².
    pub area: f64,
    /// mm.
    pub thickness: f64,
    /// Of the board as it is cut, mm³.
    pub volume: f64,
    /// kg; none where the material has no density.
    pub mass: Option<f64>,
    /// Its centre of gravity in space, mm.
    pub centre: DVec3,
    /// How far planarizing moved the corner it moved most, mm.
    pub moved: f64,
    /// The board in space, with its thickness and its edges as they are cut.
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
    /// The corners where boards have to be cut back by more than [`RELIEF_TOLERANCE`].
    pub corners: Vec<Corner>,
}

/// A quad no board can be made for.
#[derive(Debug, Clone, PartialEq)]
pub struct RefusedPanel {
    /// Address, alias, row and column.
    pub label: Label,
    /// Why.
    pub reason: PanelRefusal,
}

#[cfg(test)]
mod tests;
