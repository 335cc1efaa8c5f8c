//! Lists: comprehensions, elements, slices.

use super::{Evaluator, Frame, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Arithmetic, Clause, Expr, ExprKind, is_literal};
use crate::hir::value::{Combination, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn comprehension(
        &mut self,
        frame: &mut Frame,
        body: &Expr,
        clauses: &[Clause],
        span: Span,
    ) -> Outcome<Value> {
        let mut elements = Vec::new();
        self.clauses(frame, body, clauses, span, &mut elements)?;
        Ok(Value::List(Arc::new(elements)))
    }

    fn clauses(
        &mut self,
        frame: &mut Frame,
        body: &Expr,
        clauses: &[Clause],
        span: Span,
        out: &mut Vec<Value>,
    ) -> Outcome<()> {
        self.enter(span)?;
        let outcome = stacker::maybe_grow(128 * 1024, 1024 * 1024, || {
            self.clauses_here(frame, body, clauses, span, out)
        });
        self.leave();
        outcome
    }

    fn clauses_here(
        &mut self,
        frame: &mut Frame,
        body: &Expr,
        clauses: &[Clause],
        span: Span,
        out: &mut Vec<Value>,
    ) -> Outcome<()> {
        let Some((clause, rest)) = clauses.split_first() else {
            out.push(self.expr(frame, body)?);
            return self.length(out.len(), span);
        };
        match clause {
            Clause::If(condition) => {
                if self.truth(frame, condition)? {
                    self.clauses(frame, body, rest, span, out)?;
                }
            }
            Clause::For(slot, over) => match self.expr(frame, over)? {
                Value::Range(from, to) => {
                    for index in from..to {
                        self.step(span)?;
                        frame.set(*slot, Value::Scalar(Scalar::integer(index)));
                        self.clauses(frame, body, rest, span, out)?;
                    }
                }
                Value::List(list) => {
                    for value in list.iter() {
                        self.step(span)?;
                        frame.set(*slot, value.clone());
                        self.clauses(frame, body, rest, span, out)?;
                    }
                }
                _ => return Err(Stop::Reported),
            },
        }
        Ok(())
    }

    pub(super) fn range(&mut self, frame: &mut Frame, from: &Expr, to: &Expr) -> Outcome<Value> {
        Ok(Value::Range(self.integer(frame, from)?, self.integer(frame, to)?))
    }

    pub(super) fn element(&mut self, frame: &mut Frame, list: &Expr, index: &Expr) -> Outcome<Value> {
        let Value::List(elements) = self.expr(frame, list)? else { return Err(Stop::Reported) };
        let place = self.integer(frame, index)?;
        let found = usize::try_from(place).ok().and_then(|place| elements.get(place).cloned());
        found.ok_or_else(|| {
            let message = format!("there is no element {place} in a list of {}", elements.len());
            let diagnostic = Diagnostic::new(Code::E0602, index.span, message).label(format!("is {place}"));
            self.report(match elements.len() {
                0 => diagnostic.hint("the list is empty"),
                n => {
                    let last = if place < 0 { 0 } else { n - 1 };
                    let fixes = match is_literal(index) {
                        true => {
                            let title = format!("take element {last} instead of {place}");
                            vec![Fix::titled(title).with(index.span, last.to_string())]
                        }
                        false => Vec::new(),
                    };
                    diagnostic.ways(format!("elements are counted from 0 to {}", n - 1), fixes)
                }
            })
        })
    }

    pub(super) fn slice(&mut self, frame: &mut Frame, list: Value, ranges: &[Expr]) -> Outcome<Value> {
        let Some((first, rest)) = ranges.split_first() else { return Ok(list) };
        let Value::List(elements) = list else { return Err(Stop::Reported) };
        let Value::Range(from, to) = self.expr(frame, first)? else { return Err(Stop::Reported) };
        let bounds = usize::try_from(from).ok().zip(usize::try_from(to).ok());
        let part = bounds.filter(|(from, to)| from <= to).and_then(|(from, to)| elements.get(from..to));
        let Some(part) = part else {
            let message = format!("there is no part {from}..{to} of a list of {}", elements.len());
            let diagnostic =
                Diagnostic::new(Code::E0602, first.span, message).label(format!("is {from}..{to}"));
            let whole = elements.len();
            let ways = shorter(first, (from, to), whole).into_iter().collect();
            return Err(self.report(diagnostic.ways(format!("parts lie within 0..{whole}"), ways)));
        };
        self.spend(part.len() as u64, first.span)?;
        let part: Outcome<Vec<Value>> = part.iter().map(|row| self.slice(frame, row.clone(), rest)).collect();
        Ok(Value::List(Arc::new(part?)))
    }

    pub(super) fn each_field(&mut self, frame: &mut Frame, base: &Expr, index: usize) -> Outcome<Value> {
        let Value::List(records) = self.expr(frame, base)? else { return Err(Stop::Reported) };
        self.spend(records.len() as u64, base.span)?;
        let fields: Outcome<Vec<Value>> = records
            .iter()
            .map(|record| match record {
                Value::Record(_, fields) => fields.get(index).cloned().ok_or(Stop::Reported),
                _ => Err(Stop::Reported),
            })
            .collect();
        Ok(Value::List(Arc::new(fields?)))
    }

    /// `concat([a, b])`
    pub(super) fn concat(&mut self, lists: &[Value], span: Span) -> Outcome<Value> {
        let mut elements = Vec::new();
        for list in lists.iter().filter_map(Value::list) {
            self.spend(1 + list.len() as u64, span)?;
            self.length(elements.len() + list.len(), span)?;
            elements.extend_from_slice(list);
        }
        Ok(Value::List(Arc::new(elements)))
    }

    /// `transpose(grid)`
    pub(super) fn transpose(&mut self, grid: &[Value], argument: &Expr) -> Outcome<Value> {
        let rows: Vec<&[Value]> = grid.iter().filter_map(Value::list).collect();
        let columns = rows.first().map_or(0, |row| row.len());
        if let Some(other) = rows.iter().find(|row| row.len() != columns) {
            let message = "the rows of a grid have the same length";
            let label = format!("rows of {columns} and of {}", other.len());
            return Err(self.report(Diagnostic::new(Code::E0604, argument.span, message).label(label)));
        }
        self.spend(1 + (rows.len() * columns) as u64, argument.span)?;
        let column =
            |index: usize| Value::List(Arc::new(rows.iter().map(|row| row[index].clone()).collect()));
        Ok(Value::List(Arc::new((0..columns).map(column).collect())))
    }

    /// The sum of points and vectors, in their order.
    pub(super) fn sum_of_combinations(&mut self, list: &[Value], span: Span) -> Outcome<Value> {
        let mut total: Option<Arc<Combination>> = None;
        for value in list {
            let Value::Combination(next) = value else { return Err(Stop::Reported) };
            self.step(span)?;
            total = match total {
                None => Some(next.clone()),
                Some(total) => match self.combine(Arithmetic::Add, &total, next, span)? {
                    Value::Combination(sum) => Some(sum),
                    _ => return Err(Stop::Reported),
                },
            };
        }
        total.map(Value::Combination).ok_or(Stop::Reported)
    }

    /// `text(value)`
    pub(super) fn text(&mut self, value: &Value, argument: &Expr) -> Outcome<Value> {
        let text = match value {
            Value::Scalar(scalar) => super::words(scalar, &argument.ty).into(),
            Value::Bool(truth) => truth.to_string().into(),
            Value::Text(text) => text.clone(),
            _ => return Err(Stop::Reported),
        };
        Ok(Value::Text(text))
    }
}

/// A part that reaches to the end of a list of `whole` elements, in place of one that is written in numbers and goes beyond.
fn shorter(range: &Expr, (from, to): (i64, i64), whole: usize) -> Option<Fix> {
    let ExprKind::Range(first, last) = &range.kind else { return None };
    let start = usize::try_from(from).ok().filter(|start| *start < whole)?;
    let beyond = usize::try_from(to).is_ok_and(|end| end > whole);
    let part = format!("{start}..{whole}");
    (beyond && is_literal(first) && is_literal(last))
        .then(|| Fix::titled(format!("take {part}, to the end of the list")).with(range.span, part))
}
