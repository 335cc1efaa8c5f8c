//! Exact numbers: rationals of any size, and polynomials and fractions of polynomials over them.
//!
//! Here live the arithmetic, its limits, parsing of decimals and printing. No floating point decides anything here,
//! and nothing here knows what the numbers mean (dimensions, weights and matrices live in other rooms).

mod arithmetic;
mod decimal;
mod format;
mod polynomial;
mod rational;
mod rational_function;
mod small;

pub use arithmetic::ArithmeticError;
pub use decimal::{DecimalError, MAX_DECIMAL_DIGITS, MAX_DECIMAL_EXPONENT};
pub use format::{PolynomialDisplay, RationalFunctionDisplay};
pub use polynomial::{AtomId, MAX_COEFFICIENT_BITS, MAX_DEGREE, MAX_TERMS, Polynomial, PolynomialError};
pub use rational::{MAX_BITS, Rational};
pub use rational_function::RationalFunction;

#[cfg(test)]
mod tests;
