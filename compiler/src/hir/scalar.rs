//! Numbers as the evaluator holds them: exact as long as they can be, multiples of π apart from the rest, real numbers
//! where nothing else is left, and rational functions of the parameters while an ifs is checked for all of them.
//!
//! Lengths are millimetres, angles radians, times seconds, masses kilograms.

use crate::exact::{PolynomialError, Rational, RationalFunction};
use std::cmp::Ordering;

/// Rationals that need more bits than this go on as real numbers.
const MOST_BITS: u64 = 4096;

/// A number.
#[derive(Clone, Debug)]
pub enum Scalar {
    /// Exactly this.
    Exact(Rational),
    /// Exactly so many times π.
    Pi(Rational),
    /// Rounded to a double.
    Real(f64),
    /// A function of the parameters of the ifs being checked.
    Symbolic(RationalFunction),
}

impl PartialEq for Scalar {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Scalar::Exact(a), Scalar::Exact(b)) | (Scalar::Pi(a), Scalar::Pi(b)) => a == b,
            (Scalar::Real(a), Scalar::Real(b)) => a == b,
            (Scalar::Symbolic(a), Scalar::Symbolic(b)) => a.equals(b).unwrap_or(false),
            _ => false,
        }
    }
}

/// Why an operation has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalarError {
    /// A division by zero.
    DivisionByZero,
    /// The result is not finite.
    NotFinite,
    /// It depends on parameters whose values are not known here.
    Undetermined,
}

impl From<PolynomialError> for ScalarError {
    fn from(error: PolynomialError) -> Self {
        match error {
            PolynomialError::DivisionByZero => ScalarError::DivisionByZero,
            PolynomialError::TooComplex => ScalarError::Undetermined,
        }
    }
}

impl Scalar {
    /// A whole number.
    pub fn integer(value: i64) -> Scalar {
        Scalar::Exact(Rational::from(value))
    }

    /// Zero.
    pub fn zero() -> Scalar {
        Scalar::integer(0)
    }

    /// One.
    pub fn one() -> Scalar {
        Scalar::integer(1)
    }

    /// A real number.
    ///
    /// # Errors
    /// [`ScalarError::NotFinite`] for infinities and NaN.
    pub fn real(value: f64) -> Result<Scalar, ScalarError> {
        if value.is_finite() { Ok(Scalar::Real(value)) } else { Err(ScalarError::NotFinite) }
    }

    /// The nearest double; `None` while it is symbolic.
    pub fn to_f64(&self) -> Option<f64> {
        match self {
            Scalar::Exact(value) => Some(value.to_f64()),
            Scalar::Pi(factor) => Some(factor.to_f64() * core::f64::consts::PI),
            Scalar::Real(value) => Some(*value),
            Scalar::Symbolic(function) => function.constant().map(|value| value.to_f64()),
        }
    }

    /// The exact value; a double is taken at its word. `None` for multiples of π and functions of parameters.
    pub fn to_rational(&self) -> Option<Rational> {
        match self {
            Scalar::Exact(value) => Some(value.clone()),
            Scalar::Pi(factor) => factor.is_zero().then(|| Rational::from(0)),
            Scalar::Real(value) => Rational::from_f64(*value),
            Scalar::Symbolic(function) => function.constant(),
        }
    }

    /// The value as a whole number, where it is one that fits.
    pub fn to_integer(&self) -> Option<i64> {
        self.to_rational()?.to_i64()
    }

    /// What an operation on it costs, beside that of two doubles: 1, and more for long numbers and functions.
    pub fn cost(&self) -> u64 {
        match self {
            Scalar::Exact(value) | Scalar::Pi(value) => 1 + value.bits() / 64,
            Scalar::Real(_) => 1,
            Scalar::Symbolic(function) => function.size() as u64,
        }
    }

    /// Whether it is known to be zero.
    pub fn is_zero(&self) -> bool {
        match self {
            Scalar::Exact(value) | Scalar::Pi(value) => value.is_zero(),
            Scalar::Real(value) => *value == 0.0,
            Scalar::Symbolic(function) => function.is_zero(),
        }
    }

    /// Whether it is known to be one.
    pub fn is_one(&self) -> bool {
        self.to_rational().is_some_and(|value| value.is_one())
    }

    fn to_function(&self) -> Result<RationalFunction, ScalarError> {
        match self {
            Scalar::Symbolic(function) => Ok(function.clone()),
            other => {
                let value = match other {
                    Scalar::Pi(_) => other.to_f64().and_then(Rational::from_f64),
                    _ => other.to_rational(),
                };
                value.map(RationalFunction::from_rational).ok_or(ScalarError::NotFinite)
            }
        }
    }

    fn reals(&self, other: &Scalar, op: fn(f64, f64) -> f64) -> Result<Scalar, ScalarError> {
        match (self.to_f64(), other.to_f64()) {
            (Some(a), Some(b)) => Scalar::real(op(a, b)),
            _ => Err(ScalarError::Undetermined),
        }
    }

