//! A name changed in every file of a project, where that changes no meaning: the changed designs are read before the change
//! is offered.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::analysis::project::read_project;
use ifs_compiler::hir::index::DeclarationKind;
use ifs_compiler::hir::tree::ItemKind;
use ifs_compiler::source::{FileId, Files, Source, Span};
use tower_lsp::ls_types::*;

use super::answers::{Place, everywhere, project};
use super::neighbours::read_among;
use crate::features::rename;
use crate::protocol::convert::range_in;
use crate::world::Snapshot;
use crate::world::documents::Document;
use crate::world::overlay::{Open, Overlay};
use crate::world::project_file::PROJECT_FILE;

/// Refuses to change the library where an editor has a file of it open.
fn not_of_the_library(snapshot: &Snapshot) -> Result<(), String> {
    let module = snapshot.path.file_stem().and_then(|stem| stem.to_str());
    let file = module.and_then(|module| snapshot.places.projects.library(module));
    match file.is_some_and(|file| file == snapshot.path) {
        true => Err("this file is of the library, which cannot be changed".to_owned()),
        false => Ok(()),
    }
}

pub(super) fn prepare(snapshot: &Snapshot, position: Position) -> Result<PrepareRenameResponse, String> {
    not_of_the_library(snapshot)?;
    let (name, _) = rename::prepare(&snapshot.analysis, snapshot.analysis.root, snapshot.offset(position))?;
    Ok(PrepareRenameResponse::Range(snapshot.range(name)))
}

pub(super) fn rename(snapshot: &Snapshot, position: Position, new: &str) -> Result<WorkspaceEdit, String> {
    not_of_the_library(snapshot)?;
    let at = snapshot.offset(position);
    let (_, declared) = rename::prepare(&snapshot.analysis, snapshot.analysis.root, at)?;
    let places =
        everywhere(snapshot, declared, |analysis, declared| rename::rename(analysis, declared, new))?;
    keeps_meaning(snapshot, &places, new)?;
    let mut changes: BTreeMap<PathBuf, Vec<TextEdit>> = BTreeMap::new();
    for place in &places {
        let edit = TextEdit { range: place.range(), new_text: new.to_owned() };
        changes.entry(place.path.clone()).or_default().push(edit);
    }
    if let Some((path, edit)) = in_project_file(snapshot, declared, new)? {
        changes.entry(path).or_default().push(edit);
    }
    let changes = changes.into_iter().filter_map(|(path, edits)| Some((snapshot.uri(&path)?, edits)));
    Ok(WorkspaceEdit { changes: Some(changes.collect()), ..WorkspaceEdit::default() })
}

/// Whether every design with one of these places in it means the same when they are changed; else why not.
fn keeps_meaning(snapshot: &Snapshot, places: &[Place], new: &str) -> Result<(), String> {
    let mut open: Open = (*snapshot.open).clone();
    let all = project(snapshot);
    let analyses: Vec<&Analysis> =
        all.iter().map(|(_, other)| other.as_ref().unwrap_or(&snapshot.analysis)).collect();
    let path_of = |analysis: &Analysis, file| snapshot.places.path(analysis, file);
    for analysis in &analyses {
        for file in analysis.files.iter() {
            let (Some(path), Some(source)) = (path_of(analysis, file.file), analysis.sources.get(file.file))
            else {
                continue;
            };
            let own = places.iter().filter(|place| place.path == path);
            let mut text = source.text.clone();
            own.clone()
                .rev()
                .for_each(|place| text.replace_range(place.start as usize..place.end as usize, new));
            if own.count() > 0 {
                open.insert(path, Arc::new(Document::new(text, 0)));
            }
        }
    }
    let open = Arc::new(open);
    for before in analyses {
        let changed = |file: FileId| -> Vec<Span> {
            let own = places.iter().filter(|place| Some(&place.path) == path_of(before, file).as_ref());
            own.map(|place| Span::new(file, place.start, place.end)).collect()
        };
        let spans: Vec<Span> = before.files.iter().flat_map(|file| changed(file.file)).collect();
        let Some(path) = path_of(before, before.root).filter(|_| !spans.is_empty()) else { continue };
        if let Some(after) = read_among(snapshot, &path, &open) {
            rename::same_meaning(before, &after, &spans, new)?;
        }
    }
    Ok(())
}

/// The change of a parameter's name in the `ifs.toml` that sets it; refused where that would change what is set of another
/// design.
fn in_project_file(
    snapshot: &Snapshot,
    declared: Span,
    new: &str,
) -> Result<Option<(PathBuf, TextEdit)>, String> {
    let analysis = &snapshot.analysis;
    let name = match analysis.index.declaration(declared) {
        Some(found) if is_parameter(analysis, found.kind) => found.name.clone(),
        _ => return Ok(None),
    };
    let overlay = Overlay::of(&*snapshot.places.projects, &snapshot.path, &snapshot.open);
    let Some(overlay) = overlay else { return Ok(None) };
    let text = overlay.read(PROJECT_FILE).ok().and_then(|text| String::from_utf8(text).ok());
    let Some(text) = text else { return Ok(None) };
    let source = Source::new(FileId(0), PROJECT_FILE, text);
    let (settings, _) = read_project(source.id, &source.text);
    let Some((_, key)) = settings.parameters.get(&name) else { return Ok(None) };
    let home = snapshot.places.path(analysis, declared.file);
    for (places, other) in project(snapshot) {
        let other = other.as_ref().unwrap_or(analysis);
        let path = places.path(other, other.root);
        let own =
            |id: &ifs_compiler::hir::tree::Item| id.name == name && matches!(id.kind, ItemKind::Param(_));
        if path != home && other.hir.own_items().any(|(_, item)| own(item)) {
            let other = other.sources.get(other.root).map_or("", |source| &source.path);
            return Err(format!("`{PROJECT_FILE}` sets `{name}` for {other} too: rename it there first"));
        }
    }
    let edit = TextEdit { range: range_in(&source, *key, snapshot.encoding), new_text: new.to_owned() };
    Ok(Some((snapshot.places.root.join(PROJECT_FILE), edit)))
}

fn is_parameter(analysis: &Analysis, kind: DeclarationKind) -> bool {
    matches!(kind, DeclarationKind::Item(id) if matches!(analysis.hir.item(id).kind, ItemKind::Param(_)))
}
