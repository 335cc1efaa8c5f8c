//! Where a value of one type serves as another, and the message where it does not.

use super::units::with_unit;
use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::dimension::Dimension;
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::types::{PointSpace, Type};
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
        if value.ty == Type::Ifs
            && expected.is_figure()
            && self.ifs_space(&value) != Some(PointSpace::Control)
        {
            // An ifs of the plane or of space stands where it is; whether it is one is seen when it is evaluated.
            let span = value.span;
            return Expr { kind: ExprKind::Convert(Box::new(value)), ty: expected.clone(), span };
        }
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
            (Type::Point(a), Type::Point(b))
            | (Type::Vector(a), Type::Vector(b))
            | (Type::Map(a), Type::Map(b)) => match a.join(*b) {
                Some(_) => Fit::Yes,
                None => Fit::No,
            },
            (Type::WeightedSum(a), Type::Point(b) | Type::Vector(b)) => match a.join(*b) {
                Some(_) => Fit::Checked,
                None => Fit::No,
            },
            (Type::Weighted(a) | Type::Point(a), Type::Weighted(b)) => match a.join(*b) {
                Some(_) => Fit::Yes,
                None => Fit::No,
            },
            (Type::WeightedSum(a), Type::Weighted(b)) => match a.join(*b) {
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
        // A place that takes weighted points is one for points.
        let expected = &expected.unweighted();
        let (mut from, to) = (self.described(&value.ty), self.described(expected));
        let plain = value.ty.dimension() == Some(Dimension::NUMBER);
        if plain && expected.dimension().is_some_and(|dimension| dimension != Dimension::NUMBER) {
            from = "a number without a unit".to_owned();
        } else if plain && *expected == Type::Int {
            from = "a number that may have decimals".to_owned();
        }
        let message = format!("{to} is needed, but this is {from}");
        let mut diagnostic = Diagnostic::new(Code::E0401, value.span, message).label(from);
        if let ExprKind::Global(id) = value.kind {
            let item = &self.items[id.0 as usize];
            diagnostic = diagnostic.also(item.name_span, format!("`{}` is declared here", item.name));
        }
        if let Some(hint) = self.mend(value, expected) {
            diagnostic = hint(diagnostic);
        }
        self.report(diagnostic);
    }

    #[allow(clippy::type_complexity, reason = "a mend is a function on the diagnostic")]
    fn mend(&self, value: &Expr, expected: &Type) -> Option<Box<dyn FnOnce(Diagnostic) -> Diagnostic>> {
        let span = value.span;
        let plain = value.ty.dimension() == Some(Dimension::NUMBER);
        let control = |ty: &Type| ty.point_space() == Some(PointSpace::Control);
        match expected {
            Type::Point(_)
                if control(expected) && value.ty.point_space().is_some() && !control(&value.ty) =>
            {
                Some(Box::new(|diagnostic| {
                    diagnostic.hint("inside of an ifs points are combinations of its control points, such as `lerp(p0, p1, 1/2)`")
                }))
            }
            Type::Quantity(dimension) if plain && *dimension != Dimension::NUMBER => {
                let unit = dimension.display_unit().0;
                if unit.is_empty() {
                    return None;
                }
                if !matches!(value.kind, ExprKind::Scalar(_)) {
                    let text =
                        format!("give it a unit where it is declared, or multiply by one: `… * 1{unit}`");
                    return Some(Box::new(move |diagnostic| diagnostic.hint(text)));
                }
                let fixes = with_unit(span, *dimension);
                let text = format!("add a unit, such as `{unit}`");
                Some(Box::new(move |diagnostic| diagnostic.ways(text, fixes)))
            }
            Type::Quantity(Dimension::NUMBER) if value.ty.dimension().is_some() => {
                Some(Box::new(|diagnostic| {
                    diagnostic.hint("divide by a unit, such as `/ 1mm`, to get a plain number")
                }))
            }
            Type::Quantity(needed) if value.ty.dimension() == Dimension::NUMBER.over(*needed) => {
                Some(Box::new(|diagnostic| {
                    diagnostic.hint("a unit belongs to the number before it: `1/3m` is one by 3m, a third of a metre is `1m / 3`")
                }))
            }
            Type::Int if plain => {
                Some(Box::new(|diagnostic| diagnostic.hint("use a whole number, or `round(…)`")))
            }
            Type::Quantity(Dimension::ANGLE) if value.ty.dimension().is_some() => {
                Some(Box::new(|diagnostic| {
                    diagnostic.hint("angles are written with `deg` or `rad`: `30deg`")
                }))
            }
            Type::Point(_) if matches!(value.ty, Type::Weighted(_)) => Some(Box::new(|diagnostic| {
                diagnostic
                    .hint("a weight belongs to a control point: give it where an ifs is placed, `on (…)`")
            })),
            Type::Point(_) if matches!(value.ty, Type::Vector(_)) => Some(Box::new(|diagnostic| {
                diagnostic.hint("the difference of two points is a vector: add it to a point to get a point")
            })),
            Type::Vector(_) if matches!(value.ty, Type::Point(_)) => Some(Box::new(|diagnostic| {
                diagnostic.hint("a vector is the difference of two points: `q - p`")
            })),
            Type::Map(_) => Some(Box::new(|diagnostic| {
                diagnostic
                    .hint("a map is made by `translate(…)`, `rotate(…)`, `turn(…)`, `scale(…)` and the like")
            })),
            Type::Germ => Some(Box::new(|diagnostic| diagnostic.hint("write `germ segment(p, q)`"))),
            Type::Bool => Some(Box::new(|diagnostic| {
                diagnostic.hint("a condition is a comparison such as `a > b`, or `true` or `false`")
            })),
            Type::Plane => Some(Box::new(|diagnostic| {
                diagnostic.hint("a plane is a point and what is square to it: `plane((0m, 0m, 0m), z)`")
            })),
            Type::Cut => Some(Box::new(|diagnostic| {
                diagnostic.hint("an end is cut along a plane: `cut(plane((0m, 0m, 0m), z))`; leave it out for a square end")
            })),
            Type::Size => Some(Box::new(|diagnostic| diagnostic.hint("a size is written `120mm by 27mm`"))),
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
