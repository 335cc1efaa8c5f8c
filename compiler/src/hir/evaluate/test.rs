//! Running a test: its lines in order, and what is said where an assertion does not hold.

use super::told::words;
use super::{Evaluator, Frame, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Expr, ExprKind, ItemId, Made, Test, TestStep};
use crate::hir::types::Type;
use crate::hir::value::Value;
use crate::source::Span;
use crate::syntax::ast::Comparison;
use std::collections::BTreeMap;

/// What is made of the figures of a design.
pub type MadeValues = BTreeMap<(ItemId, Made), Value>;

impl<'a> Evaluator<'a> {
    /// The same evaluator, knowing what is made of the figures.
    #[must_use]
    pub fn with_made(mut self, made: &'a MadeValues) -> Self {
        self.made = Some(made);
        self
    }

    /// Runs a test; whether all of its assertions hold. Those that do not are reported.
    pub fn test(&mut self, test: &Test) -> bool {
        let mut frame = Frame::new(test.slots);
        let mut good = true;
        for step in &test.steps {
            match step {
                TestStep::Let(id, value) => match self.expr(&mut frame, value) {
                    Ok(value) => frame.set(*id, value),
                    // What follows may need it.
                    Err(_) => return false,
                },
                TestStep::Assert(value, _) => match self.assertion(&mut frame, value) {
                    Ok(holds) => good &= holds,
                    Err(_) => good = false,
                },
            }
        }
        good
    }

    pub(super) fn made_of(&self, figure: ItemId, made: Made) -> Outcome<Value> {
        self.made.and_then(|values| values.get(&(figure, made))).cloned().ok_or(Stop::Reported)
    }

    fn assertion(&mut self, frame: &mut Frame, value: &Expr) -> Outcome<bool> {
        match &value.kind {
            ExprKind::And(left, right) => Ok(self.assertion(frame, left)? && self.assertion(frame, right)?),
            ExprKind::Compare(comparison, left, right) => {
                let (a, b) = (self.expr(frame, left)?, self.expr(frame, right)?);
                if self.compared(*comparison, &a, &b, value.span)? {
                    return Ok(true);
                }
                let (a_words, b_words) = both_words((&a, &left.ty), (&b, &right.ty));
                let message = format!("the assertion fails: {a_words} is {} {b_words}", failure(*comparison));
                let mut diagnostic = Diagnostic::new(Code::E1001, value.span, message).label("does not hold");
                for (side, words) in [(left, a_words), (right, b_words)] {
                    if !is_literal(side) {
                        diagnostic = diagnostic.also(side.span, format!("is {words}"));
                    }
                }
                self.report(diagnostic.hint("mend the design, or what is stated of it"));
                Ok(false)
            }
            _ => {
                if self.truth(frame, value)? {
                    return Ok(true);
                }
                let diagnostic = Diagnostic::new(Code::E1001, value.span, "the assertion fails: it is false");
                let diagnostic = diagnostic.label("is false");
                self.report(diagnostic.hint("mend the design, or what is stated of it"));
                Ok(false)
            }
        }
    }

    /// `close(a, b, within)`
    pub(super) fn close(&mut self, a: &Scalar, b: &Scalar, within: &Scalar, span: Span) -> Outcome<bool> {
        let difference = a.minus(b).map_err(|error| self.scalar_error(error, span))?;
        let size = if self.order(&difference, &Scalar::zero(), span)?.is_lt() {
            difference.negated()
        } else {
            difference
        };
        Ok(self.order(&size, within, span)?.is_le())
    }

    pub(super) fn mean(&mut self, list: &[Value], at: &Expr) -> Outcome<Scalar> {
        if list.is_empty() {
            let diagnostic = Diagnostic::new(Code::E0604, at.span, "`mean` of an empty list");
            let diagnostic = diagnostic.label("no elements");
            return Err(self.report(diagnostic.hint("is the range or the `if` of the list right?")));
        }
        let count = Scalar::integer(list.len() as i64);
        let total = self.sum(list, at.span)?;
        total.over(&count).map_err(|error| self.scalar_error(error, at.span))
    }
}

/// Whether what a side is can be read where it stands.
fn is_literal(side: &Expr) -> bool {
    matches!(side.kind, ExprKind::Scalar(_) | ExprKind::Bool(_) | ExprKind::Text(_))
}

fn failure(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Equal => "not",
        Comparison::NotEqual => "the same as",
        Comparison::Less => "not below",
        Comparison::AtMost => "above",
        Comparison::Greater => "not above",
        Comparison::AtLeast => "below",
    }
}

/// Two values in words, exactly where they would look the same else.
fn both_words((a, a_type): (&Value, &Type), (b, b_type): (&Value, &Type)) -> (String, String) {
    let (short_a, short_b) = (words(a, a_type, false), words(b, b_type, false));
    if short_a == short_b { (words(a, a_type, true), words(b, b_type, true)) } else { (short_a, short_b) }
}
