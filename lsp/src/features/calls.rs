//! Which functions and ifs a thing is made of: what continues in what, and what calls what.

use std::collections::BTreeMap;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::{DeclarationKind, Target};
use ifs_compiler::hir::tree::ItemKind;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::ast;

use super::symbols::{Symbol, symbols};

/// The function, ifs or figure that is named at a place: where its name is declared.
pub(crate) fn called_at(analysis: &Analysis, file: FileId, offset: u32) -> Option<Span> {
    let Target::Declared(span) = analysis.index.name_at(file, offset)?.target else { return None };
    (goes_on(analysis, span) || is_figure(analysis, span)).then_some(span)
}

/// Whether an item is a figure: it goes on with others, and none goes on with it.
fn is_figure(analysis: &Analysis, name: Span) -> bool {
    matches!(analysis.index.declaration(name).map(|found| found.kind), Some(DeclarationKind::Item(id))
        if matches!(analysis.hir.item(id).kind, ItemKind::Figure(_)))
}

/// Whether an item is one that others go on with: a function or an ifs.
fn goes_on(analysis: &Analysis, name: Span) -> bool {
    let own = analysis.index.module(name.file).into_iter().flat_map(|module| &module.own);
    own.into_iter().any(|known| known.target == Target::Declared(name) && known.parameters.is_some())
}

/// The item of a file that a place is in, as its outline has it.
pub(crate) fn item_around(analysis: &Analysis, place: Span) -> Option<Symbol> {
    let tree = tree(analysis, place.file)?;
    let around = |symbol: &Symbol| symbol.span.start <= place.start && place.end <= symbol.span.end;
    symbols(&tree).into_iter().find(around)
}

/// The tree of a file of the project, or of the library.
fn tree(analysis: &Analysis, file: FileId) -> Option<ast::File> {
    match analysis.files.iter().find(|parsed| parsed.file == file) {
        Some(parsed) => Some(parsed.parse.ast.clone()),
        None => analysis.sources.get(file).map(|source| ifs_compiler::syntax::parse(source).ast),
    }
}

/// The functions and ifs that are used in an item, by where they are declared, with every place.
pub(crate) fn outgoing(analysis: &Analysis, name: Span) -> BTreeMap<Span, Vec<Span>> {
    let mut found: BTreeMap<Span, Vec<Span>> = BTreeMap::new();
    let Some(item) = item_around(analysis, name) else { return found };
    for used in &analysis.index.references {
        let inside = used.span.file == name.file
            && item.span.start <= used.span.start
            && used.span.end <= item.span.end;
        if let Target::Declared(declared) = used.target
            && inside
            && goes_on(analysis, declared)
        {
            found.entry(declared).or_default().push(used.span);
        }
    }
    found
}

/// The items that use a function or an ifs, by where their names stand, with every place. An import is no use.
pub(crate) fn incoming(analysis: &Analysis, name: Span) -> BTreeMap<Span, (Symbol, Vec<Span>)> {
    let mut found: BTreeMap<Span, (Symbol, Vec<Span>)> = BTreeMap::new();
    if !goes_on(analysis, name) {
        return found;
    }
    for used in analysis.index.uses(Target::Declared(name)) {
        if let Some(symbol) = item_around(analysis, used) {
            found.entry(symbol.name_span).or_insert_with(|| (symbol, Vec::new())).1.push(used);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;
    use crate::features::words::written;

    const GRAPH: &str = "ifs smooth on (a, c) {\n    let b = lerp(a, c, 1/2)\n    transform left = self on (a, b)\n    transform right = rough on (b, c)\n    germ segment(a, c)\n}\nifs rough on (a, c) {\n    let b = lerp(a, c, 1/2)\n    transform left = smooth on (a, b)\n    transform right = self on (b, c)\n    germ segment(a, c)\n}\nfn place(n: Int) -> Curve = smooth on ((0m, 0m), (n * 1m, 1m)) at level 2\nfigure all = [place(n) for n in 1..3]\nlet broken = ";

    #[test]
    fn which_ifs_continues_in_which() {
        let design = fixture(&format!("ifs s$0{}", &GRAPH[5..]));
        let analysis = &design.analysis;
        let name = called_at(analysis, analysis.root, design.at).unwrap();
        let words =
            |spans: Vec<&Span>| spans.into_iter().map(|span| written(analysis, *span)).collect::<Vec<_>>();
        assert_eq!(words(outgoing(analysis, name).keys().collect()), ["smooth", "rough"]);
        assert_eq!(words(incoming(analysis, name).keys().collect()), ["smooth", "rough", "place"]);
        let place = GRAPH.find("place").unwrap() as u32;
        let name = called_at(analysis, analysis.root, place).unwrap();
        assert_eq!(words(incoming(analysis, name).keys().collect()), ["all"]);
        assert_eq!(words(outgoing(analysis, name).keys().collect()), ["smooth"]);
        let name = called_at(analysis, analysis.root, GRAPH.find("all =").unwrap() as u32).unwrap();
        assert_eq!(words(outgoing(analysis, name).keys().collect()), ["place"]);
        assert!(incoming(analysis, name).is_empty());
        assert_eq!(called_at(analysis, analysis.root, GRAPH.find("let b").unwrap() as u32 + 4), None);
    }
}
