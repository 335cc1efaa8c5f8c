//! Maps: the surfaces of a fabrication in space, each quad in the colour of what it measures.

use glam::{DVec2, DVec3};

use super::scene::{MOST_CELLS, MOST_SHAPES, coarser, left_out};
use crate::export::html::cells::Cells;
use crate::export::html::document::{PanelShapes, SurfaceShape};
use crate::export::html::draw::body::{Body, paint};
use crate::export::html::draw::colour::Srgb;
use crate::export::html::draw::paper::svg;
use crate::export::html::draw::view::{Frame, View};
use crate::export::html::markup::Markup;
use crate::geometry::QuadMesh;

/// The surfaces of a fabrication ready to be drawn, all in one frame.
pub(super) struct Maps<'a> {
    surfaces: Vec<(&'a SurfaceShape<'a>, Cells)>,
    notes: Vec<String>,
}

/// What is said of a quad: by its surface and its place there.
pub(super) type Measure<'m> = &'m dyn Fn(&SurfaceShape<'_>, usize) -> Option<f64>;

impl<'a> Maps<'a> {
    /// The surfaces of a fabrication, without those of too many quads to draw.
    pub(super) fn of(panels: &'a PanelShapes<'a>) -> Self {
        let most = MOST_CELLS / panels.surfaces.len().max(1);
        let mut maps = Self { surfaces: Vec::new(), notes: Vec::new() };
        for surface in &panels.surfaces {
            let cells = Cells::of(surface.labels, most);
            if cells.blocks().count() > MOST_SHAPES {
                maps.notes.push(left_out(&surface.name, surface.labels.len()));
                continue;
            }
            maps.notes
                .extend(coarser(cells).map(|note| format!("{note} It has the colour of its largest value.")));
            maps.surfaces.push((surface, cells));
        }
        maps
    }

    /// What is to be said about them.
    pub(super) fn notes(&self) -> String {
        self.notes.join(" ")
    }

    /// The largest value of a quad.
    pub(super) fn largest(&self, measure: Measure<'_>) -> f64 {
        let values = self
            .surfaces
            .iter()
            .flat_map(|(surface, _)| (0..surface.labels.len()).filter_map(|quad| measure(surface, quad)));
        values.fold(0.0, f64::max)
    }

    fn points(&self) -> impl Iterator<Item = DVec3> + '_ {
        let meshes = self.surfaces.iter().flat_map(|(surface, _)| [surface.designed, surface.built]);
        meshes.flat_map(|mesh| mesh.vertices.iter().copied())
    }

    /// Draws one map: `mesh` gives the shape, `measure` a value for each quad, `colour` its colour, and `words` what a
    /// pointer over it is told.
    pub(super) fn draw(
        &self,
        page: &mut Markup,
        (title, most): (&str, (f64, f64)),
        mesh: fn(&SurfaceShape<'a>) -> &'a QuadMesh,
        measure: Measure<'_>,
        (colour, words): (&dyn Fn(Option<f64>) -> Srgb, &dyn Fn(Option<f64>) -> String),
    ) {
        let room = DVec2::new(most.0 - 2.0, most.1 - 2.0);
        let Some(frame) = Frame::fitted(View::axonometric(), self.points(), room) else { return };
        let frame = frame.moved_to(DVec2::new((most.0 - frame.size.x) / 2.0, 1.0));
        let bodies: Vec<Body> = self
            .surfaces
            .iter()
            .flat_map(|(surface, cells)| {
                let mesh = mesh(surface);
                cells.blocks().map(move |cell| {
                    let values = cells.members(cell).map(|quad| measure(surface, quad));
                    // A quad that has no value is the worst of its block.
                    let value = values.reduce(|worst, found| Some(worst?.max(found?))).flatten();
                    let name = cells.members(cell).next().and_then(|quad| surface.labels.get(quad));
                    let title = name
                        .filter(|_| cells.block == 1)
                        .map(|label| format!("{}: {}", label.alias, words(value)));
                    Body::of_polygon(&cells.corners(cell, mesh), colour(value), title.as_deref())
                })
            })
            .collect();
        svg(page, (most.0, frame.size.y + 2.0), title, |page| {
            let count = bodies.len().to_string();
            page.element("g", &[("class", "map"), ("data-fields", &count)], |page| {
                paint(page, &frame, &bodies)
            });
        });
    }
}
