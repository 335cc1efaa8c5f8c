//! What calls what, over the designs of the project; and names of the workspace.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::{Files, Source, Span};
use ifs_compiler::syntax::parse;
use serde_json::{Value, json};
use tower_lsp::ls_types::*;

use super::answers::{project, symbol_kind};
use crate::features::symbols::Symbol;
use crate::features::{calls, search};
use crate::protocol::convert::{position, range};
use crate::protocol::uri::uri_of;
use crate::world::Snapshot;
use crate::world::names::Names;
use crate::world::overlay::Overlay;
use crate::world::owner::Moment;
use crate::world::places::Places;
use crate::world::projects::Projects;

/// How many names are told of.
const MOST_SYMBOLS: usize = 1_000;

/// An item of a design as the client keeps it, with what finds it again: the document it was asked of.
fn item(
    snapshot: &Snapshot,
    (places, analysis): (&Places, &Analysis),
    symbol: &Symbol,
    document: &str,
) -> Option<CallHierarchyItem> {
    let path = places.path(analysis, symbol.name_span.file)?;
    let source = &analysis.sources.get(symbol.name_span.file)?.path;
    Some(CallHierarchyItem {
        name: symbol.name.clone(),
        kind: symbol_kind(symbol.kind),
        tags: None,
        detail: Some(source.clone()),
        uri: snapshot.uri(&path)?,
        range: range(analysis, symbol.span, snapshot.encoding),
        selection_range: range(analysis, symbol.name_span, snapshot.encoding),
        data: Some(json!({
            "document": document,
            "path": path.to_string_lossy(),
            "start": symbol.name_span.start,
            "end": symbol.name_span.end,
        })),
    })
}

/// The item that is named at a place.
pub(super) fn prepare(snapshot: &Snapshot, at: Position, document: &Uri) -> Option<Vec<CallHierarchyItem>> {
    let analysis = &*snapshot.analysis;
    let name = calls::called_at(analysis, analysis.root, snapshot.offset(at))?;
    let symbol = calls::item_around(analysis, name)?;
    Some(vec![item(snapshot, (&snapshot.places, analysis), &symbol, document.as_str())?])
}

/// The document by which an item was found.
pub(super) fn document(item: &CallHierarchyItem) -> Option<Uri> {
    item.data.as_ref()?.get("document")?.as_str()?.parse().ok()
}

/// The name of an item in an analysis.
fn name(places: &Places, analysis: &Analysis, data: &Value) -> Option<Span> {
    let path = PathBuf::from(data.get("path")?.as_str()?);
    let file = places.file(analysis, &path)?;
    let number = |key: &str| u32::try_from(data.get(key)?.as_u64()?).ok();
    Some(Span::new(file, number("start")?, number("end")?))
}

/// What the item is made of.
pub(super) fn outgoing(
    snapshot: &Snapshot,
    asked: &CallHierarchyItem,
) -> Option<Vec<CallHierarchyOutgoingCall>> {
    let analysis = &*snapshot.analysis;
    let data = asked.data.as_ref()?;
    let document = data.get("document")?.as_str()?;
    let mut found = None;
    // An item of another design may not be known to this one.
    for (places, other) in project(snapshot) {
        let analysis = other.as_ref().unwrap_or(analysis);
        let Some(name) = name(&places, analysis, data) else { continue };
        let calls = calls::outgoing(analysis, name).into_iter().filter_map(|(declared, used)| {
            let symbol = calls::item_around(analysis, declared)?;
            let to = item(snapshot, (&places, analysis), &symbol, document)?;
            let ranges = used.into_iter().map(|span| range(analysis, span, snapshot.encoding));
            Some(CallHierarchyOutgoingCall { to, from_ranges: ranges.collect() })
        });
        found = Some(calls.collect());
        break;
    }
    found
}

/// What uses the item, in all designs of the project.
pub(super) fn incoming(
    snapshot: &Snapshot,
    asked: &CallHierarchyItem,
) -> Option<Vec<CallHierarchyIncomingCall>> {
    let data = asked.data.as_ref()?;
    let document = data.get("document")?.as_str()?;
    let mut found: BTreeMap<(PathBuf, u32), CallHierarchyIncomingCall> = BTreeMap::new();
    for (places, other) in project(snapshot) {
        let analysis = other.as_ref().unwrap_or(&snapshot.analysis);
        let Some(name) = name(&places, analysis, data) else { continue };
        for (caller, (symbol, used)) in calls::incoming(analysis, name) {
            let Some(path) = places.path(analysis, caller.file) else { continue };
            let Some(from) = item(snapshot, (&places, analysis), &symbol, document) else { continue };
            let ranges = used.into_iter().map(|span| range(analysis, span, snapshot.encoding));
            let call = CallHierarchyIncomingCall { from, from_ranges: ranges.collect() };
            found.entry((path, caller.start)).or_insert(call);
        }
    }
    Some(found.into_values().collect())
}

/// The names of all designs of the folders, by some of their letters: best first.
pub(super) fn symbols(
    projects: &Arc<dyn Projects>,
    names: &Names,
    folders: &[PathBuf],
    moment: &Moment,
    query: &str,
) -> Vec<WorkspaceSymbol> {
    let mut paths: Vec<PathBuf> = folders.iter().flat_map(|folder| projects.designs(folder)).collect();
    paths.extend(moment.open.keys().cloned());
    paths.sort();
    paths.dedup();
    let mut found = Vec::new();
    for path in paths {
        let Some(overlay) = Overlay::of(&**projects, &path, &moment.open) else { continue };
        let design = overlay.project.design.clone();
        let text = overlay.read(&design).ok().and_then(|bytes| String::from_utf8(bytes).ok());
        let (Some(text), Some(uri)) = (text, uri_of(names, &path)) else { continue };
        let source = Source::new(ifs_compiler::source::FileId(0), design.clone(), text);
        for one in search::search(&parse(&source).ast, query) {
            let at = |offset| position(&source.text, &source.lines, offset, moment.encoding);
            let span = one.symbol.name_span;
            let range = Range { start: at(span.start), end: at(span.end) };
            found.push((
                one.rank,
                WorkspaceSymbol {
                    name: one.symbol.name,
                    kind: symbol_kind(one.symbol.kind),
                    tags: None,
                    container_name: Some(one.container.unwrap_or_else(|| design.clone())),
                    location: OneOf::Left(Location { uri: uri.clone(), range }),
                    data: None,
                },
            ));
        }
    }
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, symbol)| symbol).take(MOST_SYMBOLS).collect()
}
