//! From a model to its nodes and meshes.

use std::collections::BTreeMap;

use glam::DVec3;
use gltf_json as json;
use json::Index;
use json::buffer::Target;
use json::mesh::{Mode, Semantic};
use json::validation::Checked::Valid;
use serde::Serialize;

use super::colour::Scale;
use super::edges::EdgeList;
use super::layout::{Layout, Look, extras};
use super::piece::{Piece, triangle_count};
use super::pieces::add_pieces;
use super::{Curve, Figure, GlbError, MAX_PART_NODES, Model, Panelled, Part, Surface};
use crate::fabricate::label::Label;
use crate::geometry::QuadMesh;

/// How far apart the boards, the planarized and the designed surfaces stand, in widths of the whole.
const SPREAD: f64 = 1.25;

#[derive(Serialize)]
struct FigureExtras<'a> {
    kind: &'static str,
    source: &'a str,
}

#[derive(Serialize)]
struct ShapeExtras<'a> {
    kind: &'static str,
    address: &'a str,
}

#[derive(Serialize)]
struct PartExtras<'a> {
    kind: &'static str,
    address: &'a str,
    alias: &'a str,
}

#[derive(Serialize)]
struct TableExtras<'a> {
    kind: &'static str,
    parts: Vec<TableEntry<'a>>,
}

#[derive(Serialize)]
struct TableEntry<'a> {
    kind: &'static str,
    address: &'a str,
    alias: &'a str,
    first_index: usize,
    indices: usize,
}

/// Lays out the whole model.
pub(super) fn lay_out<'a>(model: &'a Model<'a>) -> Result<Layout<'a>, GlbError> {
    let mut layout = Layout::new();
    let parts: usize = model.figures.iter().map(|figure| figure.parts.len()).sum();
    let spread = spread(model);
    let mut top = Vec::new();
    for figure in &model.figures {
        top.extend(add_figure(&mut layout, figure, spread, parts > MAX_PART_NODES)?);
    }
    if !top.is_empty() {
        let name = (!model.design.is_empty()).then(|| model.design.to_owned());
        let scene = layout.root.push(json::Scene { extensions: None, extras: None, name, nodes: top });
        layout.root.scene = Some(scene);
    }
    Ok(layout)
}

/// How far (m) to move the planarized surfaces beside the boards; the designed ones twice as far.
fn spread(model: &Model<'_>) -> f32 {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for figure in model.figures.iter().filter(|figure| !figure.parts.is_empty()) {
        let surfaces = figure.surfaces.iter().flat_map(|surface| &surface.designed.vertices);
        let parts = figure.parts.iter().flat_map(|part| &part.solid.vertices);
        for point in surfaces.chain(parts) {
            low = low.min(point.x);
            high = high.max(point.x);
        }
    }
    if high > low { ((high - low) * SPREAD * 1e-3) as f32 } else { 0.0 }
}

fn add_figure<'a>(
    layout: &mut Layout<'a>,
    figure: &'a Figure<'a>,
    spread: f32,
    joined: bool,
) -> Result<Option<Index<json::Node>>, GlbError> {
    let place = layout.node(figure.name, Vec::new());
    let mut children = Vec::new();
    for curve in figure.curves.iter().filter(|curve| curve.points.len() > 1) {
        children.push(add_curve(layout, curve)?);
    }
    for surface in figure.surfaces.iter().filter(|surface| !surface.designed.quads.is_empty()) {
        add_surface(layout, surface, spread, &mut children)?;
    }
    for pieces in &figure.pieces {
        children.extend(add_pieces(layout, pieces)?);
    }
    if figure.parts.iter().any(|part| !part.solid.triangles.is_empty()) {
        children.push(add_parts(layout, figure, joined)?);
    }
    if children.is_empty() {
        layout.root.nodes.pop();
        return Ok(None);
    }
    let extras = figure.source.map(|source| extras(&FigureExtras { kind: "figure", source })).transpose()?;
    if let Some(node) = layout.node_mut(place) {
        node.children = Some(children);
        node.extras = extras.flatten();
    }
    Ok(Some(place))
}

