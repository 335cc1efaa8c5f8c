//! The checker: resolves names and gives every expression its type. Items are checked when first needed, so their
//! order in the file does not matter; a definition that needs itself is an error.

mod boundary;
mod call;
mod collection;
mod convert;
mod expression;
mod fabricate;
mod fields;
mod germ;
mod ifs;
mod import;
mod items;
mod map;
mod modules;
mod names;
mod native;
mod native_values;
mod operator;
mod placement;
mod points;
mod record;
mod records;
mod scope;
mod test;
mod transform;
mod type_expr;
mod units;
mod until;

use super::index::Index;
use super::tree::{Expr, ExprKind, Fabricate, Hir, Item, ItemId, ItemKind, LocalId, Test};
use super::types::Type;
use super::value::Germ;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::source::{FileId, Span};
use crate::syntax::ast;
use scope::ModuleScope;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
pub use units::placeholder as value_to_begin_with;

/// A parsed file on its way to the checker.
#[derive(Clone, Copy, Debug)]
pub struct ModuleSource<'a> {
    /// The name after `std.`; empty for the files of the project.
    pub name: &'a str,
    /// The path from the root of the project; empty for the library.
    pub path: &'a str,
    /// Its file.
    pub file: FileId,
    /// Its tree.
    pub ast: &'a ast::File,
    /// Where it names files it uses, and which: those that could be read.
    pub uses: &'a [(Span, FileId)],
    /// Where it names meshes, and what they are.
    pub imports: &'a [(Span, ImportedMesh)],
    /// Whether all of its text is in the tree.
    pub complete: bool,
}

/// A mesh that a file names: a germ of triangles in space, or why it is none.
pub type ImportedMesh = Result<Arc<Germ>, Box<Diagnostic>>;

/// What checking gives.
#[derive(Debug)]
pub struct Checked {
    /// The typed tree.
    pub hir: Hir,
    /// What was found.
    pub diagnostics: Vec<Diagnostic>,
    /// The index; empty unless it was asked for.
    pub index: Index,
}

/// Checks a design, the first of the modules, with the files it uses, against the library.
pub fn check(modules: &[ModuleSource<'_>]) -> Checked {
    let mut checker = Checker::new(modules, None);
    checker.check_root();
    checker.finish()
}

/// The same, with the index of names and types that editors need.
pub fn check_indexed(modules: &[ModuleSource<'_>]) -> Checked {
    let mut checker = Checker::new(modules, Some(Index::default()));
    checker.check_root();
    checker.finish()
}

/// The index of one item of a file, checked in place of the one that begins where it does and declares the same name, with
/// whatever it needs of the others; where it is a block or a test, those of the design. `None` where there is no such item.
pub fn check_in_place(modules: &[ModuleSource<'_>], file: FileId, item: &ast::Item) -> Option<Index> {
    let mut checker = Checker::new(modules, Some(Index::default()));
    let module = checker.modules.iter().position(|module| module.file == file)?;
    match (&item.kind, scope::item_name(item)) {
        (_, Some(name)) => {
            let id = *checker.modules[module].own.get(name.text.as_str())?;
            let declared = &mut checker.declared[id.0 as usize];
            let same = scope::item_name(declared.item).is_some_and(|before| before.span == name.span);
            if !same || declared.item.span.start != item.span.start {
                return None;
            }
            declared.item = item;
            checker.ensure_checked(id, name.span);
        }
        (ast::ItemKind::Fabricate(block), None) if module == 0 => checker.fabricate(block),
        (ast::ItemKind::Test(test), None) if module == 0 => checker.test(test),
        _ => return None,
    }
    let mut index = checker.index?;
    index.sort();
    Some(index)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Unchecked,
    InProgress,
    Done,
}

struct Declared<'a> {
    module: usize,
    item: &'a ast::Item,
    state: State,
}

struct Checker<'a> {
    modules: Vec<ModuleScope<'a>>,
    declared: Vec<Declared<'a>>,
    items: Vec<Item>,
    types: BTreeMap<ItemId, Type>,
    signatures: BTreeMap<ItemId, items::Signature>,
    fabricates: Vec<Fabricate>,
    tests: Vec<Test>,
    /// Names of the library used without import, each said once a file.
    not_imported: BTreeSet<(usize, String)>,
    diagnostics: Diagnostics,
    /// Candidates compared with unknown names so far.
    comparisons: usize,
    /// Filled where an index is wanted.
    index: Option<Index>,
}

/// The local names around an expression.
struct Frame {
    module: usize,
    locals: Vec<Local>,
    slots: u32,
    own_ifs: Option<ItemId>,
    /// Whether it is that of a test.
    test: bool,
}

struct Local {
    name: String,
    id: LocalId,
    ty: Type,
    span: Span,
}

impl Frame {
    fn new(module: usize) -> Self {
        Frame { module, locals: Vec::new(), slots: 0, own_ifs: None, test: false }
    }

    fn declare(&mut self, name: &ast::Name, ty: Type) -> LocalId {
        let id = LocalId(self.slots);
        self.slots += 1;
        self.locals.push(Local { name: name.text.clone(), id, ty, span: name.span });
        id
    }
}

impl<'a> Checker<'a> {
    fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    fn module_file(&self, module: usize) -> FileId {
        self.modules[module].file
    }

    fn finish(mut self) -> Checked {
        self.note_modules();
        let root = self.modules.first().map_or(FileId(0), |module| module.file);
        let library = self.modules.iter().filter(|module| module.is_library());
        let library = library.map(|module| module.file).collect();
        let hir = Hir {
            items: self.items,
            fabricates: self.fabricates,
            tests: self.tests,
            root,
            library,
            machine_file: None,
        };
        let mut index = self.index.unwrap_or_default();
        index.sort();
        Checked { hir, diagnostics: self.diagnostics.finish(), index }
    }
}

fn error_expr(span: Span) -> Expr {
    Expr { kind: ExprKind::Error, ty: Type::Error, span }
}

fn broken(name: &ast::Name, docs: &[String]) -> Item {
    Item { name: name.text.clone(), name_span: name.span, docs: docs.to_vec(), kind: ItemKind::Broken }
}
