//! What the other files of a project declare, for names that a design lacks; and a design read anew with a change that is
//! offered, before it is offered.

use std::path::Path;
use std::sync::Arc;

use ifs_compiler::analysis::{Analysis, Earlier, read_indexed_again};
use ifs_compiler::diagnostic::{Diagnostic, Edit, Severity};
use ifs_compiler::source::{FileId, Files, Source};
use ifs_compiler::syntax::{ast::ItemKind, parse};

use crate::features::fixes::{self, Mend};
use crate::world::Snapshot;
use crate::world::documents::Document;
use crate::world::overlay::{Open, Overlay};
use crate::world::project_file::with_project_file;
use crate::world::projects::Project;

/// The most files of a project that are looked through for a name.
const MOST_FILES: usize = 300;

/// The ways to import a name that is not known, from every file of the project that offers it.
pub(super) fn imports(snapshot: &Snapshot, found: &Diagnostic) -> Vec<Mend> {
    let analysis = &snapshot.analysis;
    let Some(name) = fixes::missing(analysis, found) else { return Vec::new() };
    let overlay = Overlay::of(&*snapshot.places.projects, &snapshot.path, &snapshot.open);
    let Some(overlay) = overlay else { return Vec::new() };
    let root = &overlay.project.root;
    let mut paths = snapshot.places.projects.designs(root);
    paths.extend(snapshot.open.keys().filter(|path| path.starts_with(root)).cloned());
    paths.sort();
    paths.dedup();
    let others = paths.iter().filter(|path| **path != snapshot.path).take(MOST_FILES);
    let offering = others.filter_map(|path| {
        let inner = path.strip_prefix(root).ok()?.to_str()?.replace('\\', "/");
        let text = String::from_utf8(overlay.read(&inner).ok()?).ok()?;
        // Most files do not even have the word.
        (text.contains(name) && offers(&text, name)).then_some(inner)
    });
    let mends = offering.filter_map(|from| fixes::imported(analysis, analysis.root, name, &from));
    mends.filter(|mend| helps(snapshot, found, &mend.edits)).collect()
}

/// The ifs of the library that take as many points as are given.
pub(super) fn siblings(snapshot: &Snapshot, found: &Diagnostic) -> Vec<Mend> {
    let mends = fixes::siblings(&snapshot.analysis, found);
    let mut fitting: Vec<Mend> =
        mends.into_iter().filter(|mend| helps(snapshot, found, &mend.edits)).collect();
    if let [only] = fitting.as_mut_slice() {
        only.preferred = true;
    }
    fitting
}

/// Whether a file offers a name to others.
fn offers(text: &str, name: &str) -> bool {
    let parsed = parse(&Source::new(FileId(0), "", text));
    parsed.ast.items.iter().filter(|item| item.public.is_some()).any(|item| {
        let declared = match &item.kind {
            ItemKind::Param(item) => &item.name,
            ItemKind::Let(item) => &item.name,
            ItemKind::Function(item) => &item.name,
            ItemKind::Record(item) => &item.name,
            ItemKind::Ifs(item) => &item.name,
            ItemKind::Figure(item) => &item.name,
            _ => return false,
        };
        declared.text == name
    })
}

/// Whether the diagnostic is gone after the change, and no error is new: files may not use each other in a circle.
fn helps(snapshot: &Snapshot, found: &Diagnostic, edits: &[Edit]) -> bool {
    let Some(source) = snapshot.analysis.sources.get(snapshot.analysis.root) else { return false };
    let mut text = source.text.clone();
    for edit in edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.replacement);
    }
    let errors = |analysis: &Analysis| {
        analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error).count()
    };
    let gone = |after: &Analysis| {
        after.diagnostics.iter().all(|other| other.code != found.code || other.message != found.message)
    };
    read_with(snapshot, text).is_some_and(|after| gone(&after) && errors(&after) < errors(&snapshot.analysis))
}

/// The design of a snapshot, read anew with another text.
pub(super) fn read_with(snapshot: &Snapshot, text: String) -> Option<Analysis> {
    let mut open = (*snapshot.open).clone();
    open.insert(snapshot.path.clone(), Arc::new(Document::new(text, 0)));
    read_among(snapshot, &snapshot.path, &Arc::new(open))
}

/// A design beside that of a snapshot, read anew among other open documents.
pub(super) fn read_among(snapshot: &Snapshot, path: &Path, open: &Arc<Open>) -> Option<Analysis> {
    let overlay = Overlay::of(&*snapshot.places.projects, path, open)?;
    let Project { design, overrides, .. } = &overlay.project;
    let mut analysis = read_indexed_again(&overlay, design, overrides, Earlier::beside(&snapshot.analysis));
    with_project_file(&mut analysis, &overlay);
    Some(analysis)
}
