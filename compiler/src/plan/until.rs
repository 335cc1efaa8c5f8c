//! Levels by size (LANGUAGE 6): the smallest level at which every element is small enough, found level by level.

use std::convert::Infallible;

use crate::hir::size::{SizeBound, SizeMeasure};
use crate::ifs::{Automaton, GermShape, StateId};

use super::budget::{MAX_LEVEL, figure_count};
use super::evaluate::{
    PiecesEvaluator, PointGrid, SheetEvaluator, TILE_ROWS, basis, chain_points, curve_points, net_points,
    swept_points,
};
use super::figure::{Depth, FigurePlan, PiecesPlan, Shape, SheetPlan};
use super::size::{SizeRange, distance};
use super::swept::Path;

/// Elements looked at over all levels, in limits of one level.
const LEVELS_OF_WORK: u64 = 4;

/// A level and the sizes of its elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sized {
    /// The level, in both directions.
    pub level: u32,
    /// Its sizes.
    pub sizes: SizeRange,
}

/// Why no level is right.
#[derive(Clone, Debug, PartialEq)]
pub enum UntilError {
    /// The figure has elements without this measure: those of this state, or its quads.
    NoMeasure {
        /// The state whose germ has none.
        state: Option<StateId>,
    },
    /// The next level has more elements than the limit, is too deep or takes too long.
    NotReached {
        /// The last level looked at; none when not even level 0 is within the limit.
        last: Option<Sized>,
    },
    /// The first level at which all are small enough has some below the smallest size.
    TooSmall {
        /// The level before, where there is one.
        before: Option<Sized>,
        /// That level.
        found: Sized,
    },
}

/// The smallest level at which every element is within the bound, and not below `least`; at most `limit` elements are
/// looked at in a level, and a few times as many in all. What is kept on the way does not count: it never gets smaller.
///
/// The figure must be one of a [`super::Plan`] but for its level, which is not read.
///
/// # Errors
/// [`UntilError`].
pub fn smallest_level(
    automaton: &Automaton,
    figure: &FigurePlan,
    bound: SizeBound,
    least: Option<f64>,
    limit: u64,
) -> Result<Sized, UntilError> {
    let mut figure = figure.clone();
    let mut before: Option<Sized> = None;
    let mut work = 0_u64;
    for level in 0..=MAX_LEVEL {
        set_level(&mut figure.shape, level);
        let counted = figure_count(automaton, &figure, MAX_LEVEL).filter(|count| count.elements <= limit);
        let elements = counted.map(|count| count.elements).ok_or(UntilError::NotReached { last: before })?;
        work = work.saturating_add(elements);
        if work > limit.saturating_mul(LEVELS_OF_WORK) {
            break;
        }
        let found = Sized { level, sizes: sizes(automaton, &figure.shape, bound.measure)? };
        if bound.holds(found.sizes.most) {
            return match least.filter(|least| found.sizes.least < *least) {
                Some(_) => Err(UntilError::TooSmall { before, found }),
                None => Ok(found),
            };
        }
        before = Some(found);
    }
    Err(UntilError::NotReached { last: before })
}

/// Gives every direction of a figure this level.
pub fn set_level(shape: &mut Shape, to: u32) {
    match shape {
        Shape::Curve { level, .. } => *level = to,
        Shape::Sheet(sheet) => sheet.levels = (to, to),
        Shape::Pieces(pieces) => pieces.depth = Depth::Level(to),
        Shape::Patchwork(patchwork) => patchwork.level = to,
        Shape::Chain(chain) => chain.level = to,
        Shape::Net(net) => net.sheet.levels = (to, to),
        Shape::Swept(swept) => {
            swept.profile.level = to;
            if let Path::Rail(rail, _) = &mut swept.path {
                rail.level = to;
            }
        }
    }
}

