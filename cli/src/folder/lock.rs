//! The lock beside the output folder: one build at a time, freed by the system when its process ends.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};

use super::{FolderError, WAIT};

/// A lock held. Dropping it removes the file and lets the next build in.
#[derive(Debug)]
pub(super) struct Lock {
    path: PathBuf,
    /// Holds the lock as long as it is open.
    _file: File,
}

impl Lock {
    /// Takes the lock, waiting for whoever holds it until `stop` says yes; `waiting` is called once before.
    pub(super) fn take(
        path: &Path,
        stop: fn() -> bool,
        waiting: &mut dyn FnMut(),
    ) -> Result<Lock, FolderError> {
        let mut told = false;
        loop {
            let file = OpenOptions::new()
                .write(true)
                .create(true)
                .truncate(false)
                .open(path)
                .map_err(FolderError::io("make the lock", path))?;
            match file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => {
                    if !told {
                        waiting();
                        told = true;
                    }
                    if stop() {
                        return Err(FolderError::Stopped);
                    }
                    // The system's own waiting cannot be given up.
                    std::thread::sleep(WAIT);
                    continue;
                }
                Err(TryLockError::Error(error)) => {
                    return Err(FolderError::io("take the lock", path)(error));
                }
            }
            // The one we waited for has removed the file: a lock on what has no name keeps nobody out.
            if is_the_file_at(&file, path).map_err(FolderError::io("look at the lock", path))? {
                return Ok(Lock { path: path.to_path_buf(), _file: file });
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Removed while still locked. If it stays it is only a file: the next build takes it.
        let _ = fs::remove_file(&self.path);
    }
}

/// Whether the open file is still the one that has this name.
fn is_the_file_at(file: &File, path: &Path) -> io::Result<bool> {
    let open = file.metadata()?;
    match fs::symlink_metadata(path) {
        Ok(named) => Ok(open.dev() == named.dev() && open.ino() == named.ino()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}
