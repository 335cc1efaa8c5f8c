//! Items: params, lets, figures, functions and records. An ifs and a fabricate block have files of their own.

use super::scope::item_name;
use super::{Checker, Frame, State};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::index::DeclarationKind;
use crate::hir::tree::{Body, Field, Function, Item, ItemId, ItemKind, Param};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast;

/// What a function, record or ifs takes, known before its body is checked.
#[derive(Clone, Debug)]
pub(super) struct Signature {
    pub(super) parameters: Vec<Parameter>,
    pub(super) result: Option<Type>,
}

#[derive(Clone, Debug)]
pub(super) struct Parameter {
    pub(super) name: String,
    pub(super) ty: Type,
    pub(super) required: bool,
}

impl<'a> Checker<'a> {
    /// Checks everything that the design and the files it uses declare, and what the design makes of it.
    pub(super) fn check_root(&mut self) {
        for index in 0..self.declared.len() {
            if !self.modules[self.declared[index].module].is_library() {
                let id = ItemId(index as u32);
                self.ensure_checked(id, self.items[index].name_span);
            }
        }
        self.check_records();
        let root = self.modules[0].ast;
        for item in &root.items {
            match &item.kind {
                ast::ItemKind::Fabricate(fabricate) => self.fabricate(fabricate),
                ast::ItemKind::Test(test) => self.test(test),
                _ => {}
            }
        }
        self.warn_unused_imports();
    }

    /// Checks an item unless that is done; `wanted` is where it is needed.
    pub(super) fn ensure_checked(&mut self, id: ItemId, wanted: Span) {
        match self.declared[id.0 as usize].state {
            State::Done => {}
            State::InProgress => self.needs_itself(id, wanted),
            State::Unchecked => {
                self.declared[id.0 as usize].state = State::InProgress;
                stacker::maybe_grow(128 * 1024, 1024 * 1024, || self.check_item(id));
                self.declared[id.0 as usize].state = State::Done;
            }
        }
    }

    fn needs_itself(&mut self, id: ItemId, wanted: Span) {
        let item = self.declared[id.0 as usize].item;
        // A function that says what it gives may call itself; a record or ifs may be named inside itself.
        let named_freely = match &item.kind {
            ast::ItemKind::Function(function) => function.result.is_some(),
            ast::ItemKind::Record(_) | ast::ItemKind::Ifs(_) => true,
            _ => false,
        };
        if named_freely {
            return;
        }
        self.types.insert(id, Type::Error);
        let name = self.items[id.0 as usize].name.clone();
        let declared = self.items[id.0 as usize].name_span;
        let mut diagnostic = Diagnostic::new(Code::E0305, wanted, format!("`{name}` depends on itself"))
            .label("needed here, while it is being worked out")
            .also(declared, format!("`{name}` is declared here"));
        diagnostic = match item.kind {
            ast::ItemKind::Function(_) => {
                diagnostic.hint("write what the function gives: `-> Length`, `-> Curve`, …")
            }
            _ => diagnostic.hint("give one of the definitions in the circle a value of its own"),
        };
        self.report(diagnostic);
    }

    fn check_item(&mut self, id: ItemId) {
        let Some(declared) = self.declared.get(id.0 as usize) else { return };
        let (module, item) = (declared.module, declared.item);
        let (kind, ty) = match &item.kind {
            ast::ItemKind::Param(param) => self.param(module, param),
            ast::ItemKind::Let(value) => {
                let (body, ty) = self.annotated(module, value.ty.as_ref(), &value.value);
                (ItemKind::Let(body), ty)
            }
            ast::ItemKind::Figure(figure) => self.figure(module, figure),
            ast::ItemKind::Function(function) => self.function(id, module, function),
            ast::ItemKind::Record(record) => {
                (ItemKind::Record(self.fields(id, module, &record.fields)), Type::Record(id))
            }
            ast::ItemKind::Ifs(ifs) => (self.ifs(id, module, ifs), Type::Ifs),
            _ => return,
        };
        let Some(name) = item_name(item) else { return };
        self.note(name, DeclarationKind::Item(id), ty.clone(), None);
        self.items[id.0 as usize] =
            Item { name: name.text.clone(), name_span: name.span, docs: item.docs.clone(), kind };
        self.types.entry(id).or_insert(ty);
    }

    pub(super) fn body(&mut self, module: usize, value: &ast::Expr, expected: Option<&Type>) -> Body {
        let mut frame = Frame::new(module);
        let value = match expected {
            Some(expected) => self.expect(&mut frame, value, expected),
            None => self.expr(&mut frame, value, None),
        };
        Body { value, slots: frame.slots }
    }

    fn annotated(&mut self, module: usize, ty: Option<&ast::TypeExpr>, value: &ast::Expr) -> (Body, Type) {
        let expected = ty.map(|ty| self.type_expr(module, ty));
        let body = self.body(module, value, expected.as_ref());
        let ty = expected.unwrap_or_else(|| body.value.ty.clone());
        (body, ty)
    }

