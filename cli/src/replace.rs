//! Replacing one file in one step: a reader sees the old bytes or the new ones, and so does who comes after a crash.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// How many names are tried for the new file before it takes the place of the old one.
const NAMES: u32 = 100;

/// Puts `bytes` in the place of a file that is there, with its owner and permissions. Of a link, what it leads to is
/// replaced.
///
/// # Errors
/// It is no plain file or is write-protected, or the system refuses. The file is as it was then, and nothing lies beside
/// it.
pub(crate) fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let old = fs::metadata(path)?;
    if !old.is_file() {
        return Err(io::Error::other("it is no plain file"));
    }
    if old.permissions().readonly() {
        return Err(io::Error::other("it is write-protected"));
    }
    let path = fs::canonicalize(path)?;
    let (new, file) = beside(&path)?;
    let replaced = fill(file, bytes, &old).and_then(|()| fs::rename(&new, &path));
    if replaced.is_err() {
        // If this fails too, the first error is the one to tell.
        let _ = fs::remove_file(&new);
    }
    replaced
}

/// A new file in the same folder.
fn beside(path: &Path) -> io::Result<(PathBuf, File)> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let mut taken = io::Error::other("no name is free beside it");
    for number in 0..NAMES {
        let new = path.with_file_name(format!(".{name}.ifs-fmt-{}-{number}", std::process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&new) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => taken = error,
            opened => return opened.map(|file| (new, file)),
        }
    }
    Err(taken)
}

fn fill(mut file: File, bytes: &[u8], old: &Metadata) -> io::Result<()> {
    keep_owner(&file, old);
    file.set_permissions(old.permissions())?;
    file.write_all(bytes)?;
    file.sync_all()
}

/// Only the superuser may give a file away; everybody else's new file is their own.
#[cfg(unix)]
fn keep_owner(file: &File, old: &Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let _ = fchown(file, Some(old.uid()), Some(old.gid()));
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &Metadata) {}
