//! Arithmetic of [`Rational`]: operators by value and by reference, checked division and powers, sums.

use std::fmt;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{CheckedAdd, CheckedMul, CheckedSub, Pow};

use super::rational::{Form, MAX_BITS, Rational};
use super::small;

/// Why an operation on exact numbers has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArithmeticError {
    /// A division by 0, or 0 raised to a negative power.
    DivisionByZero,
    /// The result would need more than [`MAX_BITS`] bits.
    TooLarge,
}

impl fmt::Display for ArithmeticError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ArithmeticError::DivisionByZero => f.write_str("division by zero"),
            ArithmeticError::TooLarge => {
                write!(f, "the exact number would need more than {MAX_BITS} bits")
            }
        }
    }
}

impl std::error::Error for ArithmeticError {}

impl Rational {
    /// `self / divisor`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`].
    pub fn checked_div(&self, divisor: &Rational) -> Result<Rational, ArithmeticError> {
        divisor.reciprocal().map(|reciprocal| self * &reciprocal)
    }

    /// `1 / self`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`].
    pub fn reciprocal(&self) -> Result<Rational, ArithmeticError> {
        if self.is_zero() {
            return Err(ArithmeticError::DivisionByZero);
        }
        Ok(match &self.0 {
            Form::Small(ratio) => Rational::from_small(ratio.recip()),
            Form::Big(ratio) => Rational::from_big(ratio.recip()),
        })
    }

    /// `self` raised to an integer power; `0^0` is 1.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] for a negative power of 0, [`ArithmeticError::TooLarge`], found before
    /// anything is computed, when the result could need more than [`MAX_BITS`] bits.
    pub fn checked_pow(&self, exponent: i32) -> Result<Rational, ArithmeticError> {
        let base = if exponent < 0 { self.reciprocal()? } else { self.clone() };
        let times = exponent.unsigned_abs();
        if base.is_zero() || base.abs().is_one() {
            let keeps_base = base.is_zero() && times > 0 || times % 2 == 1;
            return Ok(if keeps_base { base } else { Rational::ONE });
        }
        if base.bits().saturating_mul(u64::from(times)) > MAX_BITS {
            return Err(ArithmeticError::TooLarge);
        }
        Ok(Rational::from_big(Pow::pow(base.to_big(), times)))
    }
}

macro_rules! operator {
    ($operator:ident, $method:ident, $short:path, $checked:path) => {
        impl<'a> $operator<&'a Rational> for &'a Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                if let (Form::Small(a), Form::Small(b)) = (&self.0, &other.0)
                    && let Some(result) = $short(a, b).or_else(|| $checked(a, b))
                {
                    return Rational::from_small(result);
                }
                Rational::from_big($operator::$method(self.to_big(), other.to_big()))
            }
        }
        by_value!($operator, $method);
    };
}

macro_rules! by_value {
    ($operator:ident, $method:ident) => {
        impl $operator<Rational> for Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational {
                $operator::$method(&self, &other)
            }
        }
        impl $operator<&Rational> for Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                $operator::$method(&self, other)
            }
        }
        impl $operator<Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational {
                $operator::$method(self, &other)
            }
        }
    };
}

operator!(Add, add, small::sum, CheckedAdd::checked_add);
operator!(Sub, sub, small::difference, CheckedSub::checked_sub);
operator!(Mul, mul, small::product, CheckedMul::checked_mul);
by_value!(Div, div);

/// Division by a divisor known not to be 0; [`Rational::checked_div`] is the one for what a user wrote.
///
/// # Panics
/// When the divisor is 0, as integers do.
impl<'a> Div<&'a Rational> for &'a Rational {
    type Output = Rational;
    fn div(self, other: &Rational) -> Rational {
        if let Form::Small(b) = &other.0
            && *b.numer() != 0
        {
            return self * &Rational::from_small(b.recip());
        }
        Rational::from_big(self.to_big() / other.to_big())
    }
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        match &self.0 {
            Form::Small(ratio) => Rational(Form::Small(-*ratio)),
            Form::Big(ratio) => Rational::from_big(-(**ratio).clone()),
        }
    }
}

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        -&self
    }
}

impl AddAssign<&Rational> for Rational {
    fn add_assign(&mut self, other: &Rational) {
        *self = &*self + other;
    }
}

impl SubAssign<&Rational> for Rational {
    fn sub_assign(&mut self, other: &Rational) {
        *self = &*self - other;
    }
}

impl MulAssign<&Rational> for Rational {
    fn mul_assign(&mut self, other: &Rational) {
        *self = &*self * other;
    }
}

impl<'a> Sum<&'a Rational> for Rational {
    fn sum<I: Iterator<Item = &'a Rational>>(terms: I) -> Rational {
        terms.fold(Rational::ZERO, |total, term| &total + term)
    }
}

impl Sum for Rational {
    fn sum<I: Iterator<Item = Rational>>(terms: I) -> Rational {
        terms.fold(Rational::ZERO, |total, term| &total + &term)
    }
}
