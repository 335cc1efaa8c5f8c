//! Working designs out beside the typing: one thread, newest text first, a moment after the last edit.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use ifs_compiler::analysis::{Analysis, analyse};

use super::overlay::Overlay;
use super::owner::Message;

/// How long the text must rest before it is worked out.
const REST: Duration = Duration::from_millis(80);

/// A design to be worked out.
#[derive(Debug)]
pub(crate) struct Job {
    pub(crate) overlay: Overlay,
    /// The revision of the world it was taken from.
    pub(crate) revision: u64,
}

/// A design worked out; none where that went wrong.
#[derive(Debug)]
pub(crate) struct Worked {
    pub(crate) path: PathBuf,
    pub(crate) revision: u64,
    pub(crate) analysis: Option<Arc<Analysis>>,
}

#[derive(Default)]
struct Queue {
    jobs: BTreeMap<PathBuf, Job>,
    stopped: bool,
}

/// The thread's end of the work.
#[derive(Clone, Default)]
pub(crate) struct Background {
    queue: Arc<(Mutex<Queue>, Condvar)>,
}

impl Background {
    /// Starts the thread; it tells the owner what it has worked out.
    pub(crate) fn start(owner: Sender<Message>) -> Background {
        let background = Background::default();
        let worker = background.clone();
        thread::spawn(move || worker.run(&owner));
        background
    }

    /// A design to be worked out; an older text of it is forgotten.
    pub(crate) fn ask(&self, path: PathBuf, job: Job) {
        self.lock().jobs.insert(path, job);
        self.queue.1.notify_all();
    }

    /// A design that is not wanted any more.
    pub(crate) fn forget(&self, path: &PathBuf) {
        self.lock().jobs.remove(path);
    }

    pub(crate) fn stop(&self) {
        self.lock().stopped = true;
        self.queue.1.notify_all();
    }

    fn lock(&self) -> MutexGuard<'_, Queue> {
        self.queue.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn run(&self, owner: &Sender<Message>) {
        while let Some((path, job)) = self.next() {
            let overlay = &job.overlay;
            let work = || analyse(overlay, &overlay.project.design, &overlay.project.overrides);
            let analysis = catch_unwind(AssertUnwindSafe(work)).ok().map(Arc::new);
            let worked = Worked { path, revision: job.revision, analysis };
            if owner.send(Message::Worked(worked)).is_err() {
                return;
            }
        }
    }

    /// The next design, when nothing new has come for a moment; `None` at the end.
    fn next(&self) -> Option<(PathBuf, Job)> {
        let mut queue = self.lock();
        loop {
            if queue.stopped {
                return None;
            }
            let Some(newest) = queue.jobs.values().map(|job| job.revision).max() else {
                queue = self.queue.1.wait(queue).unwrap_or_else(PoisonError::into_inner);
                continue;
            };
            let waited = self.queue.1.wait_timeout(queue, REST).unwrap_or_else(PoisonError::into_inner);
            queue = waited.0;
            if waited.1.timed_out() {
                let path = queue
                    .jobs
                    .iter()
                    .find(|(_, job)| job.revision == newest)
                    .map(|(path, _)| path.clone())?;
                return queue.jobs.remove_entry(&path);
            }
        }
    }
}
