//! What the checker notes for the index of the design, where one is wanted: uses, declarations and types.

use super::scope::Symbol;
use super::{Checker, Frame};
use crate::hir::index::{Declaration, DeclarationKind, Reference, Target};
use crate::hir::tree::{ItemId, LocalId};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    /// The name at `span` stands for `target`.
    pub(super) fn refer(&mut self, span: Span, target: Target) {
        if let Some(index) = &mut self.index {
            index.references.push(Reference { span, target });
        }
    }

    pub(super) fn refer_symbol(&mut self, span: Span, symbol: Symbol) {
        match symbol {
            Symbol::Item(id) => self.refer(span, Target::Declared(self.items[id.0 as usize].name_span)),
            Symbol::Native(native) => self.refer(span, Target::Native(native)),
            Symbol::Lost => {}
        }
    }

    /// The name at `span` stands for a parameter or field of an item.
    pub(super) fn refer_field(&mut self, span: Span, id: ItemId, place: usize) {
        let fields: &[ast::Field] = match &self.declared[id.0 as usize].item.kind {
            ast::ItemKind::Function(function) => &function.parameters,
            ast::ItemKind::Record(record) => &record.fields,
            ast::ItemKind::Ifs(ifs) => &ifs.parameters,
            _ => &[],
        };
        if let Some(field) = fields.get(place) {
            self.refer(span, Target::Declared(field.name.span));
        }
    }

    /// Something is declared by a name.
    pub(super) fn note(&mut self, name: &ast::Name, kind: DeclarationKind, ty: Type, scope: Option<Span>) {
        if let Some(index) = &mut self.index {
            index.declarations.push(Declaration {
                name: name.text.clone(),
                span: name.span,
                kind,
                ty,
                scope,
            });
        }
    }

    /// Declares a local name that can be used in `scope`.
    pub(super) fn declare(
        &mut self,
        frame: &mut Frame,
        name: &ast::Name,
        ty: Type,
        kind: DeclarationKind,
        scope: Span,
    ) -> LocalId {
        self.note(name, kind, ty.clone(), Some(scope));
        frame.declare(name, ty)
    }

    /// The type of an expression.
    pub(super) fn note_type(&mut self, span: Span, ty: &Type) {
        if let Some(index) = &mut self.index
            && *ty != Type::Error
        {
            index.types.push((span, ty.clone()));
        }
    }
}
