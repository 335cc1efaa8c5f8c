//! Operators on numbers, points and vectors, and their dimensions.

use super::units::with_unit;
use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::dimension::Dimension;
use crate::hir::tree::{Arithmetic, Expr, ExprKind};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast::{self, BinaryOperator, UnaryOperator};

impl Checker<'_> {
    pub(super) fn unary(
        &mut self,
        frame: &mut Frame,
        operator: UnaryOperator,
        inner: &ast::Expr,
        span: Span,
    ) -> Expr {
        if operator == UnaryOperator::Not {
            let inner = self.expect(frame, inner, &Type::Bool);
            return Expr { kind: ExprKind::Not(Box::new(inner)), ty: Type::Bool, span };
        }
        let inner = self.expr(frame, inner, None);
        let ty = match &inner.ty {
            Type::Int | Type::Quantity(_) | Type::Vector(_) | Type::Error => inner.ty.clone(),
            Type::Point(space) | Type::WeightedSum(space) => Type::WeightedSum(*space),
            other => {
                let name = self.described(other);
                let message = format!("`-` does not fit {name}");
                self.report(Diagnostic::new(Code::E0402, inner.span, message).label(name));
                return error_expr(span);
            }
        };
        Expr { kind: ExprKind::Negate(Box::new(inner)), ty, span }
    }

    pub(super) fn binary(
        &mut self,
        frame: &mut Frame,
        operator: BinaryOperator,
        at: Span,
        [left, right]: [&ast::Expr; 2],
        span: Span,
        expected: Option<&Type>,
    ) -> Expr {
        let arithmetic = match operator {
            BinaryOperator::Add => Arithmetic::Add,
            BinaryOperator::Subtract => Arithmetic::Subtract,
            BinaryOperator::Multiply => Arithmetic::Multiply,
            BinaryOperator::Divide => Arithmetic::Divide,
            BinaryOperator::By => {
                let sides = [left, right].map(|side| Box::new(self.expect(frame, side, &Type::LENGTH)));
                let [length, width] = sides;
                if length.ty == Type::Error || width.ty == Type::Error {
                    return error_expr(span);
                }
                return Expr { kind: ExprKind::Size(length, width), ty: Type::Size, span };
            }
            BinaryOperator::And | BinaryOperator::Or => {
                let sides = [left, right].map(|side| Box::new(self.expect(frame, side, &Type::Bool)));
                let [left, right] = sides;
                let and = operator == BinaryOperator::And;
                let kind = if and { ExprKind::And(left, right) } else { ExprKind::Or(left, right) };
                return Expr { kind, ty: Type::Bool, span };
            }
            BinaryOperator::Compare(comparison) => {
                return self.compare(frame, comparison, at, [left, right], span);
            }
        };
        let additive = matches!(arithmetic, Arithmetic::Add | Arithmetic::Subtract);
        let (left, right) = if additive {
            // The difference of two points is a vector: where one is needed, coordinates are the second point.
            let difference = arithmetic == Arithmetic::Subtract && matches!(expected, Some(Type::Vector(_)));
            self.additive_sides(frame, left, right, difference)
        } else {
            let vector = expected.filter(|ty| matches!(ty, Type::Vector(_)));
            let wanted = |side: &ast::Expr| vector.filter(|_| matches!(side.kind, ast::ExprKind::Tuple(_)));
            // What is moved by a map is what is wanted of it.
            let moved = expected
                .filter(|ty| arithmetic == Arithmetic::Multiply && (**ty == Type::Ifs || ty.is_figure()));
            let map = moved.map(|_| &Type::Map(PointSpace::Any));
            (self.expr(frame, left, map.or(wanted(left))), self.expr(frame, right, moved.or(wanted(right))))
        };
        if self.refuse_map_of_ifs(&left, &right) {
            return error_expr(span);
        }
        match self.result(arithmetic, &left.ty, &right.ty) {
            Some(ty) => {
                let kind = ExprKind::Arithmetic(arithmetic, at, Box::new(left), Box::new(right));
                Expr { kind, ty, span }
            }
            None => self.unfit(arithmetic, at, &left, &right, span),
        }
    }

    /// Coordinates written right beside `+` or `-` are a vector when the other side is a point or a vector.
    fn additive_sides(
        &mut self,
        frame: &mut Frame,
        left: &ast::Expr,
        right: &ast::Expr,
        difference: bool,
    ) -> (Expr, Expr) {
        let literal = |side: &ast::Expr| matches!(side.kind, ast::ExprKind::Tuple(_));
        let vector = Type::Vector(PointSpace::Any);
        match (literal(left), literal(right)) {
            (false, true) => {
                let left = self.expr(frame, left, None);
                let of_points = difference && matches!(left.ty, Type::Point(_));
                let wanted = left.ty.point_space().filter(|_| !of_points).map(|_| &vector);
                let right = self.expr(frame, right, wanted);
                (left, right)
            }
            (true, false) => {
                let right = self.expr(frame, right, None);
                let wanted = matches!(right.ty, Type::Vector(_)).then_some(&vector);
                let left = self.expr(frame, left, wanted);
                (left, right)
            }
            _ => (self.expr(frame, left, None), self.expr(frame, right, None)),
        }
    }

    fn result(&self, arithmetic: Arithmetic, left: &Type, right: &Type) -> Option<Type> {
        if *left == Type::Error || *right == Type::Error {
            return Some(Type::Error);
        }
        if (arithmetic, left, right) == (Arithmetic::Add, &Type::Text, &Type::Text) {
            return Some(Type::Text);
        }
        if let (Arithmetic::Multiply, Type::Map(space)) = (arithmetic, left) {
            return mapped(*space, right);
        }
        match (arithmetic, left.dimension(), right.dimension()) {
            (Arithmetic::Add | Arithmetic::Subtract, Some(a), Some(b)) => {
                (a == b).then(|| if left == right { left.clone() } else { Type::Quantity(a) })
            }
            (Arithmetic::Multiply, Some(a), Some(b)) => {
                let whole = *left == Type::Int && *right == Type::Int;
                if whole { Some(Type::Int) } else { Some(Type::Quantity(a.times(b)?)) }
            }
            (Arithmetic::Divide, Some(a), Some(b)) => Some(Type::Quantity(a.over(b)?)),
            (Arithmetic::Multiply, Some(Dimension::NUMBER), None) => scaled(right),
            (Arithmetic::Multiply | Arithmetic::Divide, None, Some(Dimension::NUMBER)) => scaled(left),
            (Arithmetic::Add | Arithmetic::Subtract, None, None) => added(arithmetic, left, right),
            _ => None,
        }
    }

    fn unfit(&mut self, arithmetic: Arithmetic, at: Span, left: &Expr, right: &Expr, span: Span) -> Expr {
        let (a, b) = (self.described(&left.ty), self.described(&right.ty));
        if let (Arithmetic::Multiply, Type::Map(space)) = (arithmetic, &left.ty)
            && matches!(right.ty, Type::Map(_) | Type::Point(_) | Type::Vector(_))
        {
            self.mixed(*space, left.span, &right.ty, right.span);
            return error_expr(span);
        }
        let symbol = arithmetic.symbol();
        let message = format!("`{symbol}` does not fit {a} and {b}");
        let mut diagnostic = Diagnostic::new(Code::E0402, at, message)
            .label(format!("`{symbol}` of these two"))
            .also(left.span, a)
            .also(right.span, b);
        let both_numbers = left.ty.dimension().is_some() && right.ty.dimension().is_some();
        let list = [left, right].into_iter().find(|side| matches!(side.ty, Type::List(_)));
        if both_numbers {
            let unitless =
                [left, right].into_iter().find(|side| side.ty.dimension() == Some(Dimension::NUMBER));
            let other =
                if unitless.is_some_and(|side| side.span == left.span) { &right.ty } else { &left.ty };
            let unit = other.dimension().map_or("", |dimension| dimension.display_unit().0);
            diagnostic = match unitless {
                Some(side) if matches!(side.kind, ExprKind::Scalar(_)) && !unit.is_empty() => {
                    let fixes = other.dimension().map_or(Vec::new(), |other| with_unit(side.span, other));
                    diagnostic.ways(format!("add a unit, such as `{unit}`"), fixes)
                }
                _ => diagnostic
                    .hint("only values of one dimension are added: lengths to lengths, angles to angles"),
            };
        } else if matches!((&left.ty, &right.ty), (Type::List(_), Type::List(_)))
            && arithmetic == Arithmetic::Add
        {
            diagnostic = diagnostic.hint("one list after the other is `concat([a, b])`");
        } else if matches!(left.ty, Type::Map(_)) || matches!(right.ty, Type::Map(_)) {
            diagnostic = diagnostic
                .hint("a map stands to the left of what it moves: `rotate(90deg) * p`, `scale(1/2) * self`");
        } else if list.is_some() {
            diagnostic =
                diagnostic.hint(format!("for every element of a list: `[x {symbol} … for x in list]`"));
        } else if left.ty == Type::Text || right.ty == Type::Text {
            diagnostic = diagnostic.hint("texts are joined by `+`; `text(x)` makes a text of a number");
        } else if matches!(arithmetic, Arithmetic::Multiply | Arithmetic::Divide)
            && (left.ty.point_space().is_some() || right.ty.point_space().is_some())
        {
            diagnostic =
                diagnostic.hint("points and vectors are multiplied and divided by numbers without a unit");
        } else if left.ty.point_space().is_some() && right.ty.point_space().is_some() {
            diagnostic =
                diagnostic.hint("both must be in the plane, both in space, or both made of control points");
        }
        self.report(diagnostic);
        error_expr(span)
    }

    /// Coordinates written right beside a comparison are a vector when the other side is one.
    fn compared(&mut self, frame: &mut Frame, left: &ast::Expr, right: &ast::Expr) -> (Expr, Expr) {
        let wanted = |other: &Expr| matches!(other.ty, Type::Vector(_)).then(|| other.ty.clone());
        if matches!(left.kind, ast::ExprKind::Tuple(_)) {
            let right = self.expr(frame, right, None);
            let left = self.expr(frame, left, wanted(&right).as_ref());
            return (left, right);
        }
        let left = self.expr(frame, left, None);
        let vector = wanted(&left).filter(|_| matches!(right.kind, ast::ExprKind::Tuple(_)));
        let right = self.expr(frame, right, vector.as_ref());
        (left, right)
    }

    fn compare(
        &mut self,
        frame: &mut Frame,
        comparison: ast::Comparison,
        at: Span,
        [left, right]: [&ast::Expr; 2],
        span: Span,
    ) -> Expr {
        let (left, right) = self.compared(frame, left, right);
        let equality = matches!(comparison, ast::Comparison::Equal | ast::Comparison::NotEqual);
        let fits = match (&left.ty, &right.ty) {
            (Type::Error, _) | (_, Type::Error) => true,
            (a, b) if a.dimension().is_some() => a.dimension() == b.dimension(),
            (a, b) => equality && a.equals(b),
        };
        if !fits {
            let (a, b) = (self.described(&left.ty), self.described(&right.ty));
            let message = format!("{a} cannot be compared with {b} in this way");
            let mut diagnostic = Diagnostic::new(Code::E0402, at, message).label("compares these two");
            if left.ty == right.ty {
                diagnostic = diagnostic
                    .hint("only numbers are smaller or larger; others are the same (`==`) or not (`!=`)");
            } else if left.ty.dimension().is_some() && right.ty.dimension().is_some() {
                diagnostic =
                    diagnostic.hint("only values of one dimension are compared: lengths with lengths");
            }
            self.report(diagnostic.also(left.span, a).also(right.span, b));
            return error_expr(span);
        }
        Expr { kind: ExprKind::Compare(comparison, Box::new(left), Box::new(right)), ty: Type::Bool, span }
    }
}