/// The smallest and largest element of a figure at its level.
fn sizes(automaton: &Automaton, shape: &Shape, measure: SizeMeasure) -> Result<SizeRange, UntilError> {
    let none = UntilError::NoMeasure { state: None };
    match shape {
        Shape::Curve { state, points, level, .. } => {
            let vertices = curve_points(&basis(automaton, *state, *level), points);
            let lengths = vertices.windows(2).map(|ends| SizeRange::one(distance(ends[0], ends[1])));
            lengths.reduce(SizeRange::with).ok_or(none)
        }
        Shape::Chain(chain) => {
            let mut vertices = chain_points(automaton, chain);
            vertices.extend(vertices.first().copied().filter(|_| chain.closed));
            let lengths = vertices.windows(2).map(|ends| SizeRange::one(distance(ends[0], ends[1])));
            lengths.reduce(SizeRange::with).ok_or(none)
        }
        Shape::Sheet(_) | Shape::Net(_) | Shape::Swept(_) if measure == SizeMeasure::Length => Err(none),
        Shape::Net(net) => grid_sizes(&net_points(automaton, net), net.closed, measure).ok_or(none),
        Shape::Swept(swept) => {
            grid_sizes(&swept_points(automaton, swept), swept.closed(), measure).ok_or(none)
        }
        Shape::Sheet(sheet) => sheet_sizes(automaton, sheet, measure).ok_or(none),
        Shape::Pieces(pieces) => pieces_sizes(automaton, pieces, measure),
        // Its polygons are as large as they would be one by one.
        Shape::Patchwork(patchwork) => {
            let (state, points, dimension) = (patchwork.state, patchwork.points.clone(), patchwork.dimension);
            let depth = Depth::Level(patchwork.level);
            pieces_sizes(automaton, &PiecesPlan { state, points, dimension, depth }, measure)
        }
    }
}

/// Sides of quads, or with [`SizeMeasure::Size`] the largest of a quad's sides and diagonals.
fn sheet_sizes(automaton: &Automaton, sheet: &SheetPlan, measure: SizeMeasure) -> Option<SizeRange> {
    let evaluator = SheetEvaluator::new(automaton, sheet);
    let mut all: Option<SizeRange> = None;
    let mut add = |found: Option<SizeRange>| {
        all = [all, found].into_iter().flatten().reduce(SizeRange::with);
    };
    let columns = evaluator.columns();
    let mut above: Vec<[f64; 3]> = Vec::with_capacity(columns);
    let Ok(()) = evaluator.stream(TILE_ROWS, |_, tile| {
        for row in tile.chunks_exact(columns) {
            row_sizes(&above, row, measure, &mut add);
            above.clear();
            above.extend_from_slice(row);
        }
        Ok::<(), Infallible>(())
    });
    all
}

/// The same of a grid that may be closed.
fn grid_sizes(grid: &PointGrid, closed: (bool, bool), measure: SizeMeasure) -> Option<SizeRange> {
    let mut all: Option<SizeRange> = None;
    let mut add = |found: Option<SizeRange>| {
        all = [all, found].into_iter().flatten().reduce(SizeRange::with);
    };
    let round = |row: &[[f64; 3]]| -> Vec<[f64; 3]> {
        row.iter().chain(row.first().filter(|_| closed.1)).copied().collect()
    };
    let mut above: Vec<[f64; 3]> = Vec::new();
    let rows = grid.points.chunks_exact(grid.columns);
    for row in rows.clone().chain(rows.take(usize::from(closed.0))).map(round) {
        row_sizes(&above, &row, measure, &mut add);
        above = row;
    }
    all
}

/// The quads between two rows; of the first row, its own sides.
fn row_sizes(
    above: &[[f64; 3]],
    row: &[[f64; 3]],
    measure: SizeMeasure,
    add: &mut impl FnMut(Option<SizeRange>),
) {
    let side = |a: [f64; 3], b: [f64; 3]| Some(SizeRange::one(distance(a, b)));
    if measure == SizeMeasure::Edge {
        row.windows(2).for_each(|ends| add(side(ends[0], ends[1])));
        above.iter().zip(row).for_each(|(a, b)| add(side(*a, *b)));
        return;
    }
    for (a, b) in above.windows(2).zip(row.windows(2)) {
        add(measure.of(&GermShape::Polygon, &[a[0], a[1], b[1], b[0]]));
    }
}

fn pieces_sizes(
    automaton: &Automaton,
    pieces: &PiecesPlan,
    measure: SizeMeasure,
) -> Result<SizeRange, UntilError> {
    let mut reachable = automaton.reachable(pieces.state).into_iter();
    if let Some(state) = reachable.find(|id| !measure.applies_to(&automaton.state(*id).germ.shape)) {
        return Err(UntilError::NoMeasure { state: Some(state) });
    }
    let mut all: Option<SizeRange> = None;
    let mut vertices = Vec::new();
    let Ok(()) = PiecesEvaluator::new(automaton, pieces).stream(|tile| {
        for element in tile.elements().filter(|element| element.drawn.kept.is_none()) {
            tile.copy_vertices(&element, &mut vertices);
            let found = measure.of(&element.drawn.shape, &vertices);
            all = [all, found].into_iter().flatten().reduce(SizeRange::with);
        }
        Ok::<(), Infallible>(())
    });
    all.ok_or(UntilError::NoMeasure { state: None })
}
