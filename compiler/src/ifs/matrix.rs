//! [`Matrix`]: dense matrices of exact rationals, row-major.

use std::fmt;

use crate::exact::Rational;

/// Why rows do not make a matrix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MatrixError {
    /// There is no row, or the rows have no entries.
    Empty,
    /// The rows have different lengths.
    Ragged {
        /// The first row that differs from row 0.
        row: usize,
    },
    /// The inner sizes of a product differ.
    Sizes {
        /// Columns of the left factor.
        left_columns: usize,
        /// Rows of the right factor.
        right_rows: usize,
    },
}

impl fmt::Display for MatrixError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MatrixError::Empty => f.write_str("a matrix without entries"),
            MatrixError::Ragged { row } => write!(f, "row {row} of the matrix differs in length from row 0"),
            MatrixError::Sizes { left_columns, right_rows } => {
                write!(f, "a matrix of {left_columns} columns times one of {right_rows} rows")
            }
        }
    }
}

impl std::error::Error for MatrixError {}

/// An m × n matrix of exact numbers. For a transform: one row an image point, its barycentric weights on the n control
/// points (GEOMETRY 1).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    entries: Vec<Rational>,
}

impl Matrix {
    /// A matrix of these rows.
    ///
    /// # Errors
    /// [`MatrixError::Empty`], [`MatrixError::Ragged`].
    pub fn from_rows(rows: Vec<Vec<Rational>>) -> Result<Matrix, MatrixError> {
        let columns = rows.first().map_or(0, Vec::len);
        if columns == 0 {
            return Err(MatrixError::Empty);
        }
        if let Some(row) = rows.iter().position(|row| row.len() != columns) {
            return Err(MatrixError::Ragged { row });
        }
        Ok(Matrix { rows: rows.len(), columns, entries: rows.into_iter().flatten().collect() })
    }

    /// The matrix whose entry in row i, column j is `entry(i, j)`; sizes may be 0.
    pub(crate) fn from_entries(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> Rational,
    ) -> Matrix {
        let mut entries = Vec::with_capacity(rows * columns);
        for row in 0..rows {
            for column in 0..columns {
                entries.push(entry(row, column));
            }
        }
        Matrix { rows, columns, entries }
    }

    /// The identity of size n × n.
    pub fn identity(size: usize) -> Matrix {
        Matrix::from_entries(
            size,
            size,
            |row, column| if row == column { Rational::ONE } else { Rational::ZERO },
        )
    }

    /// Number of rows, m.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns, n.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// One row of n entries.
    ///
    /// # Panics
    /// When there is no such row.
    pub fn row(&self, row: usize) -> &[Rational] {
        &self.entries[row * self.columns..(row + 1) * self.columns]
    }

    /// All entries, row after row.
    pub fn entries(&self) -> &[Rational] {
        &self.entries
    }

    /// The product `self · right`.
    ///
    /// # Errors
    /// [`MatrixError::Sizes`].
    pub fn product(&self, right: &Matrix) -> Result<Matrix, MatrixError> {
        if self.columns != right.rows {
            return Err(MatrixError::Sizes { left_columns: self.columns, right_rows: right.rows });
        }
        let entries: Vec<Rational> = (0..self.rows).flat_map(|row| row_times(self.row(row), right)).collect();
        Ok(Matrix { rows: self.rows, columns: right.columns, entries })
    }

    /// The first row whose entries do not sum to 1, with that sum; `None` when the matrix is affine.
    pub fn row_not_summing_to_one(&self) -> Option<(usize, Rational)> {
        (0..self.rows).find_map(|row| {
            let sum: Rational = self.row(row).iter().sum();
            (!sum.is_one()).then_some((row, sum))
        })
    }

    /// Whether the matrix is row-stochastic in the affine sense: every row sums to 1. Entries may be negative.
    pub fn is_row_stochastic(&self) -> bool {
        self.row_not_summing_to_one().is_none()
    }

    /// The largest sum of absolute values of a row, the operator norm that belongs to the largest coordinate.
    pub fn infinity_norm(&self) -> Rational {
        (0..self.rows)
            .map(|row| self.row(row).iter().map(Rational::abs).sum())
            .max()
            .unwrap_or(Rational::ZERO)
    }

    /// The nearest doubles, row-major.
    pub fn to_f64(&self) -> Vec<f64> {
        self.entries.iter().map(Rational::to_f64).collect()
    }
}

/// The row vector `row · matrix`; entries beyond the matrix's rows do not count.
pub(crate) fn row_times(row: &[Rational], matrix: &Matrix) -> Vec<Rational> {
    let mut result = vec![Rational::ZERO; matrix.columns];
    for (index, weight) in row.iter().enumerate().take(matrix.rows) {
        if weight.is_zero() {
            continue;
        }
        for (total, entry) in result.iter_mut().zip(matrix.row(index)) {
            if !entry.is_zero() {
                *total += &(weight * entry);
            }
        }
    }
    result
}
