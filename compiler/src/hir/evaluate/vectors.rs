//! Lengths, products and directions of vectors. Exact as far as roots allow.

use super::native::square_root;
use super::{Evaluator, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::native::Native;
use crate::hir::scalar::{Scalar, ScalarError};
use crate::hir::tree::{Arithmetic, Expr};
use crate::hir::value::{Combination, Terms, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    /// A function of points and vectors.
    pub(super) fn vectors(
        &mut self,
        native: Native,
        values: &[Value],
        arguments: &[Expr],
        span: Span,
    ) -> Outcome<Value> {
        match (native, values) {
            (Native::Norm, [Value::Combination(v)]) => Ok(Value::Scalar(self.norm(v, span)?)),
            (Native::Distance, [Value::Combination(p), Value::Combination(q)]) => {
                let between = self.between(p, q, span)?;
                Ok(Value::Scalar(self.norm(&between, span)?))
            }
            (Native::Dot, [Value::Combination(v), Value::Combination(w)]) => {
                Ok(Value::Scalar(self.dot(v, w, span)?))
            }
            (Native::Toward, [Value::Combination(p), Value::Combination(q), Value::Scalar(distance)]) => {
                let between = self.between(p, q, span)?;
                let whole = self.norm(&between, span)?;
                let part = self.part(distance, &whole, "these points are one", arguments[1].span)?;
                self.lerp(p, q, &part, span)
            }
            (Native::WithLength, [Value::Combination(v), Value::Scalar(length)]) => {
                self.with_length(v, length, arguments[0].span, span)
            }
            (
                Native::Perpendicular,
                [Value::Combination(v), Value::Combination(w), Value::Scalar(length)],
            ) => {
                let product = self.cross(v, w, arguments, span)?;
                self.with_length(&product, length, arguments[1].span, span)
            }
            _ => Err(Stop::Reported),
        }
    }

    fn between(&mut self, p: &Combination, q: &Combination, span: Span) -> Outcome<Arc<Combination>> {
        match self.combine(Arithmetic::Subtract, q, p, span)? {
            Value::Combination(between) => Ok(between),
            _ => Err(Stop::Reported),
        }
    }

    fn dot(&mut self, v: &Combination, w: &Combination, span: Span) -> Outcome<Scalar> {
        let (a, b) = (v.terms.scalars(), w.terms.scalars());
        if a.len() != b.len() {
            let message = "points of the plane and points in space do not mix";
            let diagnostic = Diagnostic::new(Code::E0402, span, message).label("two and three coordinates");
            return Err(self.report(diagnostic.hint("give both the same number of coordinates")));
        }
        let sum = a.iter().zip(b).try_fold(Scalar::zero(), |sum, (a, b)| sum.plus(&a.times(b)?));
        sum.map_err(|error| self.scalar_error(error, span))
    }

    fn norm(&mut self, v: &Combination, span: Span) -> Outcome<Scalar> {
        let square = self.dot(v, v, span)?;
        square_root(&square).map_err(|error| self.scalar_error(error, span))
    }

    /// `length / whole`, with a message where there is no direction.
    fn part(&mut self, length: &Scalar, whole: &Scalar, why: &str, at: Span) -> Outcome<Scalar> {
        length.over(whole).map_err(|error| match error {
            ScalarError::DivisionByZero => {
                let diagnostic = Diagnostic::new(Code::E0604, at, "there is no direction here");
                self.report(diagnostic.label(why))
            }
            error => self.scalar_error(error, at),
        })
    }

    fn with_length(&mut self, v: &Combination, length: &Scalar, at: Span, span: Span) -> Outcome<Value> {
        let norm = self.norm(v, span)?;
        let part = self.part(length, &norm, "a vector of length 0", at)?;
        self.scale(v, &part, false, span)
    }

    fn cross(
        &mut self,
        v: &Combination,
        w: &Combination,
        arguments: &[Expr],
        span: Span,
    ) -> Outcome<Combination> {
        let ([a, b, c], [d, e, f]) = (v.terms.scalars(), w.terms.scalars()) else {
            let message = "only vectors of space have one perpendicular direction";
            let diagnostic = Diagnostic::new(Code::E0604, arguments[0].span, message).label("of the plane");
            return Err(self.report(diagnostic.hint("give them a third coordinate: `(1m, 0m, 0m)`")));
        };
        let minor = |a: &Scalar, b: &Scalar, c: &Scalar, d: &Scalar| a.times(d)?.minus(&b.times(c)?);
        let terms = || Ok(vec![minor(b, c, e, f)?, minor(c, a, f, d)?, minor(a, b, d, e)?]);
        let terms = terms().map_err(|error| self.scalar_error(error, span))?;
        Ok(Combination { terms: Terms::Coordinates(terms), weight: Scalar::zero(), made: None })
    }
}
