//! Open documents as designs: reading them when something they are made of has changed, having them worked out, and what is
//! wrong with them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use ifs_compiler::analysis::{Analysis, Earlier, read_indexed, read_indexed_again};
use ifs_compiler::diagnostic::{Code, Diagnostic};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::FileId;

use super::background::{Background, Job, Worked};
use super::discard::Discard;
use super::documents::Edit;
use super::edits::moved_diagnostic;
use super::names::Names;
use super::outbox::{AllWrong, Found, Wrong};
use super::overlay::{Open, Overlay};
use super::places::Places;
use super::project_file::{is_project_file, project_file, read_alone, with_project_file};
use super::projects::{Project, Projects};
use super::snapshot::Made;
use super::worst::with_worst_boards;

/// What is known of an open document as a design.
pub(super) struct Design {
    pub(super) places: Places,
    pub(super) analysis: Arc<Analysis>,
    pub(super) overrides: Arc<Overrides>,
    /// The revision it was read at; none when something it is made of has changed since.
    read_at: Option<u64>,
    /// Whether its own text is still the one that was read.
    pub(super) fresh: Arc<AtomicBool>,
    pub(super) made: Option<Made>,
    /// What was found by working it out that reading it did not find, moved with the edits since.
    worked: Vec<Diagnostic>,
}

impl Design {
    /// What is wrong with it as far as is known, by place.
    pub(super) fn diagnostics(&self) -> Vec<Diagnostic> {
        let mut all = self.analysis.diagnostics.clone();
        if !self.analysis.has_errors() {
            all.extend(self.worked.iter().cloned());
            all.sort_by_key(|diagnostic| (diagnostic.span.file, diagnostic.span.start));
        }
        all
    }

    fn outdate(&mut self) {
        self.read_at = None;
        if let Some(made) = &mut self.made {
            made.current = false;
        }
    }
}

/// What is kept of a design while it is read anew. Of its reading all but the trees is let go first: room that is given back
/// in one piece is taken again much quicker than room between what stays.
struct Before {
    /// The files it was made of.
    paths: Vec<String>,
    made: Option<Made>,
    worked: Vec<Diagnostic>,
}

impl Before {
    fn of(design: Design) -> (Before, Earlier) {
        let paths = paths(&design.analysis);
        let before = Before { paths, made: design.made, worked: design.worked };
        (before, Earlier::of(design.analysis))
    }

    /// What still says something of the new reading.
    fn kept(self, analysis: &Analysis) -> (Option<Made>, Vec<Diagnostic>) {
        let same_files = self.paths == paths(analysis);
        if same_files { (self.made, self.worked) } else { (self.made.map(Made::without_places), Vec::new()) }
    }
}

fn paths(analysis: &Analysis) -> Vec<String> {
    analysis.files.iter().map(|file| file.path.clone()).collect()
}

/// Whether two diagnostics say the same but for what would mend it.
fn is_same_failure(one: &Diagnostic, other: &Diagnostic) -> bool {
    let said = |of: &Diagnostic| (of.code, of.span, of.message.clone(), of.label.clone(), of.notes.clone());
    said(one) == said(other) && one.labels == other.labels
}

/// Whether a diagnostic is of those that are found last: what a machine cannot cut.
fn is_of_workshop(found: &Diagnostic) -> bool {
    matches!(found.code, Code::E0804 | Code::E0901)
}

/// The open documents that have been read.
pub(super) struct Designs {
    projects: Arc<dyn Projects>,
    names: Names,
    background: Background,
    discard: Discard,
    read: BTreeMap<PathBuf, Design>,
}

impl Designs {
    pub(super) fn new(
        projects: Arc<dyn Projects>,
        names: Names,
        background: Background,
        discard: Discard,
    ) -> Designs {
        Designs { projects, names, background, discard, read: BTreeMap::new() }
    }

    /// Forgets a design.
    pub(super) fn forget(&mut self, path: &Path) {
        self.background.forget(path);
        if let Some(design) = self.read.remove(path) {
            design.fresh.store(false, Ordering::Relaxed);
        }
    }

    /// Files may be others now: every design is read anew.
    pub(super) fn outdate_all(&mut self) {
        for (path, design) in &mut self.read {
            design.outdate();
            self.background.forget(path);
        }
    }

