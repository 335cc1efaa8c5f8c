//! Joins of segment germs (GEOMETRY 3): whether consecutive pieces of a curve meet end to start at every level, for all
//! control points, by exact arithmetic on the weights. Where weights are rounded, a gap within rounding is told apart from
//! both a join and an open one.
//!
//! With start_0, end_0 the germ's rows, the first vertex of the chain of level k+1 has the weights
//! start_{k+1}(s) = start_k(target of the first transform)·T_first, and its last vertex likewise. Pieces i and i+1 meet at
//! every level when end_k(target_i)·T_i = start_k(target_{i+1})·T_{i+1} for all k ≥ 0. Both sides, as sequences in k,
//! obey linear recurrences whose orders are at most the sums of control points over the states that the first (last)
//! transforms lead through (Cayley–Hamilton); their difference obeys one of the summed order N, so it vanishes for all k
//! once it does for k < N. Rows that no longer change end the proof sooner.

use std::collections::{BTreeMap, BTreeSet};

use crate::exact::{MAX_BITS, Rational};

use super::automaton::{Automaton, State, StateId, Transform};
use super::matrix::row_times;

/// Most multiplications of exact numbers spent on one proof, each counted once more for every 64 bits.
const WORK_BUDGET: usize = 500_000;

/// Whether pieces meet at every level, for all control points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Joins {
    /// They do.
    Joined,
    /// Their weights are rounded, and they meet to within [`ROUNDING`] at the levels looked at: the widest gap.
    Rounded(OpenJoin),
    /// These two do not.
    Open(OpenJoin),
    /// A state that the figure leads to is not drawn as a segment, so it is no curve at all.
    NotSegments {
        /// The first such state.
        state: StateId,
    },
    /// They meet at all levels looked at, but the proof needs more than is allowed.
    Unproved {
        /// How many levels were looked at.
        levels: u32,
    },
}

impl Joins {
    /// Whether pieces are one chain: exactly, or but for rounding.
    pub fn hold(&self) -> bool {
        matches!(self, Joins::Joined | Joins::Rounded(_))
    }
}

/// Two consecutive pieces that do not meet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OpenJoin {
    /// The state whose pieces they are.
    pub state: StateId,
    /// The place of the piece's transform that ends too early or late; for windows, 0.
    pub left: usize,
    /// The place of the transform whose piece should start there; for windows, 1.
    pub right: usize,
    /// The level of the state's figure at which they part: at least 1 for transforms, at least 0 for windows.
    pub level: u32,
    /// Weights of the left piece's end, on the state's control points (for windows, on one point more).
    pub left_weights: Vec<Rational>,
    /// Weights of the right piece's start, on the same points.
    pub right_weights: Vec<Rational>,
}

impl OpenJoin {
    /// The largest difference of two weights.
    pub fn gap(&self) -> f64 {
        largest(self.left_weights.iter().zip(&self.right_weights).map(|(left, right)| left - right))
    }
}

/// Differences of weights up to this part of the largest weight around are put down to rounding.
pub const ROUNDING: f64 = 1e-9;

/// Whether two rows of weights on the points of `state` differ by no more than rounding explains: a number in the weights
/// of the state, or of one it leads to, is rounded, and no difference exceeds [`ROUNDING`] times the largest weight of the
/// rows and of the state's germ (at least 1; in plane and space weights are millimetres).
///
/// # Panics
/// When the state is not of this automaton.
pub fn is_rounding(automaton: &Automaton, state: StateId, left: &[Rational], right: &[Rational]) -> bool {
    if !automaton.reachable(state).into_iter().any(|id| automaton.state(id).rounded) {
        return false;
    }
    let germ = automaton.state(state).germ.vertices.iter().flatten();
    let size = largest(germ.chain(left).chain(right).cloned()).max(1.0);
    largest(left.iter().zip(right).map(|(left, right)| left - right)) <= ROUNDING * size
}

fn largest(weights: impl Iterator<Item = Rational>) -> f64 {
    weights.map(|weight| weight.abs().to_f64()).fold(0.0, f64::max)
}

/// Whether all pieces of the curve of `state`, and of every state it leads to, meet end to start.
///
/// # Panics
/// When the state is not of this automaton.
pub fn joins(automaton: &Automaton, state: StateId) -> Joins {
    let mut ends = match Ends::new(automaton, state) {
        Ok(ends) => ends,
        Err(state) => return Joins::NotSegments { state },
    };
    let pairs: Vec<(StateId, usize, u32)> = automaton
        .reachable(state)
        .into_iter()
        .flat_map(|id| (1..automaton.state(id).transforms.len()).map(move |right| (id, right)))
        .map(|(id, right)| {
            let transforms = &automaton.state(id).transforms;
            let order =
                ends.last_order(transforms[right - 1].target) + ends.first_order(transforms[right].target);
            (id, right, order)
        })
        .collect();
    let levels = pairs.iter().map(|(_, _, order)| *order).max().unwrap_or(0);
    ends.prove(levels, |ends, k| {
        let open = pairs.iter().filter(|(_, _, order)| k < *order);
        open.filter_map(|(id, right, _)| ends.transforms_apart(*id, *right, k)).collect()
    })
}

/// Whether the windows (p0 … p_{n−1}) and (p1 … p_n) of a list of control points meet, as those of a B-spline do: the end
/// of the first is the start of the second at every level. Whether the pieces within a window meet is [`joins`].
///
/// # Panics
/// When the state is not of this automaton.
pub fn windows_join(automaton: &Automaton, state: StateId) -> Joins {
    let mut ends = match Ends::new(automaton, state) {
        Ok(ends) => ends,
        Err(state) => return Joins::NotSegments { state },
    };
    let levels = ends.last_order(state) + ends.first_order(state);
    ends.prove(levels, |ends, k| {
        let mut left_weights = ends.last[&state].clone();
        left_weights.push(Rational::ZERO);
        let mut right_weights = vec![Rational::ZERO];
        right_weights.extend_from_slice(&ends.first[&state]);
        let apart = OpenJoin { state, left: 0, right: 1, level: k, left_weights, right_weights };
        if apart.left_weights == apart.right_weights { Vec::new() } else { vec![apart] }
    })
}

