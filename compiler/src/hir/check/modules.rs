//! What a `use` leads to: the module, and what it offers by a name.

use super::Checker;
use super::scope::{ModuleScope, Symbol};
use crate::diagnostic::{Code, Diagnostic, closest};
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    /// The module that a `use` of `module` names; `None` after a report, here or where the file was looked for.
    pub(super) fn find_module(&mut self, module: usize, path: &ast::ModulePath) -> Option<usize> {
        let names = match path {
            ast::ModulePath::Library(names) => names,
            ast::ModulePath::File(text) => {
                let uses = self.modules[module].uses;
                let (_, file) = uses.iter().find(|(span, _)| *span == text.span)?;
                return self.modules.iter().position(|scope| scope.file == *file);
            }
        };
        let dotted: Vec<&str> = names.iter().map(|name| name.text.as_str()).collect();
        let importable = |scope: &&ModuleScope<'_>| scope.is_library() && scope.name != "prelude";
        if let ["std", module] = dotted.as_slice()
            && let Some(found) =
                self.modules.iter().position(|scope| importable(&scope) && scope.name == *module)
        {
            return Some(found);
        }
        let known: Vec<String> = self.modules.iter().filter(importable).map(ModuleScope::title).collect();
        let written = dotted.join(".");
        let message = format!("there is no module `{written}`");
        let mut diagnostic = Diagnostic::new(Code::E0303, path.span(), message).label("not a module");
        diagnostic = match closest(&written, known.iter().map(String::as_str)) {
            Some(candidate) => diagnostic.fix(format!("did you mean `{candidate}`?"), path.span(), candidate),
            None => diagnostic.note(format!("the modules of the library are {}", known.join(", "))),
        };
        self.report(diagnostic);
        None
    }

    /// What a module offers by a name; `None` after a report.
    pub(super) fn exported(&mut self, from: usize, name: &ast::Name) -> Option<Symbol> {
        let scope = &self.modules[from];
        if let Some(symbol) = scope.public.get(name.text.as_str()) {
            return Some(*symbol);
        }
        let own = scope.own.get(name.text.as_str()).copied();
        match own {
            Some(id) if !scope.is_library() => {
                let declared = self.items[id.0 as usize].name_span;
                let item = self.declared[id.0 as usize].item.span;
                let title = scope.title();
                let message = format!("`{}` of `{title}` is not public", name.text);
                let diagnostic = Diagnostic::new(Code::E0304, name.span, message)
                    .label("cannot be used here")
                    .also(declared, "only for its own file")
                    .fix(
                        format!("write `pub` before it in `{title}`"),
                        Span::new(item.file, item.start, item.start),
                        "pub ",
                    );
                self.report(diagnostic);
                // What it is, is known: nothing else is wrong with its uses.
                Some(Symbol::Item(id))
            }
            // It may stand in what could not be understood.
            None if !scope.complete => None,
            _ => {
                self.no_such_export(from, name);
                None
            }
        }
    }

    fn no_such_export(&mut self, from: usize, name: &ast::Name) {
        let scope = &self.modules[from];
        let title = scope.title();
        let message = if scope.own.contains_key(name.text.as_str()) {
            format!("`{}` of `{title}` is not public", name.text)
        } else {
            format!("`{title}` has no `{}`", name.text)
        };
        let mut diagnostic = Diagnostic::new(Code::E0304, name.span, message).label("not there");
        let has =
            |other: &&ModuleScope<'_>| other.is_library() && other.public.contains_key(name.text.as_str());
        if let Some(other) = self.modules.iter().find(has) {
            diagnostic = match other.name {
                "prelude" => {
                    diagnostic.hint(format!("`{}` is known everywhere: it needs no import", name.text))
                }
                module => diagnostic.hint(format!("`{}` is in `std.{module}`", name.text)),
            };
        } else if let Some(candidate) = closest(&name.text, scope.public.keys().copied()) {
            diagnostic = diagnostic.fix(format!("did you mean `{candidate}`?"), name.span, candidate);
        } else if scope.public.is_empty() {
            diagnostic = diagnostic.note(format!("`{title}` offers nothing: none of its items is `pub`"));
        } else {
            let names: Vec<&str> = scope.public.keys().copied().collect();
            diagnostic = diagnostic.note(format!("it has {}", names.join(", ")));
        }
        self.report(diagnostic);
    }
}
