//! The thread that owns the open documents. It takes messages in order; several changes that wait are read once.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

use tokio::sync::oneshot;

use super::background::{Background, Worked};
use super::designs::Designs;
use super::discard::Discard;
use super::documents::{Change, Document, Encoding};
use super::names::Names;
use super::outbox::{AllWrong, Outbox};
use super::overlay::Open;
use super::projects::Projects;
use super::snapshot::Snapshot;

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

/// Where an answer goes that comes with what is wrong in all files.
pub(crate) type ReplyWrong = oneshot::Sender<Result<(Snapshot, AllWrong), Refusal>>;

/// The open documents at one moment, and how often files on disk were said to be others before it.
#[derive(Clone, Debug)]
pub(crate) struct Moment {
    pub(crate) open: Arc<Open>,
    pub(crate) disk: u64,
    pub(crate) encoding: Encoding,
}

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
    /// What is known of a document, with what is wrong in all files.
    AskWrong {
        path: PathBuf,
        reply: ReplyWrong,
    },
    /// Which documents are open, with what is wrong in all files.
    AskAllWrong(oneshot::Sender<(Moment, AllWrong)>),
    /// Which documents are open.
    AskMoment(oneshot::Sender<Moment>),
    /// A design was worked out; none where that failed.
    Worked(PathBuf, Option<Worked>),
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

/// Starts the owner's thread, whose stack has so many bytes.
///
/// # Errors
/// The system has no thread left.
pub(crate) fn start(
    projects: Arc<dyn Projects>,
    names: Names,
    outbox: Outbox,
    stack: usize,
) -> std::io::Result<Sender<Message>> {
    let (sender, receiver) = channel();
    let background = Background::start(sender.clone(), outbox.working.clone(), stack)?;
    let owner = Owner {
        designs: Designs::new(projects, names, background.clone(), Discard::start(stack)?),
        outbox,
        background,
        encoding: Encoding::default(),
        open: Arc::default(),
        revision: 0,
        disk: 0,
        published: BTreeSet::new(),
    };
    thread::Builder::new().stack_size(stack).spawn(move || owner.run(&receiver))?;
    Ok(sender)
}

struct Owner {
    designs: Designs,
    outbox: Outbox,
    background: Background,
    encoding: Encoding,
    open: Arc<Open>,
    /// Grows with every change.
    revision: u64,
    /// Grows when files on disk change.
    disk: u64,
    /// Files of which something was said.
    published: BTreeSet<PathBuf>,
}

