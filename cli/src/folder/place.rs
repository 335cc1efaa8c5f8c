//! Where things lie: the target with links resolved, and the names beside it.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::FolderError;
use ifs_compiler::outputs::names::hex;

/// The target and its companions, all in one folder and so on one file system.
#[derive(Debug, Clone)]
pub(super) struct Place {
    /// The output folder, absolute and without links.
    pub(super) target: PathBuf,
    /// The folder it lies in.
    pub(super) parent: PathBuf,
    /// The lock file.
    pub(super) lock: PathBuf,
    /// The new set in the making.
    pub(super) staging: PathBuf,
    /// The old set, while it is being replaced without an exchange.
    pub(super) old: PathBuf,
    /// The note that the new set is complete.
    pub(super) journal: PathBuf,
}

impl Place {
    /// Resolves a target as given by a person; makes its missing parent folders.
    pub(super) fn resolve(target: &Path) -> Result<Place, FolderError> {
        let target = absolute(target)?;
        match fs::metadata(&target) {
            Ok(found) if !found.is_dir() => return Err(FolderError::NotAFolder(target)),
            Ok(_) => refuse_working_folder(&target)?,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(FolderError::io("look at the output folder", &target)(error)),
        }
        let (Some(parent), Some(name)) = (target.parent(), target.file_name()) else {
            return Err(FolderError::NoName(target));
        };
        let beside = |suffix: &str| parent.join(companion(name, suffix));
        Ok(Place {
            lock: beside("lock"),
            staging: beside("staging"),
            old: beside("old"),
            journal: beside("journal"),
            parent: parent.to_path_buf(),
            target,
        })
    }
}

/// The target without links: of itself where it exists, else of its parent, which is made.
fn absolute(target: &Path) -> Result<PathBuf, FolderError> {
    match fs::symlink_metadata(target) {
        // Also `.` and `..`, which have no name of their own, and links. A link that leads nowhere is an error here.
        Ok(_) => return fs::canonicalize(target).map_err(FolderError::io("follow", target)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) => return Err(FolderError::io("look at the output folder", target)(error)),
    }
    let Some(name) = target.file_name() else {
        return Err(FolderError::NoName(target.to_path_buf()));
    };
    let parent = match target.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    fs::create_dir_all(parent).map_err(FolderError::io("make the folder", parent))?;
    let parent = fs::canonicalize(parent).map_err(FolderError::io("follow", parent))?;
    Ok(parent.join(name))
}

/// Refuses a target that is the working folder or above it.
fn refuse_working_folder(target: &Path) -> Result<(), FolderError> {
    match std::env::current_dir().and_then(fs::canonicalize) {
        Ok(working) if working.starts_with(target) => {
            Err(FolderError::HoldsWorkingFolder(target.to_path_buf()))
        }
        // A working folder that no longer exists is not inside the target.
        _ => Ok(()),
    }
}

/// The hidden name beside a target. A target whose name is too long for it is named by its hash.
fn companion(name: &OsStr, suffix: &str) -> OsString {
    let mut hidden = OsString::from(".");
    if name.len() <= 200 {
        hidden.push(name);
    } else {
        hidden.push(hex(&Sha256::digest(name.as_encoded_bytes())));
    }
    hidden.push(".ifs-");
    hidden.push(suffix);
    hidden
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn companions_are_hidden_and_of_one_target() {
        assert_eq!(companion(OsStr::new("shell"), "lock"), ".shell.ifs-lock");
        let long = "x".repeat(255);
        let name = companion(OsStr::new(&long), "staging");
        assert!(name.len() < 100);
        assert_ne!(name, companion(OsStr::new(&format!("{}y", &long[1..])), "staging"));
    }

    #[test]
    fn the_root_and_the_working_folder_are_refused() {
        assert!(matches!(Place::resolve(Path::new("/")), Err(FolderError::HoldsWorkingFolder(_))));
        assert!(matches!(Place::resolve(Path::new(".")), Err(FolderError::HoldsWorkingFolder(_))));
        assert!(matches!(Place::resolve(Path::new("..")), Err(FolderError::HoldsWorkingFolder(_))));
    }
}
