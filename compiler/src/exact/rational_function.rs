//! [`RationalFunction`]: quotients of polynomials, the weights of an ifs with parameters.
//!
//! Equality is decided exactly, by cross multiplication; the form is kept short by cheap cancellations only (common
//! monomials and exact division), so that two equal functions may look different.

use super::polynomial::{AtomId, Polynomial, PolynomialError};
use super::rational::Rational;

/// A quotient of two polynomials with a denominator that is not zero.
#[derive(Clone, Debug)]
pub struct RationalFunction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl RationalFunction {
    /// `numerator / denominator`.
    ///
    /// # Errors
    /// [`PolynomialError::DivisionByZero`] when the denominator is the zero polynomial.
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Result<RationalFunction, PolynomialError> {
        if denominator.is_zero() {
            return Err(PolynomialError::DivisionByZero);
        }
        Ok(RationalFunction { numerator, denominator }.shortened())
    }

    /// A constant.
    pub fn from_rational(value: Rational) -> RationalFunction {
        Polynomial::from_rational(value).into()
    }

    /// The function that is one atom.
    pub fn from_atom(atom: AtomId) -> RationalFunction {
        Polynomial::from_atom(atom).into()
    }

    /// The numerator of the form at hand.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The denominator of the form at hand; never zero.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// How many terms the form at hand has: what an operation on it costs.
    pub fn size(&self) -> usize {
        self.numerator.terms().count() + self.denominator.terms().count()
    }

    /// Whether the function is zero.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The value, when the function is the same constant for all values of its atoms.
    pub fn constant(&self) -> Option<Rational> {
        let (_, denominator) = self.denominator.terms().last()?;
        let Some((_, numerator)) = self.numerator.terms().last() else { return Some(Rational::ZERO) };
        let ratio = numerator.checked_div(denominator).ok()?;
        (self.numerator == self.denominator.scaled(&ratio)).then_some(ratio)
    }

    /// `self + other`.
    ///
    /// # Errors
    /// [`PolynomialError::TooComplex`].
    pub fn checked_add(&self, other: &RationalFunction) -> Result<RationalFunction, PolynomialError> {
        if self.denominator == other.denominator {
            let numerator = self.numerator.checked_add(&other.numerator)?;
            return RationalFunction::new(numerator, self.denominator.clone());
        }
        let left = self.numerator.checked_mul(&other.denominator)?;
        let right = other.numerator.checked_mul(&self.denominator)?;
        RationalFunction::new(left.checked_add(&right)?, self.denominator.checked_mul(&other.denominator)?)
    }

    /// `self − other`.
    ///
    /// # Errors
    /// [`PolynomialError::TooComplex`].
    pub fn checked_sub(&self, other: &RationalFunction) -> Result<RationalFunction, PolynomialError> {
        self.checked_add(&other.negated())
    }

    /// `self × other`.
    ///
    /// # Errors
    /// [`PolynomialError::TooComplex`].
    pub fn checked_mul(&self, other: &RationalFunction) -> Result<RationalFunction, PolynomialError> {
        let numerator = self.numerator.checked_mul(&other.numerator)?;
        RationalFunction::new(numerator, self.denominator.checked_mul(&other.denominator)?)
    }

    /// `self ÷ other`.
    ///
    /// # Errors
    /// [`PolynomialError::DivisionByZero`] when `other` is zero, [`PolynomialError::TooComplex`].
    pub fn checked_div(&self, other: &RationalFunction) -> Result<RationalFunction, PolynomialError> {
        let numerator = self.numerator.checked_mul(&other.denominator)?;
        RationalFunction::new(numerator, self.denominator.checked_mul(&other.numerator)?)
    }

    /// `−self`.
    pub fn negated(&self) -> RationalFunction {
        let numerator = self.numerator.scaled(&-Rational::ONE);
        RationalFunction { numerator, denominator: self.denominator.clone() }
    }

    /// Whether both are the same function: `a/b = c/d` exactly when `a·d = c·b`.
    ///
    /// # Errors
    /// [`PolynomialError::TooComplex`] when the products run into the limits, so that it stays undecided.
    pub fn equals(&self, other: &RationalFunction) -> Result<bool, PolynomialError> {
        if self.denominator == other.denominator {
            return Ok(self.numerator == other.numerator);
        }
        let left = self.numerator.checked_mul(&other.denominator)?;
        Ok(left == other.numerator.checked_mul(&self.denominator)?)
    }

    /// The value where each atom has the value `value_of` gives it; `None` when it gives none for an atom that occurs,
    /// or where the denominator is 0.
    pub fn evaluate(&self, value_of: &dyn Fn(AtomId) -> Option<Rational>) -> Option<Rational> {
        self.numerator.evaluate(value_of)?.checked_div(&self.denominator.evaluate(value_of)?).ok()
    }

    /// The same function in a shorter form: an exact quotient where there is one, no common monomial, and a
    /// denominator whose first printed coefficient is 1.
    fn shortened(self) -> RationalFunction {
        if let Some(Ok(factor)) = self.denominator.constant().map(|constant| constant.reciprocal()) {
            return if factor.is_one() { self } else { self.numerator.scaled(&factor).into() };
        }
        if let Some(quotient) = self.numerator.divided_exactly(&self.denominator) {
            return quotient.into();
        }
        let common = self.denominator.common_monomial().shared_with(&self.numerator.common_monomial());
        let mut numerator = self.numerator.without_monomial(&common);
        let mut denominator = self.denominator.without_monomial(&common);
        if let Some(quotient) = denominator.divided_exactly(&numerator) {
            numerator = Polynomial::from_rational(Rational::ONE);
            denominator = quotient;
        }
        let first = denominator.terms().next().map(|(_, coefficient)| coefficient.reciprocal());
        if let Some(Ok(factor)) = first {
            numerator = numerator.scaled(&factor);
            denominator = denominator.scaled(&factor);
        }
        RationalFunction { numerator, denominator }
    }
}

impl From<Polynomial> for RationalFunction {
    fn from(numerator: Polynomial) -> RationalFunction {
        RationalFunction { numerator, denominator: Polynomial::from_rational(Rational::ONE) }
    }
}
