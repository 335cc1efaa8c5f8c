//! Tests of the exact numbers.

mod polynomials;
mod rationals;
