//! `… on …` and `… at level …`.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::tree::{Expr, ExprKind, ItemKind};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn on(
        &mut self,
        frame: &mut Frame,
        ifs: &ast::Expr,
        placement: &ast::Placement,
        span: Span,
    ) -> Expr {
        let ifs = self.expect(frame, ifs, &Type::Ifs);
        let space = self.ifs_space(&ifs);
        let point = Type::Weighted(PointSpace::Any);
        let (points, at) = match placement {
            ast::Placement::Points(points, at) => {
                let points: Vec<Expr> =
                    points.iter().map(|value| self.expr(frame, value, Some(&point))).collect();
                if let Some(list) = points.iter().find(|value| matches!(value.ty, Type::List(_))) {
                    return self.list_in_brackets(list, points.len(), span);
                }
                let points: Vec<Expr> = points.into_iter().map(|value| self.convert(value, &point)).collect();
                let placed = matches!(space, None | Some(PointSpace::Control));
                if placed && points.iter().all(|point| point.ty != Type::Error) {
                    self.count_points(&ifs, points.len(), *at);
                }
                let ty = Type::List(Box::new(point));
                (Expr { kind: ExprKind::List(points), ty, span: *at }, *at)
            }
            ast::Placement::Value(value) => {
                let list = Type::List(Box::new(point));
                let grid = Type::List(Box::new(list.clone()));
                let points = self.expr(frame, value, None);
                let rows = matches!(&points.ty, Type::List(row) if matches!(**row, Type::List(_)));
                (self.convert(points, if rows { &grid } else { &list }), value.span)
            }
        };
        if ifs.ty == Type::Error || self.refuse_points(&ifs, at) {
            return error_expr(span);
        }
        Expr { kind: ExprKind::On(Box::new(ifs), Box::new(points), at), ty: Type::Figure, span }
    }

    fn list_in_brackets(&mut self, list: &Expr, count: usize, span: Span) -> Expr {
        let name = self.described(&list.ty);
        let message = format!("in brackets after `on` stand points one by one, but this is {name}");
        let diagnostic = Diagnostic::new(Code::E0401, list.span, message).label("a whole list");
        self.report(diagnostic.hint(match count {
            1 => "a list stands after `on` without brackets around it: `on points`",
            _ => "a grid of points is a list of lists: `on [[p, q], [r, s]]`",
        }));
        error_expr(span)
    }

    fn count_points(&mut self, ifs: &Expr, given: usize, at: Span) {
        let ExprKind::Ifs(id, _) = &ifs.kind else { return };
        let ItemKind::Ifs(declared) = &self.items[id.0 as usize].kind else { return };
        let Some(needed) = declared.fixed_points().filter(|needed| *needed != given) else { return };
        let names: Vec<&str> = declared.control_points.iter().map(|point| point.name.as_str()).collect();
        let names = names.join(", ");
        let item = &self.items[id.0 as usize];
        let (name, declared_at) = (item.name.clone(), item.name_span);
        let message = format!("`{name}` is placed on {needed} control points, but {given} are given");
        let label = if given == 1 { "one point".to_owned() } else { format!("{given} points") };
        let diagnostic = Diagnostic::new(Code::E0504, at, message).label(label);
        self.report(diagnostic.also(declared_at, "declared here").hint(format!("it needs ({names})")));
    }

    pub(super) fn at(
        &mut self,
        frame: &mut Frame,
        figure: &ast::Expr,
        level: &ast::Level,
        span: Span,
    ) -> Expr {
        let figure = self.expr(frame, figure, Some(&Type::Figure));
        let figure = if figure.ty.is_figure() { figure } else { self.convert(figure, &Type::Figure) };
        let (first, second) = match level {
            ast::Level::Uniform(level) => (self.expect(frame, level, &Type::Int), None),
            ast::Level::Pair(u, v) => {
                (self.expect(frame, u, &Type::Int), Some(Box::new(self.expect(frame, v, &Type::Int))))
            }
            ast::Level::Until { each, measure, limit } => {
                return self.until(frame, figure, *each, measure, limit, span);
            }
        };
        if figure.ty == Type::Error || first.ty == Type::Error {
            return error_expr(span);
        }
        let ty = figure.ty.clone();
        Expr { kind: ExprKind::At(Box::new(figure), Box::new(first), second), ty, span }
    }
}
