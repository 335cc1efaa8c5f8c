//! Operators.

use super::{Evaluator, Frame, Outcome, Stop};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Arithmetic, Expr};
use crate::hir::value::{Terms, Value};
use crate::source::Span;
use crate::syntax::ast::Comparison;
use std::cmp::Ordering;

impl Evaluator<'_> {
    pub(super) fn negate(&mut self, frame: &mut Frame, inner: &Expr) -> Outcome<Value> {
        match self.expr(frame, inner)? {
            Value::Scalar(scalar) => Ok(Value::Scalar(scalar.negated())),
            Value::Combination(sum) => self.scale(&sum, &Scalar::integer(-1), false, inner.span),
            _ => Err(Stop::Reported),
        }
    }

    pub(super) fn arithmetic(
        &mut self,
        arithmetic: Arithmetic,
        at: Span,
        (left_expr, left): (&Expr, Value),
        (right_expr, right): (&Expr, Value),
        span: Span,
    ) -> Outcome<Value> {
        match (&left, &right) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                self.work(std::slice::from_ref(a), b.cost(), span)?;
                let outcome = match arithmetic {
                    Arithmetic::Add => a.plus(b),
                    Arithmetic::Subtract => a.minus(b),
                    Arithmetic::Multiply => a.times(b),
                    Arithmetic::Divide => a.over(b),
                };
                let place = if arithmetic == Arithmetic::Divide { right_expr.span } else { at };
                outcome.map(Value::Scalar).map_err(|error| self.scalar_error(error, place))
            }
            (Value::Combination(a), Value::Combination(b)) => self.combine(arithmetic, a, b, span),
            (Value::Combination(a), Value::Scalar(factor)) => {
                let divide = arithmetic == Arithmetic::Divide;
                if divide && factor.is_zero() {
                    return Err(
                        self.scalar_error(crate::hir::scalar::ScalarError::DivisionByZero, right_expr.span)
                    );
                }
                self.scale(a, factor, divide, span)
            }
            (Value::Scalar(factor), Value::Combination(b)) => {
                self.scale(b, factor, false, left_expr.span.to(span))
            }
            (Value::Text(a), Value::Text(b)) => {
                self.spend((a.len() + b.len()) as u64 / 64, span)?;
                self.text_length(a.len() + b.len(), span)?;
                Ok(Value::Text([a.as_ref(), b.as_ref()].concat().into()))
            }
            (Value::Map(map), thing) => self.mapped(map, (right_expr, thing), span),
            _ => Err(Stop::Reported),
        }
    }

    pub(super) fn comparison(
        &mut self,
        frame: &mut Frame,
        comparison: Comparison,
        left: &Expr,
        right: &Expr,
    ) -> Outcome<Value> {
        let (a, b) = (self.expr(frame, left)?, self.expr(frame, right)?);
        self.compared(comparison, &a, &b, left.span.to(right.span)).map(Value::Bool)
    }

    /// Whether a comparison holds for two values. Numbers are compared exactly; lists, points and records are the same
    /// where all in them is.
    pub(super) fn compared(
        &mut self,
        comparison: Comparison,
        a: &Value,
        b: &Value,
        span: Span,
    ) -> Outcome<bool> {
        let order = match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => self.order(a, b, span)?,
            _ if self.same(a, b, span)? => Ordering::Equal,
            _ => Ordering::Less,
        };
        Ok(holds(comparison, order))
    }

    fn same(&mut self, a: &Value, b: &Value, span: Span) -> Outcome<bool> {
        self.step(span)?;
        match (a, b) {
            (Value::Scalar(a), Value::Scalar(b)) => Ok(self.order(a, b, span)?.is_eq()),
            (Value::List(a), Value::List(b)) => self.all_same(a, b, span),
            (Value::Record(a, a_fields), Value::Record(b, b_fields)) => {
                Ok(a == b && self.all_same(a_fields, b_fields, span)?)
            }
            (Value::Combination(a), Value::Combination(b)) => match (&a.terms, &b.terms) {
                (Terms::Coordinates(a), Terms::Coordinates(b)) | (Terms::Weights(a), Terms::Weights(b)) => {
                    let mut same = a.len() == b.len();
                    for (a, b) in a.iter().zip(b) {
                        same = same && self.order(a, b, span)?.is_eq();
                    }
                    Ok(same)
                }
                _ => Ok(false),
            },
            _ => Ok(a == b),
        }
    }

    fn all_same(&mut self, a: &[Value], b: &[Value], span: Span) -> Outcome<bool> {
        if a.len() != b.len() {
            return Ok(false);
        }
        for (a, b) in a.iter().zip(b) {
            if !self.same(a, b, span)? {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Whether a comparison holds for two values in this order.
pub(super) fn holds(comparison: Comparison, order: Ordering) -> bool {
    match comparison {
        Comparison::Equal => order.is_eq(),
        Comparison::NotEqual => order.is_ne(),
        Comparison::Less => order.is_lt(),
        Comparison::AtMost => order.is_le(),
        Comparison::Greater => order.is_gt(),
        Comparison::AtLeast => order.is_ge(),
    }
}
