//! [`Polynomial`]: exact polynomials in named-by-index atoms, limited in degree and terms.
//!
//! Atoms are whatever the caller numbers: parameters of an ifs, or values such as a square root that stay symbols.
//! Nothing here knows their names; printing takes a naming function (`format`).

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fmt;

use super::rational::Rational;

/// Most terms a polynomial may have.
pub const MAX_TERMS: usize = 500;

/// Highest total degree a polynomial may have.
pub const MAX_DEGREE: u32 = 200;

/// Most bits (see [`Rational::bits`]) a coefficient may have.
pub const MAX_COEFFICIENT_BITS: u64 = 1024;

/// An indeterminate, numbered by the caller.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AtomId(pub u32);

/// Why an operation on polynomials has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PolynomialError {
    /// A division by the zero polynomial.
    DivisionByZero,
    /// More than [`MAX_TERMS`] terms, a degree above [`MAX_DEGREE`], or a coefficient of more than [`MAX_COEFFICIENT_BITS`] bits.
    TooComplex,
}

impl fmt::Display for PolynomialError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PolynomialError::DivisionByZero => f.write_str("division by zero"),
            PolynomialError::TooComplex => write!(
                f,
                "the expression grows beyond {MAX_TERMS} terms, degree {MAX_DEGREE} or coefficients of {MAX_COEFFICIENT_BITS} bits"
            ),
        }
    }
}

impl std::error::Error for PolynomialError {}

/// A product of powers of atoms: pairs in increasing order of the atom, exponents above 0. Ordered by total degree,
/// then with higher powers of earlier atoms first, which is also the order of printing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Monomial(pub(super) Vec<(AtomId, u32)>);

impl Monomial {
    fn degree(&self) -> u32 {
        self.0.iter().map(|(_, exponent)| exponent).sum()
    }

    fn exponent(&self, atom: AtomId) -> u32 {
        self.0.iter().find(|(other, _)| *other == atom).map_or(0, |(_, exponent)| *exponent)
    }

    fn product(&self, other: &Monomial) -> Monomial {
        let mut exponents: BTreeMap<AtomId, u32> = self.0.iter().copied().collect();
        for (atom, exponent) in &other.0 {
            *exponents.entry(*atom).or_default() += exponent;
        }
        Monomial(exponents.into_iter().collect())
    }

    /// The largest monomial that divides both.
    pub(super) fn shared_with(&self, other: &Monomial) -> Monomial {
        let smaller = self.0.iter().map(|(atom, exponent)| (*atom, (*exponent).min(other.exponent(*atom))));
        Monomial(smaller.filter(|(_, exponent)| *exponent > 0).collect())
    }

    fn quotient(&self, divisor: &Monomial) -> Option<Monomial> {
        let mut exponents: BTreeMap<AtomId, u32> = self.0.iter().copied().collect();
        for (atom, exponent) in &divisor.0 {
            let mine = exponents.get_mut(atom)?;
            *mine = mine.checked_sub(*exponent)?;
        }
        Some(Monomial(exponents.into_iter().filter(|(_, exponent)| *exponent > 0).collect()))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Monomial) -> Ordering {
        self.degree().cmp(&other.degree()).then_with(|| {
            // Walk both in the order of atoms; at the first difference, the one with more of the earlier atom is first.
            for (a, b) in self.0.iter().zip(&other.0) {
                let order = a.0.cmp(&b.0).then(b.1.cmp(&a.1));
                if order != Ordering::Equal {
                    return order;
                }
            }
            self.0.len().cmp(&other.0.len())
        })
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Monomial) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// A polynomial with exact coefficients. The form is canonical (no zero terms), so derived equality is equality.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polynomial {
    terms: BTreeMap<Monomial, Rational>,
}

impl Polynomial {
    /// The zero polynomial.
    pub fn zero() -> Polynomial {
        Polynomial::default()
    }

    /// A constant.
    pub fn from_rational(value: Rational) -> Polynomial {
        let mut result = Polynomial::zero();
        result.insert(Monomial::default(), &value);
        result
    }

    /// The polynomial that is one atom.
    pub fn from_atom(atom: AtomId) -> Polynomial {
        let mut result = Polynomial::zero();
        result.insert(Monomial(vec![(atom, 1)]), &Rational::ONE);
        result
    }

    /// Whether this is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The value, when no atom occurs.
    pub fn constant(&self) -> Option<Rational> {
        match self.terms.iter().next() {
            None => Some(Rational::ZERO),
            Some((monomial, value)) => {
                (self.terms.len() == 1 && monomial.0.is_empty()).then(|| value.clone())
            }
        }
    }

    /// The total degree; 0 for constants, zero included.
    pub fn degree(&self) -> u32 {
        self.terms.last_key_value().map_or(0, |(monomial, _)| monomial.degree())
    }

