//! Lists, comprehensions, ranges, elements and slices.

use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::evaluate::MOST_ELEMENTS;
use crate::hir::index::DeclarationKind;
use crate::hir::tree::{Clause, Expr, ExprKind};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn list(
        &mut self,
        frame: &mut Frame,
        elements: &[ast::Expr],
        span: Span,
        expected: Option<&Type>,
    ) -> Expr {
        if elements.len() > MOST_ELEMENTS {
            let message = format!("a list of {} elements; the limit is {MOST_ELEMENTS}", elements.len());
            self.report(Diagnostic::new(Code::E0704, span, message).label("too long"));
            return error_expr(span);
        }
        let wanted = element_of(expected);
        let elements: Vec<Expr> = elements.iter().map(|element| self.expr(frame, element, wanted)).collect();
        let mut ty = Type::Error;
        for element in &elements {
            let Some(joined) = ty.join(&element.ty) else {
                let (first, other) = (self.described(&ty), self.described(&element.ty));
                let message =
                    format!("the elements of a list are of one kind, but here are {first} and {other}");
                let diagnostic = Diagnostic::new(Code::E0410, element.span, message).label(other);
                self.report(diagnostic.also(elements[0].span, first));
                return error_expr(span);
            };
            ty = joined;
        }
        let elements = match &ty {
            // Points among weighted ones are made sure of one by one.
            Type::Weighted(_) => elements.into_iter().map(|element| self.convert(element, &ty)).collect(),
            _ => elements,
        };
        if elements.is_empty()
            && let Some(wanted) = wanted
        {
            ty = wanted.clone();
        }
        Expr { kind: ExprKind::List(elements), ty: Type::List(Box::new(ty)), span }
    }

    pub(super) fn comprehension(
        &mut self,
        frame: &mut Frame,
        body: &ast::Expr,
        clauses: &[ast::Clause],
        span: Span,
        expected: Option<&Type>,
    ) -> Expr {
        let outer = frame.locals.len();
        let mut checked = Vec::new();
        for clause in clauses {
            match clause {
                ast::Clause::For(name, over) => {
                    let over = self.expr(frame, over, None);
                    let ty = self.iterated(&over, "`for`");
                    let slot = self.declare(frame, name, ty, DeclarationKind::Running, span);
                    checked.push(Clause::For(slot, over));
                }
                ast::Clause::If(condition) => {
                    checked.push(Clause::If(self.expect(frame, condition, &Type::Bool)));
                }
            }
        }
        let body = self.expr(frame, body, element_of(expected));
        frame.locals.truncate(outer);
        let ty = Type::List(Box::new(body.ty.clone()));
        Expr { kind: ExprKind::Comprehension(Box::new(body), checked), ty, span }
    }

    /// The type of what runs through a range or a list; `what` does it, in words.
    pub(super) fn iterated(&mut self, over: &Expr, what: &str) -> Type {
        match &over.ty {
            Type::IntRange => Type::Int,
            Type::List(element) => (**element).clone(),
            Type::Error => Type::Error,
            other => {
                let is = self.described(other);
                let message = format!("{what} goes through a range or a list, but this is {is}");
                let diagnostic = Diagnostic::new(Code::E0401, over.span, message).label(is);
                self.report(diagnostic.hint("write `0..n` for the numbers from 0 to n - 1"));
                Type::Error
            }
        }
    }

    pub(super) fn range(&mut self, frame: &mut Frame, range: &ast::RangeExpr, span: Span) -> Expr {
        let from = self.expect(frame, &range.from, &Type::Int);
        let to = self.expect(frame, &range.to, &Type::Int);
        Expr { kind: ExprKind::Range(Box::new(from), Box::new(to)), ty: Type::IntRange, span }
    }

    pub(super) fn index(
        &mut self,
        frame: &mut Frame,
        base: &ast::Expr,
        indices: &[ast::Expr],
        span: Span,
    ) -> Expr {
        let base = self.expr(frame, base, None);
        let written = indices;
        let indices: Vec<Expr> = indices.iter().map(|index| self.expr(frame, index, None)).collect();
        if let ([ast::Expr { kind: ast::ExprKind::Name(_), .. }], [index], Type::List(element)) =
            (written, indices.as_slice(), &base.ty)
            && index.ty == Type::Error
        {
            // Which element is not known, but what kind of thing it is: `points[k]` may stand before its `for k in …`.
            return Expr { kind: ExprKind::Error, ty: (**element).clone(), span };
        }
        if base.ty == Type::Error || indices.iter().any(|index| index.ty == Type::Error) {
            return error_expr(span);
        }
        let mut ty = base.ty.clone();
        for index in &indices {
            match ty {
                Type::List(element) => ty = *element,
                other => return self.not_a_list(&other, (&base, index), span),
            }
        }
        match indices.iter().position(|index| index.ty != Type::IntRange) {
            None if !indices.is_empty() => {
                let ty = base.ty.clone();
                Expr { kind: ExprKind::Slice(Box::new(base), indices), ty, span }
            }
            _ if indices.iter().all(|index| index.ty == Type::Int) => {
                indices.into_iter().fold(base, |list, index| {
                    let Type::List(element) = list.ty.clone() else { return error_expr(span) };
                    Expr { kind: ExprKind::Index(Box::new(list), Box::new(index)), ty: *element, span }
                })
            }
            _ => {
                let other = indices.iter().find(|index| !matches!(index.ty, Type::Int | Type::IntRange));
                let at = other.or(indices.first()).map_or(span, |index| index.span);
                let (message, label) = match other {
                    Some(other) => {
                        let is = self.described(&other.ty);
                        (format!("elements are picked by whole numbers, but this is {is}"), is)
                    }
                    None => {
                        let message = "in brackets stand whole numbers, or ranges of them, not both";
                        (message.to_owned(), "does not fit the other".to_owned())
                    }
                };
                let diagnostic = Diagnostic::new(Code::E0401, at, message).label(label);
                self.report(diagnostic.hint(
                    "`list[3]` is an element, `list[0..4]` a part, `grid[0..4, 2..6]` a part of a grid",
                ));
                error_expr(span)
            }
        }
    }

    fn not_a_list(&mut self, ty: &Type, (base, index): (&Expr, &Expr), span: Span) -> Expr {
        let is = self.described(ty);
        let diagnostic = if base.ty == *ty {
            Diagnostic::new(Code::E0401, base.span, format!("{is} has no elements")).label("not a list")
        } else {
            let message = format!("there is one index too many: the elements are each {is}");
            Diagnostic::new(Code::E0401, index.span, message).label("nothing to pick from")
        };
        self.report(diagnostic);
        error_expr(span)
    }
}

fn element_of(expected: Option<&Type>) -> Option<&Type> {
    match expected {
        Some(Type::List(element)) => Some(element),
        _ => None,
    }
}
