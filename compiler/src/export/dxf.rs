//! Drawings in the plane as DXF of AutoCAD 2000 (AC1015), in millimetres: layers, polylines with arcs, lines, circles
//! and text. What is drawn is said by whoever draws: `outputs` for boards and sheets. How tags are written is in `write`,
//! how texts are escaped in `text`.
//!
//! A drawing holds no time stamp and no name of a user or program's version, so the same drawing is the same bytes.

mod text;
mod write;

#[cfg(test)]
mod tests;

use std::io;

use glam::DVec2;

/// A colour of a layer, by its AutoCAD colour index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Colour {
    /// 1
    Red,
    /// 3
    Green,
    /// 5
    Blue,
    /// 6
    Magenta,
    /// 7: black on paper, white on a dark screen.
    Black,
    /// 8
    Grey,
}

impl Colour {
    fn index(self) -> u8 {
        match self {
            Colour::Red => 1,
            Colour::Green => 3,
            Colour::Blue => 5,
            Colour::Magenta => 6,
            Colour::Black => 7,
            Colour::Grey => 8,
        }
    }
}

/// A layer of the drawing that gave it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layer(usize);

/// A corner of a polyline and what leads from it to the next one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// mm.
    pub at: DVec2,
    /// The tangent of a quarter of the angle of the arc to the next corner, positive anticlockwise; 0 for a straight
    /// side, 1 for half a circle to the right of the way.
    pub bulge: f64,
}

impl From<DVec2> for Vertex {
    fn from(at: DVec2) -> Self {
        Self { at, bulge: 0.0 }
    }
}

/// A drawing in the plane, mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    layers: Vec<NamedLayer>,
    entities: Vec<(Layer, Entity)>,
}

#[derive(Debug, Clone, PartialEq)]
struct NamedLayer {
    name: String,
    colour: Colour,
}

#[derive(Debug, Clone, PartialEq)]
enum Entity {
    Polyline { vertices: Vec<Vertex>, closed: bool },
    Line { from: DVec2, to: DVec2 },
    Circle { centre: DVec2, radius: f64 },
    Text { at: DVec2, height: f64, turn: f64, text: String },
}

impl Drawing {
    /// The layer of this name, made where the drawing has none yet; its colour is that of the first call. Characters that
    /// CAD programs do not take in names of layers become `_`, and names are cut at 120 characters; what is the same name
    /// then, but for capitals, is the same layer.
    pub fn layer(&mut self, name: &str, colour: Colour) -> Layer {
        let name = text::layer_name(name);
        let known = self.layers.iter().position(|layer| layer.name.eq_ignore_ascii_case(&name));
        Layer(known.unwrap_or_else(|| {
            self.layers.push(NamedLayer { name, colour });
            self.layers.len() - 1
        }))
    }

    /// An outline of straight sides that closes itself.
    pub fn outline(&mut self, layer: Layer, corners: &[DVec2]) {
        self.polyline(layer, corners.iter().map(|&corner| corner.into()).collect(), true);
    }

    /// A pen stroke: straight sides from the first point to the last.
    pub fn stroke(&mut self, layer: Layer, points: &[DVec2]) {
        self.polyline(layer, points.iter().map(|&point| point.into()).collect(), false);
    }

    /// Straight sides and arcs. One of fewer than two corners is left out: it has no length.
    pub fn polyline(&mut self, layer: Layer, vertices: Vec<Vertex>, closed: bool) {
        if vertices.len() > 1 {
            self.entities.push((layer, Entity::Polyline { vertices, closed }));
        }
    }

    /// A straight line.
    pub fn line(&mut self, layer: Layer, from: DVec2, to: DVec2) {
        self.entities.push((layer, Entity::Line { from, to }));
    }

    /// A circle, as for a hole.
    pub fn circle(&mut self, layer: Layer, centre: DVec2, radius: f64) {
        self.entities.push((layer, Entity::Circle { centre, radius }));
    }

    /// A line of text from `at` on its baseline, its capitals `height` high, turned by `turn` rad anticlockwise. It is for
    /// people: the font is the reader's. Strokes that a machine follows are polylines.
    pub fn text(&mut self, layer: Layer, at: DVec2, height: f64, turn: f64, text: &str) {
        self.entities.push((layer, Entity::Text { at, height, turn, text: text.to_owned() }));
    }

    /// Writes the file.
    ///
    /// # Errors
    /// Those of `out`; a coordinate that is not finite.
    pub fn write(&self, out: &mut dyn io::Write) -> io::Result<()> {
        write::write(self, out)
    }
}
