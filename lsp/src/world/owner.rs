//! The thread that owns the open documents. It takes messages in order, reads designs when they are asked for or changed,
//! publishes what is wrong with them, and has them worked out in the background.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

use ifs_compiler::analysis::{Analysis, read_indexed};
use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::source::FileId;
use tokio::sync::{mpsc, oneshot};

use super::background::{Background, Job, Worked};
use super::documents::{Change, Document, Encoding};
use super::edits::moved_diagnostic;
use super::overlay::{Open, Overlay};
use super::places::Places;
use super::projects::Projects;
use super::snapshot::{Made, Snapshot};

/// Why there is no snapshot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// The document is not open.
    Unknown,
    /// The document has changed since.
    Outdated,
    /// The compiler failed on it, which is a mistake of ours.
    Failed,
}

/// Where an answer goes.
pub(crate) type Reply = oneshot::Sender<Result<Snapshot, Refusal>>;

/// What the owner is told or asked.
pub(crate) enum Message {
    Encoding(Encoding),
    Open {
        path: PathBuf,
        text: String,
        version: i32,
    },
    Change {
        path: PathBuf,
        version: i32,
        changes: Vec<Change>,
    },
    Close {
        path: PathBuf,
    },
    /// Files on disk are others now.
    DiskChanged,
    /// What is known of a document, as it is when this is met.
    Ask {
        path: PathBuf,
        reply: Reply,
    },
    Worked(Worked),
    Stop,
}

impl Message {
    /// The document that it changes.
    fn changes(&self) -> Option<&Path> {
        match self {
            Message::Open { path, .. } | Message::Change { path, .. } | Message::Close { path } => Some(path),
            _ => None,
        }
    }
}

/// The folder of a project, one of its designs, and what is wrong in one file as far as this design says.
pub(crate) type Found = (PathBuf, Arc<Analysis>, Vec<Diagnostic>);

/// What the client is to be told, in order.
pub(crate) enum Outgoing {
    /// What is wrong in a file, as far as its designs say.
    Diagnostics { path: PathBuf, version: Option<i32>, found: Vec<Found> },
    /// Designs were worked out: what was said of them may be more now.
    Worked,
    /// A mistake of ours.
    Failed(String),
}

/// Starts the owner's thread.
pub(crate) fn start(projects: Arc<dyn Projects>, out: mpsc::UnboundedSender<Outgoing>) -> Sender<Message> {
    let (sender, receiver) = channel();
    let background = Background::start(sender.clone());
    let owner = Owner {
        projects,
        out,
        background,
        encoding: Encoding::default(),
        open: Arc::default(),
        revision: 0,
        designs: BTreeMap::new(),
        published: BTreeSet::new(),
    };
    thread::spawn(move || owner.run(&receiver));
    sender
}

/// What is known of an open document as a design.
struct Design {
    places: Places,
    analysis: Arc<Analysis>,
    /// The revision it was last changed at.
    revision: u64,
    made: Option<Made>,
    /// What was found by working it out that reading it did not find, moved with the edits since.
    worked: Vec<Diagnostic>,
}

impl Design {
    fn diagnostics(&self) -> Vec<Diagnostic> {
        let mut all = self.analysis.diagnostics.clone();
        if !self.analysis.has_errors() {
            all.extend(self.worked.iter().cloned());
            all.sort_by_key(|diagnostic| (diagnostic.span.file, diagnostic.span.start));
        }
        all
    }
}

struct Owner {
    projects: Arc<dyn Projects>,
    out: mpsc::UnboundedSender<Outgoing>,
    background: Background,
    encoding: Encoding,
    open: Arc<Open>,
    revision: u64,
    /// Open documents that have been read since they last changed.
    designs: BTreeMap<PathBuf, Design>,
    /// Files of which something was said to be wrong.
    published: BTreeSet<PathBuf>,
}