    fn param(&mut self, module: usize, param: &ast::Param) -> (ItemKind, Type) {
        let ty = self.type_expr(module, &param.ty);
        let number = ty.dimension().is_some();
        if !number && !matches!(ty, Type::Bool | Type::Text | Type::Error) {
            let message = format!("a parameter cannot be {}", self.described(&ty));
            let diagnostic =
                Diagnostic::new(Code::E0401, param.ty.span, message).label("not set from outside");
            self.report(
                diagnostic.hint("parameters are numbers (`Length`, `Angle`, `Int`, …), `Bool` or `Text`"),
            );
        }
        let default = self.body(module, &param.default, Some(&ty));
        if let Some(range) = &param.range
            && matches!(ty, Type::Bool | Type::Text)
        {
            let message = "only a number has a range";
            let at = range.from.span.to(range.to.span);
            self.report(
                Diagnostic::new(Code::E0401, at, message).label("no range fits here").hint("leave it out"),
            );
        }
        let bound = |checker: &mut Self, value: &ast::Expr| checker.body(module, value, Some(&ty));
        let range = param.range.as_ref().filter(|_| number);
        let range = range.map(|range| (bound(self, &range.from), bound(self, &range.to)));
        let step = param.step.as_ref().filter(|_| number).map(|step| bound(self, step));
        (ItemKind::Param(Box::new(Param { ty: ty.clone(), default, range, step })), ty)
    }

    fn figure(&mut self, module: usize, figure: &ast::Figure) -> (ItemKind, Type) {
        let (body, ty) = match &figure.ty {
            Some(ty) => self.annotated(module, Some(ty), &figure.value),
            None => {
                // Or a list of figures, so it is only what the place would like.
                let mut frame = Frame::new(module);
                let value = self.expr(&mut frame, &figure.value, Some(&Type::Figure));
                let ty = value.ty.clone();
                (Body { value, slots: frame.slots }, ty)
            }
        };
        let fits = match &ty {
            Type::List(element) => element.is_figure() || **element == Type::Error,
            ty => ty.is_figure() || *ty == Type::Error,
        };
        if !fits {
            let is = self.described(&ty);
            let message = format!("a figure is needed, but this is {is}");
            let mut diagnostic = Diagnostic::new(Code::E0401, figure.value.span, message).label(is);
            diagnostic = match ty {
                Type::Ifs => match self.ifs_space(&body.value) {
                    Some(PointSpace::Plane | PointSpace::Space) => {
                        diagnostic.hint("say how deep it goes: `… at level 3`")
                    }
                    _ => diagnostic.hint("put the ifs on control points: `… on (p, q, …) at level 3`"),
                },
                _ => diagnostic.hint("a figure is an ifs on control points, or a list of such figures"),
            };
            self.report(diagnostic);
            return (ItemKind::Broken, Type::Error);
        }
        (ItemKind::Figure(body), ty)
    }

    fn function(&mut self, id: ItemId, module: usize, function: &ast::Function) -> (ItemKind, Type) {
        let parameters = self.fields(id, module, &function.parameters);
        let mut frame = Frame::new(module);
        let scope = self.declared[id.0 as usize].item.span;
        for (place, (field, parameter)) in function.parameters.iter().zip(&parameters).enumerate() {
            let kind = DeclarationKind::Field(id, place);
            self.declare(&mut frame, &field.name, parameter.ty.clone(), kind, scope);
        }
        let result = self.signature(id).result;
        let value = match &result {
            Some(expected) => self.expect(&mut frame, &function.body, expected),
            None => self.expr(&mut frame, &function.body, None),
        };
        let ty = result.unwrap_or_else(|| value.ty.clone());
        let body = Body { value, slots: frame.slots };
        (ItemKind::Function(Function { parameters, body }), ty)
    }

    /// Parameters or fields with their defaults checked.
    pub(super) fn fields(&mut self, id: ItemId, module: usize, fields: &[ast::Field]) -> Vec<Field> {
        let signature = self.signature(id);
        let mut checked = Vec::new();
        for (index, (field, parameter)) in fields.iter().zip(signature.parameters).enumerate() {
            if let Some(first) = fields[..index].iter().find(|other| other.name.text == field.name.text) {
                let message = format!("`{}` is declared twice", field.name.text);
                let diagnostic =
                    Diagnostic::new(Code::E0302, field.name.span, message).label("declared again here");
                self.report(diagnostic.also(first.name.span, "first declared here"));
            }
            self.note(&field.name, DeclarationKind::Field(id, index), parameter.ty.clone(), None);
            let default = field.default.as_ref().map(|value| self.body(module, value, Some(&parameter.ty)));
            checked.push(Field { name: parameter.name, ty: parameter.ty, default });
        }
        checked
    }

    /// What a function, record or ifs takes and gives.
    pub(super) fn signature(&mut self, id: ItemId) -> Signature {
        if let Some(signature) = self.signatures.get(&id) {
            return signature.clone();
        }
        let Some(declared) = self.declared.get(id.0 as usize) else {
            return Signature { parameters: Vec::new(), result: None };
        };
        let (module, item) = (declared.module, declared.item);
        let (fields, result): (&[ast::Field], Option<Type>) = match &item.kind {
            ast::ItemKind::Function(function) => {
                (&function.parameters, function.result.as_ref().map(|ty| self.type_expr(module, ty)))
            }
            ast::ItemKind::Record(record) => (&record.fields, Some(Type::Record(id))),
            ast::ItemKind::Ifs(ifs) => (&ifs.parameters, Some(Type::Ifs)),
            _ => (&[], None),
        };
        let parameters = fields.iter().map(|field| Parameter {
            name: field.name.text.clone(),
            ty: self.type_expr(module, &field.ty),
            required: field.default.is_none(),
        });
        let signature = Signature { parameters: parameters.collect(), result };
        self.signatures.insert(id, signature.clone());
        signature
    }
}
