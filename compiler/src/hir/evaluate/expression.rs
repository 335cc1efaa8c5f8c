//! Expressions: which kind goes where.

use super::{Call, Evaluator, Frame, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::dimension::Dimension;
use crate::hir::scalar::{Scalar, ScalarError};
use crate::hir::tree::{Expr, ExprKind, Field, ItemId, ItemKind};
use crate::hir::types::Type;
use crate::hir::value::{IfsValue, Instance, Value};
use crate::source::Span;
use std::cmp::Ordering;
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn expr(&mut self, frame: &mut Frame, expr: &Expr) -> Outcome<Value> {
        self.step(expr.span)?;
        self.enter(expr.span)?;
        let outcome = stacker::maybe_grow(128 * 1024, 1024 * 1024, || self.expr_here(frame, expr));
        self.leave();
        outcome
    }

    fn expr_here(&mut self, frame: &mut Frame, expr: &Expr) -> Outcome<Value> {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Error => Err(self.untyped(expr.span)),
            ExprKind::Scalar(scalar) => Ok(Value::Scalar(scalar.clone())),
            ExprKind::Bool(truth) => Ok(Value::Bool(*truth)),
            ExprKind::Text(text) => Ok(Value::Text(text.as_str().into())),
            ExprKind::Choice(kind, position) => Ok(Value::Choice(*kind, *position)),
            ExprKind::Local(id) => frame.slots.get(id.0 as usize).cloned().unwrap_or(Err(Stop::Reported)),
            ExprKind::Global(id) => self.global(*id),
            ExprKind::Ifs(id, arguments) => {
                let arguments = self.all(frame, arguments)?;
                Ok(Value::Ifs(Arc::new(IfsValue::Instance(Instance { ifs: *id, arguments }))))
            }
            ExprKind::Imported(mesh) => {
                self.spend(mesh.vertices.len() as u64, span)?;
                Ok(Value::Germ(mesh.clone()))
            }
            ExprKind::OwnGerm(germ) => Ok(Value::OwnGerm(*germ)),
            ExprKind::SelfIfs(_) => {
                let own = frame.own_ifs.clone().ok_or(Stop::Reported)?;
                Ok(Value::Ifs(Arc::new(IfsValue::Instance(own))))
            }
            ExprKind::Call(id, arguments) => self.call(frame, *id, arguments, span),
            ExprKind::Native(native, arguments) => self.native(frame, *native, arguments, expr),
            ExprKind::Record(id, fields) => Ok(Value::Record(*id, Arc::new(self.all(frame, fields)?))),
            ExprKind::Default(id, index) => self.default_of(*id, *index),
            ExprKind::Settings(_, settings) => {
                let mut values = Vec::new();
                for setting in settings {
                    values.push((setting.name, self.expr(frame, &setting.value)?, setting.value.span));
                }
                Ok(Value::Settings(Arc::new(values)))
            }
            ExprKind::Point(parts) => self.coordinates(frame, parts, Scalar::one()),
            ExprKind::Vector(parts) => self.coordinates(frame, parts, Scalar::zero()),
            ExprKind::Coordinate(point, index) => self.coordinate(frame, point, *index),
            ExprKind::List(elements) => Ok(Value::List(Arc::new(self.all(frame, elements)?))),
            ExprKind::Comprehension(body, clauses) => self.comprehension(frame, body, clauses, span),
            ExprKind::Range(from, to) => self.range(frame, from, to),
            ExprKind::Size(length, width) => {
                let sides = (self.scalar(frame, length)?, self.scalar(frame, width)?);
                Ok(Value::Size(sides.0, sides.1))
            }
            ExprKind::Field(base, index) => match self.expr(frame, base)? {
                Value::Record(_, fields) => fields.get(*index).cloned().ok_or(Stop::Reported),
                _ => Err(Stop::Reported),
            },
            ExprKind::Made(figure, made) => self.made_of(*figure, *made),
            ExprKind::EachField(base, index) => self.each_field(frame, base, *index),
            ExprKind::Index(list, index) => self.element(frame, list, index),
            ExprKind::Slice(list, ranges) => {
                let list = self.expr(frame, list)?;
                self.slice(frame, list, ranges)
            }
            ExprKind::Negate(inner) => self.negate(frame, inner),
            ExprKind::Not(inner) => Ok(Value::Bool(!self.truth(frame, inner)?)),
            ExprKind::Arithmetic(arithmetic, at, left, right) => {
                let left_value = self.expr(frame, left)?;
                let right_value = self.expr(frame, right)?;
                self.arithmetic(*arithmetic, *at, (left, left_value), (right, right_value), span)
            }
            ExprKind::Compare(comparison, left, right) => self.comparison(frame, *comparison, left, right),
            ExprKind::And(left, right) => {
                Ok(Value::Bool(self.truth(frame, left)? && self.truth(frame, right)?))
            }
            ExprKind::Or(left, right) => {
                Ok(Value::Bool(self.truth(frame, left)? || self.truth(frame, right)?))
            }
            ExprKind::If(condition, yes, no) => {
                let branch = if self.truth(frame, condition)? { yes } else { no };
                self.expr(frame, branch)
            }
            ExprKind::On(ifs, points, at) => self.on(frame, ifs, points, *at, span),
            ExprKind::At(figure, u, v) => self.at(frame, figure, u, v.as_deref()),
            ExprKind::Until(figure, until) => self.until(frame, figure, until),
            ExprKind::Convert(inner) => {
                let value = self.expr(frame, inner)?;
                self.converted(value, &expr.ty, inner)
            }
        }
    }

    pub(super) fn all(&mut self, frame: &mut Frame, exprs: &[Expr]) -> Outcome<Vec<Value>> {
        exprs.iter().map(|expr| self.expr(frame, expr)).collect()
    }

    pub(super) fn scalar(&mut self, frame: &mut Frame, expr: &Expr) -> Outcome<Scalar> {
        match self.expr(frame, expr)? {
            Value::Scalar(scalar) => Ok(scalar),
            _ => Err(Stop::Reported),
        }
    }

    pub(super) fn integer(&mut self, frame: &mut Frame, expr: &Expr) -> Outcome<i64> {
        match self.scalar(frame, expr)? {
            Scalar::Symbolic(_) => Err(Stop::Undetermined),
            scalar => scalar.to_integer().ok_or_else(|| {
                let message = "this whole number is too large";
                let diagnostic =
                    Diagnostic::new(Code::E0604, expr.span, message).label("beyond what can be counted");
                self.report(diagnostic.hint("use a smaller number"))
            }),
        }
    }

    pub(super) fn truth(&mut self, frame: &mut Frame, expr: &Expr) -> Outcome<bool> {
        match self.expr(frame, expr)? {
            Value::Bool(truth) => Ok(truth),
            _ => Err(Stop::Reported),
        }
    }

    fn default_of(&mut self, id: ItemId, index: usize) -> Outcome<Value> {
        let hir = self.hir;
        let fields: &[Field] = match &hir.item(id).kind {
            ItemKind::Function(function) => &function.parameters,
            ItemKind::Record(fields) => fields,
            ItemKind::Ifs(ifs) => &ifs.parameters,
            _ => &[],
        };
        match fields.get(index).and_then(|field| field.default.as_ref()) {
            Some(default) => {
                self.enter_call();
                let outcome = self.body(default);
                self.leave_call();
                outcome
            }
            None => Err(Stop::Reported),
        }
    }

    fn call(&mut self, frame: &mut Frame, id: ItemId, arguments: &[Expr], span: Span) -> Outcome<Value> {
        let hir = self.hir;
        let ItemKind::Function(function) = &hir.item(id).kind else { return Err(Stop::Reported) };
        let arguments = self.all(frame, arguments)?;
        let mut inner = Frame::new(function.body.slots.max(arguments.len() as u32));
        for (slot, argument) in inner.slots.iter_mut().zip(arguments) {
            *slot = Ok(argument);
        }
        self.calls.push(Call { span, of: id });
        self.enter_call();
        let outcome = self.expr(&mut inner, &function.body.value);
        self.leave_call();
        self.calls.pop();
        outcome
    }

    /// A failed operation on numbers as a report.
    pub(super) fn scalar_error(&mut self, error: ScalarError, span: Span) -> Stop {
        match error {
            ScalarError::Undetermined => Stop::Undetermined,
            ScalarError::DivisionByZero => {
                let diagnostic =
                    Diagnostic::new(Code::E0603, span, "a division by zero").label("this is zero");
                self.report(
                    diagnostic
                        .hint("keep it above 0: by the range of a parameter, or by `if … then … else …`"),
                )
            }
            ScalarError::NotFinite => {
                let message = "the result is too large to be a number";
                let diagnostic = Diagnostic::new(Code::E0604, span, message).label("not finite");
                self.report(diagnostic.hint("are the units right?"))
            }
        }
    }

    pub(super) fn order(&mut self, a: &Scalar, b: &Scalar, span: Span) -> Outcome<Ordering> {
        a.compare(b).map_err(|error| self.scalar_error(error, span))
    }
}

