//! Figures whose level is found by size: the bound as a number.

use super::{Evaluator, Frame, Outcome, Stop, quantity_words};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::dimension::Dimension;
use crate::hir::size::{SizeBound, Until, UntilExpr};
use crate::hir::tree::{Expr, Limit};
use crate::hir::value::{Figure, Level, Value};
use crate::source::Span;
use crate::syntax::ast::Comparison;
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn until(&mut self, frame: &mut Frame, figure: &Expr, until: &UntilExpr) -> Outcome<Value> {
        let Value::Figure(value) = self.expr(frame, figure)? else { return Err(Stop::Reported) };
        let (least, most, strict, at) = match &until.limit {
            Limit::Compare(comparison, most) => {
                (None, self.size(frame, most)?, *comparison == Comparison::Less, most.span)
            }
            Limit::Within(least, most) => {
                let at = least.span.to(most.span);
                (Some(self.size(frame, least)?), self.size(frame, most)?, false, at)
            }
        };
        if most <= 0.0 || least.is_some_and(|least| least > most) {
            return Err(self.report(nothing_fits(least, most, at)));
        }
        let bound = SizeBound { measure: until.measure, most, strict };
        let worked_out = Until { each: until.each, bound, least };
        let level = Level { u: 0, v: None, until: Some(worked_out), span: until.span };
        Ok(Value::Figure(Arc::new(Figure { level: Some(level), ..value.as_ref().clone() })))
    }

    fn size(&mut self, frame: &mut Frame, size: &Expr) -> Outcome<f64> {
        self.scalar(frame, size)?.to_f64().ok_or(Stop::Undetermined)
    }
}

fn nothing_fits(least: Option<f64>, most: f64, at: Span) -> Diagnostic {
    let words = |size: f64| quantity_words(size, Dimension::LENGTH);
    match least.filter(|least| *least > most) {
        Some(least) => {
            let message = format!("nothing lies within {} .. {}", words(least), words(most));
            Diagnostic::new(Code::E0607, at, message).label("empty").hint("write the smaller end first")
        }
        None => {
            let message = format!("no element is as small as {}", words(most));
            let diagnostic = Diagnostic::new(Code::E0551, at, message).label("not above 0");
            diagnostic.hint("give a size above 0: `until edge <= 600mm`")
        }
    }
}
