//! Exact answers about eigenvalues: whether a matrix has spectral radius at least 1, and whether a multiple of the
//! identity exceeds a Gram matrix.

use crate::exact::{MAX_BITS, Rational};

use super::matrix::Matrix;

/// Whether the spectral radius of a square matrix is at least 1, decided exactly: the characteristic polynomial
/// (Faddeev–LeVerrier) has a root on or outside the unit circle when the Schur–Cohn reduction (Schur 1917, Cohn 1922)
/// fails. `None` when numbers grow beyond [`MAX_BITS`] bits.
pub(super) fn spectral_radius_at_least_one(matrix: &Matrix) -> Option<bool> {
    let mut polynomial = characteristic_polynomial(matrix)?;
    while polynomial.len() > 1 {
        let degree = polynomial.len() - 1;
        // Monic throughout, so the product of all roots is ± the constant coefficient.
        let constant = polynomial[0].clone();
        if constant.abs() >= Rational::ONE {
            return Some(true);
        }
        let scale = (&Rational::ONE - &(&constant * &constant)).reciprocal().ok()?;
        polynomial = (0..degree)
            .map(|i| &(&polynomial[i + 1] - &(&constant * &polynomial[degree - 1 - i])) * &scale)
            .collect();
        if polynomial.iter().any(|coefficient| coefficient.bits() > MAX_BITS) {
            return None;
        }
    }
    Some(false)
}

/// Coefficients of det(x·I − A), constant first, monic.
fn characteristic_polynomial(matrix: &Matrix) -> Option<Vec<Rational>> {
    let size = matrix.rows();
    let mut coefficients = vec![Rational::ONE; size + 1];
    let mut power = matrix.clone();
    for step in 1..=size {
        let trace: Rational = (0..size).map(|i| &power.row(i)[i]).sum();
        if trace.bits() > MAX_BITS {
            return None;
        }
        let coefficient = (-trace).checked_div(&Rational::from(step as u64)).ok()?;
        coefficients[size - step] = coefficient.clone();
        if step < size {
            let shifted = Matrix::from_entries(size, size, |row, column| {
                let entry = &power.row(row)[column];
                if row == column { entry + &coefficient } else { entry.clone() }
            });
            power = matrix.product(&shifted).ok()?;
        }
    }
    Some(coefficients)
}

/// The 2-norm of `matrix` to about nine digits, by halving what [`euclidean_norm_below`] decides.
pub(super) fn euclidean_norm(matrix: &Matrix) -> f64 {
    let is_below =
        |bound: f64| Rational::from_f64(bound).is_none_or(|bound| euclidean_norm_below(matrix, &bound));
    let mut above = 1.0;
    while !is_below(above) {
        above *= 2.0;
    }
    let mut below = 0.0;
    for _ in 0..30 {
        let middle = f64::midpoint(below, above);
        if is_below(middle) { above = middle } else { below = middle }
    }
    f64::midpoint(below, above)
}

/// Whether the 2-norm of `matrix` is below `bound`, decided exactly: `bound²·I − AᵀA` is positive definite when every
/// pivot of its elimination is above 0.
pub(super) fn euclidean_norm_below(matrix: &Matrix, bound: &Rational) -> bool {
    let size = matrix.columns();
    let square = bound * bound;
    let mut rest: Vec<Vec<Rational>> = (0..size)
        .map(|i| {
            (0..size)
                .map(|j| {
                    let gram: Rational =
                        (0..matrix.rows()).map(|row| &matrix.row(row)[i] * &matrix.row(row)[j]).sum();
                    if i == j { &square - &gram } else { -gram }
                })
                .collect()
        })
        .collect();
    for pivot in 0..size {
        let (above, below) = rest.split_at_mut(pivot + 1);
        let pivot_row = &above[pivot];
        if pivot_row[pivot] <= Rational::ZERO {
            return false;
        }
        for row in below {
            let factor = &row[pivot] / &pivot_row[pivot];
            for (entry, above) in row.iter_mut().zip(pivot_row).skip(pivot) {
                *entry -= &(&factor * above);
            }
        }
    }
    true
}