fn add_curve<'a>(layout: &mut Layout<'a>, curve: &Curve<'a>) -> Result<Index<json::Node>, GlbError> {
    let view = layout.view(Piece::Points(curve.points), Target::ArrayBuffer, None);
    let positions = layout.positions(view, 0, curve.points)?;
    let strip = layout.primitive(Mode::LineStrip, Look::Line, positions, None);
    let node = layout.node(&format!("{}/curve", curve.address), vec![strip]);
    describe(layout, node, &ShapeExtras { kind: "curve", address: curve.address })?;
    Ok(node)
}

fn add_surface<'a>(
    layout: &mut Layout<'a>,
    surface: &Surface<'a>,
    spread: f32,
    children: &mut Vec<Index<json::Node>>,
) -> Result<(), GlbError> {
    let address = surface.address;
    let Some(Panelled { planarized, required }) = surface.panelled else {
        let node = add_plain(layout, &format!("{address}/surface"), surface.designed)?;
        describe(layout, node, &ShapeExtras { kind: "surface", address })?;
        children.push(node);
        return Ok(());
    };
    let scale = Scale::around(required);
    for (kind, mesh, places) in [("planarized", planarized, 1.0), ("designed", surface.designed, 2.0)] {
        let node = add_map(layout, &format!("{address}/{kind}"), mesh, scale.clone())?;
        describe(layout, node, &ShapeExtras { kind, address })?;
        if let Some(node) = layout.node_mut(node).filter(|_| spread > 0.0) {
            node.translation = Some([spread * places, 0.0, 0.0]);
        }
        children.push(node);
    }
    Ok(())
}

/// A mesh as it is: triangles and edges on the same vertices.
fn add_plain<'a>(
    layout: &mut Layout<'a>,
    name: &str,
    mesh: &'a QuadMesh,
) -> Result<Index<json::Node>, GlbError> {
    let view = layout.view(Piece::Points(&mesh.vertices), Target::ArrayBuffer, None);
    let positions = layout.positions(view, 0, &mesh.vertices)?;
    let triangles = triangle_count(mesh);
    let edges = EdgeList::of(&mesh.quads, mesh.vertices.len());
    let mut primitives = Vec::new();
    if triangles > 0 {
        let indices = layout.indices(Piece::Triangles(mesh), triangles * 3);
        primitives.push(layout.primitive(Mode::Triangles, Look::Surface, positions, Some(indices)));
    }
    if edges.len() > 0 {
        let count = edges.len() * 2;
        let indices = layout.indices(Piece::Edges(edges), count);
        primitives.push(layout.primitive(Mode::Lines, Look::Line, positions, Some(indices)));
    }
    Ok(layout.node(name, primitives))
}

/// A mesh coloured quad by quad, so each quad has corners of its own; and its edges on the shared vertices.
fn add_map<'a>(
    layout: &mut Layout<'a>,
    name: &str,
    mesh: &'a QuadMesh,
    scale: Scale,
) -> Result<Index<json::Node>, GlbError> {
    let corners = mesh.quads.len() * 4;
    let view = layout.view(Piece::Corners(mesh), Target::ArrayBuffer, None);
    let points = mesh.quads.iter().flatten().map(|&corner| &mesh.vertices[corner as usize]);
    let positions = layout.positions(view, 0, points)?;
    let colours = layout.colours(Piece::CornerColours(mesh, scale), corners);
    let indices = layout.indices(Piece::CornerTriangles(mesh), mesh.quads.len() * 6);
    let mut faces = layout.primitive(Mode::Triangles, Look::Map, positions, Some(indices));
    faces.attributes.insert(Valid(Semantic::Colors(0)), colours);
    let mut primitives = vec![faces];
    let edges = EdgeList::of(&mesh.quads, mesh.vertices.len());
    if edges.len() > 0 {
        let view = layout.view(Piece::Points(&mesh.vertices), Target::ArrayBuffer, None);
        let positions = layout.positions(view, 0, &mesh.vertices)?;
        let count = edges.len() * 2;
        let indices = layout.indices(Piece::Edges(edges), count);
        primitives.push(layout.primitive(Mode::Lines, Look::Line, positions, Some(indices)));
    }
    Ok(layout.node(name, primitives))
}