    /// `self + other`.
    ///
    /// # Errors
    /// [`PolynomialError::TooComplex`].
    pub fn checked_add(&self, other: &Polynomial) -> Result<Polynomial, PolynomialError> {
        let mut result = self.clone();
        for (monomial, coefficient) in &other.terms {
            result.insert(monomial.clone(), coefficient);
        }
        result.within_limits()
    }

    /// `self − other`.
    ///
    /// # Errors
    /// [`PolynomialError::TooComplex`].
    pub fn checked_sub(&self, other: &Polynomial) -> Result<Polynomial, PolynomialError> {
        self.checked_add(&other.scaled(&-Rational::ONE))
    }

    /// `self × other`.
    ///
    /// # Errors
    /// [`PolynomialError::TooComplex`]; also when the product has more than 50 × [`MAX_TERMS`] products of terms to
    /// add up, which bounds the work.
    pub fn checked_mul(&self, other: &Polynomial) -> Result<Polynomial, PolynomialError> {
        let products = self.terms.len() * other.terms.len();
        if products > 50 * MAX_TERMS || self.degree() + other.degree() > MAX_DEGREE {
            return Err(PolynomialError::TooComplex);
        }
        let mut result = Polynomial::zero();
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                result.insert(a.product(b), &(x * y));
            }
        }
        result.within_limits()
    }

    /// Every coefficient times `factor`.
    pub fn scaled(&self, factor: &Rational) -> Polynomial {
        let mut result = Polynomial::zero();
        for (monomial, coefficient) in &self.terms {
            result.insert(monomial.clone(), &(coefficient * factor));
        }
        result
    }

    /// The quotient when `divisor` divides this polynomial exactly; `None` when it does not, or is zero, or when the
    /// division runs into the limits.
    pub fn divided_exactly(&self, divisor: &Polynomial) -> Option<Polynomial> {
        let (lead, lead_coefficient) = divisor.terms.last_key_value()?;
        let mut remainder = self.clone();
        let mut quotient = Polynomial::zero();
        // The leading monomial falls in a monomial order at every step, so this ends; the count bounds the work.
        for _ in 0..MAX_TERMS {
            let Some((monomial, coefficient)) = remainder.terms.last_key_value() else {
                return Some(quotient);
            };
            let mut step = Polynomial::zero();
            step.insert(monomial.quotient(lead)?, &coefficient.checked_div(lead_coefficient).ok()?);
            remainder = remainder.checked_sub(&step.checked_mul(divisor).ok()?).ok()?;
            quotient = quotient.checked_add(&step).ok()?;
        }
        None
    }

    /// The value where each atom has the value `value_of` gives it; `None` when it gives none for an atom that occurs.
    pub fn evaluate(&self, value_of: &dyn Fn(AtomId) -> Option<Rational>) -> Option<Rational> {
        let mut total = Rational::ZERO;
        for (monomial, coefficient) in &self.terms {
            let mut term = coefficient.clone();
            for (atom, exponent) in &monomial.0 {
                let value = value_of(*atom)?;
                for _ in 0..*exponent {
                    term *= &value;
                }
            }
            total += &term;
        }
        Some(total)
    }

    /// The terms in the order of printing: lower degrees first.
    pub(super) fn terms(&self) -> impl Iterator<Item = (&Monomial, &Rational)> {
        self.terms.iter()
    }

    /// The largest monomial that divides every term.
    pub(super) fn common_monomial(&self) -> Monomial {
        let mut terms = self.terms.keys();
        let first = terms.next().cloned().unwrap_or_default();
        terms.fold(first, |common, monomial| common.shared_with(monomial))
    }

    /// Each monomial divided by `monomial`, which must divide them all (others are left out).
    pub(super) fn without_monomial(&self, monomial: &Monomial) -> Polynomial {
        let divided =
            self.terms.iter().filter_map(|(key, value)| Some((key.quotient(monomial)?, value.clone())));
        Polynomial { terms: divided.collect() }
    }

    fn insert(&mut self, monomial: Monomial, coefficient: &Rational) {
        match self.terms.entry(monomial) {
            Entry::Vacant(place) => {
                if !coefficient.is_zero() {
                    place.insert(coefficient.clone());
                }
            }
            Entry::Occupied(mut place) => {
                *place.get_mut() += coefficient;
                if place.get().is_zero() {
                    place.remove();
                }
            }
        }
    }

    fn within_limits(self) -> Result<Polynomial, PolynomialError> {
        let too_long = self.terms.values().any(|coefficient| coefficient.bits() > MAX_COEFFICIENT_BITS);
        if self.terms.len() > MAX_TERMS || self.degree() > MAX_DEGREE || too_long {
            return Err(PolynomialError::TooComplex);
        }
        Ok(self)
    }
}
