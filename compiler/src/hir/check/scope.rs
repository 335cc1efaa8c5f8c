//! Modules and what they declare and import.

use super::{Checker, Declared, ImportedMesh, ModuleSource, State, broken};
use crate::diagnostic::{Code, Diagnostic, Diagnostics};
use crate::hir::index::{DeclarationKind, Index, Target};
use crate::hir::native::{Native, natives};
use crate::hir::tree::ItemId;
use crate::hir::types::Type;
use crate::source::{FileId, Span};
use crate::syntax::ast;
use std::collections::{BTreeMap, BTreeSet};

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Symbol {
    /// An item of some module.
    Item(ItemId),
    /// A function of the program.
    Native(Native),
    /// A name whose import failed; that has been said.
    Lost,
}

pub(super) struct Import {
    pub(super) symbol: Symbol,
    pub(super) span: Span,
    pub(super) used: bool,
}

pub(super) struct ModuleScope<'a> {
    pub(super) name: &'a str,
    pub(super) path: &'a str,
    pub(super) file: FileId,
    pub(super) ast: &'a ast::File,
    pub(super) uses: &'a [(Span, FileId)],
    pub(super) meshes: &'a [(Span, ImportedMesh)],
    pub(super) complete: bool,
    pub(super) own: BTreeMap<&'a str, ItemId>,
    pub(super) public: BTreeMap<&'a str, Symbol>,
    pub(super) imports: BTreeMap<&'a str, Import>,
    /// Whether a `use` names nothing, so that any name of the library may have been meant.
    pub(super) broken_use: bool,
}

impl ModuleScope<'_> {
    pub(super) fn is_library(&self) -> bool {
        !self.name.is_empty()
    }

    /// As messages call it: `std.curves`, `parts/ribs.ifs`.
    pub(super) fn title(&self) -> String {
        if self.is_library() { format!("std.{}", self.name) } else { self.path.to_owned() }
    }
}

pub(super) fn item_name(item: &ast::Item) -> Option<&ast::Name> {
    match &item.kind {
        ast::ItemKind::Param(param) => Some(&param.name),
        ast::ItemKind::Let(value) => Some(&value.name),
        ast::ItemKind::Function(function) => Some(&function.name),
        ast::ItemKind::Record(record) => Some(&record.name),
        ast::ItemKind::Ifs(ifs) => Some(&ifs.name),
        ast::ItemKind::Figure(figure) => Some(&figure.name),
        ast::ItemKind::Use(_)
        | ast::ItemKind::Fabricate(_)
        | ast::ItemKind::Test(_)
        | ast::ItemKind::Error => None,
    }
}

