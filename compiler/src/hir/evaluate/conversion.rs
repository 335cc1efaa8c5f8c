//! Conversions that are checked when a value is known: weighted sums to points and vectors, figures to curves and
//! surfaces.

use super::{Evaluator, MustJoin, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::{AtomId, Rational};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::types::Type;
use crate::hir::value::{Combination, Shape, Terms, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn converted(&mut self, value: Value, to: &Type, from: &Expr) -> Outcome<Value> {
        match (to, &value) {
            (Type::List(element), Value::List(list)) => {
                let converted: Outcome<Vec<Value>> =
                    list.iter().map(|value| self.converted(value.clone(), element, from)).collect();
                Ok(Value::List(Arc::new(converted?)))
            }
            (Type::Point(_) | Type::Weighted(_), Value::Combination(sum)) => self.of_weight(sum, 1, from),
            (Type::Vector(_), Value::Combination(sum)) => self.of_weight(sum, 0, from),
            (to, Value::Ifs(ifs)) if to.is_figure() => {
                let figure = self.on_frame(ifs, from.span)?;
                self.converted(figure, to, from)
            }
            (Type::Curve | Type::Surface, Value::Figure(figure)) => {
                let curve = *to == Type::Curve;
                match &figure.shape {
                    Shape::Curve { ifs, .. } if curve => {
                        let why = "a Curve is needed here".to_owned();
                        self.must_join.push(MustJoin { ifs: ifs.clone(), span: placed(from), why });
                    }
                    Shape::Curve { ifs, .. } if self.draws_polygons(ifs) => {
                        let why = "a Surface is needed here".to_owned();
                        self.must_join.push(MustJoin { ifs: ifs.clone(), span: placed(from), why });
                    }
                    // What it stands on has been asked for where it was made.
                    Shape::Chain(_) if curve => {}
                    Shape::Sheet { .. } | Shape::Net(_) | Shape::Swept(_) if !curve => {}
                    _ => {
                        let (needed, is) = if curve { ("Curve", "surface") } else { ("Surface", "curve") };
                        let message = format!("a {needed} is needed, but this figure is a {is}");
                        let diagnostic = Diagnostic::new(Code::E0401, from.span, message);
                        return Err(self.report(diagnostic.label(format!("a {is}"))));
                    }
                }
                Ok(value)
            }
            _ => Ok(value),
        }
    }

    fn of_weight(&mut self, sum: &Arc<Combination>, wanted: i64, from: &Expr) -> Outcome<Value> {
        let wanted_scalar = Scalar::integer(wanted);
        let rest = wanted_scalar.minus(&sum.weight).map_err(|error| self.scalar_error(error, from.span))?;
        let off = match &rest {
            Scalar::Real(rest) => rest.abs() > 1e-12,
            rest => !rest.is_zero(),
        };
        if !off {
            return Ok(Value::Combination(sum.clone()));
        }
        // One mistake, however often the sum is used.
        if let Some(made) = sum.made {
            if self.is_known_wrong(made) {
                return Err(Stop::Reported);
            }
            self.wrong_sums.insert(made);
        }
        let (code, what) = if wanted == 1 { (Code::E0501, "point") } else { (Code::E0502, "vector") };
        let total = self.scalar_words(&sum.weight);
        let message = format!("the weights of a {what} sum to {wanted}, but these sum to {total}");
        let label = match &sum.terms {
            Terms::Weights(weights) => self.weights_words(weights),
            Terms::Coordinates(_) => format!("sums to {total}"),
        };
        let mut diagnostic = Diagnostic::new(code, from.span, message).label(label);
        if let Some(made) = sum.made.filter(|made| *made != from.span) {
            diagnostic = diagnostic.also(made, "the sum is made here");
        }
        diagnostic = diagnostic.note(self.missing_words(&rest));
        if wanted == 1 && !sum.weight.is_zero() {
            diagnostic = diagnostic.hint(format!("divide the sum by {total}, or add the missing weight"));
        } else if wanted == 1 {
            diagnostic = diagnostic.hint("the difference of two points is a vector: add it to a point");
        } else {
            diagnostic = diagnostic.hint("a vector is the difference of two points");
        }
        Err(self.report(diagnostic))
    }

    fn missing_words(&self, rest: &Scalar) -> String {
        match rest.to_rational() {
            Some(rest) if rest.is_negative() => format!("{} too much", rest.abs()),
            _ => format!("{} is missing", self.scalar_words(rest)),
        }
    }

    /// An exact number or a function of parameters in words.
    pub(super) fn scalar_words(&self, scalar: &Scalar) -> String {
        match scalar {
            Scalar::Symbolic(function) => {
                let name = |atom: AtomId| self.atoms.get(atom.0 as usize).cloned().unwrap_or_default();
                function.display(&name).to_string()
            }
            Scalar::Exact(value) => short(value),
            other => other.to_f64().map_or_else(String::new, |value| format!("{value}")),
        }
    }

    /// Weights with the names of the control points of the ifs being worked out.
    pub(super) fn weights_words(&self, weights: &[Scalar]) -> String {
        let named = weights.iter().enumerate().filter(|(_, weight)| !weight.is_zero());
        let mut sum = String::new();
        for (index, weight) in named {
            let point = self.points.get(index).map_or("?", String::as_str);
            let words = self.scalar_words(weight);
            let (sign, words) = match words.strip_prefix('-') {
                Some(words) if !words.contains(' ') => ("-", words.to_owned()),
                _ if words.contains(' ') => ("+", format!("({words})")),
                _ => ("+", words),
            };
            sum.push_str(&match (sum.is_empty(), sign) {
                (true, "+") => String::new(),
                (true, sign) => sign.to_owned(),
                (false, sign) => format!(" {sign} "),
            });
            if words != "1" {
                sum.push_str(&words);
                sum.push(' ');
            }
            sum.push_str(point);
        }
        if sum.is_empty() { "no points at all".to_owned() } else { sum }
    }
}

/// Where the ifs stands that a figure is made of; the whole expression where that is another's matter.
fn placed(figure: &Expr) -> Span {
    match &figure.kind {
        ExprKind::At(figure, ..) | ExprKind::Until(figure, _) | ExprKind::Convert(figure) => placed(figure),
        ExprKind::On(ifs, ..) => ifs.span,
        _ => figure.span,
    }
}

/// A fraction as it is, unless it is long: then its decimals.
fn short(value: &Rational) -> String {
    let exact = value.to_string();
    if exact.len() <= 24 { exact } else { format!("{}", value.to_f64()) }
}
