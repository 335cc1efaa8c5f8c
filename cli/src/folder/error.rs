//! What can go wrong with the output folder: what was being done, to which path, and why it failed.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// A failure of the output folder. The folder still holds the old set.
#[derive(Debug)]
pub enum FolderError {
    /// The operating system refused.
    Io {
        /// What was being done, as in "could not …".
        doing: &'static str,
        /// What it was being done to.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The target exists and is no folder.
    NotAFolder(PathBuf),
    /// The target has no name that could stand beside it (the root of a file system).
    NoName(PathBuf),
    /// The target holds the folder the process works in, which would vanish under it.
    HoldsWorkingFolder(PathBuf),
    /// A file of the new set would replace one that no earlier build wrote.
    ForeignInTheWay(PathBuf),
    /// The target holds a `manifest.json` that no build of ifs wrote, or one that is damaged.
    NotOurManifest {
        /// The manifest.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A name that may not stand in an output folder.
    BadName {
        /// The name as asked for.
        name: String,
        /// The rule it breaks.
        reason: &'static str,
    },
    /// A name was written twice.
    Duplicate(String),
    /// The making of the set was given up because its caller said so.
    Stopped,
}

impl FolderError {
    /// Wraps a system error with what was being done to which path.
    pub(super) fn io(doing: &'static str, path: &Path) -> impl FnOnce(io::Error) -> FolderError {
        let path = path.to_path_buf();
        move |source| FolderError::Io { doing, path, source }
    }
}

impl fmt::Display for FolderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FolderError::Io { doing, path, source } => {
                write!(f, "could not {doing} {}: {source}", path.display())?;
                if source.kind() == io::ErrorKind::StorageFull {
                    write!(f, "; the earlier outputs are untouched")?;
                }
                Ok(())
            }
            FolderError::NotAFolder(path) => {
                write!(f, "the output folder {} exists and is not a folder", path.display())
            }
            FolderError::NoName(path) => {
                write!(f, "{} cannot be an output folder: choose a folder inside another", path.display())
            }
            FolderError::HoldsWorkingFolder(path) => {
                write!(
                    f,
                    "the output folder {} holds the working folder and would be replaced under it: \
                     choose a folder of its own, or run from outside it",
                    path.display()
                )
            }
            FolderError::ForeignInTheWay(path) => {
                write!(
                    f,
                    "{} was not written by an earlier build and would be overwritten: move it, or choose another folder",
                    path.display()
                )
            }
            FolderError::NotOurManifest { path, reason } => {
                write!(
                    f,
                    "{} is not the manifest of an earlier build ({reason}): move it, or choose another folder",
                    path.display()
                )
            }
            FolderError::BadName { name, reason } => {
                write!(f, "the output name {name:?} is refused: {reason}")
            }
            FolderError::Duplicate(name) => write!(f, "the output {name:?} was written twice"),
            FolderError::Stopped => write!(f, "the outputs were given up; the earlier ones are untouched"),
        }
    }
}

impl std::error::Error for FolderError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            FolderError::Io { source, .. } => Some(source),
            _ => None,
        }
    }
}