impl<'a> Checker<'a> {
    pub(super) fn new(sources: &[ModuleSource<'a>], index: Option<Index>) -> Self {
        let mut checker = Checker {
            modules: Vec::new(),
            declared: Vec::new(),
            items: Vec::new(),
            types: BTreeMap::new(),
            signatures: BTreeMap::new(),
            fabricates: Vec::new(),
            tests: Vec::new(),
            not_imported: BTreeSet::new(),
            diagnostics: Diagnostics::default(),
            comparisons: 0,
            index,
        };
        for source in sources {
            checker.declare_module(*source);
        }
        for module in 0..checker.modules.len() {
            checker.import(module);
        }
        checker
    }

    fn declare_module(&mut self, source: ModuleSource<'a>) {
        let module = self.modules.len();
        let mut scope = ModuleScope {
            name: source.name,
            path: source.path,
            file: source.file,
            ast: source.ast,
            uses: source.uses,
            meshes: source.imports,
            complete: source.complete,
            own: BTreeMap::new(),
            public: BTreeMap::new(),
            imports: BTreeMap::new(),
            broken_use: false,
        };
        if scope.is_library() {
            for native in natives().filter(|native| native.module == source.name) {
                scope.public.insert(native.name, Symbol::Native(native.native));
            }
        }
        for item in &source.ast.items {
            let Some(name) = item_name(item) else { continue };
            if let Some(first) = scope.own.get(name.text.as_str()) {
                let first = self.items[first.0 as usize].name_span;
                let message = format!("`{}` is declared twice", name.text);
                let diagnostic =
                    Diagnostic::new(Code::E0302, name.span, message).label("declared again here");
                let diagnostic =
                    diagnostic.also(first, "first declared here").hint("give one of them another name");
                self.report(diagnostic);
                continue;
            }
            let id = ItemId(self.items.len() as u32);
            self.items.push(broken(name, &item.docs));
            self.declared.push(Declared { module, item, state: State::Unchecked });
            self.note(name, DeclarationKind::Item(id), Type::Error, None);
            scope.own.insert(&name.text, id);
            if item.public.is_some() {
                scope.public.insert(&name.text, Symbol::Item(id));
            }
        }
        self.modules.push(scope);
    }

    fn import(&mut self, module: usize) {
        let ast = self.modules[module].ast;
        for item in &ast.items {
            let ast::ItemKind::Use(import) = &item.kind else { continue };
            let Some(from) = self.find_module(module, &import.module) else {
                self.modules[module].broken_use |= import.names.is_empty();
                let library = matches!(import.module, ast::ModulePath::Library(_));
                for name in &import.names {
                    self.lost(module, name, library);
                }
                continue;
            };
            self.refer(import.module.span(), Target::Module(self.modules[from].file));
            for name in &import.names {
                self.import_name(module, from, name);
            }
        }
    }

    /// A name that could not be imported from the library stands for what the library has by this name, else for
    /// nothing; either way it is not missed again where it is used.
    fn lost(&mut self, module: usize, name: &'a ast::Name, library: bool) {
        let found = self.modules.iter().find_map(|scope| match scope.public.get(name.text.as_str()) {
            Some(symbol) if library && scope.is_library() => Some(*symbol),
            _ => None,
        });
        let import = Import { symbol: found.unwrap_or(Symbol::Lost), span: name.span, used: true };
        self.modules[module].imports.entry(&name.text).or_insert(import);
    }

    fn import_name(&mut self, module: usize, from: usize, name: &'a ast::Name) {
        let Some(symbol) = self.exported(from, name) else {
            let library = self.modules[from].is_library();
            self.lost(module, name, library);
            return;
        };
        self.refer_symbol(name.span, symbol);
        let scope = &self.modules[module];
        let earlier = scope.imports.get(name.text.as_str()).map(|import| import.span);
        let own = scope.own.get(name.text.as_str()).map(|id| self.items[id.0 as usize].name_span);
        if let Some(other) = earlier.or(own) {
            let (message, label, hint) = match earlier {
                Some(_) => ("is imported twice", "first imported here", "remove one of them"),
                None => {
                    let hint = "remove the import, or give the one declared here another name";
                    ("is both imported and declared", "declared here", hint)
                }
            };
            let message = format!("`{}` {message}", name.text);
            let diagnostic = Diagnostic::new(Code::E0302, name.span, message).label("imported here");
            self.report(diagnostic.also(other, label).hint(hint));
            return;
        }
        let import = Import { symbol, span: name.span, used: false };
        self.modules[module].imports.insert(&name.text, import);
    }

    /// Warns of imports of the project that nothing uses. Where there are errors nothing is said: what uses them may
    /// stand in what could not be understood.
    pub(super) fn warn_unused_imports(&mut self) {
        if self.diagnostics.has_errors() {
            return;
        }
        let own = self.modules.iter().filter(|scope| !scope.is_library());
        let unused: Vec<(String, Span)> = own
            .flat_map(|scope| &scope.imports)
            .filter(|(_, import)| !import.used)
            .map(|(name, import)| ((*name).to_owned(), import.span))
            .collect();
        for (name, span) in unused {
            let message = format!("`{name}` is imported but never used");
            self.report(Diagnostic::new(Code::W0307, span, message).label("not used").hint("remove it"));
        }
    }
}
