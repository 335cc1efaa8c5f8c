//! Calls: functions, records, ifs with arguments, and the functions of the program.

use super::fields::Callee;
use super::scope::Symbol;
use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::hir::index::Target;
use crate::hir::schema::SchemaKind;
use crate::hir::tree::{Expr, ExprKind, ItemId, SettingValue};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn call(
        &mut self,
        frame: &mut Frame,
        callee: &ast::Expr,
        arguments: &[ast::Argument],
        span: Span,
    ) -> Expr {
        let ast::ExprKind::Name(name) = &callee.kind else {
            let written = callee;
            let callee = self.expr(frame, callee, None);
            if callee.ty == Type::Error {
                return error_expr(span);
            }
            if matches!(callee.ty, Type::Point(_) | Type::List(_)) {
                let after = callee.span.after();
                let message = format!("{} is followed by a bracket", self.described(&callee.ty));
                let diagnostic =
                    Diagnostic::new(Code::E0408, callee.span, message).label("a comma is missing after this");
                self.report(diagnostic.fix("put a comma between the two", after, ","));
                return error_expr(span);
            }
            if let Some(diagnostic) = divided_by_call(written) {
                self.report(diagnostic);
                return error_expr(span);
            }
            let message = format!("{} cannot be called", self.described(&callee.ty));
            return self.not_callable(message, (&callee.ty, callee.span), None, arguments, span);
        };
        if name == "self" {
            return self.self_with_arguments(frame, callee, arguments, span);
        }
        if let Some(local) = frame.locals.iter().rev().find(|local| local.name == *name) {
            let message = format!("`{name}` is no function: it is {}", self.described(&local.ty));
            let (ty, declared) = (local.ty.clone(), local.span);
            return self.not_callable(message, (&ty, callee.span), Some(declared), arguments, span);
        }
        match self.symbol(frame.module, name, callee.span) {
            Some(Symbol::Native(native)) => self.native(frame, native, arguments, callee.span, span),
            Some(Symbol::Item(id)) => self.call_item(frame, id, callee.span, arguments, span),
            symbol @ (Some(Symbol::Lost) | None) => {
                for argument in arguments {
                    self.expr(frame, &argument.value, None);
                }
                if symbol.is_none() {
                    self.unknown(frame, name, callee.span, "fn");
                }
                error_expr(span)
            }
        }
    }

    /// What stands before the brackets, of this type, is no function: they may have been meant to multiply it or to pick
    /// one of its elements.
    fn not_callable(
        &mut self,
        message: String,
        (ty, at): (&Type, Span),
        declared: Option<Span>,
        arguments: &[ast::Argument],
        span: Span,
    ) -> Expr {
        let mut diagnostic = Diagnostic::new(Code::E0408, at, message).label("not a function");
        if let Some(declared) = declared {
            diagnostic = diagnostic.also(declared, "declared here");
        }
        let hint = "a product is written with `*`, an element of a list is picked with `[…]`";
        let meant = match arguments {
            [ast::Argument { name: None, value }] => meant(ty, at, value.span, span),
            _ => None,
        };
        self.report(diagnostic.ways(hint, meant.into_iter().collect()));
        error_expr(span)
    }

    fn self_with_arguments(
        &mut self,
        frame: &mut Frame,
        callee: &ast::Expr,
        arguments: &[ast::Argument],
        span: Span,
    ) -> Expr {
        match frame.own_ifs {
            Some(id) => {
                self.refer(callee.span, Target::Declared(self.items[id.0 as usize].name_span));
                self.call_item(frame, id, callee.span, arguments, span)
            }
            None => self.expr(frame, callee, None),
        }
    }

    fn call_item(
        &mut self,
        frame: &mut Frame,
        id: ItemId,
        at: Span,
        arguments: &[ast::Argument],
        span: Span,
    ) -> Expr {
        let name = self.items[id.0 as usize].name.clone();
        let kind = &self.declared[id.0 as usize].item.kind;
        let callable =
            matches!(kind, ast::ItemKind::Function(_) | ast::ItemKind::Record(_) | ast::ItemKind::Ifs(_));
        self.ensure_checked(id, at);
        if self.is_broken(id) {
            for argument in arguments {
                self.expr(frame, &argument.value, None);
            }
            return error_expr(span);
        }
        if !callable {
            let ty = self.types.get(&id).cloned().unwrap_or(Type::Error);
            let message = format!("`{name}` is no function: it is {}", self.described(&ty));
            let declared = self.items[id.0 as usize].name_span;
            return self.not_callable(message, (&ty, at), Some(declared), arguments, span);
        }
        if self.refuse_points_in_brackets(frame, id, arguments, at, span) {
            return error_expr(span);
        }
        let bound = self.bind_item(frame, id, &name, arguments, at, span);
        let Some(values) = bound else { return error_expr(span) };
        let result = self.signature(id).result.or_else(|| self.types.get(&id).cloned());
        let (kind, ty) = match self.declared[id.0 as usize].item.kind {
            ast::ItemKind::Function(_) => (ExprKind::Call(id, values), result.unwrap_or(Type::Error)),
            ast::ItemKind::Record(_) => (ExprKind::Record(id, values), Type::Record(id)),
            _ => (ExprKind::Ifs(id, values), Type::Ifs),
        };
        Expr { kind, ty, span }
    }

    /// Every argument with defaults filled in; `None` after a report.
    fn bind_item(
        &mut self,
        frame: &mut Frame,
        id: ItemId,
        name: &str,
        arguments: &[ast::Argument],
        at: Span,
        span: Span,
    ) -> Option<Vec<Expr>> {
        let parameters = self.signature(id).parameters;
        let bound = self.bind(frame, Callee::Item(id, name), &parameters, arguments, at);
        let values =
            bound.into_iter().zip(parameters).enumerate().map(|(index, (value, parameter))| match value {
                Some(value) => Some(value),
                None if parameter.required => None,
                None => Some(Expr { kind: ExprKind::Default(id, index), ty: parameter.ty, span }),
            });
        values.collect()
    }

    /// An ifs named without arguments: all have defaults, or it is an error.
    pub(super) fn ifs_without_arguments(&mut self, id: ItemId, span: Span) -> Expr {
        let name = self.items[id.0 as usize].name.clone();
        let mut frame = Frame::new(self.declared[id.0 as usize].module);
        match self.bind_item(&mut frame, id, &name, &[], span, span) {
            Some(values) => Expr { kind: ExprKind::Ifs(id, values), ty: Type::Ifs, span },
            None => error_expr(span),
        }
    }

    /// `{ name: value }`: settings, or a record whose type the place knows.
    pub(super) fn bare_record(
        &mut self,
        frame: &mut Frame,
        fields: &[ast::Argument],
        span: Span,
        expected: Option<&Type>,
    ) -> Expr {
        match expected {
            Some(Type::Settings(kind)) => self.settings(frame, *kind, fields, span),
            Some(Type::Record(id)) => {
                let name = self.items[id.0 as usize].name.clone();
                self.ensure_checked(*id, span);
                match self.bind_item(frame, *id, &name, fields, span, span) {
                    Some(values) => Expr { kind: ExprKind::Record(*id, values), ty: Type::Record(*id), span },
                    None => error_expr(span),
                }
            }
            _ => {
                let message = "fields in braces can stand only where the type of the record is known";
                let diagnostic = Diagnostic::new(Code::E0401, span, message).label("which record?");
                self.report(diagnostic.hint("name the record: `Radius(across: 1m, along: 2m)`"));
                error_expr(span)
            }
        }
    }

    fn settings(
        &mut self,
        frame: &mut Frame,
        kind: SchemaKind,
        fields: &[ast::Argument],
        span: Span,
    ) -> Expr {
        let mut values: Vec<SettingValue> = Vec::new();
        for field in fields {
            let Some(name) = &field.name else {
                let message = format!("settings of {} are given by name", kind.name());
                self.report(Diagnostic::new(Code::E0404, field.value.span, message).label("which setting?"));
                continue;
            };
            if let Some(value) = self.setting(frame, kind, name, &field.value, &values) {
                values.push(value);
            }
        }
        Expr { kind: ExprKind::Settings(kind, values), ty: Type::Settings(kind), span }
    }

    pub(super) fn field(
        &mut self,
        frame: &mut Frame,
        base: &ast::Expr,
        name: &ast::Name,
        span: Span,
    ) -> Expr {
        let base = self.expr(frame, base, None);
        if base.ty == Type::Error {
            return error_expr(span);
        }
        if let Some(space) = base.ty.point_space().filter(|space| *space != PointSpace::Control) {
            return self.coordinate(base, space, name, span);
        }
        let (record, each) = match &base.ty {
            Type::Record(id) => (Some(*id), false),
            Type::List(element) => match **element {
                Type::Record(id) => (Some(id), true),
                _ => (None, true),
            },
            _ => (None, false),
        };
        let Some(id) = record else {
            if let Some(made) = self.made(frame, &base, name, span) {
                return made;
            }
            let ty = self.described(&base.ty);
            let message = format!("{ty} has no fields");
            let mut diagnostic =
                Diagnostic::new(Code::E0407, name.span, message).label("nothing to name here");
            if base.ty.is_figure() {
                diagnostic = diagnostic.hint("a test can ask it for its `boards`, `elements` and `vertices`");
            } else if matches!(base.ty, Type::List(_)) {
                diagnostic =
                    diagnostic.hint("the number of elements of a list is `len(list)`, an element `list[0]`");
            }
            self.report(diagnostic);
            return error_expr(span);
        };
        self.ensure_checked(id, span);
        // A record is known by its signature even while its defaults are being checked.
        let fields = self.signature(id).parameters;
        let Some(index) = fields.iter().position(|field| field.name == name.text) else {
            let known: Vec<String> = fields.iter().map(|field| field.name.clone()).collect();
            let record = self.items[id.0 as usize].name.clone();
            let message = format!("`{record}` has no field `{}`", name.text);
            self.unknown_word(Code::E0407, name, message, known.iter().map(String::as_str));
            return error_expr(span);
        };
        self.refer_field(name.span, id, index);
        let ty = fields[index].ty.clone();
        let base = Box::new(base);
        if each {
            return Expr { kind: ExprKind::EachField(base, index), ty: Type::List(Box::new(ty)), span };
        }
        Expr { kind: ExprKind::Field(base, index), ty, span }
    }

    /// `point.x`
    fn coordinate(&mut self, base: Expr, space: PointSpace, name: &ast::Name, span: Span) -> Expr {
        let known: &[&str] = if space == PointSpace::Plane { &["x", "y"] } else { &["x", "y", "z"] };
        let Some(index) = known.iter().position(|known| *known == name.text) else {
            let message = format!("{} has no field `{}`", self.described(&base.ty), name.text);
            self.unknown_word(Code::E0407, name, message, known.iter().copied());
            return error_expr(span);
        };
        Expr { kind: ExprKind::Coordinate(Box::new(base), index), ty: Type::LENGTH, span }
    }
}

/// What one value in round brackets behind a value of some type may have been meant to be.
fn meant(ty: &Type, at: Span, inner: Span, span: Span) -> Option<Fix> {
    match ty {
        Type::List(_) => {
            let open = Span::new(at.file, at.end, inner.start);
            let close = Span::new(at.file, inner.end, span.end);
            Some(Fix::titled("pick an element with `[…]`").with(open, "[").with(close, "]"))
        }
        _ => ty.dimension().map(|_| Fix::titled("multiply with `*`").with(at.after(), " * ")),
    }
}

/// `2m/min(…)`: a unit, where it was meant to divide by what a function gives.
fn divided_by_call(callee: &ast::Expr) -> Option<Diagnostic> {
    let ast::ExprKind::Number { digits, unit: Some(unit) } = &callee.kind else { return None };
    let (over, under) = unit.suffix().split_once('/')?;
    let message = format!("`{digits}{}` is a number with a unit, and no function", unit.suffix());
    let diagnostic = Diagnostic::new(Code::E0408, callee.span, message).label("not a function");
    let quotient = format!("{digits}{over} / {under}");
    let hint = format!("to divide by what `{under}(…)` gives, write `{quotient}(…)`");
    Some(diagnostic.fix(hint, callee.span, quotient))
}
