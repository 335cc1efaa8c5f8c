//! The output folder: all of a build's files or none of them.
//!
//! Files are made in a staging folder beside the target, flushed, listed in `manifest.json`, and the two folders are
//! exchanged in one step. A process killed at any moment leaves the old set or the new one. What a killed build left
//! behind is cleaned by the next one, under a lock that lies beside the folder.
//!
//! Beside a target `out/shell` there may lie, while a build runs or after one was killed:
//!
//! | name | what |
//! |---|---|
//! | `.shell.ifs-lock` | the lock; a second build waits for it |
//! | `.shell.ifs-staging` | the new set in the making; after an exchange, the old set until it is removed |
//! | `.shell.ifs-old`, `.shell.ifs-journal` | only where the system has no exchange of names: the old set, and the note that the new one is complete |
//!
//! What is not here: what the files contain, and the exit codes (every [`FolderError`] is an input/output failure).

mod error;
mod foreign;
mod hashed;
mod keep;
mod lock;
mod manifest;
mod names;
mod place;
mod replace;
mod staging;

use std::path::Path;
use std::time::Duration;

pub use error::FolderError;
pub use manifest::{FileRecord, LeftOutRecord, Manifest, Provenance, SourceRecord, verify};
pub use replace::Exchange;
pub use staging::{Committed, Staging};

use lock::Lock;
use place::Place;

/// How a set is made: by which way of replacing, and when it is given up.
#[derive(Debug, Clone, Copy)]
pub struct Making {
    /// How the new set takes the place of the old one.
    pub exchange: Exchange,
    /// Asked again and again until the new set takes its place; where it says yes the making ends with
    /// [`FolderError::Stopped`], and leaves no trace.
    pub stop: fn() -> bool,
}

impl Default for Making {
    fn default() -> Making {
        Making { exchange: Exchange::System, stop: || false }
    }
}

/// How long a build sleeps between two looks at the lock of another.
const WAIT: Duration = Duration::from_millis(50);

/// The way into the room: where a set of outputs begins.
#[derive(Debug, Clone, Copy)]
pub struct OutputFolder;

impl OutputFolder {
    /// Opens a staging folder for `target`, after waiting for any other build of the same target and after mending
    /// what a killed one left. Missing parent folders of the target are made; a target that is a symbolic link is
    /// followed.
    ///
    /// # Errors
    /// The target is no folder, has no name, holds the working folder, its `manifest.json` is somebody else's, or the
    /// system refuses (read-only, full, no permission). Nothing was changed then.
    pub fn stage(target: &Path) -> Result<Staging, FolderError> {
        Self::stage_with(target, Making::default(), &mut || ())
    }

    /// As [`OutputFolder::stage`], with the way of replacing chosen, with a way to stop, and `waiting` called once before the process
    /// waits for another build (so that a person can be told).
    ///
    /// # Errors
    /// As [`OutputFolder::stage`].
    pub fn stage_with(
        target: &Path,
        making: Making,
        waiting: &mut dyn FnMut(),
    ) -> Result<Staging, FolderError> {
        let place = Place::resolve(target)?;
        let lock = Lock::take(&place.lock, making.stop, waiting)?;
        replace::recover(&place)?;
        Staging::open(place, lock, making)
    }

    /// Finishes or rolls back what a killed build left beside `target`, for commands that read the folder. Nothing
    /// happens when nothing is left. Waits for a running build.
    ///
    /// # Errors
    /// As [`OutputFolder::stage`].
    pub fn recover(target: &Path) -> Result<(), FolderError> {
        let place = Place::resolve(target)?;
        if !replace::is_unfinished(&place) {
            return Ok(());
        }
        let _lock = Lock::take(&place.lock, Making::default().stop, &mut || ())?;
        replace::recover(&place)
    }
}
