//! Points of a curve.

use super::basis::Basis;

/// The vertices of a chain on placed control points, in chain order: row · P, summed in the order of the points.
/// Lengths are those of `points`; there must be as many as the basis has columns, others are not read.
pub fn curve_points(basis: &Basis, points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let vertex = |row: &[f64]| {
        let mut sum = [0.0; 3];
        for (weight, point) in row.iter().zip(points) {
            for (total, coordinate) in sum.iter_mut().zip(point) {
                *total += weight * coordinate;
            }
        }
        sum
    };
    basis.weights.chunks_exact(basis.columns.max(1)).map(vertex).collect()
}
