//! Working designs out beside the typing: one thread, newest text first, a moment after the last edit, and not to its end
//! where the text changes meanwhile.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use ifs_compiler::analysis::{Analysis, Watch, measure_watched, mended};
use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::outputs::workshop_faults;
use ifs_compiler::planarize::Progress;

use super::owner::Message;
use super::working::{Doing, Work, Working};

/// How long the text must rest before it is worked out, and how much longer for each KiB of it: a long one takes its time,
/// which should not be between two keystrokes.
const REST: Duration = Duration::from_millis(80);
const REST_PER_KIB: Duration = Duration::from_millis(1);

/// A design to be worked out, as it was read.
#[derive(Debug)]
pub(crate) struct Job {
    pub(crate) read: Arc<Analysis>,
    pub(crate) overrides: Arc<Overrides>,
    /// The revision of the world it was taken from.
    pub(crate) revision: u64,
}

impl Job {
    fn rest(&self) -> Duration {
        let texts = self.read.files.iter().filter_map(|file| self.read.sources.get(file.file));
        let bytes: usize = texts.map(|source| source.text.len()).sum();
        REST + REST_PER_KIB * u32::try_from(bytes / 1024).unwrap_or(u32::MAX).min(1000)
    }
}

/// A design worked out.
#[derive(Debug)]
pub(crate) struct Worked {
    pub(crate) revision: u64,
    /// Measured.
    pub(crate) analysis: Arc<Analysis>,
    /// What is wrong with it, with what would mend it; `None` while that is still looked for.
    pub(crate) mended: Option<Vec<Diagnostic>>,
}

#[derive(Default)]
struct Queue {
    jobs: BTreeMap<PathBuf, Job>,
    /// What is being worked out, and whether nobody wants it any more.
    running: Option<(PathBuf, Arc<AtomicBool>)>,
    stopped: bool,
}

impl Queue {
    fn newest(&self) -> Option<(&PathBuf, &Job)> {
        self.jobs.iter().max_by_key(|(_, job)| job.revision)
    }

    fn forget(&mut self, path: &Path) {
        self.jobs.remove(path);
        if let Some((_, unwanted)) = self.running.as_ref().filter(|(running, _)| running == path) {
            unwanted.store(true, Ordering::Relaxed);
        }
    }
}

/// Ends what nobody wants, and says what is done.
struct Unwanted {
    is: Arc<AtomicBool>,
    design: String,
    working: Working,
}

impl Unwanted {
    fn is(&self) -> bool {
        self.is.load(Ordering::Relaxed)
    }

    fn say(&self, doing: Doing) {
        self.working.set(Some(Work { design: self.design.clone(), doing }));
    }
}

impl Watch for Unwanted {
    fn planarizing(&mut self, figure: &str, progress: &Progress) -> ControlFlow<()> {
        self.say(Doing::Planarizing(figure.to_owned(), *progress));
        self.step()
    }

    fn planarized(&mut self, _: &str) {
        self.say(Doing::Measuring);
    }

    fn step(&mut self) -> ControlFlow<()> {
        if self.is() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// The owner's end of the work.
#[derive(Clone, Default)]
pub(crate) struct Background {
    queue: Arc<(Mutex<Queue>, Condvar)>,
    working: Working,
}

impl Background {
    /// Starts the thread; it tells the owner what it has worked out.
    pub(super) fn start(
        owner: Sender<Message>,
        working: Working,
        stack: usize,
    ) -> std::io::Result<Background> {
        let background = Background { working, ..Background::default() };
        let worker = background.clone();
        thread::Builder::new().stack_size(stack).spawn(move || worker.run(&owner))?;
        Ok(background)
    }

    /// A design to be worked out; an older text of it is forgotten.
    pub(crate) fn ask(&self, path: PathBuf, job: Job) {
        let mut queue = self.lock();
        queue.forget(&path);
        queue.jobs.insert(path, job);
        self.queue.1.notify_all();
    }

    /// A design that is not wanted any more as it was.
    pub(crate) fn forget(&self, path: &Path) {
        self.lock().forget(path);
        self.queue.1.notify_all();
    }

    pub(crate) fn stop(&self) {
        let mut queue = self.lock();
        queue.stopped = true;
        if let Some((_, unwanted)) = &queue.running {
            unwanted.store(true, Ordering::Relaxed);
        }
        self.queue.1.notify_all();
    }

    fn lock(&self) -> MutexGuard<'_, Queue> {
        self.queue.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn run(&self, owner: &Sender<Message>) {
        while let Some((path, job, unwanted)) = self.next() {
            let Job { read, overrides, revision } = job;
            let design =
                path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
            let mut watch = Unwanted { is: Arc::clone(&unwanted), design, working: self.working.clone() };
            watch.say(Doing::Measuring);
            let measure = || Arc::new(measure_watched((*read).clone(), &overrides, &mut watch));
            let measured = catch_unwind(AssertUnwindSafe(measure)).ok();
            let is_wanted = || !unwanted.load(Ordering::Relaxed);
            let worked = |analysis: &Arc<Analysis>, mended| Worked {
                revision,
                analysis: Arc::clone(analysis),
                mended,
            };
            // What was measured is told before it is looked for what would mend it.
            if let Some(measured) = measured.as_ref().filter(|_| is_wanted())
                && owner.send(Message::Worked(path.clone(), Some(worked(measured, None)))).is_err()
            {
                return;
            }
            let mend = |measured: &Arc<Analysis>| {
                watch.say(Doing::Mending);
                let mended = || {
                    let mut mended = mended(measured, &overrides, &mut watch);
                    watch.say(Doing::Cutting);
                    mended.extend(workshop_faults(measured, &mut watch));
                    mended
                };
                catch_unwind(AssertUnwindSafe(mended)).ok().map(|mended| worked(measured, Some(mended)))
            };
            let worked = measured.as_ref().filter(|_| is_wanted()).and_then(mend);
            self.lock().running = None;
            self.working.set(None);
            if is_wanted() && owner.send(Message::Worked(path, worked)).is_err() {
                return;
            }
        }
    }

    /// The next design, when nothing new has come for a moment; `None` at the end.
    fn next(&self) -> Option<(PathBuf, Job, Arc<AtomicBool>)> {
        let mut queue = self.lock();
        loop {
            if queue.stopped {
                return None;
            }
            let Some(rest) = queue.newest().map(|(_, job)| job.rest()) else {
                queue = self.queue.1.wait(queue).unwrap_or_else(PoisonError::into_inner);
                continue;
            };
            let waited = self.queue.1.wait_timeout(queue, rest).unwrap_or_else(PoisonError::into_inner);
            queue = waited.0;
            if !waited.1.timed_out() {
                continue;
            }
            let newest = queue.newest().map(|(path, _)| path.clone());
            if let Some((path, job)) = newest.and_then(|path| queue.jobs.remove_entry(&path)) {
                let unwanted = Arc::<AtomicBool>::default();
                queue.running = Some((path.clone(), Arc::clone(&unwanted)));
                return Some((path, job, unwanted));
            }
        }
    }
}
