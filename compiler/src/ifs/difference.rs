//! Difference operators: what a transform does to the differences of control points (GEOMETRY 2).

use crate::exact::Rational;

use super::automaton::{Automaton, StateId, StateSpace, Transform};
use super::matrix::Matrix;
use super::spectrum::euclidean_norm;

/// The matrix L with D·T = L·D, where D takes forward differences: as rows of T sum to 1, `T·P` differs between
/// neighbouring rows only by differences of P. (m−1) × (n−1); L[i][j] = Σ_{c>j} T[i+1][c] − T[i][c].
pub(super) fn forward_difference_operator(transform: &Matrix) -> Matrix {
    let (rows, columns) = (transform.rows() - 1, transform.columns() - 1);
    // Suffix sums from the right, row by row.
    let mut suffix = vec![vec![Rational::ZERO; columns]; rows];
    for (row, sums) in suffix.iter_mut().enumerate() {
        let (upper, lower) = (transform.row(row), transform.row(row + 1));
        let mut total = Rational::ZERO;
        for column in (0..columns).rev() {
            total += &(&lower[column + 1] - &upper[column + 1]);
            sums[column] = total.clone();
        }
    }
    Matrix::from_entries(rows, columns, |row, column| suffix[row][column].clone())
}

/// The linear part of a transform on the differences p_j − p_0, for a frame its matrix in that frame's coordinates.
/// (m−1) × (n−1).
pub(super) fn frame_operator(transform: &Matrix) -> Matrix {
    Matrix::from_entries(transform.rows() - 1, transform.columns() - 1, |row, column| {
        &transform.row(row + 1)[column + 1] - &transform.row(0)[column + 1]
    })
}

/// The factor of one transform: the ∞-norm of its forward difference operator. No difference of neighbouring control
/// points grows by more in one step.
pub fn difference_norm(transform: &Transform) -> Rational {
    forward_difference_operator(&transform.matrix).infinity_norm()
}

/// By how much lengths grow at most in one step: for maps of the plane or of space the 2-norm of the linear part, else the
/// largest growth of a difference of neighbouring control points, [`difference_norm`].
pub fn step_factor(automaton: &Automaton, state: StateId, transform: &Transform) -> f64 {
    let framed = |id: StateId| automaton.state(id).space != StateSpace::Control;
    if framed(state) && framed(transform.target) {
        euclidean_norm(&frame_operator(&transform.matrix))
    } else {
        difference_norm(transform).to_f64()
    }
}

/// One step between two states with its difference operator.
pub(super) struct Edge {
    pub(super) source: StateId,
    pub(super) letter: usize,
    pub(super) target: StateId,
    pub(super) operator: Matrix,
}

/// The steps between all states reachable from `state`, in order of state and letter.
pub(super) fn edges(automaton: &Automaton, state: StateId, operator: fn(&Matrix) -> Matrix) -> Vec<Edge> {
    let mut edges = Vec::new();
    for source in automaton.reachable(state) {
        for (letter, transform) in automaton.state(source).transforms.iter().enumerate() {
            let operator = operator(&transform.matrix);
            edges.push(Edge { source, letter, target: transform.target, operator });
        }
    }
    edges
}