    /// The sum.
    ///
    /// # Errors
    /// When it is not finite or not to be determined.
    pub fn plus(&self, other: &Scalar) -> Result<Scalar, ScalarError> {
        match (self, other) {
            (Scalar::Exact(a), Scalar::Exact(b)) => limited(a + b),
            (Scalar::Pi(a), Scalar::Pi(b)) => Ok(Scalar::Pi(a + b)),
            (a, b) if b.is_exact_zero() => Ok(a.clone()),
            (a, b) if a.is_exact_zero() => Ok(b.clone()),
            (Scalar::Symbolic(_), _) | (_, Scalar::Symbolic(_)) => {
                Ok(Scalar::Symbolic(self.to_function()?.checked_add(&other.to_function()?)?))
            }
            _ => self.reals(other, |a, b| a + b),
        }
    }

    /// The difference.
    ///
    /// # Errors
    /// As for [`Scalar::plus`].
    pub fn minus(&self, other: &Scalar) -> Result<Scalar, ScalarError> {
        self.plus(&other.negated())
    }

    /// The opposite.
    pub fn negated(&self) -> Scalar {
        match self {
            Scalar::Exact(value) => Scalar::Exact(-value),
            Scalar::Pi(value) => Scalar::Pi(-value),
            Scalar::Real(value) => Scalar::Real(0.0 - value),
            Scalar::Symbolic(function) => Scalar::Symbolic(function.negated()),
        }
    }

    /// The product.
    ///
    /// # Errors
    /// As for [`Scalar::plus`].
    pub fn times(&self, other: &Scalar) -> Result<Scalar, ScalarError> {
        match (self, other) {
            (Scalar::Exact(a), Scalar::Exact(b)) => limited(a * b),
            (Scalar::Pi(a), Scalar::Exact(b)) | (Scalar::Exact(b), Scalar::Pi(a)) => Ok(Scalar::Pi(a * b)),
            (Scalar::Symbolic(_), _) | (_, Scalar::Symbolic(_)) => {
                Ok(Scalar::Symbolic(self.to_function()?.checked_mul(&other.to_function()?)?))
            }
            _ => self.reals(other, |a, b| a * b),
        }
    }

    /// The quotient.
    ///
    /// # Errors
    /// Also [`ScalarError::DivisionByZero`].
    pub fn over(&self, other: &Scalar) -> Result<Scalar, ScalarError> {
        if other.is_zero() {
            return Err(ScalarError::DivisionByZero);
        }
        let divided = |a: &Rational, b: &Rational| a.checked_div(b).map_err(|_| ScalarError::DivisionByZero);
        match (self, other) {
            (Scalar::Exact(a), Scalar::Exact(b)) | (Scalar::Pi(a), Scalar::Pi(b)) => limited(divided(a, b)?),
            (Scalar::Pi(a), Scalar::Exact(b)) => Ok(Scalar::Pi(divided(a, b)?)),
            (Scalar::Symbolic(_), _) | (_, Scalar::Symbolic(_)) => {
                Ok(Scalar::Symbolic(self.to_function()?.checked_div(&other.to_function()?)?))
            }
            _ => self.reals(other, |a, b| a / b),
        }
    }

    /// Which is larger.
    ///
    /// # Errors
    /// [`ScalarError::Undetermined`] while one of them is symbolic.
    pub fn compare(&self, other: &Scalar) -> Result<Ordering, ScalarError> {
        match (self, other) {
            (Scalar::Exact(a), Scalar::Exact(b)) | (Scalar::Pi(a), Scalar::Pi(b)) => Ok(a.cmp(b)),
            _ => match (self.to_f64(), other.to_f64()) {
                (Some(a), Some(b)) => a.partial_cmp(&b).ok_or(ScalarError::NotFinite),
                _ => Err(ScalarError::Undetermined),
            },
        }
    }

    fn is_exact_zero(&self) -> bool {
        matches!(self, Scalar::Exact(value) | Scalar::Pi(value) if value.is_zero())
    }
}

fn limited(value: Rational) -> Result<Scalar, ScalarError> {
    if value.bits() <= MOST_BITS { Ok(Scalar::Exact(value)) } else { Scalar::real(value.to_f64()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(n: i64, d: i64) -> Scalar {
        Scalar::Exact(Rational::new(n, d).unwrap())
    }

    #[test]
    fn numbers_stay_exact_and_multiples_of_pi_apart() {
        assert_eq!(exact(1, 3).plus(&exact(1, 6)), Ok(exact(1, 2)));
        let right_angle = Scalar::Pi(Rational::new(1, 2).unwrap());
        assert_eq!(right_angle.times(&exact(2, 1)), Ok(Scalar::Pi(Rational::from(1))));
        assert_eq!(right_angle.over(&right_angle), Ok(Scalar::one()));
        assert_eq!(exact(1, 1).over(&Scalar::zero()), Err(ScalarError::DivisionByZero));
        let sum = right_angle.plus(&Scalar::one()).unwrap();
        assert_eq!(sum.to_f64(), Some(core::f64::consts::FRAC_PI_2 + 1.0));
    }

    #[test]
    fn growing_numbers_become_real_and_then_an_error() {
        let mut value = exact(3, 2);
        let outcome = (0..40).try_for_each(|_| {
            value = value.times(&value)?;
            Ok(())
        });
        assert_eq!(outcome, Err(ScalarError::NotFinite));
    }
}
