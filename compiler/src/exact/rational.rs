//! [`Rational`]: an exact fraction in lowest terms, held in two `i128` while it fits and in big integers beyond.
//!
//! The type, its construction, its queries and its conversions. Operators are in `arithmetic`, decimals in `decimal`.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{Signed, ToPrimitive, Zero};

/// The size in bits (see [`Rational::bits`]) above which a caller should refuse a number rather than compute on with
/// it. Ample for every design: the doubles with the longest fractions need about 1,100.
pub const MAX_BITS: u64 = 4096;

/// An exact rational number in lowest terms with a positive denominator.
///
/// Numbers whose numerator and denominator fit in an `i128` (its minimum excepted) are held so, all others as big
/// integers; the form is canonical, so derived equality is equality of values.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(pub(super) Form);

#[derive(Clone, Eq)]
pub(super) enum Form {
    Small(Ratio<i128>),
    Big(Box<BigRational>),
}

// In lowest terms equal fractions have equal parts; that of the library divides them step by step, since it cannot know.
impl PartialEq for Form {
    fn eq(&self, other: &Form) -> bool {
        match (self, other) {
            (Form::Small(a), Form::Small(b)) => a.numer() == b.numer() && a.denom() == b.denom(),
            (Form::Big(a), Form::Big(b)) => a.numer() == b.numer() && a.denom() == b.denom(),
            _ => false,
        }
    }
}

impl Hash for Form {
    fn hash<H: Hasher>(&self, state: &mut H) {
        match self {
            Form::Small(ratio) => (ratio.numer(), ratio.denom()).hash(state),
            Form::Big(ratio) => (ratio.numer(), ratio.denom()).hash(state),
        }
    }
}

impl Rational {
    /// 0.
    pub const ZERO: Rational = Rational(Form::Small(Ratio::new_raw(0, 1)));
    /// 1.
    pub const ONE: Rational = Rational(Form::Small(Ratio::new_raw(1, 1)));

    /// `numerator / denominator` in lowest terms; `None` when the denominator is 0.
    pub fn new(numerator: i64, denominator: i64) -> Option<Rational> {
        (denominator != 0)
            .then(|| Rational(Form::Small(Ratio::new(i128::from(numerator), i128::from(denominator)))))
    }

    /// As [`Rational::new`], of integers of any size.
    pub fn from_integers(numerator: BigInt, denominator: BigInt) -> Option<Rational> {
        (!denominator.is_zero()).then(|| Rational::from_big(BigRational::new(numerator, denominator)))
    }

    /// The exact value of a double; `None` for infinities and NaN.
    pub fn from_f64(value: f64) -> Option<Rational> {
        BigRational::from_float(value).map(Rational::from_big)
    }

    /// The nearest double, ties to even; subnormal where it is that small, infinite beyond the range of doubles.
    pub fn to_f64(&self) -> f64 {
        let nearest = match &self.0 {
            Form::Small(ratio) => ratio.to_f64(),
            Form::Big(ratio) => ratio.to_f64(),
        };
        // `None` stands for NaN only, which no fraction with a denominator above 0 gives.
        nearest.unwrap_or(f64::NAN)
    }

    /// The value as an `i64`, when it is an integer that fits.
    pub fn to_i64(&self) -> Option<i64> {
        match &self.0 {
            Form::Small(ratio) if ratio.is_integer() => ratio.numer().to_i64(),
            _ => None,
        }
    }

    /// The numerator; it carries the sign.
    pub fn numerator(&self) -> BigInt {
        match &self.0 {
            Form::Small(ratio) => BigInt::from(*ratio.numer()),
            Form::Big(ratio) => ratio.numer().clone(),
        }
    }

    /// The denominator, above 0.
    pub fn denominator(&self) -> BigInt {
        match &self.0 {
            Form::Small(ratio) => BigInt::from(*ratio.denom()),
            Form::Big(ratio) => ratio.denom().clone(),
        }
    }

    /// Bits of the numerator plus bits of the denominator: the size that budgets count. 0 has 1, 3/4 has 5.
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Form::Small(ratio) => {
                u64::from(128 - ratio.numer().unsigned_abs().leading_zeros())
                    + u64::from(128 - ratio.denom().unsigned_abs().leading_zeros())
            }
            Form::Big(ratio) => ratio.numer().bits() + ratio.denom().bits(),
        }
    }

    /// Whether the value is 0.
    pub fn is_zero(&self) -> bool {
        *self == Rational::ZERO
    }

    /// Whether the value is 1.
    pub fn is_one(&self) -> bool {
        *self == Rational::ONE
    }

    /// Whether the value is below 0.
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Form::Small(ratio) => *ratio.numer() < 0,
            Form::Big(ratio) => ratio.numer().is_negative(),
        }
    }

    /// Whether the value is an integer.
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Form::Small(ratio) => ratio.is_integer(),
            Form::Big(ratio) => ratio.is_integer(),
        }
    }

    /// The absolute value.
    pub fn abs(&self) -> Rational {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// The greatest integer not above the value.
    pub fn floor(&self) -> Rational {
        match &self.0 {
            // `Ratio::floor` subtracts before it divides, which could overflow; Euclid's quotient cannot.
            Form::Small(ratio) => {
                Rational(Form::Small(Ratio::from_integer(ratio.numer().div_euclid(*ratio.denom()))))
            }
            Form::Big(ratio) => Rational::from_big(ratio.floor()),
        }
    }

    /// The canonical form of a small fraction in lowest terms: `i128::MIN` belongs to the big form, so that
    /// negation always fits.
    pub(super) fn from_small(ratio: Ratio<i128>) -> Rational {
        if *ratio.numer() == i128::MIN {
            let (numerator, denominator) = ratio.into_raw();
            return Rational(Form::Big(Box::new(Ratio::new_raw(numerator.into(), denominator.into()))));
        }
        Rational(Form::Small(ratio))
    }

    /// The canonical form of a fraction in lowest terms.
    pub(super) fn from_big(ratio: BigRational) -> Rational {
        match (ratio.numer().to_i128(), ratio.denom().to_i128()) {
            (Some(numerator), Some(denominator)) => {
                Rational::from_small(Ratio::new_raw(numerator, denominator))
            }
            _ => Rational(Form::Big(Box::new(ratio))),
        }
    }

    /// The value in big integers.
    pub(super) fn to_big(&self) -> BigRational {
        match &self.0 {
            Form::Small(ratio) => Ratio::new_raw((*ratio.numer()).into(), (*ratio.denom()).into()),
            Form::Big(ratio) => (**ratio).clone(),
        }
    }
}

impl Default for Rational {
    fn default() -> Self {
        Rational::ZERO
    }
}

macro_rules! from_integer {
    ($($integer:ty),*) => {$(
        impl From<$integer> for Rational {
            fn from(value: $integer) -> Rational {
                Rational(Form::Small(Ratio::from_integer(i128::from(value))))
            }
        }
    )*};
}
from_integer!(i32, u32, i64, u64);

impl Ord for Rational {
    fn cmp(&self, other: &Rational) -> Ordering {
        match (&self.0, &other.0) {
            (Form::Small(a), Form::Small(b)) => a.cmp(b),
            _ => self.to_big().cmp(&other.to_big()),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Rational) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// `23/50`, `-1/2`, `3`.
impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Form::Small(ratio) => fmt::Display::fmt(ratio, f),
            Form::Big(ratio) => fmt::Display::fmt(ratio, f),
        }
    }
}

/// As `Display`.
impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
