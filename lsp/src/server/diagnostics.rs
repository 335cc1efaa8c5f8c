//! Diagnostics that the client pulls: of a document, and of the whole workspace. What has not changed since it was last told
//! is said to be so.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use ifs_compiler::analysis::{Analysis, measure_watched, read};
use ifs_compiler::source::FileId;
use tower_lsp::ls_types::*;

use super::patience::{Limited, Patience};
use crate::protocol::diagnostics::diagnostic;
use crate::protocol::uri::uri_of;
use crate::world::names::Names;
use crate::world::overlay::Overlay;
use crate::world::owner::Moment;
use crate::world::places::Places;
use crate::world::project_file::{project_file, with_project_file};
use crate::world::projects::Projects;
use crate::world::{Encoding, Snapshot};

/// What is wrong with a document. `related`: what its design finds in other files goes with it.
pub(super) fn pulled(snapshot: &Snapshot, known: Option<&str>, related: bool) -> DocumentDiagnosticReport {
    let root = snapshot.analysis.root;
    let of = |file: FileId| -> Vec<Diagnostic> {
        let found = snapshot.diagnostics.iter().filter(|found| found.span.file == file);
        found.map(|one| diagnostic(&snapshot.places, &snapshot.analysis, one, snapshot.encoding)).collect()
    };
    let others = related.then(|| others(snapshot, of)).filter(|others| !others.is_empty());
    let related_documents = others.map(|others| others.into_iter().collect());
    match report(of(root), known) {
        Report::Same(result_id) => {
            DocumentDiagnosticReport::Unchanged(RelatedUnchangedDocumentDiagnosticReport {
                related_documents,
                unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport { result_id },
            })
        }
        Report::New(full_document_diagnostic_report) => {
            DocumentDiagnosticReport::Full(RelatedFullDocumentDiagnosticReport {
                related_documents,
                full_document_diagnostic_report,
            })
        }
    }
}

/// What is wrong in files that are not open: those that are speak for themselves. A file in which nothing is wrong is said
/// to be so, since something may have been.
fn others(
    snapshot: &Snapshot,
    of: impl Fn(FileId) -> Vec<Diagnostic>,
) -> Vec<(Uri, DocumentDiagnosticReportKind)> {
    let files = snapshot.analysis.files.iter().map(|file| file.file).chain(project_file(&snapshot.analysis));
    let others = files.filter(|file| *file != snapshot.analysis.root).filter_map(|file| {
        let path = snapshot.places.path(&snapshot.analysis, file)?;
        let Report::New(full) = report(of(file), None) else { return None };
        let open = snapshot.open.contains_key(&path);
        (!open).then_some((snapshot.uri(&path)?, DocumentDiagnosticReportKind::Full(full)))
    });
    others.collect()
}

enum Report {
    New(FullDocumentDiagnosticReport),
    /// With the identity of what is known.
    Same(String),
}

fn report(items: Vec<Diagnostic>, known: Option<&str>) -> Report {
    let result_id = identity(&items);
    match known {
        Some(known) if known == result_id => Report::Same(result_id),
        _ => Report::New(FullDocumentDiagnosticReport { result_id: Some(result_id), items }),
    }
}

