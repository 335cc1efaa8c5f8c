//! Looking names up: locals, the file, its imports, the prelude, and at last the whole library.

use super::scope::Symbol;
use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic, did_you_mean};
use crate::hir::tree::{Expr, ExprKind, ItemId, ItemKind};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    /// What a name that is no local stands for. A name of the library that is not imported serves with a warning.
    pub(super) fn symbol(&mut self, module: usize, name: &str, span: Span) -> Option<Symbol> {
        if let Some(id) = self.modules[module].own.get(name) {
            return Some(Symbol::Item(*id));
        }
        if let Some(import) = self.modules[module].imports.get_mut(name) {
            import.used = true;
            return Some(import.symbol);
        }
        let (owner, symbol) = self.modules.iter().find_map(|scope| {
            let symbol = scope.public.get(name).filter(|_| !scope.name.is_empty())?;
            Some((scope.name, *symbol))
        })?;
        if owner != "prelude" && module == 0 {
            let file = self.module_file(module);
            let message = format!("`{name}` is used without being imported");
            let line = format!("use std.{owner} ({name})\n");
            let at = self.import_place(module);
            let diagnostic = Diagnostic::new(Code::W0308, span, message)
                .label(format!("found in `std.{owner}`"))
                .fix(format!("add `use std.{owner} ({name})`"), Span::new(file, at, at), line);
            self.report(diagnostic);
        }
        Some(symbol)
    }

    fn import_place(&self, module: usize) -> u32 {
        self.modules[module].ast.items.first().map_or(0, |item| item.span.start)
    }

    pub(super) fn name(&mut self, frame: &Frame, name: &str, span: Span) -> Expr {
        if let Some(local) = frame.locals.iter().rev().find(|local| local.name == name) {
            return Expr { kind: ExprKind::Local(local.id), ty: local.ty.clone(), span };
        }
        match self.symbol(frame.module, name, span) {
            Some(Symbol::Item(id)) => self.item_value(id, span),
            Some(Symbol::Native(native)) => {
                let declaration = native.declaration();
                let names: Vec<&str> =
                    declaration.parameters.iter().map(|parameter| parameter.name).collect();
                let message = format!("`{name}` is a function; it needs its arguments");
                let diagnostic = Diagnostic::new(Code::E0401, span, message).label("a function, not a value");
                self.report(diagnostic.hint(format!("write `{name}({})`", names.join(", "))));
                error_expr(span)
            }
            Some(Symbol::Later) => self.later(name, span),
            None => self.unknown(frame, name, span),
        }
    }

    pub(super) fn later(&mut self, name: &str, span: Span) -> Expr {
        let message = format!("`{name}` is not available yet");
        let diagnostic =
            Diagnostic::new(Code::E0001, span, message).label("part of the language, but still to come");
        self.report(diagnostic);
        error_expr(span)
    }

    pub(super) fn unknown(&mut self, frame: &Frame, name: &str, span: Span) -> Expr {
        let mut known: Vec<&str> = frame.locals.iter().map(|local| local.name.as_str()).collect();
        let scope = &self.modules[frame.module];
        known.extend(scope.own.keys().copied());
        known.extend(scope.imports.keys().copied());
        known.extend(self.modules.iter().flat_map(|other| other.public.keys().copied()));
        let mut diagnostic =
            Diagnostic::new(Code::E0301, span, format!("there is no `{name}`")).label("not known here");
        if let Some(candidate) = crate::diagnostic::closest(name, known.iter().copied()) {
            let candidate = candidate.to_owned();
            diagnostic = diagnostic.fix(format!("did you mean `{candidate}`?"), span, candidate);
        }
        self.report(diagnostic);
        error_expr(span)
    }

    fn item_value(&mut self, id: ItemId, span: Span) -> Expr {
        self.ensure_checked(id, span);
        let ty = self.types.get(&id).cloned().unwrap_or(Type::Error);
        match &self.declared[id.0 as usize].item.kind {
            ast::ItemKind::Ifs(_) => self.ifs_without_arguments(id, span),
            ast::ItemKind::Function(_) | ast::ItemKind::Record(_) => {
                let name = self.items[id.0 as usize].name.clone();
                let message = format!("`{name}` needs its arguments");
                let diagnostic = Diagnostic::new(Code::E0401, span, message).label("not a value by itself");
                self.report(diagnostic.hint(format!("write `{name}(…)`")));
                error_expr(span)
            }
            _ if matches!(self.items[id.0 as usize].kind, ItemKind::Broken) => error_expr(span),
            _ => Expr { kind: ExprKind::Global(id), ty, span },
        }
    }

    /// A measure, setting or word that is not one of a closed list.
    pub(super) fn unknown_word<'n>(
        &mut self,
        code: Code,
        name: &ast::Name,
        what: &str,
        known: impl Iterator<Item = &'n str> + Clone,
    ) {
        let message = format!("there is no {what} `{}`", name.text);
        let mut diagnostic = Diagnostic::new(code, name.span, message).label("not known here");
        diagnostic = match did_you_mean(&name.text, known.clone()) {
            Some(suggestion) => diagnostic.hint(suggestion),
            None => diagnostic.note(format!("there are {}", known.collect::<Vec<_>>().join(", "))),
        };
        self.report(diagnostic);
    }
}
