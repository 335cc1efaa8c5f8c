//! Printing of polynomials and of their quotients as an architect would write them: `1 - t`, `2*t^2`, `t/(1 + t)`.

use std::fmt;

use super::polynomial::{AtomId, Monomial, Polynomial};
use super::rational::Rational;
use super::rational_function::RationalFunction;

/// A polynomial with names for its atoms, to be printed; made by [`Polynomial::display`].
pub struct PolynomialDisplay<'a> {
    polynomial: &'a Polynomial,
    name_of: &'a dyn Fn(AtomId) -> String,
}

/// A rational function with names for its atoms, to be printed; made by [`RationalFunction::display`].
pub struct RationalFunctionDisplay<'a> {
    function: &'a RationalFunction,
    name_of: &'a dyn Fn(AtomId) -> String,
}

impl Polynomial {
    /// Prints the polynomial, lower degrees first, with `name_of` naming the atoms.
    pub fn display<'a>(&'a self, name_of: &'a dyn Fn(AtomId) -> String) -> PolynomialDisplay<'a> {
        PolynomialDisplay { polynomial: self, name_of }
    }
}

impl RationalFunction {
    /// Prints the function with `name_of` naming the atoms; without `/` where the denominator is 1.
    pub fn display<'a>(&'a self, name_of: &'a dyn Fn(AtomId) -> String) -> RationalFunctionDisplay<'a> {
        RationalFunctionDisplay { function: self, name_of }
    }
}

impl fmt::Display for PolynomialDisplay<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.polynomial.is_zero() {
            return f.write_str("0");
        }
        for (place, (monomial, coefficient)) in self.polynomial.terms().enumerate() {
            match (place, coefficient.is_negative()) {
                (0, true) => f.write_str("-")?,
                (0, false) => {}
                (_, true) => f.write_str(" - ")?,
                (_, false) => f.write_str(" + ")?,
            }
            write_term(f, monomial, &coefficient.abs(), self.name_of)?;
        }
        Ok(())
    }
}

impl fmt::Display for RationalFunctionDisplay<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numerator = self.function.numerator().display(self.name_of);
        let denominator = self.function.denominator().display(self.name_of);
        if self.function.denominator().constant().is_some_and(|value| value.is_one()) {
            return write!(f, "{numerator}");
        }
        if self.function.numerator().terms().count() > 1 {
            write!(f, "({numerator})")?;
        } else {
            write!(f, "{numerator}")?;
        }
        if is_single_atom(self.function.denominator()) {
            write!(f, "/{denominator}")
        } else {
            write!(f, "/({denominator})")
        }
    }
}

/// Whether the polynomial prints as one name or one power, which needs no brackets after `/`.
fn is_single_atom(polynomial: &Polynomial) -> bool {
    let mut terms = polynomial.terms();
    let first = terms.next();
    terms.next().is_none()
        && first.is_some_and(|(monomial, coefficient)| monomial.0.len() == 1 && coefficient.is_one())
}

fn write_term(
    f: &mut fmt::Formatter<'_>,
    monomial: &Monomial,
    coefficient: &Rational,
    name_of: &dyn Fn(AtomId) -> String,
) -> fmt::Result {
    let mut separator = "";
    if !coefficient.is_one() || monomial.0.is_empty() {
        write!(f, "{coefficient}")?;
        separator = "*";
    }
    for (atom, exponent) in &monomial.0 {
        write!(f, "{separator}{}", name_of(*atom))?;
        if *exponent > 1 {
            write!(f, "^{exponent}")?;
        }
        separator = "*";
    }
    Ok(())
}
