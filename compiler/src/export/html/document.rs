//! What the report is made of: the report itself and the shapes it shows. Nothing is worked out here.

use glam::DVec3;

use crate::export::report::Report;
use crate::fabricate::label::Label;
use crate::fabricate::panel::Panel;
use crate::fabricate::plank::Plank;
use crate::geometry::QuadMesh;

/// Everything that `report.html` shows.
#[derive(Debug, Clone)]
pub struct Document<'a> {
    /// The figures.
    pub report: &'a Report,
    /// The shapes of each of its fabrications, in the same order.
    pub made: Vec<Made<'a>>,
    /// The figures nothing is made of.
    pub plain: Vec<Plain>,
}

/// The shapes of a fabrication, at its own scale.
#[derive(Debug, Clone)]
pub enum Made<'a> {
    /// Boards.
    Panels(PanelShapes<'a>),
    /// Planks.
    Planks(PlankShapes<'a>),
}

/// Boards and the surfaces they are made of.
#[derive(Debug, Clone)]
pub struct PanelShapes<'a> {
    /// The surfaces.
    pub surfaces: Vec<SurfaceShape<'a>>,
    /// All boards.
    pub panels: &'a [Panel],
    /// The planarity in the middle of the colour scale: what is required, else what planarizing aims at.
    pub required: f64,
}

/// A surface as designed and as built.
#[derive(Debug, Clone)]
pub struct SurfaceShape<'a> {
    /// The figure, with its place in a list of figures.
    pub name: String,
    /// As designed.
    pub designed: &'a QuadMesh,
    /// As built: the same quads.
    pub built: &'a QuadMesh,
    /// One for each quad.
    pub labels: &'a [Label],
}

/// Planks and the curves they are made of.
#[derive(Debug, Clone)]
pub struct PlankShapes<'a> {
    /// The curves.
    pub curves: Vec<CurveShape<'a>>,
    /// All planks, curve by curve.
    pub planks: &'a [Plank],
}

/// A curve of planks.
#[derive(Debug, Clone)]
pub struct CurveShape<'a> {
    /// The figure, with its place in a list of figures.
    pub name: String,
    /// Its points, mm; the first is the last again where it is closed.
    pub points: &'a [DVec3],
    /// One for each segment.
    pub labels: &'a [Label],
}

/// A figure nothing is made of, as lines and polygons. mm.
#[derive(Debug, Clone, Default)]
pub struct Plain {
    /// Polygons, each with its corners in order.
    pub polygons: Vec<Vec<DVec3>>,
    /// Chains of points.
    pub lines: Vec<Vec<DVec3>>,
    /// How many elements the figure has that are not shown.
    pub left_out: u64,
}
