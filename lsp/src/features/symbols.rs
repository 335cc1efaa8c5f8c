//! The outline of a file: its items with their parameters, transforms, boundaries and requirements.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast;

/// What kind of thing a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SymbolKind {
    Parameter,
    Value,
    Function,
    Record,
    Field,
    Ifs,
    Transform,
    Boundary,
    Point,
    Figure,
    Fabrication,
    Setting,
    Requirement,
    Test,
}

/// A named part of a file.
#[derive(Clone, Debug)]
pub(crate) struct Symbol {
    pub(crate) name: String,
    pub(crate) detail: String,
    pub(crate) kind: SymbolKind,
    /// All of it.
    pub(crate) span: Span,
    /// Its name.
    pub(crate) name_span: Span,
    pub(crate) parts: Vec<Symbol>,
}

impl Symbol {
    fn new(name: &ast::Name, kind: SymbolKind, span: Span) -> Symbol {
        let whole = if span.start <= name.span.start && name.span.end <= span.end { span } else { name.span };
        Symbol {
            name: name.text.clone(),
            detail: String::new(),
            kind,
            span: whole,
            name_span: name.span,
            parts: Vec::new(),
        }
    }

    fn with(mut self, parts: impl Iterator<Item = Symbol>) -> Symbol {
        self.parts = parts.collect();
        self
    }
}

/// The outline of a tree, in the order of the text.
pub(crate) fn symbols(file: &ast::File) -> Vec<Symbol> {
    file.items.iter().filter_map(item).collect()
}

/// Says beside each name that has none yet what type it has, where that is known.
pub(crate) fn tell_types(analysis: &Analysis, symbols: &mut [Symbol]) {
    for symbol in symbols {
        let declared = analysis.index.declaration(symbol.name_span);
        if let Some(declared) = declared.filter(|found| symbol.detail.is_empty() && found.ty != Type::Error) {
            symbol.detail = type_name(&analysis.hir.items, &declared.ty);
        }
        tell_types(analysis, &mut symbol.parts);
    }
}

fn item(item: &ast::Item) -> Option<Symbol> {
    let new = |name, kind| Symbol::new(name, kind, item.span);
    Some(match &item.kind {
        ast::ItemKind::Param(param) => new(&param.name, SymbolKind::Parameter),
        ast::ItemKind::Let(value) => new(&value.name, SymbolKind::Value),
        ast::ItemKind::Function(function) => new(&function.name, SymbolKind::Function)
            .with(fields(&function.parameters, SymbolKind::Parameter)),
        ast::ItemKind::Record(record) => {
            new(&record.name, SymbolKind::Record).with(fields(&record.fields, SymbolKind::Field))
        }
        ast::ItemKind::Ifs(ifs) => {
            let parts = fields(&ifs.parameters, SymbolKind::Parameter);
            new(&ifs.name, SymbolKind::Ifs).with(parts.chain(ifs.members.iter().filter_map(member)))
        }
        ast::ItemKind::Figure(figure) => new(&figure.name, SymbolKind::Figure),
        ast::ItemKind::Fabricate(block) => fabrication(block, item.span),
        ast::ItemKind::Test(test) => {
            let name = ast::Name { text: test.name.value.clone(), span: test.name.span };
            new(&name, SymbolKind::Test)
        }
        ast::ItemKind::Use(_) | ast::ItemKind::Error => return None,
    })
}

fn fields(fields: &[ast::Field], kind: SymbolKind) -> impl Iterator<Item = Symbol> + '_ {
    fields.iter().map(move |field| Symbol::new(&field.name, kind, field.name.span.to(field.ty.span)))
}

fn member(member: &ast::Member) -> Option<Symbol> {
    let (name, kind) = match &member.kind {
        ast::MemberKind::Let(value) => (&value.name, SymbolKind::Point),
        ast::MemberKind::Transform(transform) => (&transform.name, SymbolKind::Transform),
        ast::MemberKind::Boundary(name, _) => (name, SymbolKind::Boundary),
        _ => return None,
    };
    Some(Symbol::new(name, kind, member.span))
}

fn fabrication(block: &ast::Fabricate, span: Span) -> Symbol {
    let entries = block.entries.iter().filter_map(|entry| match &entry.kind {
        ast::EntryKind::Setting(name, _) => Some(Symbol::new(name, SymbolKind::Setting, entry.span)),
        ast::EntryKind::Require(requirement) => {
            let mut symbol = Symbol::new(&requirement.measure, SymbolKind::Requirement, entry.span);
            symbol.name = format!("require {}", requirement.measure.text);
            Some(symbol)
        }
        ast::EntryKind::Error => None,
    });
    let mut symbol = Symbol::new(&block.figure, SymbolKind::Fabrication, span);
    symbol.name = format!("fabricate {}", block.figure.text);
    symbol.detail = format!("as {}", block.kind.text);
    symbol.with(entries)
}
