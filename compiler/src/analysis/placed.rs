//! Figures worked out in space: points of curves, quads of surfaces, and what each element is called.

use crate::diagnostic::Diagnostic;
use crate::fabricate::label::Label;
use crate::geometry::{Grid, LARGEST_COORDINATE, QuadMesh, grid::Closed};
use crate::hir::tree::{Hir, ItemId};
use crate::plan::address::{Address, FigureAddresses};
use crate::plan::evaluate::{
    PiecesEvaluator, PointGrid, SheetEvaluator, basis, chain_points, curve_points, net_points, patchwork,
    swept_points,
};
use crate::plan::lower::{Lowered, out_of_reach};
use crate::plan::{FigurePlan, Plan, Shape};
use glam::DVec3;
use std::collections::BTreeMap;
use std::convert::Infallible;

/// A figure in space, mm.
#[derive(Clone, Debug)]
pub enum FigureGeometry {
    /// The points of a chain of segments; of a closed one the first is also the last.
    Curve(Vec<DVec3>),
    /// The quads of a surface, row by row.
    Surface(QuadMesh),
    /// Separate pieces, which are worked out where they are used: there may be millions.
    Pieces(Box<PiecesEvaluator>),
}

/// A figure of a plan in space; `None` where its coordinates are beyond what can be built, [`LARGEST_COORDINATE`].
pub fn figure_geometry(plan: &Plan, figure: &FigurePlan) -> Option<FigureGeometry> {
    match &figure.shape {
        Shape::Curve { state, points, level, .. } => {
            let basis = basis(plan.automaton(), *state, *level);
            near(curve_points(&basis, points)).map(FigureGeometry::Curve)
        }
        Shape::Sheet(sheet) => {
            let evaluator = SheetEvaluator::new(plan.automaton(), sheet);
            let mut buffer = Vec::new();
            evaluator.fill(&mut buffer);
            let points = buffer.into_iter().map(DVec3::from_array).collect();
            let grid = Grid::try_new(evaluator.rows(), evaluator.columns(), points).ok()?;
            grid.into_mesh(Closed::NONE).ok().map(FigureGeometry::Surface)
        }
        Shape::Pieces(pieces) => {
            Some(FigureGeometry::Pieces(Box::new(PiecesEvaluator::new(plan.automaton(), pieces))))
        }
        Shape::Patchwork(plan_of) => {
            let made = patchwork(plan.automaton(), plan.adjacency(plan_of.state)?, plan_of)?;
            let vertices = made.vertices.iter().copied().map(DVec3::from_array).collect();
            let quad = |corners: &[u32]| <[u32; 4]>::try_from(corners).ok();
            let quads: Option<Vec<[u32; 4]>> = made.polygons().map(quad).collect();
            QuadMesh::try_new(vertices, quads?).ok().map(FigureGeometry::Surface)
        }
        Shape::Chain(chain) => {
            let mut points = chain_points(plan.automaton(), chain);
            if chain.closed {
                points.extend(points.first().copied());
            }
            near(points).map(FigureGeometry::Curve)
        }
        Shape::Net(net) => surface(net_points(plan.automaton(), net), net.closed),
        Shape::Swept(swept) => surface(swept_points(plan.automaton(), swept), swept.closed()),
    }
}

/// E0707, once for each name, for figures that reach further than can be built. Of those that boards or planks are made of, the blocks say so.
pub(super) fn too_large(hir: &Hir, lowered: &Lowered) -> Vec<Diagnostic> {
    let plan = &lowered.plan;
    let all = plan.figures().iter().zip(&lowered.sources);
    let alone = all.filter(|(_, source)| hir.fabricates.iter().all(|block| block.figure != source.item));
    let far = alone.filter(|(figure, _)| {
        let may = figure.shape.reach(plan.automaton()) > LARGEST_COORDINATE;
        may && figure_geometry(plan, figure).is_none()
    });
    let mut first: BTreeMap<ItemId, &FigurePlan> = BTreeMap::new();
    far.for_each(|(figure, source)| {
        first.entry(source.item).or_insert(figure);
    });
    let said = first.into_iter().map(|(item, figure)| {
        out_of_reach(figure, hir.item(item).name_span)
            .hint("are the units of its control points right? An ifs that does not contract makes it larger with each level")
    });
    said.collect()
}

/// The points where all of them can be built.
fn near(points: Vec<[f64; 3]>) -> Option<Vec<DVec3>> {
    let points: Vec<DVec3> = points.into_iter().map(DVec3::from_array).collect();
    let near = |point: &DVec3| point.abs().max_element() <= LARGEST_COORDINATE && point.is_finite();
    points.iter().all(near).then_some(points)
}

fn surface(grid: PointGrid, (rows, columns): (bool, bool)) -> Option<FigureGeometry> {
    let points = grid.points.into_iter().map(DVec3::from_array).collect();
    let grid = Grid::try_new(grid.rows, grid.columns, points).ok()?;
    grid.into_mesh(Closed { rows, columns }).ok().map(FigureGeometry::Surface)
}

/// The names of a curve's segments, in order.
pub(super) fn segment_labels(plan: &Plan, figure: &FigurePlan, count: usize) -> Vec<Label> {
    let addresses = FigureAddresses::new(plan.automaton(), figure);
    (0..count as u64)
        .filter_map(|index| addresses.segment(index))
        .map(|address| label(&address, None))
        .collect()
}

/// The names of a surface's quads, row by row; of a patchwork's in the order of their words.
pub(super) fn quad_labels(plan: &Plan, figure: &FigurePlan, rows: u64, columns: u64) -> Vec<Label> {
    let addresses = FigureAddresses::new(plan.automaton(), figure);
    if matches!(figure.shape, Shape::Patchwork(_)) {
        let elements = (0..rows).filter_map(|element| addresses.segment(element));
        return elements.map(|address| label(&address, None)).collect();
    }
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    places
        .filter_map(|(row, column)| {
            let address = addresses.quad(row, column)?;
            Some(label(&address, Some((row as u32, column as u32))))
        })
        .collect()
}

/// The names of the elements of a figure of separate pieces, in the order of their words.
pub fn piece_labels(plan: &Plan, figure: &FigurePlan, evaluator: &PiecesEvaluator) -> Vec<Label> {
    let addresses = FigureAddresses::new(plan.automaton(), figure);
    let mut labels = Vec::new();
    let Ok(()) = evaluator.stream(|tile| {
        for element in tile.elements() {
            let address = addresses.piece(labels.len() as u64, &element);
            labels.extend(address.map(|address| label(&address, None)));
        }
        Ok::<(), Infallible>(())
    });
    labels
}

fn label(address: &Address, place: Option<(u32, u32)>) -> Label {
    Label {
        address: address.to_string(),
        alias: address.alias.clone(),
        row: place.map(|(row, _)| row),
        column: place.map(|(_, column)| column),
    }
}