    /// A document has changed: designs that are made of it are read anew, and what was worked out of them moves.
    pub(super) fn edited(&mut self, path: &Path, edits: &[Edit]) {
        for (own, design) in &mut self.read {
            // What is wrong in an `ifs.toml` is asked of its designs.
            if is_project_file(own) && own != path && path.starts_with(&design.places.root) {
                design.outdate();
                continue;
            }
            let is_settings = is_project_file(path) && path.parent() == Some(&*design.places.root);
            let settings = project_file(&design.analysis).filter(|_| is_settings);
            let own_file = design.places.own_file(&design.analysis, path);
            let Some(file) = own_file.or(settings) else { continue };
            for edit in edits {
                design.worked.retain_mut(|diagnostic| moved_diagnostic(diagnostic, file, *edit));
                design.made.iter_mut().for_each(|made| made.edited(file, *edit));
            }
            design.outdate();
            self.background.forget(own);
            if own == path {
                design.fresh.store(false, Ordering::Relaxed);
            }
        }
    }

    /// Reads a design unless it is read as it is now. `None` where its path cannot be one.
    pub(super) fn read(&mut self, path: &Path, open: &Arc<Open>, revision: u64) -> Option<&Design> {
        if self.read.get(path).is_none_or(|design| design.read_at.is_none()) {
            let overlay = Overlay::of(&*self.projects, path, open)?;
            let (before, earlier) = self.read.remove(path).map(Before::of).unzip();
            let analysis = if is_project_file(path) {
                read_alone(&overlay, &*self.projects)
            } else {
                let Project { design, overrides, .. } = &overlay.project;
                let mut analysis = match earlier {
                    Some(earlier) => read_indexed_again(&overlay, design, overrides, earlier),
                    None => read_indexed(&overlay, design, overrides),
                };
                with_project_file(&mut analysis, &overlay);
                analysis
            };
            self.put(path, overlay, analysis, revision, before);
        }
        self.read.get(path)
    }

    fn put(
        &mut self,
        path: &Path,
        overlay: Overlay,
        analysis: Analysis,
        revision: u64,
        before: Option<Before>,
    ) {
        let analysis = Arc::new(analysis);
        let Project { root, overrides, .. } = overlay.project;
        let overrides = Arc::new(overrides);
        if !analysis.has_errors() && !is_project_file(path) {
            let (read, overrides) = (Arc::clone(&analysis), Arc::clone(&overrides));
            self.background.ask(path.to_owned(), Job { read, overrides, revision });
        }
        let (made, worked) = before.map_or((None, Vec::new()), |before| before.kept(&analysis));
        let design = Design {
            places: Places { root, projects: Arc::clone(&self.projects), names: self.names.clone() },
            analysis,
            overrides,
            read_at: Some(revision),
            fresh: Arc::new(AtomicBool::new(true)),
            made,
            worked,
        };
        self.read.insert(path.to_owned(), design);
    }

    /// What the background has found; it is of no use where the text has changed since. Whether it was of use.
    pub(super) fn worked(&mut self, path: &Path, worked: Worked) -> bool {
        let Some(design) = self.read.get_mut(path) else { return false };
        if design.read_at != Some(worked.revision) {
            return false;
        }
        let Worked { analysis, mended, .. } = worked;
        let read = &design.analysis.diagnostics;
        let found = mended.as_ref().unwrap_or(&analysis.diagnostics).iter();
        let found = found.filter(|found| !read.contains(found));
        let found = found.map(|found| with_worst_boards(found.clone(), &analysis));
        // What was known of remedies stays until it is known anew: nothing comes and goes while one types.
        let known = std::mem::take(&mut design.worked);
        let kept = |found: Diagnostic| match known.iter().find(|known| is_same_failure(known, &found)) {
            Some(known) if mended.is_none() => known.clone(),
            _ => found,
        };
        let mut worked: Vec<Diagnostic> = found.map(kept).collect();
        if mended.is_none() && !analysis.has_errors() {
            worked.extend(known.iter().filter(|known| is_of_workshop(known)).cloned());
        }
        let same = worked == known;
        design.worked = worked;
        if same && mended.is_some() {
            return false;
        }
        if analysis.plan.is_some() {
            let old = design.made.replace(Made::of(analysis));
            old.into_iter().for_each(|old| self.discard.put(old.analysis));
        }
        true
    }

    /// What is wrong, file by file; every open document is named.
    pub(super) fn wrong(&self, open: &Open) -> AllWrong {
        let named = |path: &PathBuf| {
            let version = open.get(path).map(|document| document.version);
            (path.clone(), Wrong { version, found: Vec::new() })
        };
        let mut wrong: AllWrong = open.keys().map(named).collect();
        for design in self.read.values() {
            let mut files: BTreeMap<FileId, Vec<Diagnostic>> = BTreeMap::new();
            for diagnostic in design.diagnostics() {
                files.entry(diagnostic.span.file).or_default().push(diagnostic);
            }
            for (file, diagnostics) in files {
                let Some(path) = design.places.path(&design.analysis, file) else { continue };
                let (places, analysis) = (design.places.clone(), Arc::clone(&design.analysis));
                wrong.entry(path).or_default().found.push(Found { places, analysis, diagnostics });
            }
        }
        wrong
    }
}
