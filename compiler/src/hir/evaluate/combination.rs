//! Points, vectors and weighted sums: their arithmetic.

use super::{Evaluator, Frame, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::scalar::{Scalar, ScalarError};
use crate::hir::tree::{Arithmetic, Expr};
use crate::hir::value::{Combination, Terms, Value};
use crate::source::Span;
use std::collections::BTreeSet;
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn coordinates(
        &mut self,
        frame: &mut Frame,
        parts: &[Expr],
        weight: Scalar,
    ) -> Outcome<Value> {
        let mut coordinates = Vec::with_capacity(parts.len());
        for part in parts {
            coordinates.push(self.scalar(frame, part)?);
        }
        let terms = Terms::Coordinates(coordinates);
        Ok(Value::Combination(Arc::new(Combination { terms, weight, made: None })))
    }

    /// `point.x`
    pub(super) fn coordinate(&mut self, frame: &mut Frame, point: &Expr, index: usize) -> Outcome<Value> {
        let Value::Combination(value) = self.expr(frame, point)? else { return Err(Stop::Reported) };
        let coordinates = value.terms.scalars();
        coordinates.get(index).cloned().map(Value::Scalar).ok_or_else(|| {
            let message = "a point of the plane has no third coordinate";
            let label = format!("has {} coordinates", coordinates.len());
            self.report(Diagnostic::new(Code::E0604, point.span, message).label(label))
        })
    }

    pub(super) fn combine(
        &mut self,
        arithmetic: Arithmetic,
        left: &Combination,
        right: &Combination,
        span: Span,
    ) -> Outcome<Value> {
        let same = match (&left.terms, &right.terms) {
            (Terms::Coordinates(a), Terms::Coordinates(b)) | (Terms::Weights(a), Terms::Weights(b)) => {
                a.len() == b.len()
            }
            _ => false,
        };
        if !same {
            let message = "points of the plane and points in space do not mix";
            let diagnostic = Diagnostic::new(Code::E0402, span, message).label("two and three coordinates");
            return Err(self.report(diagnostic.hint("give every point the same number of coordinates")));
        }
        self.work(left.terms.scalars(), 1, span)?;
        self.work(right.terms.scalars(), 1, span)?;
        let op = |a: &Scalar, b: &Scalar| match arithmetic {
            Arithmetic::Subtract => a.minus(b),
            _ => a.plus(b),
        };
        let zipped = left.terms.scalars().iter().zip(right.terms.scalars());
        let numbers: Result<Vec<Scalar>, ScalarError> = zipped.map(|(a, b)| op(a, b)).collect();
        let numbers = numbers.map_err(|error| self.scalar_error(error, span))?;
        let weight = op(&left.weight, &right.weight).map_err(|error| self.scalar_error(error, span))?;
        self.remember(span, [left.made, right.made]);
        Ok(combination(&left.terms, numbers, weight, span))
    }

    pub(super) fn scale(
        &mut self,
        value: &Combination,
        factor: &Scalar,
        divide: bool,
        span: Span,
    ) -> Outcome<Value> {
        let factor = match value.terms {
            Terms::Weights(_) => {
                self.taken_exactly(factor.clone()).map_err(|error| self.scalar_error(error, span))?
            }
            Terms::Coordinates(_) => factor.clone(),
        };
        self.work(value.terms.scalars(), factor.cost(), span)?;
        let op = |a: &Scalar| if divide { a.over(&factor) } else { a.times(&factor) };
        let numbers: Result<Vec<Scalar>, ScalarError> = value.terms.scalars().iter().map(op).collect();
        let numbers = numbers.map_err(|error| self.scalar_error(error, span))?;
        let weight = op(&value.weight).map_err(|error| self.scalar_error(error, span))?;
        self.remember(span, [value.made, None]);
        Ok(combination(&value.terms, numbers, weight, span))
    }

    /// Remembers what the sum at a place was made of.
    fn remember(&mut self, span: Span, parts: [Option<Span>; 2]) {
        let known = self.sums.entry(span).or_default();
        for part in parts.into_iter().flatten().filter(|part| *part != span) {
            if !known.contains(&part) {
                known.push(part);
            }
        }
    }

    /// Whether a sum, or one that it was made of, has been found wrong already.
    pub(super) fn is_known_wrong(&self, made: Span) -> bool {
        let mut seen = BTreeSet::new();
        let mut next = vec![made];
        while let Some(sum) = next.pop() {
            if self.wrong_sums.contains(&sum) {
                return true;
            }
            if seen.insert(sum) {
                next.extend(self.sums.get(&sum).into_iter().flatten());
            }
        }
        false
    }

    /// A number for a weight: [`exactly`], remembering where that hides a rounding.
    pub(super) fn taken_exactly(&mut self, scalar: Scalar) -> Result<Scalar, ScalarError> {
        self.rounded |= matches!(scalar, Scalar::Real(_) | Scalar::Pi(_)) && !scalar.is_zero();
        exactly(scalar)
    }

    /// `(1 - t) a + t b`
    pub(super) fn lerp(
        &mut self,
        a: &Combination,
        b: &Combination,
        t: &Scalar,
        span: Span,
    ) -> Outcome<Value> {
        let rest = Scalar::one().minus(t).map_err(|error| self.scalar_error(error, span))?;
        let (first, second) = (self.scale(a, &rest, false, span)?, self.scale(b, t, false, span)?);
        match (first, second) {
            (Value::Combination(first), Value::Combination(second)) => {
                self.combine(Arithmetic::Add, &first, &second, span)
            }
            _ => Err(Stop::Reported),
        }
    }
}

fn combination(like: &Terms, numbers: Vec<Scalar>, weight: Scalar, span: Span) -> Value {
    let terms = match like {
        Terms::Coordinates(_) => Terms::Coordinates(numbers),
        Terms::Weights(_) => Terms::Weights(numbers),
    };
    Value::Combination(Arc::new(Combination { terms, weight, made: Some(span) }))
}

/// A number taken at the word of its double, so that weights made of it sum exactly.
pub(super) fn exactly(scalar: Scalar) -> Result<Scalar, ScalarError> {
    match scalar {
        Scalar::Real(_) | Scalar::Pi(_) => {
            let value = scalar.to_f64().and_then(Rational::from_f64);
            value.map(Scalar::Exact).ok_or(ScalarError::NotFinite)
        }
        exact => Ok(exact),
    }
}
