//! The design in space: its boards and planks as solids, and the figures nothing is made of.

use glam::{DVec2, DVec3};

use crate::export::html::cells::Cells;
use crate::export::html::document::{Document, Made, Plain};
use crate::export::html::draw::body::{Body, paint};
use crate::export::html::draw::colour::{Srgb, WOOD};
use crate::export::html::draw::paper::{Path, group, svg};
use crate::export::html::draw::scale_bar::scale_bar;
use crate::export::html::draw::view::{Frame, View};
use crate::export::html::markup::Markup;
use crate::export::html::number::{count, counted};

/// Boards or planks drawn as solids, at most; above, boards are drawn as the quads they are made of.
const MOST_SOLIDS: usize = 1000;

/// Shapes in one drawing, at most, where they can be drawn in blocks.
pub(super) const MOST_CELLS: usize = 2500;

/// Shapes in one drawing, at most, where they cannot: a drawing of more is left out.
pub(super) const MOST_SHAPES: usize = 20_000;

/// Figures nothing is made of.
const STONE: Srgb = [0.875, 0.882, 0.862];

/// What is painted, and what is to be said about it.
#[derive(Debug, Default)]
pub(super) struct Scene {
    bodies: Vec<Body>,
    lines: Vec<Vec<DVec3>>,
    notes: Vec<String>,
}

impl Scene {
    /// What a fabrication makes.
    pub(super) fn of_made(made: &Made<'_>, colour: Srgb) -> Self {
        let mut scene = Self::default();
        scene.add_made(made, colour);
        scene
    }

    fn add_made(&mut self, made: &Made<'_>, colour: Srgb) {
        match made {
            Made::Planks(planks) if planks.planks.len() <= MOST_SHAPES => {
                let planks = planks.planks.iter();
                self.bodies
                    .extend(planks.map(|plank| Body::of_solid(&plank.solid, colour, &plank.label.alias)));
            }
            Made::Planks(planks) => {
                self.lines.extend(planks.curves.iter().map(|curve| curve.points.to_vec()));
                self.notes
                    .push(format!("Of {}, only the axes are drawn.", counted(planks.planks.len(), "plank")));
            }
            Made::Panels(panels) if panels.panels.len() <= MOST_SOLIDS => {
                let panels = panels.panels.iter();
                self.bodies
                    .extend(panels.map(|panel| Body::of_solid(&panel.solid, colour, &panel.label.alias)));
            }
            Made::Panels(panels) => {
                for surface in &panels.surfaces {
                    let cells = Cells::of(surface.labels, MOST_CELLS / panels.surfaces.len().max(1));
                    if cells.blocks().count() > MOST_SHAPES {
                        self.notes.push(left_out(&surface.name, surface.labels.len()));
                        continue;
                    }
                    let corners = cells.blocks().map(|cell| cells.corners(cell, surface.built));
                    self.bodies.extend(corners.map(|corners| Body::of_polygon(&corners, colour, None)));
                    self.notes.extend(coarser(cells));
                }
            }
        }
    }

    /// All fabrications of one scale; at 1 with the figures nothing is made of.
    pub(super) fn at_scale(document: &Document<'_>, scale: f64) -> Self {
        let mut scene = Self::default();
        for (made, fabrication) in document.made.iter().zip(&document.report.fabrications) {
            if fabrication.scale.value == scale {
                scene.add_made(made, WOOD);
            }
        }
        if scale == 1.0 {
            document.plain.iter().for_each(|plain| scene.add_plain(plain));
        }
        scene
    }

    fn add_plain(&mut self, plain: &Plain) {
        self.bodies.extend(plain.polygons.iter().map(|corners| Body::of_polygon(corners, STONE, None)));
        self.lines.extend(plain.lines.iter().cloned());
        if plain.left_out > 0 {
            let left_out = count(usize::try_from(plain.left_out).unwrap_or(usize::MAX));
            self.notes.push(format!("{left_out} further elements are in the model only (model.glb)."));
        }
    }

    /// All corners and points.
    pub(super) fn points(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.bodies.iter().flat_map(Body::corners).chain(self.lines.iter().flatten().copied())
    }

    /// Paints it in a view.
    pub(super) fn paint(&self, page: &mut Markup, frame: &Frame) {
        paint(page, frame, &self.bodies);
        let mut path = Path::default();
        for points in &self.lines {
            let points: Vec<DVec2> = points.iter().map(|point| frame.paper(*point)).collect();
            path.chain(&points, false);
        }
        if !path.is_empty() {
            group(page, "lines", |page| path.write(page, &[]));
        }
    }

    /// What is to be said about it.
    pub(super) fn notes(&self) -> String {
        self.notes.join(" ")
    }

    /// Draws it in space, with a scale bar; nothing where there is nothing to see.
    pub(super) fn picture(&self, page: &mut Markup, most: (f64, f64), title: &str, caption: &str) {
        let (width, height) = most;
        // A figure that lies flat is seen best from above.
        let (low, high) = self.points().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| {
            (low.min(point), high.max(point))
        });
        let flat = (high.z - low.z).abs() < 1e-6 * (high - low).max_element();
        let view = if flat { View::PLAN } else { View::axonometric() };
        let room = DVec2::new(width - 4.0, height - 12.0);
        let Some(frame) = Frame::fitted(view, self.points(), room) else { return };
        let frame = frame.moved_to(DVec2::new((width - frame.size.x) / 2.0, 2.0));
        let height = frame.size.y + 12.0;
        page.element("figure", &[("class", "sheet")], |page| {
            svg(page, (width, height), title, |page| {
                self.paint(page, &frame);
                scale_bar(page, DVec2::new(3.0, height - 5.5), frame.scale);
            });
            let notes = self.notes();
            let caption = [caption, notes.as_str()].map(str::trim).join(" ");
            page.texts("figcaption", &[], caption.trim());
        });
    }
}

/// What is said where quads are drawn in blocks.
pub(super) fn coarser(cells: Cells) -> Option<String> {
    let block = cells.block;
    (block > 1).then(|| format!("Drawn coarser: each field stands for {block} by {block} boards."))
}

/// What is said where a drawing is left out.
pub(super) fn left_out(name: &str, quads: usize) -> String {
    format!("{name} has {} and no rows: it is in the model only (model.glb).", counted(quads, "quad"))
}