/// What a map of this space makes of a thing.
fn mapped(space: PointSpace, thing: &Type) -> Option<Type> {
    let join = |other: PointSpace| space.join(other).filter(|joined| *joined != PointSpace::Control);
    match thing {
        Type::Map(other) => Some(Type::Map(join(*other)?)),
        Type::Point(other) => Some(Type::Point(join(*other)?)),
        Type::Vector(other) => Some(Type::Vector(join(*other)?)),
        Type::Ifs => Some(Type::Ifs),
        figure if figure.is_figure() => Some(figure.clone()),
        _ => None,
    }
}

fn scaled(ty: &Type) -> Option<Type> {
    match ty {
        Type::Vector(space) => Some(Type::Vector(*space)),
        Type::Point(space) | Type::WeightedSum(space) => Some(Type::WeightedSum(*space)),
        _ => None,
    }
}

fn added(arithmetic: Arithmetic, left: &Type, right: &Type) -> Option<Type> {
    let space = left.point_space()?.join(right.point_space()?)?;
    Some(match (left, right) {
        (Type::Point(_), Type::Vector(_)) => Type::Point(space),
        (Type::Vector(_), Type::Point(_)) if arithmetic == Arithmetic::Add => Type::Point(space),
        (Type::Vector(_), Type::Vector(_)) => Type::Vector(space),
        (Type::Point(_), Type::Point(_)) if arithmetic == Arithmetic::Subtract => Type::Vector(space),
        _ => Type::WeightedSum(space),
    })
}
