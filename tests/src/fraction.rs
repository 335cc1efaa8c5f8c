//! Small fractions, for second opinions on exact arithmetic that share no code with the compiler.

/// A fraction in lowest terms, its denominator above 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fraction(pub i128, pub i128);

impl Fraction {
    /// A fraction; the denominator is not 0.
    pub fn new(numerator: i128, denominator: i128) -> Fraction {
        let (mut a, mut b) = (numerator.unsigned_abs(), denominator.unsigned_abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let shared = i128::try_from(a).unwrap_or(1).max(1) * denominator.signum();
        Fraction(numerator / shared, denominator / shared)
    }

    /// The sum.
    #[must_use]
    pub fn plus(self, other: Fraction) -> Fraction {
        Fraction::new(self.0 * other.1 + other.0 * self.1, self.1 * other.1)
    }

    /// The product.
    #[must_use]
    pub fn times(self, other: Fraction) -> Fraction {
        Fraction::new(self.0 * other.0, self.1 * other.1)
    }
}

/// 1.
pub const ONE: Fraction = Fraction(1, 1);
/// 0.
pub const ZERO: Fraction = Fraction(0, 1);
