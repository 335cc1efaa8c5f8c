//! Figures of separate pieces: points, lines and triangles, made while they are written, since there may be millions.

use std::convert::Infallible;
use std::io;

use glam::DVec3;
use gltf_json as json;
use json::Index;
use json::buffer::Target;
use json::mesh::Mode;
use serde::Serialize;

use super::GlbError;
use super::drawn::Drawing;
use super::layout::{Layout, Look, extras};
use super::piece::{Piece, position};
use crate::fabricate::label::Label;
use crate::plan::evaluate::PiecesEvaluator;

/// A figure of separate pieces. One of nothing gets no node.
#[derive(Debug, Clone, Copy)]
pub struct Pieces<'a> {
    /// The figure's name, and its index in a list of figures.
    pub address: &'a str,
    /// Its elements.
    pub evaluator: &'a PiecesEvaluator,
    /// One for each element, in order; none where there are too many for a table.
    pub labels: &'a [Label],
}

#[derive(Serialize)]
struct PiecesExtras<'a> {
    kind: &'static str,
    address: &'a str,
    elements: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    parts: Vec<PieceEntry<'a>>,
}

#[derive(Serialize)]
struct PieceEntry<'a> {
    kind: &'static str,
    address: &'a str,
    alias: &'a str,
    first_vertex: usize,
    vertices: usize,
}

/// What places of vertices are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Places {
    /// One a point.
    Points,
    /// Two a line.
    Lines,
    /// Three a triangle.
    Triangles,
}

/// What all elements come to, and where they lie in the model.
struct Sum {
    elements: usize,
    vertices: u64,
    points: usize,
    lines: usize,
    triangles: usize,
    low: [f32; 3],
    high: [f32; 3],
    finite: bool,
}

/// Adds the node of a figure; none where it has no elements.
pub(super) fn add_pieces<'a>(
    layout: &mut Layout<'a>,
    pieces: &Pieces<'a>,
) -> Result<Option<Index<json::Node>>, GlbError> {
    let (sum, entries) = sum(pieces);
    if !sum.finite {
        return Err(GlbError::OutOfRange);
    }
    if sum.vertices >= u64::from(u32::MAX) {
        return Err(GlbError::TooLarge);
    }
    if sum.elements == 0 {
        return Ok(None);
    }
    let evaluator = pieces.evaluator;
    let view =
        layout.view(Piece::SeparateVertices(evaluator, sum.vertices as usize), Target::ArrayBuffer, None);
    let positions = layout.bounded(view, 0, sum.vertices, sum.low, sum.high);
    let mut primitives = Vec::new();
    let kinds = [
        (Places::Triangles, Mode::Triangles, Look::Surface, sum.triangles, 3),
        (Places::Lines, Mode::Lines, Look::Line, sum.lines, 2),
        (Places::Points, Mode::Points, Look::Line, sum.points, 1),
    ];
    for (places, mode, look, count, each) in kinds.into_iter().filter(|kind| kind.3 > 0) {
        // Points or segments alone are the vertices as they stand.
        let plain =
            places != Places::Triangles && (count * each) as u64 == sum.vertices && sum.triangles == 0;
        let indices = (!plain).then(|| {
            let piece = Piece::SeparatePlaces(evaluator, places, count * each);
            layout.indices(piece, count * each)
        });
        primitives.push(layout.primitive(mode, look, positions, indices));
    }
    let node = layout.node(&format!("{}/pieces", pieces.address), primitives);
    let described =
        PiecesExtras { kind: "pieces", address: pieces.address, elements: sum.elements, parts: entries };
    let extras = extras(&described)?;
    if let Some(node) = layout.node_mut(node) {
        node.extras = extras;
    }
    Ok(Some(node))
}

fn sum<'a>(pieces: &Pieces<'a>) -> (Sum, Vec<PieceEntry<'a>>) {
    let (low, high) = ([f32::MAX; 3], [f32::MIN; 3]);
    let mut sum =
        Sum { elements: 0, vertices: 0, points: 0, lines: 0, triangles: 0, low, high, finite: true };
    let mut entries = Vec::with_capacity(pieces.labels.len());
    let Ok(()) = walk(pieces.evaluator, |drawing, first, vertices| {
        if let Some(Label { address, alias, .. }) = pieces.labels.get(sum.elements) {
            let (kind, vertices) = (drawing.kind(), drawing.vertices);
            entries.push(PieceEntry { kind, address, alias, first_vertex: first as usize, vertices });
        }
        sum.elements += 1;
        sum.vertices += vertices.len() as u64;
        sum.points += usize::from(drawing.is_point());
        sum.lines += drawing.lines.len();
        sum.triangles += drawing.triangles;
        for vertex in vertices {
            for (axis, value) in position(*vertex).into_iter().enumerate() {
                sum.finite &= value.is_finite();
                sum.low[axis] = sum.low[axis].min(value);
                sum.high[axis] = sum.high[axis].max(value);
            }
        }
        Ok::<(), Infallible>(())
    });
    (sum, entries)
}

/// Calls `found` for each element with the number of its first vertex and its vertices in the model.
fn walk<E>(
    evaluator: &PiecesEvaluator,
    mut found: impl FnMut(&Drawing, u32, &[DVec3]) -> Result<(), E>,
) -> Result<(), E> {
    let drawings: Vec<Drawing> = evaluator.germs().iter().map(Drawing::of).collect();
    let mut vertices = Vec::new();
    let mut first = 0_u32;
    evaluator.stream(|tile| {
        for element in tile.elements() {
            let drawing = &drawings[element.germ];
            let places = element.first..element.first + element.vertices();
            vertices.clear();
            vertices.extend(places.map(|place| DVec3::from_array(tile.point(place))));
            drawing.place(&mut vertices);
            found(drawing, first, &vertices)?;
            first = first.saturating_add(vertices.len() as u32);
        }
        Ok(())
    })
}

/// Gives all vertices, in order.
pub(super) fn vertices(
    evaluator: &PiecesEvaluator,
    mut write: impl FnMut(DVec3) -> io::Result<()>,
) -> io::Result<()> {
    walk(evaluator, |_, _, vertices| vertices.iter().try_for_each(|vertex| write(*vertex)))
}

/// Gives the places of vertices of all points, lines or triangles, in order.
pub(super) fn places(
    evaluator: &PiecesEvaluator,
    kind: Places,
    mut write: impl FnMut(u32) -> io::Result<()>,
) -> io::Result<()> {
    let mut triangles = Vec::new();
    walk(evaluator, |drawing, first, vertices| match kind {
        Places::Points if drawing.is_point() => write(first),
        Places::Points => Ok(()),
        Places::Lines => drawing.lines.as_flattened().iter().try_for_each(|place| write(first + place)),
        Places::Triangles => {
            triangles.clear();
            drawing.triangulate(vertices, |triangle| triangles.push(triangle));
            triangles.as_flattened().iter().try_for_each(|place| write(first + place))
        }
    })
}
