//! What the checker notes for the index of the design, where one is wanted: uses, declarations and types.

use super::scope::Symbol;
use super::{Checker, Frame};
use crate::hir::index::{
    Declaration, DeclarationKind, Index, Known, ModuleNames, Parameter, Reference, Target,
};
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

    /// The type that the place of an expression would like.
    pub(super) fn note_expected(&mut self, span: Span, expected: Option<&Type>) {
        if let (Some(index), Some(expected)) = (&mut self.index, expected)
            && *expected != Type::Error
        {
            index.expected.push((span, expected.clone()));
        }
    }

    /// What the names of each file stand for, noted when everything is checked.
    pub(super) fn note_modules(&mut self) {
        if self.index.is_none() {
            return;
        }
        let modules: Vec<ModuleNames> =
            (0..self.modules.len()).map(|module| self.module_names(module)).collect();
        let records = (0..self.items.len() as u32).map(ItemId);
        let records: Vec<ItemId> = records
            .filter(|id| matches!(self.declared[id.0 as usize].item.kind, ast::ItemKind::Record(_)))
            .collect();
        let materials = records.into_iter().filter(|id| self.is_material(&Type::Record(*id))).collect();
        if let Some(index) = &mut self.index {
            *index = Index { modules, materials, ..std::mem::take(index) };
        }
    }

    fn module_names(&mut self, module: usize) -> ModuleNames {
        let scope = &self.modules[module];
        let own: Vec<(String, Symbol)> =
            scope.own.iter().map(|(name, id)| ((*name).to_owned(), Symbol::Item(*id))).collect();
        let public: Vec<(String, Symbol)> =
            scope.public.iter().map(|(name, symbol)| ((*name).to_owned(), *symbol)).collect();
        let imported: Vec<(String, Symbol)> =
            scope.imports.iter().map(|(name, import)| ((*name).to_owned(), import.symbol)).collect();
        let (file, title, library) = (scope.file, scope.title(), scope.is_library());
        let mut known = |names: Vec<(String, Symbol)>| {
            names.into_iter().filter_map(|(name, symbol)| self.known(name, symbol)).collect()
        };
        let (own, public, imported) = (known(own), known(public), known(imported));
        ModuleNames { file, title, library, own, public, imported }
    }

    fn known(&mut self, name: String, symbol: Symbol) -> Option<Known> {
        let id = match symbol {
            Symbol::Item(id) => id,
            Symbol::Native(native) => {
                let target = Target::Native(native);
                return Some(Known { name, target, ty: Type::Error, parameters: None, space: None });
            }
            Symbol::Lost => return None,
        };
        let declared = self.items[id.0 as usize].name_span;
        let fields: Option<&[ast::Field]> = match &self.declared[id.0 as usize].item.kind {
            ast::ItemKind::Function(function) => Some(&function.parameters),
            ast::ItemKind::Record(record) => Some(&record.fields),
            ast::ItemKind::Ifs(ifs) => Some(&ifs.parameters),
            _ => None,
        };
        let (ty, parameters) = match fields {
            Some(fields) => {
                let signature = self.signature(id);
                let checked = self.types.get(&id).cloned().unwrap_or(Type::Error);
                let parameters =
                    fields.iter().zip(signature.parameters).map(|(field, parameter)| Parameter {
                        name: parameter.name,
                        ty: parameter.ty,
                        required: parameter.required,
                        span: field.name.span,
                        default: field.default.as_ref().map(|value| value.span),
                    });
                (signature.result.unwrap_or(checked), Some(parameters.collect()))
            }
            None => {
                self.ensure_checked(id, declared);
                (self.types.get(&id).cloned().unwrap_or(Type::Error), None)
            }
        };
        let space = self.space_of(id);
        Some(Known { name, target: Target::Declared(declared), ty, parameters, space })
    }
}
