//! Affine combinations as a point and differences: p0, p1 − p0, p2 − p0, … instead of p0, p1, p2, ….

use crate::exact::Rational;
use crate::ifs::Matrix;

/// The first point, and the others from there.
pub(super) fn differences(points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let first = points.first().copied().unwrap_or_default();
    let others = points.iter().skip(1).map(|point| [0, 1, 2].map(|axis| point[axis] - first[axis]));
    points.first().copied().into_iter().chain(others).collect()
}

/// Weights of points on the first point and differences, row after row: the first weight is 1, since they sum to 1.
pub(super) fn on_differences(rows: &[Vec<Rational>]) -> Vec<f64> {
    let row = |row: &Vec<Rational>| {
        let rest: Vec<f64> = row.iter().skip(1).map(Rational::to_f64).collect();
        std::iter::once(1.0).chain(rest)
    };
    rows.iter().flat_map(row).collect()
}

/// A transform, row-major, from the first point and differences to the first image and the others from there.
pub(super) fn of_differences(matrix: &Matrix) -> Vec<f64> {
    let mut out = Vec::with_capacity(matrix.entries().len());
    for row in 0..matrix.rows() {
        out.push(if row == 0 { 1.0 } else { 0.0 });
        for (entry, first) in matrix.row(row).iter().zip(matrix.row(0)).skip(1) {
            out.push(if row == 0 { entry.to_f64() } else { (entry - first).to_f64() });
        }
    }
    out
}