fn add_parts<'a>(
    layout: &mut Layout<'a>,
    figure: &'a Figure<'a>,
    joined: bool,
) -> Result<Index<json::Node>, GlbError> {
    let parts = &figure.parts;
    let name = format!("{}/boards", figure.name);
    let stride = (parts.len() > 1 && !joined).then_some(12);
    let view = layout.view(Piece::PartPoints(parts), Target::ArrayBuffer, stride);
    if joined {
        return add_joined(layout, &name, parts, view);
    }
    let place = layout.node(&name, Vec::new());
    let mut shapes: BTreeMap<&[[u32; 3]], Index<json::Accessor>> = BTreeMap::new();
    let mut children = Vec::with_capacity(parts.len());
    let mut offset = 0u64;
    for (index, part) in parts.iter().enumerate() {
        let Part { label, kind, solid } = part;
        let start = offset;
        offset += solid.vertices.len() as u64 * 12;
        if solid.triangles.is_empty() {
            continue;
        }
        let positions = layout.positions(view, start, &solid.vertices)?;
        let triangles = solid.triangles.as_slice();
        let indices = *shapes
            .entry(triangles)
            .or_insert_with(|| layout.indices(Piece::Indices(triangles), triangles.len() * 3));
        let faces = layout.primitive(Mode::Triangles, timber(label, index), positions, Some(indices));
        let node = layout.node(&label.address, vec![faces]);
        let (address, alias) = (label.address.as_str(), label.alias.as_str());
        describe(layout, node, &PartExtras { kind: kind.name(), address, alias })?;
        children.push(node);
    }
    if let Some(node) = layout.node_mut(place) {
        node.children = Some(children);
    }
    Ok(place)
}

/// Two shades in turn: as on a chessboard where boards have rows and columns, else one after the other.
fn timber(label: &Label, index: usize) -> Look {
    let place = label.row.zip(label.column).map_or(index, |(row, column)| (row ^ column) as usize);
    if place.is_multiple_of(2) { Look::Timber } else { Look::PaleTimber }
}

/// All parts as one mesh, and a table that says which indices are whose.
fn add_joined<'a>(
    layout: &mut Layout<'a>,
    name: &str,
    parts: &'a [Part<'a>],
    view: Index<json::buffer::View>,
) -> Result<Index<json::Node>, GlbError> {
    let points: Vec<&DVec3> = parts.iter().flat_map(|part| &part.solid.vertices).collect();
    let positions = layout.positions(view, 0, points)?;
    let mut first_index = 0;
    let entries = parts.iter().map(|part| {
        let indices = part.solid.triangles.len() * 3;
        first_index += indices;
        TableEntry {
            kind: part.kind.name(),
            address: &part.label.address,
            alias: &part.label.alias,
            first_index: first_index - indices,
            indices,
        }
    });
    let table = TableExtras { kind: "boards", parts: entries.collect() };
    let indices = layout.indices(Piece::PartTriangles(parts), first_index);
    let faces = layout.primitive(Mode::Triangles, Look::Timber, positions, Some(indices));
    let node = layout.node(name, vec![faces]);
    describe(layout, node, &table)?;
    Ok(node)
}

fn describe(
    layout: &mut Layout<'_>,
    node: Index<json::Node>,
    value: &impl Serialize,
) -> Result<(), GlbError> {
    let extras = extras(value)?;
    if let Some(node) = layout.node_mut(node) {
        node.extras = extras;
    }
    Ok(())
}
