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
use super::told::Told;
use crate::protocol::diagnostics::{diagnostic, without_related};
use crate::protocol::uri::uri_of;
use crate::world::names::Names;
use crate::world::outbox::{AllWrong, Wrong};
use crate::world::overlay::Overlay;
use crate::world::owner::Moment;
use crate::world::places::Places;
use crate::world::project_file::{project_file, with_project_file};
use crate::world::projects::Projects;
use crate::world::{Encoding, Snapshot};

/// Everything that is said of a file, once.
pub(super) fn said_of(wrong: &Wrong, told: Told) -> Vec<Diagnostic> {
    let mut all = Vec::new();
    for found in &wrong.found {
        let said = found.diagnostics.iter();
        add(&mut all, said.map(|one| shown(&found.places, &found.analysis, one, told)));
    }
    all
}

/// A diagnostic as the client can show it.
fn shown(
    places: &Places,
    analysis: &Analysis,
    found: &ifs_compiler::diagnostic::Diagnostic,
    told: Told,
) -> Diagnostic {
    let said = if told.plain.diagnostics { without_related } else { diagnostic };
    said(places, analysis, found, told.encoding)
}

/// Adds what is not among them yet.
fn add(all: &mut Vec<Diagnostic>, more: impl Iterator<Item = Diagnostic>) {
    for one in more {
        if !all.contains(&one) {
            all.push(one);
        }
    }
}

/// What all open designs find in a document. Where the client takes it, what its own finds in files that are not open goes with
/// it.
pub(super) fn pulled(
    snapshot: &Snapshot,
    wrong: &AllWrong,
    known: Option<&str>,
    told: Told,
) -> DocumentDiagnosticReport {
    let of = |path: &Path| wrong.get(path).map_or_else(Vec::new, |wrong| said_of(wrong, told));
    let others = told.takes_related.then(|| others(snapshot, of)).filter(|others| !others.is_empty());
    let related_documents = others.map(|others| others.into_iter().collect());
    match report(of(&snapshot.path), known) {
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

/// What is wrong in files of the design that are not open: those that are speak for themselves. A file in which nothing is
/// wrong is said to be so, since something may have been.
fn others(
    snapshot: &Snapshot,
    of: impl Fn(&Path) -> Vec<Diagnostic>,
) -> Vec<(Uri, DocumentDiagnosticReportKind)> {
    let files = snapshot.analysis.files.iter().map(|file| file.file).chain(project_file(&snapshot.analysis));
    let others = files.filter(|file| *file != snapshot.analysis.root).filter_map(|file| {
        let path = snapshot.places.path(&snapshot.analysis, file)?;
        let Report::New(full) = report(of(&path), None) else { return None };
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
    /// What it finds in its other files, the project's `ifs.toml` among them.
    elsewhere: Vec<(PathBuf, Vec<Diagnostic>)>,
}

/// The designs of the workspace that are not open, read when they or what they are made of has changed, and worked out as far
/// as [`Patience`] goes: what is left waits until the client asks again. What would mend them is told where they are open.
#[derive(Clone, Default)]
pub(super) struct Workspace {
    kept: Arc<Mutex<BTreeMap<PathBuf, Kept>>>,
}

impl Workspace {
    /// What is wrong in each file below the folders, and in what open designs are made of.
    pub(super) fn pulled(
        &self,
        projects: &Arc<dyn Projects>,
        names: &Names,
        folders: &[PathBuf],
        (moment, wrong): (&Moment, &AllWrong),
        known: &BTreeMap<String, String>,
        told: Told,
    ) -> Vec<WorkspaceDocumentDiagnosticReport> {
        let mut paths: Vec<PathBuf> = folders.iter().flat_map(|folder| projects.designs(folder)).collect();
        paths.sort();
        paths.dedup();
        paths.retain(|path| !moment.open.contains_key(path));
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.retain(|path, _| paths.contains(path));
        let open = wrong.iter().map(|(path, wrong)| (path.clone(), said_of(wrong, told)));
        let mut found: BTreeMap<PathBuf, Vec<Diagnostic>> = open.collect();
        let patience = Patience::from_now();
        for path in paths {
            let known = kept.get(&path).filter(|kept| is_current(kept, moment));
            if known.is_none_or(|kept| kept.waits && patience.is_left()) {
                let Some(looked) = look(projects, names, &path, (moment, told), patience) else { continue };
                kept.insert(path.clone(), looked);
            }
            let Some(kept) = kept.get(&path) else { continue };
            for (file, items) in &kept.elsewhere {
                add(found.entry(file.clone()).or_default(), items.iter().cloned());
            }
            add(found.entry(path).or_default(), kept.items.iter().cloned());
        }
        let reports = found.into_iter().filter_map(|(path, items)| {
            let uri = uri_of(names, &path)?;
            let known = known.get(uri.as_str()).map(String::as_str);
            let version = moment.open.get(&path).map(|document| i64::from(document.version));
            Some(workspace_report(uri, version, report(items, known)))
        });
        reports.collect()
    }
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
    (moment, told): (&Moment, Told),
    patience: Patience,
) -> Option<Kept> {
    let overlay = Overlay::of(&**projects, path, &moment.open)?;
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
        found.map(|one| shown(&places, &analysis, one, told)).collect()
    };
    let others = analysis.files.iter().map(|file| file.file).chain(project_file(&analysis));
    let others = others.filter(|file| *file != analysis.root);
    let elsewhere = others.filter_map(|file| Some((places.path(&analysis, file)?, of(file)))).collect();
    let (items, disk, encoding) = (of(analysis.root), moment.disk, moment.encoding);
    Some(Kept { made_of, disk, encoding, items, waits, elsewhere })
}
