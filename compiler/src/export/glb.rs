//! `model.glb`: glTF 2.0, in metres and Y up. Designs are millimetres and Z up; the positions themselves are turned,
//! (x, y, z) mm to (x, z, −y) m, so no node carries a rotation. What the nodes are is in `nodes`, how the binary part
//! is laid out in `layout`, its bytes in `piece`.
//!
//! One node for each figure, and below it:
//! - `…/curve` each curve as a line strip;
//! - `…/surface` a surface without boards: triangles along the diagonal of the smaller fold, and its quads' edges;
//! - `…/pieces` a figure of separate pieces: points as points, segments as lines, polygons and meshes as triangles with
//!   their edges, struts as bars. Its extras are a table of addresses with the vertices of each, up to
//!   [`MAX_PART_NODES`] elements; elements stand in the order of their words.
//! - `…/designed`, `…/planarized` a surface with boards: the same, coloured by planarity, moved beside the boards by
//!   the translation of their nodes, so that none hides another;
//! - `…/boards` and below it one closed solid for each board or plank, named by its address, with address, alias and
//!   kind as extras. Above [`MAX_PART_NODES`] of them in a model they are one mesh with a table of addresses.
//!
//! Nothing has normals: viewers then shade flat, as boards are.

pub(super) mod colour;
mod drawn;
mod edges;
mod layout;
mod nodes;
mod piece;
mod pieces;
mod split;

use std::fmt;
use std::io::{self, Write};

use glam::DVec3;

use crate::fabricate::label::Label;
use crate::fabricate::panel::Panel;
use crate::fabricate::plank::Plank;
use crate::fabricate::solid::Solid;
use crate::geometry::QuadMesh;

/// With more boards and planks than this, each figure's are one mesh with a table of addresses.
pub const MAX_PART_NODES: usize = 20_000;

pub use pieces::Pieces;

/// What a model holds.
#[derive(Debug, Clone, Default)]
pub struct Model<'a> {
    /// The name of the design.
    pub design: &'a str,
    /// Its figures.
    pub figures: Vec<Figure<'a>>,
}

/// A figure and what was made of it. A figure of nothing gets no node.
#[derive(Debug, Clone, Default)]
pub struct Figure<'a> {
    /// Its name.
    pub name: &'a str,
    /// Where it is written: `shell.ifs:12`.
    pub source: Option<&'a str>,
    /// Its curves.
    pub curves: Vec<Curve<'a>>,
    /// Its surfaces.
    pub surfaces: Vec<Surface<'a>>,
    /// Its separate pieces.
    pub pieces: Vec<Pieces<'a>>,
    /// Its boards or planks.
    pub parts: Vec<Part<'a>>,
}

/// A curve of a figure. One of fewer than two points gets no node.
#[derive(Debug, Clone, Copy)]
pub struct Curve<'a> {
    /// The figure's name, and its index in a list of figures: `vault.0`.
    pub address: &'a str,
    /// mm
    pub points: &'a [DVec3],
}

/// A surface of a figure. One without quads gets no node.
#[derive(Debug, Clone, Copy)]
pub struct Surface<'a> {
    /// The figure's name, and its index in a list of figures.
    pub address: &'a str,
    /// As designed.
    pub designed: &'a QuadMesh,
    /// Given for a surface with boards; then both are coloured.
    pub panelled: Option<Panelled<'a>>,
}

/// The surface from which boards are made.
#[derive(Debug, Clone, Copy)]
pub struct Panelled<'a> {
    /// With its vertices moved, or the designed one again.
    pub planarized: &'a QuadMesh,
    /// The planarity in the middle of the colour scale: what is required.
    pub required: f64,
}

/// A board or plank.
#[derive(Debug, Clone, Copy)]
pub struct Part<'a> {
    /// Its names.
    pub label: &'a Label,
    /// What it is.
    pub kind: PartKind,
    /// Its shape.
    pub solid: &'a Solid,
}

impl<'a> From<&'a Panel> for Part<'a> {
    fn from(panel: &'a Panel) -> Self {
        Self { label: &panel.label, kind: PartKind::Panel, solid: &panel.solid }
    }
}

impl<'a> From<&'a Plank> for Part<'a> {
    fn from(plank: &'a Plank) -> Self {
        Self { label: &plank.label, kind: PartKind::Plank, solid: &plank.solid }
    }
}

/// What a part is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartKind {
    /// A flat board.
    Panel,
    /// A plank.
    Plank,
}

impl PartKind {
    /// As the extras say it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Panel => "panel",
            Self::Plank => "plank",
        }
    }
}

/// Why a model cannot be written.
#[derive(Debug)]
pub enum GlbError {
    /// A coordinate is not finite, or too large for a 32-bit float in metres.
    OutOfRange,
    /// More bytes than the format can count (4 GiB), or more vertices in one mesh than 32 bits can number.
    TooLarge,
    /// The writer failed.
    Write(io::Error),
}

impl fmt::Display for GlbError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange => out.write_str("a coordinate is too large for the model"),
            Self::TooLarge => out.write_str("the model is larger than the 4 GiB a GLB file can hold"),
            Self::Write(error) => error.fmt(out),
        }
    }
}

impl std::error::Error for GlbError {}

impl From<io::Error> for GlbError {
    fn from(error: io::Error) -> Self {
        Self::Write(error)
    }
}

/// The bytes of the model.
///
/// # Errors
/// As [`write_glb`], but for the writer's.
pub fn glb(model: &Model<'_>) -> Result<Vec<u8>, GlbError> {
    let layout = nodes::lay_out(model)?;
    let header = layout.header()?;
    let mut bytes = Vec::with_capacity(header.len() + layout.binary_length() as usize);
    bytes.extend_from_slice(&header);
    layout.write_binary(&mut bytes)?;
    Ok(bytes)
}

/// Writes the model piece by piece, through a small buffer: no copy of its geometry is made on the way.
///
/// # Errors
/// Coordinates a 32-bit float cannot hold, more than 4 GiB, and the errors of `out`.
pub fn write_glb(model: &Model<'_>, out: &mut impl Write) -> Result<(), GlbError> {
    let layout = nodes::lay_out(model)?;
    out.write_all(&layout.header()?)?;
    layout.write_binary(out)
}

#[cfg(test)]
mod tests;
