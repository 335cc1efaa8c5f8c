//! The `ifs.toml` of a project as the editor has it: what is wrong in it, said at its own places, beside a design of the
//! project and as a document of its own. What it means is `ifs_compiler::analysis::project`.

use std::path::Path;
use std::sync::Arc;

use ifs_compiler::analysis::project::{misspelt_parameters, read_project};
use ifs_compiler::analysis::{Analysis, read, read_indexed};
use ifs_compiler::diagnostic::{Code, Diagnostic, Fix};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{FileId, Files, MemoryFiles, Span};

use super::overlay::Overlay;
use super::projects::Projects;

/// The name of the file that marks a project's folder.
pub(crate) const PROJECT_FILE: &str = "ifs.toml";

/// Whether a document is no design but what a project sets.
pub(crate) fn is_project_file(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == PROJECT_FILE)
}

/// The `ifs.toml` among the sources of an analysis.
pub(crate) fn project_file(analysis: &Analysis) -> Option<FileId> {
    analysis.sources.iter().find(|source| source.path == PROJECT_FILE).map(|source| source.id)
}

/// An `ifs.toml` as a document: its text is the root, which is no design, and nothing but it is spoken of. What open
/// designs of its project find in it is said too.
pub(super) fn read_alone(overlay: &Overlay, projects: &dyn Projects) -> Analysis {
    let mut analysis = read_indexed(&MemoryFiles::single("", ""), "", &Overrides::default());
    let text = text(overlay).unwrap_or_default();
    let root = Arc::make_mut(&mut analysis.sources).add(PROJECT_FILE, text.as_str());
    analysis.root = root;
    analysis.diagnostics = read_project(root, &text).1;
    let below = overlay.open.keys().filter(|path| path.starts_with(&overlay.project.root));
    for path in below.filter(|path| !is_project_file(path)) {
        let design = Overlay::of(projects, path, &overlay.open);
        let Some(design) = design.filter(|other| other.project.root == overlay.project.root) else {
            continue;
        };
        let mut read = read(&design, &design.project.design, &design.project.overrides);
        with_project_file(&mut read, &design);
        let Some(file) = project_file(&read) else { continue };
        for found in read.diagnostics.into_iter().filter(|found| found.span.file == file) {
            let found = moved(found, root);
            if !analysis.diagnostics.contains(&found) {
                analysis.diagnostics.push(found);
            }
        }
    }
    analysis
}

/// What one analysis says of a file, said of the same file in another.
fn moved(mut found: Diagnostic, file: FileId) -> Diagnostic {
    found.span.file = file;
    found.labels.clear();
    let fixes = found.hints.iter_mut().flat_map(|hint| &mut hint.fixes);
    for edit in fixes.flat_map(|fix| &mut fix.edits) {
        edit.span.file = file;
    }
    found
}

/// Adds what is wrong in the `ifs.toml` of a design's project to what is wrong with the design.
pub(crate) fn with_project_file(analysis: &mut Analysis, overlay: &Overlay) {
    let Some(text) = text(overlay) else { return };
    let file = Arc::make_mut(&mut analysis.sources).add(PROJECT_FILE, text.as_str());
    let (settings, found) = read_project(file, &text);
    analysis.diagnostics.extend(found);
    analysis.diagnostics.extend(misspelt_parameters(&settings, &analysis.hir));
    // A machine that is not there is a mistake of the file that names it.
    let Some((named, at)) = settings.machine.filter(|(named, _)| {
        analysis.machine.as_ref().is_some_and(|used| used.whence == named.whence && used.name == named.name)
    }) else {
        return;
    };
    for diagnostic in &mut analysis.diagnostics {
        if matches!(diagnostic.code, Code::E0860 | Code::E0861)
            && diagnostic.span.start == diagnostic.span.end
        {
            diagnostic.span = at;
            offer_name(diagnostic, &text, &named.name, at);
        }
    }
}

/// The name that a machine may have been meant by, as a change of the text.
fn offer_name(diagnostic: &mut Diagnostic, text: &str, name: &str, at: Span) {
    let Some(written) = text.get(at.range()) else { return };
    for hint in diagnostic.hints.iter_mut().filter(|hint| hint.fixes.is_empty()) {
        let meant = hint.text.strip_prefix("did you mean `").and_then(|rest| rest.strip_suffix("`?"));
        if let (Some(meant), Some((before, after))) = (meant, written.rsplit_once(name)) {
            hint.fixes.push(Fix::replacing(at, format!("{before}{meant}{after}")));
        }
    }
}

fn text(overlay: &Overlay) -> Option<String> {
    String::from_utf8(overlay.read(PROJECT_FILE).ok()?).ok()
}
