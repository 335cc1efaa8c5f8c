//! Where a value of one type serves as another, and the message where it does not.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::dimension::Dimension;
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::types::Type;
use crate::syntax::ast;

enum Fit {
    /// As it is.
    Yes,
    /// After a check when it is evaluated.
    Checked,
    No,
}

impl Checker<'_> {
    /// The expression as a value of the type that the place needs.
    pub(super) fn expect(&mut self, frame: &mut Frame, value: &ast::Expr, expected: &Type) -> Expr {
        let checked = self.expr(frame, value, Some(expected));
        self.convert(checked, expected)
    }

    pub(super) fn convert(&mut self, value: Expr, expected: &Type) -> Expr {
        match self.fit(&value.ty, expected) {
            Fit::Yes => value,
            Fit::Checked => {
                let (span, ty) = (value.span, narrowed(&value.ty, expected));
                Expr { kind: ExprKind::Convert(Box::new(value)), ty, span }
            }
            Fit::No => {
                self.mismatch(&value, expected);
                error_expr(value.span)
            }
        }
    }

    fn fit(&mut self, from: &Type, to: &Type) -> Fit {
        match (from, to) {
            (Type::Error, _) | (_, Type::Error) => Fit::Yes,
            (a, b) if a == b => Fit::Yes,
            (Type::Int, Type::Quantity(Dimension::NUMBER)) => Fit::Yes,
            (Type::Point(a), Type::Point(b)) | (Type::Vector(a), Type::Vector(b)) => match a.join(*b) {
                Some(_) => Fit::Yes,
                None => Fit::No,
            },
            (Type::WeightedSum(a), Type::Point(b) | Type::Vector(b)) => match a.join(*b) {
                Some(_) => Fit::Checked,
                None => Fit::No,
            },
            (Type::Curve | Type::Surface, Type::Figure) => Fit::Yes,
            (Type::Figure, Type::Curve | Type::Surface) => Fit::Checked,
            (Type::Record(_), Type::Material) if self.is_material(from) => Fit::Yes,
            (Type::List(a), Type::List(b)) => self.fit(a, b),
            _ => Fit::No,
        }
    }

    fn mismatch(&mut self, value: &Expr, expected: &Type) {
        let (from, to) = (self.type_name(&value.ty), self.type_name(expected));
        let message = format!("{} {to} is needed, but this is {} {from}", article(&to), article(&from));
        let label = format!("{} {from}", article(&from));
        let mut diagnostic = Diagnostic::new(Code::E0401, value.span, message).label(label);
        if let Some(hint) = self.mend(value, expected) {
            diagnostic = hint(diagnostic);
        }
        self.report(diagnostic);
    }

    #[allow(clippy::type_complexity, reason = "a mend is a function on the diagnostic")]
    fn mend(&self, value: &Expr, expected: &Type) -> Option<Box<dyn FnOnce(Diagnostic) -> Diagnostic>> {
        let span = value.span;
        let plain = value.ty.dimension() == Some(Dimension::NUMBER);
        match expected {
            Type::Quantity(dimension) if plain && *dimension != Dimension::NUMBER => {
                let unit = dimension.display_unit().0;
                if unit.is_empty() || !matches!(value.kind, ExprKind::Scalar(_)) {
                    return None;
                }
                let after = span.after();
                let text = format!("add a unit, such as `{unit}`");
                Some(Box::new(move |diagnostic| diagnostic.fix(text, after, unit)))
            }
            Type::Quantity(Dimension::NUMBER) if value.ty.dimension().is_some() => {
                Some(Box::new(|diagnostic| {
                    diagnostic.hint("divide by a unit, such as `/ 1mm`, to get a plain number")
                }))
            }
            Type::Int if plain => {
                Some(Box::new(|diagnostic| diagnostic.hint("use a whole number, or `round(…)`")))
            }
            Type::Material => {
                Some(Box::new(|diagnostic| {
                    diagnostic.hint("a material is a record with a `thickness` or a `density`, such as `birch_plywood(12mm)`")
                }))
            }
            Type::Point(_) | Type::Vector(_) if value.ty.dimension().is_some() => {
                Some(Box::new(|diagnostic| diagnostic.hint("a point is two or three lengths: `(1m, 0m)`")))
            }
            ty if ty.is_figure() && value.ty == Type::Ifs => Some(Box::new(|diagnostic| {
                diagnostic.hint("put the ifs on control points: `… on (p, q, …) at level 3`")
            })),
            _ => None,
        }
    }
}

/// The type that a place needs, with what is known of the space the value lives in.
fn narrowed(from: &Type, to: &Type) -> Type {
    let space = from.point_space().zip(to.point_space()).and_then(|(from, to)| from.join(to));
    match (to, space) {
        (Type::Point(_), Some(space)) => Type::Point(space),
        (Type::Vector(_), Some(space)) => Type::Vector(space),
        _ => to.clone(),
    }
}

/// `a` or `an`, by the first letter; nothing before words in quotes.
fn article(word: &str) -> &'static str {
    match word.chars().next() {
        Some('A' | 'E' | 'I' | 'O' | 'U' | 'a' | 'e' | 'i' | 'o' | 'u') => "an",
        _ => "a",
    }
}
