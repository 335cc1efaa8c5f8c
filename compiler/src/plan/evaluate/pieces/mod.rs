//! [`PiecesEvaluator`]: figures whose pieces do not join, element by element (GEOMETRY 4, form 2).
//!
//! A word is cut in two. The control points of its first letters are worked out one word after the other; what hangs
//! below them is a block of weights made once for each state. So an element costs one weighted sum a coordinate, in the
//! vector instructions at hand, and no memory: blocks are handed on as tiles. Where every branch stops on its own, words
//! are walked one by one.
//!
//! Inside, the points p0, p1, … of a piece are p0, p1 − p0, …: an affine combination is then p0 and a weighted sum of
//! differences, exactly as far from everything as the piece itself. With plain weights an affine frame of 1 mm would lose
//! five digits on a figure of 10 m.

mod affine;
mod block;
mod each;
mod tile;
mod walk;

pub use each::EachError;
pub use tile::{PieceElement, Tile};

use std::sync::Arc;

pub use crate::ifs::GermShape;
use crate::ifs::{Automaton, Germ, StateId};

use super::super::figure::{Depth, PiecesPlan};
use super::combine::combine;
use block::{Below, Block};
use tile::Coordinates;
use walk::Walk;

/// Doubles of a block of weights, at most: with the tile they are multiplied into it stays in the first cache.
const BLOCK_WEIGHTS: usize = 3072;

/// Levels of a block, at most.
const BLOCK_LEVELS: u32 = 12;

/// Something that is drawn: the germ of a state, or one that it keeps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DrawnGerm {
    /// How its vertices are drawn.
    pub shape: GermShape,
    /// How many it has.
    pub vertices: u32,
    /// Its place among those its state keeps, where it is kept.
    pub kept: Option<u32>,
}

/// A figure of pieces, ready to give its elements in the order of their words.
#[derive(Clone, Debug)]
pub struct PiecesEvaluator {
    root: usize,
    /// The first point, and the others from there.
    points: Vec<[f64; 3]>,
    depth: Depth,
    /// All states of the automaton; those the figure does not reach are empty.
    states: Arc<Vec<Prepared>>,
    germs: Arc<Vec<DrawnGerm>>,
    /// Levels of the states' blocks.
    height: u32,
}

/// A state in doubles.
#[derive(Clone, Debug, Default)]
struct Prepared {
    transforms: Vec<PreparedTransform>,
    /// What is kept of it.
    kept: Block,
    /// Its germ.
    germ: Block,
    /// What is drawn below it at the end of a word.
    leaves: Block,
}

#[derive(Clone, Debug)]
struct PreparedTransform {
    target: usize,
    matrix: Vec<f64>,
}

impl PiecesEvaluator {
    /// Prepares a figure of a [`crate::plan::Plan`] on this automaton, within a budget.
    ///
    /// # Panics
    /// When its state is not of this automaton.
    pub fn new(automaton: &Automaton, plan: &PiecesPlan) -> PiecesEvaluator {
        let reachable = automaton.reachable(plan.state);
        let mut states = vec![Prepared::default(); automaton.states().len()];
        let mut germs = Vec::new();
        for id in &reachable {
            states[id.index()] = prepare(automaton, *id, &mut germs);
        }
        let most = match plan.depth {
            Depth::Level(level) => level.min(BLOCK_LEVELS),
            Depth::Each(_) => 0,
        };
        let height = raise(&mut states, most);
        PiecesEvaluator {
            root: plan.state.index(),
            points: affine::differences(&plan.points),
            depth: plan.depth,
            states: Arc::new(states),
            germs: Arc::new(germs),
            height,
        }
    }

    /// What is drawn; elements name it by its place.
    pub fn germs(&self) -> &[DrawnGerm] {
        &self.germs
    }

    /// Hands all elements to `write`, in the order of their words and what is kept before what follows below it, in
    /// tiles whose memory is used again.
    ///
    /// # Errors
    /// The first error of `write`, which ends the evaluation.
    pub fn stream<E>(&self, write: impl FnMut(&Tile<'_>) -> Result<(), E>) -> Result<(), E> {
        match self.depth {
            Depth::Level(level) => self.stream_level(level, write),
            Depth::Each(each) => self.stream_each(&each, write),
        }
    }

    fn stream_level<E>(
        &self,
        level: u32,
        mut write: impl FnMut(&Tile<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let last = level.saturating_sub(self.height) as usize;
        let mut walk = Walk::new(self.root, &self.points);
        let mut tile = self.coordinates();
        while let Some(state) = walk.state() {
            let state = &self.states[state];
            if walk.letters.len() == last {
                write(&tile.filled(&state.leaves, &walk, self))?;
                walk.leave();
                continue;
            }
            if walk.is_fresh() && !state.kept.elements.is_empty() {
                write(&tile.filled(&state.kept, &walk, self))?;
            }
            if !walk.enter(&self.states) {
                walk.leave();
            }
        }
        Ok(())
    }

    fn coordinates(&self) -> Coordinates {
        let blocks = self.states.iter().flat_map(|state| [&state.kept, &state.germ, &state.leaves]);
        let rows = blocks.map(|block| block.rows).max().unwrap_or(0);
        Coordinates::new(rows, self.points.iter().all(|point| point[2] == 0.0))
    }
}

fn prepare(automaton: &Automaton, id: StateId, germs: &mut Vec<DrawnGerm>) -> Prepared {
    let state = automaton.state(id);
    let transforms = state.transforms.iter().map(|transform| PreparedTransform {
        target: transform.target.index(),
        matrix: affine::of_differences(&transform.matrix),
    });
    let mut add = |block: Block, germ: &Germ, kept: Option<u32>| {
        let (shape, vertices) = (germ.shape.clone(), germ.vertices.len() as u32);
        germs.push(DrawnGerm { shape, vertices, kept });
        block.with_germ(germs.len() as u32 - 1, &affine::on_differences(&germ.vertices))
    };
    let empty = || Block::new(state.control_points);
    let germ = add(empty(), &state.germ, None);
    let kept = (0..).zip(&state.keep).fold(empty(), |block, (place, germ)| add(block, germ, Some(place)));
    Prepared { transforms: transforms.collect(), kept, leaves: germ.clone(), germ }
}

/// Raises the blocks of all states level by level, to `most` or while they are small; returns the level.
fn raise(states: &mut [Prepared], most: u32) -> u32 {
    for height in 0..most {
        let rows = |state: &Prepared| {
            let below = state.transforms.iter().map(|transform| states[transform.target].leaves.rows);
            (state.kept.rows + below.sum::<usize>()) * state.kept.columns
        };
        if states.iter().map(rows).max().unwrap_or(0) > BLOCK_WEIGHTS {
            return height;
        }
        let raised: Vec<Block> = states.iter().map(|state| one_higher(states, state)).collect();
        for (state, leaves) in states.iter_mut().zip(raised) {
            state.leaves = leaves;
        }
    }
    most
}

fn one_higher(states: &[Prepared], state: &Prepared) -> Block {
    let pieces = (0..).zip(&state.transforms).map(|(letter, transform)| Below {
        letter,
        matrix: &transform.matrix,
        block: &states[transform.target].leaves,
    });
    Block::stacked(&state.kept, &pieces.collect::<Vec<_>>())
}
