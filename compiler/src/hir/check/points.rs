//! Control points in the brackets of a call, where they stand behind `on`.

use super::scope::Symbol;
use super::{Checker, Frame};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::hir::tree::ItemId;
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    /// Reports an ifs that is called with nothing but points, and takes none; whether it did. `at` is where the ifs is named,
    /// `span` the whole call.
    pub(super) fn refuse_points_in_brackets(
        &mut self,
        frame: &mut Frame,
        id: ItemId,
        arguments: &[ast::Argument],
        at: Span,
        span: Span,
    ) -> bool {
        if !matches!(self.declared[id.0 as usize].item.kind, ast::ItemKind::Ifs(_))
            || self.space_of(id) != Some(PointSpace::Control)
            || arguments.is_empty()
        {
            return false;
        }
        let parameters = self.signature(id).parameters;
        let takes_points = parameters.iter().any(|parameter| is_of_points(&parameter.ty));
        let mut are_points = |argument: &ast::Argument| {
            argument.name.is_none() && self.reads_as_points(frame, &argument.value)
        };
        if takes_points || !arguments.iter().all(&mut are_points) {
            return false;
        }
        let name = self.items[id.0 as usize].name.clone();
        let given = arguments[0].value.span.to(arguments[arguments.len() - 1].value.span);
        for argument in arguments {
            self.expr(frame, &argument.value, None);
        }
        let message = format!("the control points of `{name}` are given in brackets");
        let diagnostic =
            Diagnostic::new(Code::E0406, given, message).label("control points stand behind `on`");
        let (hint, fix) = match arguments {
            [ast::Argument { value, .. }] if !matches!(value.kind, ast::ExprKind::Tuple(_)) => {
                let points = match &value.kind {
                    ast::ExprKind::Name(name) => name,
                    _ => "[p, q, …]",
                };
                let hint = format!("write `{name} on {points}`");
                let fix = Fix::titled(hint.clone())
                    .with(Span::new(at.file, at.end, value.span.start), " on ")
                    .with(Span::new(at.file, value.span.end, span.end), "");
                (hint, fix)
            }
            _ => {
                let hint = format!("write `{name} on (p, q, …)`");
                (hint.clone(), Fix::titled(hint).with(at.after(), " on "))
            }
        };
        self.report(if parameters.iter().any(|parameter| parameter.required) {
            diagnostic.hint(format!("{hint}, behind the arguments that it needs"))
        } else {
            diagnostic.ways(hint, vec![fix])
        });
        true
    }

    /// Whether what is written can be told to be a point, or a list of points, before it is checked.
    fn reads_as_points(&mut self, frame: &Frame, value: &ast::Expr) -> bool {
        match &value.kind {
            ast::ExprKind::Tuple(_) => true,
            ast::ExprKind::Group(inner) => self.reads_as_points(frame, inner),
            ast::ExprKind::List(all) => all.first().is_some_and(|first| self.reads_as_points(frame, first)),
            ast::ExprKind::Comprehension { body, .. } => self.reads_as_points(frame, body),
            ast::ExprKind::Name(name) => {
                if let Some(local) = frame.locals.iter().rev().find(|local| local.name == *name) {
                    return is_of_points(&local.ty);
                }
                let scope = &self.modules[frame.module];
                let imported = || match scope.imports.get(name.as_str())?.symbol {
                    Symbol::Item(id) => Some(id),
                    Symbol::Native(_) | Symbol::Lost => None,
                };
                let Some(id) = scope.own.get(name.as_str()).copied().or_else(imported) else { return false };
                self.ensure_checked(id, value.span);
                self.types.get(&id).is_some_and(is_of_points)
            }
            _ => false,
        }
    }
}

/// A point, a control point with weights, or lists of them.
fn is_of_points(ty: &Type) -> bool {
    match ty {
        Type::List(element) => is_of_points(element),
        ty => matches!(ty, Type::Point(_) | Type::Weighted(_)),
    }
}