impl Owner {
    fn run(mut self, messages: &Receiver<Message>) {
        while let Ok(first) = messages.recv() {
            let mut batch = vec![first];
            batch.extend(messages.try_iter());
            if batch.iter().any(|message| matches!(message, Message::Stop)) {
                break;
            }
            let mut changed = false;
            let last: BTreeMap<PathBuf, usize> = batch
                .iter()
                .enumerate()
                .filter_map(|(at, message)| Some((message.changes()?.to_owned(), at)))
                .collect();
            for (at, message) in batch.into_iter().enumerate() {
                match message {
                    Message::Ask { path, reply } => {
                        let outdated = last.get(&path).is_some_and(|last| *last > at);
                        self.answer(&path, reply, outdated);
                    }
                    message => changed |= self.take(message),
                }
            }
            if changed {
                self.refresh();
            }
        }
        self.background.stop();
    }

    /// Whether anything has to be said anew.
    fn take(&mut self, message: Message) -> bool {
        match message {
            Message::Encoding(encoding) => {
                self.encoding = encoding;
                false
            }
            Message::Open { path, text, version } => {
                self.put(path, Some(Arc::new(Document::new(text, version))));
                true
            }
            Message::Change { path, version, changes } => self.change(&path, version, &changes),
            Message::Close { path } => {
                self.background.forget(&path);
                self.designs.remove(&path);
                self.put(path, None);
                true
            }
            Message::DiskChanged => {
                self.revision += 1;
                self.outdate(|_, _| true);
                true
            }
            Message::Worked(worked) => self.worked(worked),
            Message::Ask { .. } | Message::Stop => false,
        }
    }

    /// Opens, replaces or closes a document; who read it from elsewhere reads anew.
    fn put(&mut self, path: PathBuf, document: Option<Arc<Document>>) {
        self.revision += 1;
        let open = Arc::make_mut(&mut self.open);
        match document {
            Some(document) => open.insert(path, document),
            None => open.remove(&path),
        };
        self.outdate(|_, _| true);
    }

    fn change(&mut self, path: &Path, version: i32, changes: &[Change]) -> bool {
        let Some(document) = Arc::make_mut(&mut self.open).get_mut(path) else { return false };
        let document = Arc::make_mut(document);
        document.version = version;
        let edits: Vec<_> = changes.iter().map(|change| document.apply(change, self.encoding)).collect();
        self.revision += 1;
        for design in self.designs.values_mut() {
            let Some(file) = design.places.file(&design.analysis, path) else { continue };
            for edit in &edits {
                design.worked.iter_mut().for_each(|diagnostic| moved_diagnostic(diagnostic, file, *edit));
            }
        }
        self.outdate(|places, analysis| places.file(analysis, path).is_some());
        true
    }

    /// Marks designs as changed.
    fn outdate(&mut self, which: impl Fn(&Places, &Analysis) -> bool) {
        for design in self.designs.values_mut() {
            if which(&design.places, &design.analysis) {
                design.revision = 0;
                if let Some(made) = &mut design.made {
                    made.current = false;
                }
            }
        }
    }

    fn overlay(&self, path: &Path) -> Option<Overlay> {
        let project = self.projects.project(path)?;
        Some(Overlay { project, open: Arc::clone(&self.open) })
    }

