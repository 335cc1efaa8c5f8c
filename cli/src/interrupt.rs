//! Ctrl-C and a plain `kill` during a build. While nothing is being written the program ends at once: a build keeps
//! nothing on the disk before its outputs are made. While the set is written whoever writes it is asked to stop, removes
//! what was begun, and ends; once the new set is in place it is too late, and the build is complete. So the exit code
//! [`Exit::Interrupted`] means always that the output folder is as it was.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::Signals;

use crate::exit::Exit;
use crate::output;
use crate::progress;

/// What is said at the end.
const SAID: &str = "interrupted: nothing was written\n";

static ASKED: AtomicBool = AtomicBool::new(false);
static STAGE: Mutex<Stage> = Mutex::new(Stage::Working);

/// How far the build is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// Nothing is on the disk.
    Working,
    /// The set is in the making.
    Writing,
    /// The set is in place, and this is how the program ends.
    Done(Exit),
}

/// From now on SIGINT and SIGTERM end the program in good order. Where the system has no signals to be listened to
/// they end it as they always did.
pub fn listen() {
    let Ok(mut signals) = Signals::new([SIGINT, SIGTERM]) else { return };
    std::thread::spawn(move || signals.forever().for_each(|_| end()));
}

/// Whether the program was asked to stop.
pub fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}

/// Says that a build stopped because it was asked to, and how the program should end.
pub fn stopped() -> Exit {
    output::message(SAID);
    Exit::Interrupted
}

fn end() {
    ASKED.store(true, Ordering::SeqCst);
    let stage = stage();
    match *stage {
        // The stage stays locked, so that nobody begins to write any more.
        Stage::Working => std::process::exit(stopped() as i32),
        Stage::Writing => {}
        Stage::Done(exit) => {
            progress::hide();
            std::process::exit(exit as i32)
        }
    }
}

fn stage() -> MutexGuard<'static, Stage> {
    STAGE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// While this lives the program does not end at a signal, but expects that [`asked`] is asked often.
#[derive(Debug)]
pub struct Writing(());

impl Writing {
    /// Begins to write.
    pub fn begin() -> Writing {
        *stage() = Stage::Writing;
        Writing(())
    }

    /// Says that the set is in place, and how the program ends for what was found.
    pub fn done(self, exit: Exit) {
        *stage() = Stage::Done(exit);
        std::mem::forget(self);
    }
}

impl Drop for Writing {
    fn drop(&mut self) {
        *stage() = Stage::Working;
    }
}
