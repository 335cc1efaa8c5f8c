//! Powers, logarithms, angles and remainders. Exact where they can be; the rest through libm.

use super::native::whole;
use super::{Evaluator, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::native::Native;
use crate::hir::scalar::{Scalar, ScalarError};
use crate::hir::tree::Expr;

/// Largest whole exponent.
const MOST_FACTORS: i64 = 1024;

/// Powers that need more bits than this are real numbers.
const MOST_BITS: u64 = 4096;

impl Evaluator<'_> {
    /// A function of one or two numbers.
    pub(super) fn maths(
        &mut self,
        native: Native,
        numbers: &[&Scalar],
        arguments: &[Expr],
    ) -> Outcome<Scalar> {
        let span = arguments[0].span;
        if numbers.iter().any(|x| matches!(x, Scalar::Symbolic(_)) && x.to_rational().is_none()) {
            return Err(Stop::Undetermined);
        }
        let real = |x: &Scalar| x.to_f64().ok_or(ScalarError::Undetermined);
        let outcome = match (native, numbers) {
            (Native::Asin | Native::Acos, [x]) => {
                let one = Scalar::one();
                if self.order(x, &one, span)?.is_gt() || self.order(x, &one.negated(), span)?.is_lt() {
                    return Err(self.outside(native, x, "between -1 and 1", &arguments[0]));
                }
                if native == Native::Asin { angle(x, libm::asin) } else { angle(x, libm::acos) }
            }
            (Native::Atan, [x]) => angle(x, libm::atan),
            (Native::Atan2, [y, x]) => {
                if y.is_zero() && x.is_zero() {
                    return Err(self.outside(native, x, "other than 0 on one side", &arguments[1]));
                }
                let direction = || Ok(libm::atan2(real(y)?, real(x)?));
                direction().and_then(exact_angle)
            }
            (Native::Exp, [x]) => real(x).and_then(|x| Scalar::real(libm::exp(x))),
            (Native::Ln, [x]) => {
                if !self.order(x, &Scalar::zero(), span)?.is_gt() {
                    return Err(self.outside(native, x, "above 0", &arguments[0]));
                }
                real(x).and_then(|x| if x == 1.0 { Ok(Scalar::zero()) } else { Scalar::real(libm::log(x)) })
            }
            (Native::Ceil, [x]) => whole(&x.negated(), 0).map(|below| below.negated()),
            (Native::Mod, [a, b]) => {
                if b.is_zero() {
                    return Err(self.scalar_error(ScalarError::DivisionByZero, arguments[1].span));
                }
                a.over(b).and_then(|ratio| a.minus(&whole(&ratio, 0)?.times(b)?))
            }
            (Native::Pow, [x, n]) => return self.power(x, n, arguments),
            _ => return Err(Stop::Reported),
        };
        outcome.map_err(|error| self.scalar_error(error, span))
    }

    fn power(&mut self, x: &Scalar, n: &Scalar, arguments: &[Expr]) -> Outcome<Scalar> {
        let span = arguments[0].span;
        let whole = n.to_integer().filter(|n| n.abs() <= MOST_FACTORS);
        let outcome = match (x, whole) {
            (Scalar::Exact(exact), Some(n)) if exact.bits() * n.unsigned_abs() <= MOST_BITS => {
                self.work(std::slice::from_ref(x), n.unsigned_abs(), span)?;
                exact.checked_pow(n as i32).map(Scalar::Exact).map_err(|_| ScalarError::DivisionByZero)
            }
            (_, Some(n)) => real_power(x, n as f64),
            (_, None) => {
                if !self.order(x, &Scalar::zero(), span)?.is_gt() {
                    return Err(self.outside(Native::Pow, x, "above 0 for such an exponent", &arguments[0]));
                }
                n.to_f64().ok_or(ScalarError::Undetermined).and_then(|n| real_power(x, n))
            }
        };
        outcome.map_err(|error| self.scalar_error(error, span))
    }

    fn outside(&mut self, native: Native, x: &Scalar, where_to: &str, argument: &Expr) -> Stop {
        let name = native.declaration().name;
        let is = super::words(x, &argument.ty);
        let message = format!("`{name}` needs a number {where_to}");
        let diagnostic = Diagnostic::new(Code::E0604, argument.span, message).label(format!("is {is}"));
        self.report(diagnostic)
    }
}

fn real_power(x: &Scalar, n: f64) -> Result<Scalar, ScalarError> {
    let x = x.to_f64().ok_or(ScalarError::Undetermined)?;
    if x == 0.0 && n < 0.0 {
        return Err(ScalarError::DivisionByZero);
    }
    Scalar::real(libm::pow(x, n))
}

fn angle(x: &Scalar, function: fn(f64) -> f64) -> Result<Scalar, ScalarError> {
    exact_angle(function(x.to_f64().ok_or(ScalarError::Undetermined)?))
}

/// An angle; a multiple of 30 or 45 degrees exactly, where the double is the nearest to it.
fn exact_angle(radians: f64) -> Result<Scalar, ScalarError> {
    for parts in [6, 4] {
        let count = libm::round(radians / core::f64::consts::PI * f64::from(parts));
        let exact = Rational::new(count as i64, i64::from(parts)).map(Scalar::Pi);
        if let Some(exact) = exact
            && exact.to_f64().is_some_and(|value| (value - radians).abs() <= f64::EPSILON * radians.abs())
        {
            return Ok(exact);
        }
    }
    Scalar::real(radians)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_that_have_a_name_are_exact() {
        for (radians, parts, of) in
            [(libm::asin(0.5), 1, 6), (libm::atan(1.0), 1, 4), (libm::acos(-1.0), 1, 1)]
        {
            assert_eq!(exact_angle(radians), Ok(Scalar::Pi(Rational::new(parts, of).unwrap())));
        }
        assert!(matches!(exact_angle(0.3), Ok(Scalar::Real(_))));
        assert_eq!(exact_angle(0.0), Ok(Scalar::Pi(Rational::from(0))));
    }
}