    /// Reads a design unless it is read as it is now.
    fn ensure_read(&mut self, path: &Path) -> Result<(), Refusal> {
        if self.designs.get(path).is_some_and(|design| design.revision != 0) {
            return Ok(());
        }
        if !self.open.contains_key(path) {
            return Err(Refusal::Unknown);
        }
        let overlay = self.overlay(path).ok_or(Refusal::Unknown)?;
        let work = || read_indexed(&overlay, &overlay.project.design, &overlay.project.overrides);
        let Ok(analysis) = catch_unwind(AssertUnwindSafe(work)) else {
            let failed = format!("the compiler failed on {}; please report it with the file", path.display());
            let _ = self.out.send(Outgoing::Failed(failed));
            return Err(Refusal::Failed);
        };
        let old = self.designs.remove(path);
        let same_files = |old: &Design| {
            old.analysis.files.len() == analysis.files.len()
                && old.analysis.files.iter().zip(&analysis.files).all(|(a, b)| a.path == b.path)
        };
        let kept = old.as_ref().is_some_and(same_files);
        let (made, worked) = old.map_or((None, Vec::new()), |old| (old.made, old.worked));
        let worked = if kept { worked } else { Vec::new() };
        if !analysis.has_errors() {
            self.background.ask(path.to_owned(), Job { overlay: overlay.clone(), revision: self.revision });
        }
        let places = Places { root: overlay.project.root, projects: Arc::clone(&self.projects) };
        let design = Design { places, analysis: Arc::new(analysis), revision: self.revision, made, worked };
        self.designs.insert(path.to_owned(), design);
        Ok(())
    }

    fn answer(&mut self, path: &Path, reply: Reply, outdated: bool) {
        if reply.is_closed() {
            return;
        }
        let answer = if outdated { Err(Refusal::Outdated) } else { self.snapshot(path) };
        // A request that was cancelled meanwhile wants none.
        let _ = reply.send(answer);
    }

    fn snapshot(&mut self, path: &Path) -> Result<Snapshot, Refusal> {
        self.ensure_read(path)?;
        let design = self.designs.get(path).ok_or(Refusal::Unknown)?;
        Ok(Snapshot {
            path: path.to_owned(),
            analysis: Arc::clone(&design.analysis),
            made: design.made.clone(),
            diagnostics: Arc::new(design.diagnostics()),
            places: design.places.clone(),
            open: Arc::clone(&self.open),
            encoding: self.encoding,
        })
    }

    /// What the background has found; it is of no use where the text has changed since.
    fn worked(&mut self, worked: Worked) -> bool {
        let Some(design) = self.designs.get_mut(&worked.path) else { return false };
        if design.revision != worked.revision {
            return false;
        }
        let Some(analysis) = worked.analysis else {
            let failed =
                format!("working out {} failed; please report it with the file", worked.path.display());
            let _ = self.out.send(Outgoing::Failed(failed));
            return false;
        };
        let read = &design.analysis.diagnostics;
        design.worked = analysis.diagnostics.iter().filter(|found| !read.contains(found)).cloned().collect();
        if analysis.plan.is_some() {
            design.made = Some(Made { analysis, current: true });
        }
        let _ = self.out.send(Outgoing::Worked);
        true
    }

    /// Reads what has changed and says what is wrong.
    fn refresh(&mut self) {
        let open: Vec<PathBuf> = self.open.keys().cloned().collect();
        for path in &open {
            let _ = self.ensure_read(path);
        }
        let mut wrong: BTreeMap<PathBuf, Vec<Found>> =
            open.into_iter().map(|path| (path, Vec::new())).collect();
        for design in self.designs.values() {
            let mut files: BTreeMap<FileId, Vec<Diagnostic>> = BTreeMap::new();
            for diagnostic in design.diagnostics() {
                files.entry(diagnostic.span.file).or_default().push(diagnostic);
            }
            for (file, found) in files {
                let Some(path) = design.places.path(&design.analysis, file) else { continue };
                let root = design.places.root.clone();
                wrong.entry(path).or_default().push((root, Arc::clone(&design.analysis), found));
            }
        }
        let gone: Vec<PathBuf> =
            self.published.iter().filter(|path| !wrong.contains_key(*path)).cloned().collect();
        self.published = wrong.keys().cloned().collect();
        for path in gone {
            let _ = self.out.send(Outgoing::Diagnostics { path, version: None, found: Vec::new() });
        }
        for (path, found) in wrong {
            let version = self.open.get(&path).map(|document| document.version);
            let _ = self.out.send(Outgoing::Diagnostics { path, version, found });
        }
    }
}