/// The weights of the first and the last vertex of every reachable state's chain, at one level.
struct Ends<'a> {
    automaton: &'a Automaton,
    first: BTreeMap<StateId, Vec<Rational>>,
    last: BTreeMap<StateId, Vec<Rational>>,
    work_left: usize,
    /// The widest gap that is put down to rounding.
    rounded: Option<OpenJoin>,
}

impl<'a> Ends<'a> {
    /// At level 0: the germs' ends; the state that has none.
    fn new(automaton: &'a Automaton, state: StateId) -> Result<Ends<'a>, StateId> {
        let (mut first, mut last) = (BTreeMap::new(), BTreeMap::new());
        for id in automaton.reachable(state) {
            let (start, end) = automaton.state(id).germ.ends().ok_or(id)?;
            first.insert(id, start.to_vec());
            last.insert(id, end.to_vec());
        }
        Ok(Ends { automaton, first, last, work_left: WORK_BUDGET, rounded: None })
    }

    /// Looks for a parting at the levels below `levels`, and says that there is none at any level.
    fn prove(&mut self, levels: u32, apart: impl Fn(&Ends<'_>, u32) -> Vec<OpenJoin>) -> Joins {
        for k in 0..levels {
            for open in apart(self, k) {
                if !is_rounding(self.automaton, open.state, &open.left_weights, &open.right_weights) {
                    return Joins::Open(open);
                }
                let wider = |known: &OpenJoin| known.gap() < open.gap();
                if self.rounded.as_ref().is_none_or(wider) {
                    self.rounded = Some(open);
                }
            }
            match self.step() {
                Some(true) => {}
                Some(false) => break,
                None => return Joins::Unproved { levels: k + 1 },
            }
        }
        self.rounded.take().map_or(Joins::Joined, Joins::Rounded)
    }

    /// One level deeper; whether anything changed, or `None` when the budget is spent.
    fn step(&mut self) -> Option<bool> {
        let weights = self.first.values().chain(self.last.values()).flatten();
        let bits = weights.map(Rational::bits).max().unwrap_or(0);
        if bits > MAX_BITS {
            return None;
        }
        let multiplications =
            self.first.keys().map(|id| self.multiplications(*id)).fold(0, usize::saturating_add);
        let work = multiplications.saturating_mul(1 + bits as usize / 64);
        self.work_left = self.work_left.checked_sub(work)?;
        let first = self.stepped(&self.first, first_transform);
        let last = self.stepped(&self.last, last_transform);
        let changed = first != self.first || last != self.last;
        (self.first, self.last) = (first, last);
        Some(changed)
    }

    fn stepped(
        &self,
        rows: &BTreeMap<StateId, Vec<Rational>>,
        choose: fn(&State) -> &Transform,
    ) -> BTreeMap<StateId, Vec<Rational>> {
        let step = |id: &StateId| {
            let transform = choose(self.automaton.state(*id));
            (*id, row_times(&rows[&transform.target], &transform.matrix))
        };
        rows.keys().map(step).collect()
    }

    /// Multiplications of one step of one state, and of comparing its pieces: weights of 0 cost none.
    fn multiplications(&self, id: StateId) -> usize {
        let rows = |ends: &BTreeMap<StateId, Vec<Rational>>, target: StateId| {
            ends[&target].iter().filter(|weight| !weight.is_zero()).count()
        };
        let entries = |transform: &Transform| {
            let rows = rows(&self.first, transform.target) + rows(&self.last, transform.target);
            rows * transform.matrix.columns()
        };
        self.automaton.state(id).transforms.iter().map(entries).sum::<usize>()
    }

    /// The join of two neighbouring transforms at level k of their pieces, when it is open.
    fn transforms_apart(&self, state: StateId, right: usize, k: u32) -> Option<OpenJoin> {
        let transforms = &self.automaton.state(state).transforms;
        let (a, b) = (&transforms[right - 1], &transforms[right]);
        let left_weights = row_times(&self.last[&a.target], &a.matrix);
        let right_weights = row_times(&self.first[&b.target], &b.matrix);
        let apart = OpenJoin { state, left: right - 1, right, level: k + 1, left_weights, right_weights };
        (apart.left_weights != apart.right_weights).then_some(apart)
    }

    fn first_order(&self, state: StateId) -> u32 {
        self.order(state, first_transform)
    }

    fn last_order(&self, state: StateId) -> u32 {
        self.order(state, last_transform)
    }

    /// A bound of the order of the recurrence which the end's weights obey: the control points of all states that the
    /// chosen transforms lead through.
    fn order(&self, state: StateId, choose: fn(&State) -> &Transform) -> u32 {
        let mut visited = BTreeSet::new();
        let mut id = state;
        while visited.insert(id) {
            id = choose(self.automaton.state(id)).target;
        }
        let points: usize = visited.iter().map(|id| self.automaton.state(*id).control_points).sum();
        u32::try_from(points).unwrap_or(u32::MAX / 2)
    }
}

/// The first transform; every state of an automaton has one.
fn first_transform(state: &State) -> &Transform {
    &state.transforms[0]
}

fn last_transform(state: &State) -> &Transform {
    &state.transforms[state.transforms.len() - 1]
}