impl Owner {
    fn run(mut self, messages: &Receiver<Message>) {
        'all: while let Ok(first) = messages.recv() {
            let mut batch = vec![first];
            batch.extend(messages.try_iter());
            let mut last: BTreeMap<PathBuf, usize> = BTreeMap::new();
            for (at, message) in batch.iter().enumerate() {
                last.extend(message.changes().map(|path| (path.to_owned(), at)));
            }
            let mut changed = false;
            for (at, message) in batch.into_iter().enumerate() {
                match message {
                    Message::Stop => break 'all,
                    Message::Ask { path, reply } => {
                        let outdated = last.get(&path).is_some_and(|last| *last > at);
                        self.answer(reply, outdated, |owner| owner.snapshot(&path));
                    }
                    Message::AskWrong { path, reply } => {
                        let outdated = last.get(&path).is_some_and(|last| *last > at);
                        self.answer(reply, outdated, |owner| Ok((owner.snapshot(&path)?, owner.wrong())));
                    }
                    message => changed |= self.guarded(|owner| owner.take(message)).unwrap_or(true),
                }
            }
            if changed {
                self.guarded(Owner::refresh);
            }
        }
        self.background.stop();
    }

    /// Does something that may fail through a mistake of ours, and says so then.
    fn guarded<T>(&mut self, act: impl FnOnce(&mut Owner) -> T) -> Option<T> {
        let done = catch_unwind(AssertUnwindSafe(|| act(self)));
        if done.is_err() {
            self.fail("the server failed on a change; please report it with the file".to_owned());
        }
        done.ok()
    }

    fn fail(&self, words: String) {
        self.outbox.put(|news| news.failures.push(words));
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
                self.designs.forget(&path);
                self.put(path, None);
                true
            }
            Message::DiskChanged => {
                self.revision += 1;
                self.disk += 1;
                self.designs.outdate_all();
                self.outbox.put(|news| news.pull_again = true);
                true
            }
            Message::AskMoment(reply) => {
                // Who asked may have been cancelled.
                let _ = reply.send(self.moment());
                false
            }
            Message::AskAllWrong(reply) => {
                let _ = reply.send((self.moment(), self.wrong()));
                false
            }
            Message::Worked(path, worked) => self.worked(&path, worked),
            Message::Ask { .. } | Message::AskWrong { .. } | Message::Stop => false,
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
        self.designs.outdate_all();
    }

    fn change(&mut self, path: &Path, version: i32, changes: &[Change]) -> bool {
        let Some(document) = Arc::make_mut(&mut self.open).get_mut(path) else { return false };
        let document = Arc::make_mut(document);
        document.version = version;
        let edits: Vec<_> = changes.iter().map(|change| document.apply(change, self.encoding)).collect();
        self.revision += 1;
        self.designs.edited(path, &edits);
        true
    }

    fn answer<T>(
        &mut self,
        reply: oneshot::Sender<Result<T, Refusal>>,
        outdated: bool,
        find: impl FnOnce(&mut Owner) -> Result<T, Refusal>,
    ) {
        // A request that was cancelled meanwhile wants no answer.
        if reply.is_closed() {
            return;
        }
        let answer = if outdated { Err(Refusal::Outdated) } else { find(self) };
        let _ = reply.send(answer);
    }

    fn moment(&self) -> Moment {
        Moment { open: Arc::clone(&self.open), disk: self.disk, encoding: self.encoding }
    }

    fn snapshot(&mut self, path: &Path) -> Result<Snapshot, Refusal> {
        if !self.open.contains_key(path) {
            return Err(Refusal::Unknown);
        }
        let (open, revision, encoding) = (Arc::clone(&self.open), self.revision, self.encoding);
        self.guarded(|owner| {
            let design = owner.designs.read(path, &open, revision)?;
            Some(Snapshot {
                path: path.to_owned(),
                analysis: Arc::clone(&design.analysis),
                overrides: Arc::clone(&design.overrides),
                made: design.made.clone(),
                diagnostics: Arc::new(design.diagnostics()),
                places: design.places.clone(),
                open: Arc::clone(&open),
                encoding,
                fresh: Arc::clone(&design.fresh),
            })
        })
        .ok_or(Refusal::Failed)?
        .ok_or(Refusal::Unknown)
    }

    fn worked(&mut self, path: &Path, worked: Option<Worked>) -> bool {
        let Some(worked) = worked else {
            self.fail(format!("working out {} failed; please report it with the file", path.display()));
            return false;
        };
        let useful = self.designs.worked(path, worked);
        if useful {
            self.outbox.put(|news| news.pull_again = true);
        }
        useful
    }

    /// Reads what has changed and says what is wrong.
    fn refresh(&mut self) {
        let mut wrong = self.wrong();
        let said = wrong.keys().cloned().collect();
        for gone in std::mem::replace(&mut self.published, said) {
            wrong.entry(gone).or_default();
        }
        self.outbox.put(|news| news.wrong.extend(wrong));
    }

    /// What is wrong in all files, after what has changed was read.
    fn wrong(&mut self) -> AllWrong {
        let open = Arc::clone(&self.open);
        for path in open.keys() {
            let revision = self.revision;
            self.guarded(|owner| owner.designs.read(path, &open, revision).is_some());
        }
        self.designs.wrong(&open)
    }
}
