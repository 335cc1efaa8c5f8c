//! Germs: their vertices lie in the space of the ifs around; `limit` and `control` stand for germs it finds itself.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::native::Native;
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::types::{PointSpace, Type};
use crate::hir::value::OwnGerm;
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    /// `limit` and `control`, inside of an ifs.
    pub(super) fn own_germ(&mut self, frame: &Frame, name: &str, span: Span) -> Option<Expr> {
        frame.own_ifs?;
        let germ = match name {
            "limit" => OwnGerm::Limit,
            "control" => OwnGerm::Control,
            _ => return None,
        };
        if frame.locals.iter().any(|local| local.name == name) {
            return None;
        }
        Some(Expr { kind: ExprKind::OwnGerm(germ), ty: Type::Germ, span })
    }

    /// The type of a germ, whose vertices are those of the ifs around, if there is one.
    pub(super) fn germ_type(&mut self, frame: &Frame, values: &[Expr]) -> Option<Type> {
        let Some(own) = self.own_space(frame) else { return Some(Type::Germ) };
        for value in values {
            let of = match &value.ty {
                Type::List(element) => element.point_space(),
                ty => ty.point_space(),
            };
            if of.is_some_and(|space| space.join(own).is_none()) {
                self.germ_elsewhere(own, value);
                return None;
            }
        }
        Some(Type::Germ)
    }

    fn germ_elsewhere(&mut self, own: PointSpace, value: &Expr) {
        if own == PointSpace::Control {
            let message = "a germ is drawn between the control points of its ifs, or combinations of them";
            let diagnostic = Diagnostic::new(Code::E0402, value.span, message).label("not a control point");
            self.report(diagnostic.hint("name control points: `germ segment(p0, p3)`"));
            return;
        }
        let is = self.described(&value.ty);
        let count = if own == PointSpace::Plane { "two" } else { "three" };
        let message = format!("a germ of an ifs {} has points with {count} coordinates", own.words());
        let diagnostic = Diagnostic::new(Code::E0532, value.span, message).label(is);
        self.report(diagnostic.hint(match own {
            PointSpace::Plane => "write `(0m, 1m)`",
            _ => "give every point a height: `(0m, 0m, 1m)`",
        }));
    }

    /// `polygon(p, q, r, …)`, or of one list.
    pub(super) fn polygon(
        &mut self,
        frame: &mut Frame,
        arguments: &[ast::Argument],
        at: Span,
        span: Span,
    ) -> Expr {
        let points = Type::List(Box::new(Type::Point(PointSpace::Any)));
        let named = arguments.first().is_some_and(|argument| argument.name.is_some());
        if named || arguments.is_empty() {
            // As any other function: its one parameter is the list.
            return self.native_by_parameters(frame, Native::Polygon, arguments, at, span);
        }
        let list = match arguments {
            [only] => {
                let checked = self.expr(frame, &only.value, Some(&points));
                match checked.ty {
                    Type::Point(_) => {
                        return self.too_few_corners(1, only.value.span, span);
                    }
                    _ => self.convert(checked, &points),
                }
            }
            several => {
                let corners: Vec<Expr> = several
                    .iter()
                    .map(|argument| {
                        self.unnamed(argument);
                        self.expect(frame, &argument.value, &Type::Point(PointSpace::Any))
                    })
                    .collect();
                if corners.iter().any(|corner| corner.ty == Type::Error) {
                    return error_expr(span);
                }
                if corners.len() < 3 {
                    return self.too_few_corners(corners.len(), at, span);
                }
                if self.germ_type(frame, &corners).is_none() {
                    return error_expr(span);
                }
                Expr { kind: ExprKind::List(corners), ty: points, span }
            }
        };
        if list.ty == Type::Error || self.germ_type(frame, std::slice::from_ref(&list)).is_none() {
            return error_expr(span);
        }
        Expr { kind: ExprKind::Native(Native::Polygon, vec![list]), ty: Type::Germ, span }
    }

    fn unnamed(&mut self, argument: &ast::Argument) {
        if let Some(name) = &argument.name {
            let message = "the corners of a polygon are listed without names";
            self.report(Diagnostic::new(Code::E0404, name.span, message).label("a name"));
        }
    }

    fn too_few_corners(&mut self, corners: usize, at: Span, span: Span) -> Expr {
        let message = format!("a polygon has three corners or more, not {corners}");
        let diagnostic = Diagnostic::new(Code::E0535, at, message).label("too few corners");
        self.report(diagnostic.hint("a line between two points is `segment(p, q)`"));
        error_expr(span)
    }
}
