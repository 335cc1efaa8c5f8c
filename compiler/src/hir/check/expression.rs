//! Expressions: which kind goes where.

use super::names::not_among;
use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::exact::Rational;
use crate::hir::dimension::{Worth, unit_worth};
use crate::hir::index::Target;
use crate::hir::scalar::Scalar;
use crate::hir::schema::ChoiceKind;
use crate::hir::tree::{Expr, ExprKind};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    /// The typed expression; `expected` is what the place would like, which settles words and coordinates.
    pub(super) fn expr(&mut self, frame: &mut Frame, value: &ast::Expr, expected: Option<&Type>) -> Expr {
        let typed = stacker::maybe_grow(128 * 1024, 1024 * 1024, || self.expr_here(frame, value, expected));
        self.note_type(value.span, &typed.ty);
        self.note_expected(value.span, expected);
        typed
    }

    fn expr_here(&mut self, frame: &mut Frame, value: &ast::Expr, expected: Option<&Type>) -> Expr {
        let span = value.span;
        match &value.kind {
            ast::ExprKind::Error => error_expr(span),
            ast::ExprKind::Number { digits, unit } => self.number(digits, *unit, span),
            ast::ExprKind::Text(text) => Expr { kind: ExprKind::Text(text.clone()), ty: Type::Text, span },
            ast::ExprKind::Bool(truth) => Expr { kind: ExprKind::Bool(*truth), ty: Type::Bool, span },
            ast::ExprKind::Name(name) => self.word_or_name(frame, name, span, expected),
            ast::ExprKind::Group(inner) => {
                let inner = self.expr(frame, inner, expected);
                Expr { span, ..inner }
            }
            ast::ExprKind::Tuple(parts) => self.coordinates(frame, parts, span, expected),
            ast::ExprKind::List(elements) => self.list(frame, elements, span, expected),
            ast::ExprKind::Comprehension { body, clauses } => {
                self.comprehension(frame, body, clauses, span, expected)
            }
            ast::ExprKind::Fields(fields) => self.bare_record(frame, fields, span, expected),
            ast::ExprKind::Call { callee, arguments } => self.call(frame, callee, arguments, span),
            ast::ExprKind::Field(base, name) => self.field(frame, base, name, span),
            ast::ExprKind::Index(base, indices) => self.index(frame, base, indices, span),
            ast::ExprKind::Unary(operator, inner) => self.unary(frame, *operator, inner, span),
            ast::ExprKind::Binary(operator, at, left, right) => {
                self.binary(frame, *operator, *at, [left, right], span, expected)
            }
            ast::ExprKind::Range(range) => self.range(frame, range, span),
            ast::ExprKind::If(condition, yes, no) => {
                self.condition(frame, [condition, yes, no], span, expected)
            }
            ast::ExprKind::On(ifs, placement) => self.on(frame, ifs, placement, span),
            ast::ExprKind::At(figure, level) => self.at(frame, figure, level, span),
        }
    }

    fn number(&mut self, digits: &str, unit: Option<ast::Unit>, span: Span) -> Expr {
        let Ok(value) = Rational::from_decimal(digits) else { return error_expr(span) };
        let whole = !digits.contains(['.', 'e', 'E']);
        let (scalar, ty) = match unit {
            None if whole => (Scalar::Exact(value), Type::Int),
            None => (Scalar::Exact(value), Type::NUMBER),
            Some(unit) => {
                let (dimension, worth) = unit_worth(unit);
                let scalar = match worth {
                    Worth::Exact(worth) => Scalar::Exact(&value * &worth),
                    Worth::TimesPi(worth) => Scalar::Pi(&value * &worth),
                };
                (scalar, Type::Quantity(dimension))
            }
        };
        Expr { kind: ExprKind::Scalar(scalar), ty, span }
    }

    fn word_or_name(&mut self, frame: &mut Frame, name: &str, span: Span, expected: Option<&Type>) -> Expr {
        if name == "self" {
            return self.own_ifs(frame, span);
        }
        // A parameter hands a word on: `dialect: dialect`.
        let local = || frame.locals.iter().any(|local| local.name == name);
        if let Some(Type::Choice(kind)) = expected
            && (kind.position(name).is_some() || !local())
        {
            return self.word(*kind, name, span);
        }
        if *expected.unwrap_or(&Type::Error) == Type::Germ
            && let Some(germ) = self.own_germ(frame, name, span)
        {
            return germ;
        }
        self.name(frame, name, span)
    }

    fn word(&mut self, kind: ChoiceKind, name: &str, span: Span) -> Expr {
        let Some(position) = kind.position(name) else {
            let words = kind.words().iter().map(|word| word.name);
            let message = format!("`{name}` is none of the words that can stand here");
            let name = ast::Name { text: name.to_owned(), span };
            let mut diagnostic = not_among(Code::E0411, &name, message, words.clone());
            if diagnostic.hints.is_empty() {
                let fixes = words.map(|word| Fix::replacing(span, word));
                diagnostic = diagnostic.ways("write one of its words", fixes.collect());
            }
            self.report(diagnostic);
            return error_expr(span);
        };
        self.refer(span, Target::Choice(kind, position));
        Expr { kind: ExprKind::Choice(kind, position), ty: Type::Choice(kind), span }
    }

    fn own_ifs(&mut self, frame: &Frame, span: Span) -> Expr {
        if let Some(id) = frame.own_ifs {
            self.refer(span, Target::Declared(self.items[id.0 as usize].name_span));
            return Expr { kind: ExprKind::SelfIfs(id), ty: Type::Ifs, span };
        }
        let message = "`self` stands for the ifs around, and there is none here";
        let diagnostic = Diagnostic::new(Code::E0301, span, message).label("outside of an ifs");
        self.report(diagnostic.hint("name the ifs instead"));
        error_expr(span)
    }

    fn coordinates(
        &mut self,
        frame: &mut Frame,
        parts: &[ast::Expr],
        span: Span,
        expected: Option<&Type>,
    ) -> Expr {
        let space = match parts.len() {
            2 => PointSpace::Plane,
            3 => PointSpace::Space,
            count => {
                let message = format!("a point or vector has two or three coordinates, not {count}");
                self.report(Diagnostic::new(Code::E0401, span, message).label(format!("{count} values")));
                return error_expr(span);
            }
        };
        if !parts.is_empty() && parts.iter().all(is_plain_number) {
            return self.plain_coordinates(parts, span);
        }
        let lengths: Vec<Expr> = parts.iter().map(|part| self.expect(frame, part, &Type::LENGTH)).collect();
        if lengths.iter().any(|length| length.ty == Type::Error) {
            return error_expr(span);
        }
        match expected {
            Some(Type::Vector(_)) => Expr { kind: ExprKind::Vector(lengths), ty: Type::Vector(space), span },
            _ => Expr { kind: ExprKind::Point(lengths), ty: Type::Point(space), span },
        }
    }

    /// `(0, 1)`: however many numbers lack their unit, it is one mistake.
    fn plain_coordinates(&mut self, parts: &[ast::Expr], span: Span) -> Expr {
        let message = "the coordinates of a point are Lengths, but these are numbers without a unit";
        let diagnostic = Diagnostic::new(Code::E0401, span, message).label("numbers without a unit");
        let example = if parts.len() == 2 { "(0m, 1.5m)" } else { "(0m, 1.5m, 200mm)" };
        self.report(diagnostic.hint(format!("add units, such as `{example}`")));
        error_expr(span)
    }

    fn condition(
        &mut self,
        frame: &mut Frame,
        [condition, yes, no]: [&ast::Expr; 3],
        span: Span,
        expected: Option<&Type>,
    ) -> Expr {
        let condition = self.expect(frame, condition, &Type::Bool);
        let yes = self.expr(frame, yes, expected);
        let no = self.expr(frame, no, expected);
        let Some(ty) = yes.ty.join(&no.ty) else {
            let (a, b) = (self.described(&yes.ty), self.described(&no.ty));
            let message =
                format!("after `then` and `else` stand values of one type, but these are {a} and {b}");
            let diagnostic = Diagnostic::new(Code::E0401, no.span, message).label(b);
            self.report(diagnostic.also(yes.span, a));
            return error_expr(span);
        };
        let (yes, no) = match &ty {
            Type::Weighted(_) => (self.convert(yes, &ty), self.convert(no, &ty)),
            _ => (yes, no),
        };
        let parts = [condition, yes, no].map(Box::new);
        let [condition, yes, no] = parts;
        Expr { kind: ExprKind::If(condition, yes, no), ty, span }
    }
}

/// A number as it is written, with a sign or without.
fn is_plain_number(part: &ast::Expr) -> bool {
    match &part.kind {
        ast::ExprKind::Number { unit, .. } => unit.is_none(),
        ast::ExprKind::Unary(ast::UnaryOperator::Negate, inner) => is_plain_number(inner),
        _ => false,
    }
}
