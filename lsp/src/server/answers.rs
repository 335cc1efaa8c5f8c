//! Answers in the protocol's types, each from one feature.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use ifs_compiler::analysis::{Analysis, read_indexed};
use ifs_compiler::hir::index::{DeclarationKind, Target};
use ifs_compiler::source::Span;
use tower_lsp::ls_types::*;

use crate::features::facts::WorkedOut;
use crate::features::{definition, format, hover, links, references, symbols};
use crate::protocol::convert::range;
use crate::world::Snapshot;
use crate::world::overlay::Overlay;
use crate::world::places::Places;

pub(super) fn hover(snapshot: &Snapshot, position: Position) -> Option<Hover> {
    let known = WorkedOut {
        made: snapshot.made.as_ref().map(|made| &*made.analysis),
        current: snapshot.made.as_ref().is_some_and(|made| made.current),
        overrides: &snapshot.overrides,
    };
    let found = hover::hover(&snapshot.analysis, known, snapshot.analysis.root, snapshot.offset(position))?;
    Some(Hover {
        contents: HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value: found.markdown }),
        range: Some(snapshot.range(found.span)),
    })
}

fn link(snapshot: &Snapshot, found: Option<(Span, Span)>) -> Option<GotoDefinitionResponse> {
    let (_, declared) = found?;
    Some(GotoDefinitionResponse::Scalar(snapshot.location(declared)?))
}

pub(super) fn definition(snapshot: &Snapshot, position: Position) -> Option<GotoDefinitionResponse> {
    let at = snapshot.offset(position);
    link(snapshot, definition::definition(&snapshot.analysis, snapshot.analysis.root, at))
}

pub(super) fn type_definition(snapshot: &Snapshot, position: Position) -> Option<GotoDefinitionResponse> {
    let at = snapshot.offset(position);
    link(snapshot, definition::type_definition(&snapshot.analysis, snapshot.analysis.root, at))
}

/// The designs of the project that may use what this one declares, read with their indexes: this one first.
pub(super) fn project(snapshot: &Snapshot) -> Vec<(Places, Option<Analysis>)> {
    let mut all = vec![(snapshot.places.clone(), None)];
    let projects = &snapshot.places.projects;
    let mut paths: BTreeSet<PathBuf> = projects.designs(&snapshot.places.root).into_iter().collect();
    paths.extend(snapshot.open.keys().filter(|path| path.starts_with(&snapshot.places.root)).cloned());
    paths.remove(&snapshot.path);
    for path in paths {
        let overlay = Overlay::of(&**projects, &path, &snapshot.open);
        let Some(overlay) = overlay.filter(|other| other.project.root == snapshot.places.root) else {
            continue;
        };
        let analysis = read_indexed(&overlay, &overlay.project.design, &overlay.project.overrides);
        all.push((snapshot.places.clone(), Some(analysis)));
    }
    all
}

/// A place of a name in some file of the project.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Place {
    pub(super) path: PathBuf,
    pub(super) start: u32,
    pub(super) end: u32,
    from: (u32, u32),
    to: (u32, u32),
}

impl Place {
    fn new(path: PathBuf, span: Span, range: Range) -> Place {
        let pair = |position: Position| (position.line, position.character);
        Place { path, start: span.start, end: span.end, from: pair(range.start), to: pair(range.end) }
    }

    pub(super) fn range(&self) -> Range {
        let position = |(line, character)| Position { line, character };
        Range { start: position(self.from), end: position(self.to) }
    }

    fn location(&self, snapshot: &Snapshot) -> Option<Location> {
        Some(Location { uri: snapshot.uri(&self.path)?, range: self.range() })
    }
}

/// The places of a name over all designs of the project, in the order of files: `spans` finds those of one analysis.
pub(super) fn everywhere(
    snapshot: &Snapshot,
    declared: Span,
    spans: impl Fn(&Analysis, Span) -> Result<Vec<Span>, String>,
) -> Result<Vec<Place>, String> {
    let home = snapshot.places.path(&snapshot.analysis, declared.file).unwrap_or_default();
    // A parameter can be named in calls from other files.
    let local = snapshot
        .analysis
        .index
        .declaration(declared)
        .is_some_and(|found| found.scope.is_some() && !matches!(found.kind, DeclarationKind::Field(..)));
    let all = if local { vec![(snapshot.places.clone(), None)] } else { project(snapshot) };
    let mut found = Vec::new();
    for (places, analysis) in &all {
        let analysis = analysis.as_ref().unwrap_or(&snapshot.analysis);
        let Some(file) = places.file(analysis, &home) else { continue };
        for span in spans(analysis, Span::new(file, declared.start, declared.end))? {
            let Some(path) = places.path(analysis, span.file) else { continue };
            found.push(Place::new(path, span, range(analysis, span, snapshot.encoding)));
        }
    }
    found.sort();
    found.dedup();
    Ok(found)
}

