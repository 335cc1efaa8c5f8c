//! [`Basis`]: the weights of a chain's vertices on its control points.

use std::collections::{BTreeMap, BTreeSet};

use crate::ifs::{Automaton, StateId, StateSpace, Transform};

/// The vertices of a chain as weights on the control points of its state.
#[derive(Clone, Debug, PartialEq)]
pub struct Basis {
    /// Vertices: elements + 1, joined ones once, in chain order.
    pub rows: usize,
    /// Control points.
    pub columns: usize,
    /// Row-major, `rows` × `columns`; every row sums to 1 up to rounding.
    pub weights: Vec<f64>,
}

impl Basis {
    /// The weights of one vertex.
    ///
    /// # Panics
    /// When there is no such row.
    pub fn row(&self, row: usize) -> &[f64] {
        &self.weights[row * self.columns..(row + 1) * self.columns]
    }
}

/// Tables of one level, by state.
type Tables = BTreeMap<StateId, Vec<f64>>;

/// The basis table of `state` at `level`, built from the leaves: A_0 is the germ, A_k(s) stacks A_{k−1}(t)·T over the
/// transforms T to t, with the vertex that two pieces share taken from the earlier one.
///
/// The joins of the state must be proved ([`crate::ifs::joins`]) and its count within a budget
/// ([`crate::plan::budget`]): time and memory are those of the rows.
///
/// # Panics
/// When the state is not of this automaton.
pub fn basis(automaton: &Automaton, state: StateId, level: u32) -> Basis {
    let columns = automaton.state(state).control_points;
    let needed = needed_states(automaton, state, level);
    let mut tables = Tables::new();
    let mut spare: Vec<Vec<f64>> = Vec::new();
    for (height, states) in needed.iter().rev().enumerate() {
        let mut next = Tables::new();
        for id in states {
            let mut table = spare.pop().unwrap_or_default();
            table.clear();
            if height == 0 {
                germ_rows(automaton, *id, &mut table);
            } else {
                stack_pieces(automaton, *id, &tables, &mut table);
            }
            next.insert(*id, table);
        }
        spare.extend(std::mem::replace(&mut tables, next).into_values());
    }
    let weights = tables.remove(&state).unwrap_or_default();
    Basis { rows: weights.len() / columns, columns, weights }
}

/// The states that occur after 0, 1, …, `level` steps.
pub(super) fn needed_states(automaton: &Automaton, state: StateId, level: u32) -> Vec<BTreeSet<StateId>> {
    let mut needed = vec![BTreeSet::from([state])];
    for depth in 0..level as usize {
        let transforms = needed[depth].iter().flat_map(|id| &automaton.state(*id).transforms);
        let next = transforms.map(|transform| transform.target).collect();
        needed.push(next);
    }
    needed
}

fn germ_rows(automaton: &Automaton, state: StateId, table: &mut Vec<f64>) {
    table.extend(automaton.state(state).germ.vertices.iter().flatten().map(|weight| weight.to_f64()));
}

fn stack_pieces(automaton: &Automaton, state: StateId, tables: &Tables, table: &mut Vec<f64>) {
    for (place, transform) in automaton.state(state).transforms.iter().enumerate() {
        let Some(piece) = tables.get(&transform.target) else { continue };
        let inner = transform.matrix.rows();
        let shared = if place == 0 { 0 } else { inner };
        let first = table.len();
        append_product(&piece[shared..], transform, table);
        if automaton.state(state).space != StateSpace::Control {
            complete_frame_rows(&mut table[first..], transform.matrix.columns());
        }
    }
}

/// On a frame of points 1 mm apart the weights are as large as the coordinates, and what their rounded sum lacks to 1
/// would grow from step to step: the origin's weight is what the others leave of 1.
fn complete_frame_rows(rows: &mut [f64], columns: usize) {
    for row in rows.chunks_exact_mut(columns) {
        if let [origin, others @ ..] = row {
            *origin = 1.0 - others.iter().sum::<f64>();
        }
    }
}

/// Appends `rows · T`, the rows of `rows` having as many entries as T has rows.
fn append_product(rows: &[f64], transform: &Transform, table: &mut Vec<f64>) {
    let (inner, columns) = (transform.matrix.rows(), transform.matrix.columns());
    let matrix = transform.matrix.to_f64();
    let first = table.len();
    table.resize(first + rows.len() / inner * columns, 0.0);
    for (row, result) in rows.chunks_exact(inner).zip(table[first..].chunks_exact_mut(columns)) {
        for (weight, image) in row.iter().zip(matrix.chunks_exact(columns)) {
            for (total, entry) in result.iter_mut().zip(image) {
                *total += weight * entry;
            }
        }
    }
}
