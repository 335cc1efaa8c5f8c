//! [`Automaton`]: the states of a graph-directed ifs and the transforms between them (LANGUAGE 2).
//!
//! Checked on construction, so that everything else may rely on sizes, targets and sums of weights.

use std::collections::BTreeSet;
use std::fmt;

use crate::exact::Rational;

use super::matrix::Matrix;

/// Most states an automaton may have: each set of arguments an ifs is used with is one.
pub const MAX_STATES: usize = 1000;

/// The place of a state in its automaton.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StateId(pub u32);

impl StateId {
    /// As an index into [`Automaton::states`].
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// One transform of a state: the images of the target's control points as rows of weights on the state's own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Transform {
    /// Its letter in addresses: `left`, or `branch.0` for a member of a family.
    pub name: String,
    /// The state it continues with.
    pub target: StateId,
    /// Rows: control points of the target; columns: control points of the state.
    pub matrix: Matrix,
}

/// What is drawn at the last level, in weights on the state's control points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Germ {
    /// A straight segment from one weighted point to another.
    Segment {
        /// Weights of its start.
        start: Vec<Rational>,
        /// Weights of its end.
        end: Vec<Rational>,
    },
}

/// One ifs with one set of arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct State {
    /// As an architect would write it: `bezier3(t: 23/50)`.
    pub name: String,
    /// How many control points it stands on.
    pub control_points: usize,
    /// Its transforms, in the order of declaration, which for a curve is the order along it.
    pub transforms: Vec<Transform>,
    /// What is drawn at level 0.
    pub germ: Germ,
}

/// A graph-directed ifs whose sizes, targets and sums of weights are right.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Automaton {
    states: Vec<State>,
}

/// Why states do not make an automaton. Names are those of the states and transforms given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AutomatonError {
    /// More than [`MAX_STATES`] states.
    TooManyStates {
        /// How many there are.
        states: usize,
    },
    /// A state without control points.
    NoControlPoints {
        /// The state.
        state: String,
    },
    /// A state without transforms, which has no figure at level 1.
    NoTransforms {
        /// The state.
        state: String,
    },
    /// A transform to a state that is not there.
    UnknownTarget {
        /// The state.
        state: String,
        /// The transform.
        transform: String,
        /// The missing target.
        target: StateId,
    },
    /// A transform whose matrix has not the size its two states ask for.
    WrongSize {
        /// The state.
        state: String,
        /// The transform.
        transform: String,
        /// Rows and columns needed: control points of the target and of the state.
        expected: (usize, usize),
        /// Rows and columns of the matrix.
        found: (usize, usize),
    },
    /// An image point whose weights do not sum to 1.
    WeightSum {
        /// The state.
        state: String,
        /// The transform.
        transform: String,
        /// Which image point, from 0.
        row: usize,
        /// The sum of its weights.
        sum: Rational,
    },
    /// A vertex of the germ with a wrong number of weights, or whose weights do not sum to 1.
    GermWeights {
        /// The state.
        state: String,
        /// Which vertex of the germ, from 0.
        vertex: usize,
        /// Weights needed.
        expected: usize,
        /// Weights given.
        found: usize,
        /// Their sum.
        sum: Rational,
    },
}

impl fmt::Display for AutomatonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AutomatonError::TooManyStates { states } => {
                write!(f, "{states} states; at most {MAX_STATES} are allowed")
            }
            AutomatonError::NoControlPoints { state } => write!(f, "`{state}` has no control points"),
            AutomatonError::NoTransforms { state } => write!(f, "`{state}` has no transforms"),
            AutomatonError::UnknownTarget { state, transform, target } => {
                write!(
                    f,
                    "transform `{transform}` of `{state}` continues with state {}, which is not there",
                    target.0
                )
            }
            AutomatonError::WrongSize { state, transform, expected, found } => write!(
                f,
                "transform `{transform}` of `{state}` is {} by {} where {} by {} is needed",
                found.0, found.1, expected.0, expected.1
            ),
            AutomatonError::WeightSum { state, transform, row, sum } => {
                write!(
                    f,
                    "weights of image point {row} in transform `{transform}` of `{state}` sum to {sum}, not 1"
                )
            }
            AutomatonError::GermWeights { state, vertex, expected, found, sum } => write!(
                f,
                "vertex {vertex} of the germ of `{state}` has {found} weights of sum {sum}; {expected} of sum 1 are needed"
            ),
        }
    }
}

impl std::error::Error for AutomatonError {}

impl Germ {
    /// Its vertices in order, each a row of weights.
    pub fn vertices(&self) -> Vec<&[Rational]> {
        match self {
            Germ::Segment { start, end } => vec![start, end],
        }
    }
}

impl Automaton {
    /// An automaton of these states; a [`StateId`] is a place in the list.
    ///
    /// # Errors
    /// The first [`AutomatonError`] in the order of states and transforms.
    pub fn try_new(states: Vec<State>) -> Result<Automaton, AutomatonError> {
        if states.len() > MAX_STATES {
            return Err(AutomatonError::TooManyStates { states: states.len() });
        }
        for state in &states {
            check_state(state)?;
            for transform in &state.transforms {
                check_transform(&states, state, transform)?;
            }
        }
        Ok(Automaton { states })
    }

    /// All states.
    pub fn states(&self) -> &[State] {
        &self.states
    }

    /// One state; `None` when the id is not of this automaton.
    pub fn get(&self, id: StateId) -> Option<&State> {
        self.states.get(id.index())
    }

    /// One state.
    ///
    /// # Panics
    /// When the id is not of this automaton; targets of transforms always are.
    pub fn state(&self, id: StateId) -> &State {
        &self.states[id.index()]
    }

    /// The states that can follow `from` after any number of steps, itself included, in increasing order.
    pub fn reachable(&self, from: StateId) -> BTreeSet<StateId> {
        let mut reached = BTreeSet::new();
        let mut open = vec![from];
        while let Some(id) = open.pop() {
            if reached.insert(id) {
                open.extend(self.state(id).transforms.iter().map(|transform| transform.target));
            }
        }
        reached
    }
}

fn check_state(state: &State) -> Result<(), AutomatonError> {
    if state.control_points == 0 {
        return Err(AutomatonError::NoControlPoints { state: state.name.clone() });
    }
    if state.transforms.is_empty() {
        return Err(AutomatonError::NoTransforms { state: state.name.clone() });
    }
    for (vertex, weights) in state.germ.vertices().into_iter().enumerate() {
        let sum: Rational = weights.iter().sum();
        if weights.len() != state.control_points || !sum.is_one() {
            return Err(AutomatonError::GermWeights {
                state: state.name.clone(),
                vertex,
                expected: state.control_points,
                found: weights.len(),
                sum,
            });
        }
    }
    Ok(())
}

fn check_transform(states: &[State], state: &State, transform: &Transform) -> Result<(), AutomatonError> {
    let (name, letter) = (state.name.clone(), transform.name.clone());
    let Some(target) = states.get(transform.target.index()) else {
        return Err(AutomatonError::UnknownTarget {
            state: name,
            transform: letter,
            target: transform.target,
        });
    };
    let expected = (target.control_points, state.control_points);
    let found = (transform.matrix.rows(), transform.matrix.columns());
    if expected != found {
        return Err(AutomatonError::WrongSize { state: name, transform: letter, expected, found });
    }
    match transform.matrix.row_not_summing_to_one() {
        Some((row, sum)) => Err(AutomatonError::WeightSum { state: name, transform: letter, row, sum }),
        None => Ok(()),
    }
}
