//! Vertices of chains of windows, plain and rational.

use crate::ifs::Automaton;

use super::super::chain::{ChainPlan, homogeneous, window_count};
use super::basis::{Basis, basis};

/// The vertices of a chain as rows (wx, wy, wz, w), in chain order: those that two windows share once, and where the
/// chain is closed the first one not again at its end. The weights are exactly 1 where it has none.
pub fn chain_rows(automaton: &Automaton, chain: &ChainPlan) -> Vec<[f64; 4]> {
    let basis = basis(automaton, chain.state, chain.level);
    match &chain.weights {
        Some(weights) => chain_values(&basis, chain, &homogeneous(&chain.points, weights)),
        None => {
            let points = chain_values(&basis, chain, &chain.points);
            points.into_iter().map(|[x, y, z]| [x, y, z, 1.0]).collect()
        }
    }
}

/// The vertices of a chain in millimetres, as [`chain_rows`], divided by their weights.
pub fn chain_points(automaton: &Automaton, chain: &ChainPlan) -> Vec<[f64; 3]> {
    chain_rows(automaton, chain).into_iter().map(divided).collect()
}

/// Numbers of control points brought to the vertices of a chain: for a rational one the weighted mean.
pub(super) fn chain_numbers(automaton: &Automaton, chain: &ChainPlan, numbers: &[f64]) -> Vec<f64> {
    let basis = basis(automaton, chain.state, chain.level);
    let weight = |place: usize| chain.weights.as_ref().map_or(1.0, |weights| weights[place]);
    let rows: Vec<[f64; 2]> =
        numbers.iter().enumerate().map(|(place, number)| [number * weight(place), weight(place)]).collect();
    let rows = chain_values(&basis, chain, &rows).into_iter();
    match chain.weights {
        Some(_) => rows.map(|[number, weight]| number / weight).collect(),
        None => rows.map(|[number, _]| number).collect(),
    }
}

/// A row divided by its weight; as it is where that is 1.
pub(super) fn divided([x, y, z, w]: [f64; 4]) -> [f64; 3] {
    if w == 1.0 { [x, y, z] } else { [x / w, y / w, z / w] }
}

/// Σ_k basis[row][k] · values[window + k], window by window.
fn chain_values<const N: usize>(basis: &Basis, chain: &ChainPlan, values: &[[f64; N]]) -> Vec<[f64; N]> {
    let windows = window_count(values.len(), basis.columns, chain.closed);
    let mut vertices = Vec::with_capacity(windows * basis.rows.saturating_sub(1) + 1);
    for window in 0..windows {
        for row in usize::from(window > 0)..basis.rows {
            let mut sum = [0.0; N];
            for (place, weight) in basis.row(row).iter().enumerate() {
                let value = &values[(window + place) % values.len()];
                for (total, entry) in sum.iter_mut().zip(value) {
                    *total += weight * entry;
                }
            }
            vertices.push(sum);
        }
    }
    if chain.closed {
        vertices.pop();
    }
    vertices
}