/// A number with the unit of its type, for messages.
pub fn words(scalar: &Scalar, ty: &Type) -> String {
    let dimension = ty.dimension().unwrap_or(Dimension::NUMBER);
    match scalar.to_f64() {
        Some(value) => quantity_words(value, dimension),
        None => "an unknown number".to_owned(),
    }
}

/// A quantity in inner units with the unit of its dimension, for messages: at most three decimals, six for plain numbers.
/// Areas of less than a square decimetre are told in mm2.
pub fn quantity_words(value: f64, dimension: Dimension) -> String {
    let decimals = if dimension == Dimension::NUMBER { 6 } else { 3 };
    quantity_words_to(value, dimension, decimals)
}

/// The same with at most so many decimals.
pub fn quantity_words_to(value: f64, dimension: Dimension, decimals: usize) -> String {
    let small_area = dimension == Dimension::AREA && value != 0.0 && value.abs() < 1e4;
    let (unit, worth) = if small_area { ("mm2", 1.0) } else { dimension.display_unit() };
    let mut digits = format!("{:.decimals$}", value / worth);
    if digits.contains('.') {
        digits.truncate(digits.trim_end_matches('0').trim_end_matches('.').len());
    }
    if digits == "-0" {
        digits = "0".to_owned();
    }
    format!("{digits}{unit}")
}
