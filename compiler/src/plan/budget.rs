//! Budgets: how many elements a plan asks for, refused above a limit before anything is evaluated.

use std::fmt;

use crate::ifs::{Automaton, Count, Drawn, StateId, count, drawn};

use super::figure::{Depth, FigurePlan, Plan, Shape};
use super::uses::StateUse;

/// Deepest level that is evaluated; an address has one letter a level.
pub const MAX_LEVEL: u32 = 1000;

/// What a figure comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FigureCount {
    /// Segments of a curve, quads of a sheet, germs of pieces with those that are kept.
    pub elements: u64,
    /// Vertices, joined ones counted once; of a patchwork, all corners of its polygons.
    pub vertices: u64,
    /// Elements along u and v; a curve and pieces have 1 along v.
    pub grid: (u64, u64),
}

/// Why a plan is not evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BudgetError {
    /// A level beyond [`MAX_LEVEL`].
    TooDeep {
        /// The figure, `vault[2]`.
        figure: String,
        /// Its level, the larger of two.
        level: u32,
    },
    /// More elements than the limit.
    TooMany {
        /// The figure at which the limit is passed.
        figure: String,
        /// Elements of all figures; `None` when they are not counted: beyond 1.8·10^19, or at a level beyond
        /// [`MAX_LEVEL`].
        elements: Option<u64>,
        /// The limit.
        limit: u64,
        /// The largest level to which every figure could be cut back so that all fit; `None` when not even level 0
        /// does.
        fits: Option<u32>,
    },
}

impl fmt::Display for BudgetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BudgetError::TooDeep { figure, level } => {
                write!(f, "`{figure}` is at level {level}; the deepest level is {MAX_LEVEL}")
            }
            BudgetError::TooMany { figure, elements, limit, fits } => {
                match elements {
                    Some(elements) => write!(f, "{elements} elements")?,
                    None => f.write_str("more elements than can be counted")?,
                }
                write!(f, " with `{figure}`; the limit is {limit}")?;
                match fits {
                    Some(level) => write!(f, ", and the largest level that fits is {level}"),
                    None => f.write_str(", and no level fits"),
                }
            }
        }
    }
}

impl std::error::Error for BudgetError {}

/// The counts of all figures, in their order, when together they have at most `limit` elements.
///
/// # Errors
/// [`BudgetError`]. Takes milliseconds at any level.
pub fn check(plan: &Plan, limit: u64) -> Result<Vec<FigureCount>, BudgetError> {
    let automaton = plan.automaton();
    let mut counts = Vec::with_capacity(plan.figures().len());
    let mut total = 0_u64;
    for figure in plan.figures() {
        let counted = figure_count(automaton, figure, MAX_LEVEL);
        match counted.and_then(|counted| Some((counted, total.checked_add(counted.elements)?))) {
            Some((counted, sum)) if sum <= limit => {
                total = sum;
                counts.push(counted);
            }
            _ => return Err(too_many(plan, figure, limit)),
        }
    }
    let deepest = |figure: &&FigurePlan| figure.shape.deepest() > MAX_LEVEL;
    match plan.figures().iter().find(deepest) {
        Some(figure) => {
            Err(BudgetError::TooDeep { figure: figure.to_string(), level: figure.shape.deepest() })
        }
        None => Ok(counts),
    }
}

fn too_many(plan: &Plan, figure: &FigurePlan, limit: u64) -> BudgetError {
    let total = |cut: u32| {
        plan.figures().iter().try_fold(0_u64, |total, figure| {
            total.checked_add(figure_count(plan.automaton(), figure, cut)?.elements)
        })
    };
    let fits_at = |cut: u32| total(cut).is_some_and(|elements| elements <= limit);
    let deepest = plan.figures().iter().map(|figure| figure.shape.deepest()).max().unwrap_or(0);
    // Counts never fall with the level, so bisection finds the last one that fits.
    let fits = fits_at(0).then(|| {
        let (mut fits, mut fails) = (0, deepest.min(MAX_LEVEL));
        while fails - fits > 1 {
            let middle = fits + (fails - fits) / 2;
            if fits_at(middle) { fits = middle } else { fails = middle }
        }
        fits
    });
    let elements = if deepest <= MAX_LEVEL { total(MAX_LEVEL) } else { None };
    BudgetError::TooMany { figure: figure.to_string(), elements, limit, fits }
}

/// The counts of one figure with its levels cut back to `cut`; `None` when they do not fit in 64 bits.
pub(super) fn figure_count(automaton: &Automaton, figure: &FigurePlan, cut: u32) -> Option<FigureCount> {
    match &figure.shape {
        Shape::Pieces(pieces) => {
            let Drawn { elements, vertices } = match pieces.depth {
                Depth::Level(level) => drawn(automaton, pieces.state, level.min(cut))?,
                Depth::Each(each) => each.drawn,
            };
            Some(FigureCount { elements, vertices, grid: (elements, 1) })
        }
        Shape::Patchwork(patchwork) => {
            let level = patchwork.level.min(cut);
            let elements = chain_count(automaton, patchwork.state, level)?;
            let corners = automaton
                .reachable(patchwork.state)
                .into_iter()
                .map(|id| automaton.state(id).germ.vertices.len())
                .max()?;
            let vertices = elements.checked_mul(corners as u64)?;
            Some(FigureCount { elements, vertices, grid: (elements, 1) })
        }
        _ => chains_count(automaton, &figure.shape, cut),
    }
}

/// The counts of a figure of chains: one for a curve, two for a surface.
fn chains_count(automaton: &Automaton, shape: &Shape, cut: u32) -> Option<FigureCount> {
    let mut along = shape.uses().into_iter().map(|used| elements(automaton, used, cut));
    if shape.is_curve() {
        let elements = along.next()??;
        let vertices = elements.checked_add(u64::from(!shape.closed().0))?;
        return Some(FigureCount { elements, vertices, grid: (elements, 1) });
    }
    let u = match shape {
        Shape::Swept(swept) if swept.steps().is_some() => u64::from(swept.steps()?),
        _ => along.next()??,
    };
    let v = along.next()??;
    let vertices = |elements: u64, closed: bool| elements.checked_add(u64::from(!closed));
    let vertices = vertices(u, shape.closed().0)?.checked_mul(vertices(v, shape.closed().1)?)?;
    Some(FigureCount { elements: u.checked_mul(v)?, vertices, grid: (u, v) })
}

/// The elements along one chain with its level cut back to `cut`.
fn elements(automaton: &Automaton, used: StateUse, cut: u32) -> Option<u64> {
    chain_count(automaton, used.state, used.level.min(cut))?.checked_mul(used.windows(automaton) as u64)
}

fn chain_count(automaton: &Automaton, state: StateId, level: u32) -> Option<u64> {
    match count(automaton, state, level, u64::MAX) {
        Count::Exactly(elements) => Some(elements),
        Count::Exceeds => None,
    }
}
