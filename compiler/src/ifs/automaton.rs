//! [`Automaton`]: the states of a graph-directed ifs and the transforms between them (LANGUAGE 2).
//!
//! Checked on construction, so that everything else may rely on sizes, targets and sums of weights.

use std::collections::BTreeSet;
use std::fmt;

use crate::exact::Rational;

use super::germ::Germ;
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

/// What the coordinates of a state's points mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StateSpace {
    /// Control points, free to lie anywhere.
    Control,
    /// The three points of an affine frame of the plane: the origin, and 1 mm from it along each axis.
    Plane,
    /// The four points of an affine frame of space, likewise.
    Space,
}

/// A boundary operator (GEOMETRY 3): a part of the state's edge, as another state on points of this one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Boundary {
    /// Its name.
    pub name: String,
    /// The state that it is.
    pub target: StateId,
    /// Rows: control points of the target; columns: control points of the state.
    pub matrix: Matrix,
}

/// An end of the curve that segment germs draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Where its first piece starts.
    Start,
    /// Where its last piece ends.
    Finish,
}

/// One side of a stated join.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// `left.end`: a boundary of the piece of a transform, by their places in the state and in the transform's target.
    Piece {
        /// Place of the transform.
        transform: usize,
        /// Place of the boundary in the transform's target.
        boundary: usize,
    },
    /// `start`, `bottom.left`: a boundary of the state itself after one step of its own ifs.
    Own {
        /// Place of the boundary in the state.
        boundary: usize,
        /// Place of the transform in the boundary's ifs.
        transform: usize,
    },
    /// `left.end` of a piece that is drawn as segments.
    PieceEnd {
        /// Place of the transform.
        transform: usize,
        /// Which end.
        end: End,
    },
    /// `end` of a state that is drawn as segments, after one step.
    OwnEnd(End),
}

/// `join left.end = right.start`
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StatedJoin {
    /// As written before the sign.
    pub left: Side,
    /// As written after it.
    pub right: Side,
}

/// One ifs with one set of arguments.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct State {
    /// As an architect would write it: `bezier3(t: 23/50)`.
    pub name: String,
    /// How many control points it stands on.
    pub control_points: usize,
    /// Their names, or those of the points of its frame.
    pub point_names: Vec<String>,
    /// Its transforms, in the order of declaration, which for a curve is the order along it.
    pub transforms: Vec<Transform>,
    /// What is drawn at the last level.
    pub germ: Germ,
    /// What is drawn at every level on the way (LANGUAGE 2).
    pub keep: Vec<Germ>,
    /// What its points mean.
    pub space: StateSpace,
    /// Whether a number in its weights is rounded, such as the cosine of most angles: exact proofs then hold for the
    /// rounded numbers only.
    pub rounded: bool,
    /// Its named boundaries.
    pub boundaries: Vec<Boundary>,
    /// The joins that are stated of it.
    pub stated_joins: Vec<StatedJoin>,
}

impl State {
    /// A state on control points `p0`, `p1`, …, without `keep`, boundaries and stated joins.
    pub fn new(name: String, control_points: usize, transforms: Vec<Transform>, germ: Germ) -> State {
        let (keep, boundaries, stated_joins) = (Vec::new(), Vec::new(), Vec::new());
        let space = StateSpace::Control;
        State {
            name,
            control_points,
            point_names: (0..control_points).map(|point| format!("p{point}")).collect(),
            transforms,
            germ,
            keep,
            space,
            rounded: false,
            boundaries,
            stated_joins,
        }
    }
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
    /// A germ that has not the vertices its shape asks for.
    GermVertices {
        /// The state.
        state: String,
    },
    /// A boundary to a state that is not there, or whose matrix has a wrong size or rows that do not sum to 1.
    Boundary {
        /// The state.
        state: String,
        /// The boundary.
        boundary: String,
    },
    /// A stated join of something that is not there.
    StatedJoin {
        /// The state.
        state: String,
        /// Its place among the stated joins.
        join: usize,
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
            AutomatonError::GermVertices { state } => {
                write!(f, "the germ of `{state}` has not the vertices its shape asks for")
            }
            AutomatonError::Boundary { state, boundary } => {
                write!(f, "boundary `{boundary}` of `{state}` does not fit what it is to be")
            }
            AutomatonError::StatedJoin { state, join } => {
                write!(f, "join {join} of `{state}` names what is not there")
            }
            AutomatonError::GermWeights { state, vertex, expected, found, sum } => write!(
                f,
                "vertex {vertex} of the germ of `{state}` has {found} weights of sum {sum}; {expected} of sum 1 are needed"
            ),
        }
    }
}

impl std::error::Error for AutomatonError {}

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
            check_boundaries(&states, state)?;
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
    let mut germs = std::iter::once(&state.germ).chain(&state.keep);
    if germs.any(|germ| !germ.is_complete()) {
        return Err(AutomatonError::GermVertices { state: state.name.clone() });
    }
    let germs = std::iter::once(&state.germ).chain(&state.keep);
    for (vertex, weights) in germs.flat_map(|germ| germ.vertices.iter().enumerate()) {
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

fn check_boundaries(states: &[State], state: &State) -> Result<(), AutomatonError> {
    for boundary in &state.boundaries {
        let fits = states.get(boundary.target.index()).is_some_and(|target| {
            (boundary.matrix.rows(), boundary.matrix.columns())
                == (target.control_points, state.control_points)
        });
        if !fits || boundary.matrix.row_not_summing_to_one().is_some() {
            let (state, boundary) = (state.name.clone(), boundary.name.clone());
            return Err(AutomatonError::Boundary { state, boundary });
        }
    }
    let there = |side: &Side| match *side {
        Side::Piece { transform, boundary } => {
            let target = state.transforms.get(transform).and_then(|piece| states.get(piece.target.index()));
            target.is_some_and(|target| boundary < target.boundaries.len())
        }
        Side::Own { boundary, transform } => {
            let target = state.boundaries.get(boundary).and_then(|own| states.get(own.target.index()));
            target.is_some_and(|target| transform < target.transforms.len())
        }
        Side::PieceEnd { transform, .. } => {
            let target = state.transforms.get(transform).and_then(|piece| states.get(piece.target.index()));
            target.is_some_and(|target| target.germ.ends().is_some())
        }
        Side::OwnEnd(_) => state.germ.ends().is_some(),
    };
    match state.stated_joins.iter().position(|join| !there(&join.left) || !there(&join.right)) {
        Some(join) => Err(AutomatonError::StatedJoin { state: state.name.clone(), join }),
        None => Ok(()),
    }
}