/// The same for the same diagnostics, whenever they are found.
fn identity(items: &[Diagnostic]) -> String {
    let mut hasher = DefaultHasher::new();
    serde_json::to_string(items).unwrap_or_default().hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

/// What was read of a file that is not open.
struct Kept {
    /// The files it is made of, with the versions of those that were open.
    made_of: Vec<(PathBuf, Option<i32>)>,
    disk: u64,
    encoding: Encoding,
    items: Vec<Diagnostic>,
    /// Whether it still has to be worked out.
    waits: bool,
    /// The project's `ifs.toml`, and what is wrong in it for this design.
    project: Option<(PathBuf, Vec<Diagnostic>)>,
}

/// The designs of the workspace that are not open, read when they or what they are made of has changed, and worked out as far
/// as [`Patience`] goes: what is left waits until the client asks again. What would mend them is told where they are open.
#[derive(Clone, Default)]
pub(super) struct Workspace {
    kept: Arc<Mutex<BTreeMap<PathBuf, Kept>>>,
}

impl Workspace {
    /// What is wrong in each file below the folders that is not open.
    pub(super) fn pulled(
        &self,
        projects: &Arc<dyn Projects>,
        names: &Names,
        folders: &[PathBuf],
        moment: &Moment,
        known: &BTreeMap<String, String>,
    ) -> Vec<WorkspaceDocumentDiagnosticReport> {
        let mut paths: Vec<PathBuf> = folders.iter().flat_map(|folder| projects.designs(folder)).collect();
        paths.sort();
        paths.dedup();
        paths.retain(|path| !moment.open.contains_key(path));
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.retain(|path, _| paths.contains(path));
        let mut found: BTreeMap<PathBuf, Vec<Diagnostic>> = BTreeMap::new();
        let patience = Patience::from_now();
        for path in paths {
            let known = kept.get(&path).filter(|kept| is_current(kept, moment));
            if known.is_none_or(|kept| kept.waits && patience.is_left()) {
                let Some(looked) = look(projects, names, &path, moment, patience) else { continue };
                kept.insert(path.clone(), looked);
            }
            let Some(kept) = kept.get(&path) else { continue };
            if let Some((file, items)) =
                kept.project.as_ref().filter(|(file, _)| !moment.open.contains_key(file))
            {
                let all = found.entry(file.clone()).or_default();
                all.extend(items.iter().filter(|item| !all.contains(item)).cloned().collect::<Vec<_>>());
            }
            found.entry(path).or_default().extend(kept.items.iter().cloned());
        }
        let reports = found.into_iter().filter_map(|(path, items)| {
            let uri = uri_of(names, &path)?;
            let known = known.get(uri.as_str()).map(String::as_str);
            Some(workspace_report(uri, None, report(items, known)))
        });
        reports.collect()
    }
}

/// The report of an open document in that of the workspace.
pub(super) fn open_report(
    snapshot: &Snapshot,
    known: &BTreeMap<String, String>,
) -> Option<WorkspaceDocumentDiagnosticReport> {
    let uri = snapshot.uri(&snapshot.path)?;
    let root = snapshot.analysis.root;
    let own = snapshot.diagnostics.iter().filter(|found| found.span.file == root);
    let items = own.map(|one| diagnostic(&snapshot.places, &snapshot.analysis, one, snapshot.encoding));
    let report = report(items.collect(), known.get(uri.as_str()).map(String::as_str));
    let version = snapshot.open.get(&snapshot.path).map(|document| i64::from(document.version));
    Some(workspace_report(uri, version, report))
}

fn workspace_report(uri: Uri, version: Option<i64>, report: Report) -> WorkspaceDocumentDiagnosticReport {
    match report {
        Report::Same(result_id) => {
            WorkspaceDocumentDiagnosticReport::Unchanged(WorkspaceUnchangedDocumentDiagnosticReport {
                uri,
                version,
                unchanged_document_diagnostic_report: UnchangedDocumentDiagnosticReport { result_id },
            })
        }
        Report::New(full_document_diagnostic_report) => {
            WorkspaceDocumentDiagnosticReport::Full(WorkspaceFullDocumentDiagnosticReport {
                uri,
                version,
                full_document_diagnostic_report,
            })
        }
    }
}

fn is_current(kept: &Kept, moment: &Moment) -> bool {
    let version = |path: &Path| moment.open.get(path).map(|document| document.version);
    kept.disk == moment.disk
        && kept.encoding == moment.encoding
        && kept.made_of.iter().all(|(path, then)| version(path) == *then)
}

fn look(
    projects: &Arc<dyn Projects>,
    names: &Names,
    path: &Path,
    moment: &Moment,
    patience: Patience,
) -> Option<Kept> {
    let overlay = Overlay { project: projects.project(path)?, open: Arc::clone(&moment.open) };
    let mut analysis: Analysis = read(&overlay, &overlay.project.design, &overlay.project.overrides);
    let waits = !analysis.has_errors() && !patience.is_left();
    if !analysis.has_errors() && !waits {
        let mut limited = Limited::from_now();
        let measured = measure_watched(analysis.clone(), &overlay.project.overrides, &mut limited);
        // Of what took too long nothing is known but what was read.
        if !limited.stopped {
            analysis = measured;
        }
    }
    with_project_file(&mut analysis, &overlay);
    let root = overlay.project.root;
    let places = Places { root, projects: Arc::clone(projects), names: names.clone() };
    let files = analysis.files.iter().filter_map(|file| places.path(&analysis, file.file));
    let made_of = files.map(|path| {
        let version = moment.open.get(&path).map(|document| document.version);
        (path, version)
    });
    let made_of = made_of.collect();
    let of = |file: FileId| -> Vec<Diagnostic> {
        let found = analysis.diagnostics.iter().filter(|found| found.span.file == file);
        found.map(|one| diagnostic(&places, &analysis, one, moment.encoding)).collect()
    };
    let project = project_file(&analysis).and_then(|file| Some((places.path(&analysis, file)?, of(file))));
    let (items, disk, encoding) = (of(analysis.root), moment.disk, moment.encoding);
    Some(Kept { made_of, disk, encoding, items, waits, project })
}
