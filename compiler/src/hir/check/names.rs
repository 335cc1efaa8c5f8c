//! Looking names up: locals, the file, its imports, the prelude, and at last the whole library.

use super::scope::Symbol;
use super::{Checker, Frame, error_expr};
use crate::diagnostic::{Code, Diagnostic, Fix, closest};
use crate::hir::index::Target;
use crate::hir::tree::{Expr, ExprKind, ItemId, ItemKind};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;

/// How many candidates are compared with unknown names, over a whole design.
const MOST_COMPARISONS: usize = 200_000;

impl Checker<'_> {
    /// What a name that is no local stands for. A name of the library that is not imported serves with a warning.
    pub(super) fn symbol(&mut self, module: usize, name: &str, span: Span) -> Option<Symbol> {
        let symbol = self.found(module, name, span);
        if let Some(symbol) = symbol {
            self.refer_symbol(span, symbol);
        }
        symbol
    }

    fn found(&mut self, module: usize, name: &str, span: Span) -> Option<Symbol> {
        if let Some(id) = self.modules[module].own.get(name) {
            return Some(Symbol::Item(*id));
        }
        if let Some(import) = self.modules[module].imports.get_mut(name) {
            import.used = true;
            return Some(import.symbol);
        }
        let (owner, symbol) = self.modules.iter().find_map(|scope| {
            let symbol = scope.public.get(name).filter(|_| scope.is_library())?;
            Some((scope.name, *symbol))
        })?;
        if owner != "prelude"
            && !self.modules[module].is_library()
            && !self.modules[module].broken_use
            && self.not_imported.insert((module, name.to_owned()))
        {
            let message = format!("`{name}` is used without being imported");
            let diagnostic =
                Diagnostic::new(Code::W0308, span, message).label(format!("found in `std.{owner}`"));
            let hint = format!("add `use std.{owner} ({name})`");
            let (at, text) = self.to_import(module, &format!("std.{owner}"), name);
            let import = Fix::titled(hint.clone()).with(at, text);
            self.report(diagnostic.ways(hint, vec![import]));
        }
        Some(symbol)
    }

    /// The change by which a module knows a name of another.
    pub(super) fn to_import(&self, module: usize, from: &str, name: &str) -> (Span, String) {
        let (at, text) = self.modules[module].ast.to_import(from, name);
        (Span::new(self.module_file(module), at, at), text)
    }

    pub(super) fn name(&mut self, frame: &Frame, name: &str, span: Span) -> Expr {
        if let Some(local) = frame.locals.iter().rev().find(|local| local.name == name) {
            self.refer(span, Target::Declared(local.span));
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
            Some(Symbol::Lost) => error_expr(span),
            None => match self.own_germ(frame, name, span) {
                Some(germ) => germ,
                None => self.unknown(frame, name, span, "let"),
            },
        }
    }

    /// `keyword` is what would declare it: `let`, `fn`, `figure`.
    pub(super) fn unknown(&mut self, frame: &Frame, name: &str, span: Span, keyword: &str) -> Expr {
        let mut diagnostic =
            Diagnostic::new(Code::E0301, span, format!("there is no `{name}`")).label("not known here");
        if let Some(candidate) = self.nearest_value(frame, name) {
            // What was meant is not unused.
            if let Some(import) = self.modules[frame.module].imports.get_mut(candidate.as_str()) {
                import.used = true;
            }
            diagnostic = diagnostic.fix(format!("did you mean `{candidate}`?"), span, candidate);
        } else if name.contains(|c: char| c.is_ascii_uppercase()) {
            diagnostic = diagnostic.hint("names of values are written in small letters");
        } else {
            let arguments = if keyword == "fn" { "(…)" } else { "" };
            diagnostic = diagnostic.hint(format!("declare it: `{keyword} {name}{arguments} = …`"));
        }
        self.report(diagnostic);
        error_expr(span)
    }

    /// The known value whose name is nearest, as long as looking for it is not too much work: in a design with
    /// thousands of unknown names the last ones go without.
    fn nearest_value(&mut self, frame: &Frame, name: &str) -> Option<String> {
        let scope = &self.modules[frame.module];
        self.comparisons = self.comparisons.saturating_add(scope.own.len() + frame.locals.len());
        if self.comparisons > MOST_COMPARISONS {
            return None;
        }
        let mut known: Vec<&str> = frame.locals.iter().map(|local| local.name.as_str()).collect();
        known.extend(frame.own_ifs.map(|_| "self"));
        known.extend(scope.own.keys().copied());
        known.extend(scope.imports.keys().copied());
        let library = self.modules.iter().filter(|other| other.is_library());
        known.extend(library.flat_map(|other| other.public.keys().copied()));
        closest(name, known).map(str::to_owned)
    }

    fn item_value(&mut self, id: ItemId, span: Span) -> Expr {
        self.ensure_checked(id, span);
        let ty = self.types.get(&id).cloned().unwrap_or(Type::Error);
        match &self.declared[id.0 as usize].item.kind {
            ast::ItemKind::Ifs(_) if self.is_broken(id) => error_expr(span),
            ast::ItemKind::Ifs(_) => self.ifs_without_arguments(id, span),
            ast::ItemKind::Function(_) | ast::ItemKind::Record(_) => {
                let name = self.items[id.0 as usize].name.clone();
                let message = format!("`{name}` needs its arguments");
                let diagnostic = Diagnostic::new(Code::E0401, span, message).label("not a value by itself");
                let parameters = self.signature(id).parameters;
                let needed = parameters.iter().filter(|parameter| parameter.required);
                let needed: Vec<&str> = needed.map(|parameter| parameter.name.as_str()).collect();
                self.report(diagnostic.hint(format!("write `{name}({})`", needed.join(", "))));
                error_expr(span)
            }
            _ if self.is_broken(id) => error_expr(span),
            _ => Expr { kind: ExprKind::Global(id), ty, span },
        }
    }

    /// Whether an item has been checked and nothing is left of it.
    pub(super) fn is_broken(&self, id: ItemId) -> bool {
        let done = self.declared[id.0 as usize].state == super::State::Done;
        done && matches!(self.items[id.0 as usize].kind, ItemKind::Broken)
    }

    /// A field, setting or word that is not one of a closed list.
    pub(super) fn unknown_word<'n>(
        &mut self,
        code: Code,
        name: &ast::Name,
        message: String,
        known: impl Iterator<Item = &'n str> + Clone,
    ) {
        self.report(not_among(code, name, message, known));
    }
}

/// What is said of a name that is not one of a closed list.
pub(super) fn not_among<'n>(
    code: Code,
    name: &ast::Name,
    message: String,
    known: impl Iterator<Item = &'n str> + Clone,
) -> Diagnostic {
    let mut diagnostic = Diagnostic::new(code, name.span, message).label("not known here");
    if let Some(candidate) = closest(&name.text, known.clone()) {
        diagnostic = diagnostic.fix(format!("did you mean `{candidate}`?"), name.span, candidate);
    }
    let words: Vec<String> = known.map(|word| format!("`{word}`")).collect();
    match words.as_slice() {
        [] => diagnostic,
        [only] => diagnostic.note(format!("there is only {only}")),
        [rest @ .., last] => diagnostic.note(format!("it can be {} or {last}", rest.join(", "))),
    }
}