pub(super) fn references(
    snapshot: &Snapshot,
    position: Position,
    declaration: bool,
) -> Option<Vec<Location>> {
    let at = snapshot.offset(position);
    let found = references::references(&snapshot.analysis, snapshot.analysis.root, at)?;
    let Some(declared) = found.declaration else {
        return Some(found.uses.into_iter().filter_map(|span| snapshot.location(span)).collect());
    };
    let spans = |analysis: &Analysis, declared: Span| {
        let mut spans = references::of_target(analysis, Target::Declared(declared)).uses;
        spans.extend(declaration.then_some(declared));
        Ok(spans)
    };
    let places = everywhere(snapshot, declared, spans).unwrap_or_default();
    Some(places.iter().filter_map(|place| place.location(snapshot)).collect())
}

pub(super) fn highlights(snapshot: &Snapshot, position: Position) -> Vec<DocumentHighlight> {
    let found = references::highlights(&snapshot.analysis, snapshot.analysis.root, snapshot.offset(position));
    let kind =
        |declaration| if declaration { DocumentHighlightKind::WRITE } else { DocumentHighlightKind::READ };
    found
        .into_iter()
        .map(|(span, declaration)| DocumentHighlight {
            range: snapshot.range(span),
            kind: Some(kind(declaration)),
        })
        .collect()
}

pub(super) fn symbol_kind(kind: symbols::SymbolKind) -> SymbolKind {
    use symbols::SymbolKind as Kind;
    match kind {
        Kind::Parameter => SymbolKind::CONSTANT,
        Kind::Value | Kind::Point => SymbolKind::VARIABLE,
        Kind::Function => SymbolKind::FUNCTION,
        Kind::Record => SymbolKind::STRUCT,
        Kind::Field => SymbolKind::FIELD,
        Kind::Ifs => SymbolKind::CLASS,
        Kind::Transform => SymbolKind::METHOD,
        Kind::Boundary => SymbolKind::PROPERTY,
        Kind::Figure => SymbolKind::OBJECT,
        Kind::Fabrication => SymbolKind::MODULE,
        Kind::Setting => SymbolKind::PROPERTY,
        Kind::Requirement => SymbolKind::EVENT,
        Kind::Test => SymbolKind::METHOD,
    }
}

fn symbol(snapshot: &Snapshot, found: symbols::Symbol) -> DocumentSymbol {
    let kind = symbol_kind(found.kind);
    let parts: Vec<DocumentSymbol> = found.parts.into_iter().map(|part| symbol(snapshot, part)).collect();
    #[allow(deprecated, reason = "the field must be given")]
    DocumentSymbol {
        name: found.name,
        detail: (!found.detail.is_empty()).then_some(found.detail),
        kind,
        tags: None,
        deprecated: None,
        range: snapshot.range(found.span),
        selection_range: snapshot.range(found.name_span),
        children: (!parts.is_empty()).then_some(parts),
    }
}

pub(super) fn symbols(snapshot: &Snapshot) -> Vec<DocumentSymbol> {
    let root = snapshot.analysis.files.first();
    let mut found = root.map_or_else(Vec::new, |file| symbols::symbols(&file.parse.ast));
    symbols::tell_types(&snapshot.analysis, &mut found);
    found.into_iter().map(|found| symbol(snapshot, found)).collect()
}

pub(super) fn format(snapshot: &Snapshot) -> Option<Vec<TextEdit>> {
    let edits = format::edits(&snapshot.analysis, snapshot.analysis.root)?;
    Some(edits.into_iter().map(|(span, text)| snapshot.edit(span, text)).collect())
}

pub(super) fn links(snapshot: &Snapshot) -> Vec<DocumentLink> {
    let root = snapshot.analysis.root;
    let link = |span, path: &Path| {
        let target = Some(snapshot.uri(path)?);
        Some(DocumentLink { range: snapshot.range(span), target, tooltip: None, data: None })
    };
    let modules = links::links(&snapshot.analysis, root).into_iter();
    let modules =
        modules.filter_map(|(span, file)| link(span, &snapshot.places.path(&snapshot.analysis, file)?));
    let meshes = links::meshes(&snapshot.analysis, root).iter();
    let meshes = meshes.filter_map(|(span, path)| link(*span, &snapshot.places.root.join(path)));
    modules.chain(meshes).collect()
}
