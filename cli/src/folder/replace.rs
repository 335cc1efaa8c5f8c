//! The one step in which the new set takes the place of the old one, and the mending of what a killed build left.
//!
//! Where the system can exchange two names at once there is no moment without a set. Where it cannot, a journal says
//! that the new set is complete; between its two renames a kill leaves no target, and the next command finishes.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

use super::manifest::verify;
use super::place::Place;
use super::staging::flush_folder;
use super::{FolderError, foreign};

/// How the new set takes the place of the old one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exchange {
    /// By the system's exchange of two names, and by the journal where it has none.
    System,
    /// By the journal, as on a file system without an exchange.
    Journal,
}

/// Puts the staging folder in the target's place. On an error the target holds the old set, or [`recover`] will put
/// it there.
pub(super) fn replace(place: &Place, exchange: Exchange) -> Result<(), FolderError> {
    let failed = |error| FolderError::io("put the outputs in place at", &place.target)(error);
    if fs::symlink_metadata(&place.target).is_err() {
        return fs::rename(&place.staging, &place.target).map_err(failed);
    }
    if exchange == Exchange::System {
        match exchange_names(&place.staging, &place.target) {
            Err(error) if cannot_exchange(&error) => {}
            done => return done.map_err(failed),
        }
    }
    write_journal(place).map_err(FolderError::io("write", &place.journal))?;
    flush_folder(&place.parent)?;
    fs::rename(&place.target, &place.old).map_err(failed)?;
    if let Err(error) = fs::rename(&place.staging, &place.target) {
        fs::rename(&place.old, &place.target).map_err(failed)?;
        return Err(failed(error));
    }
    flush_folder(&place.parent)?;
    fs::remove_file(&place.journal).map_err(FolderError::io("remove", &place.journal))
}

/// Whether anything lies beside the target that a build makes and a finished build does not leave.
pub(super) fn is_unfinished(place: &Place) -> bool {
    [&place.journal, &place.staging, &place.old].into_iter().any(|path| path.symlink_metadata().is_ok())
}

/// Finishes a replacing that was cut off, or rolls it back, and sweeps up. The lock is held.
pub(super) fn recover(place: &Place) -> Result<(), FolderError> {
    if place.journal.symlink_metadata().is_ok() {
        if place.target.symlink_metadata().is_err() {
            let complete = verify(&place.staging).is_ok_and(|differences| differences.is_empty());
            let set = if complete { &place.staging } else { &place.old };
            if set.is_dir() {
                fs::rename(set, &place.target)
                    .map_err(FolderError::io("finish an earlier build at", &place.target))?;
            }
        }
        flush_folder(&place.parent)?;
        fs::remove_file(&place.journal).map_err(FolderError::io("remove", &place.journal))?;
    }
    sweep(place)
}

/// Removes what lies beside the target, once it is certain that the target is on the disk and has all that is not
/// ours. The lock is held.
pub(super) fn sweep(place: &Place) -> Result<(), FolderError> {
    flush_folder(&place.parent)?;
    for leftover in [&place.staging, &place.old] {
        if leftover.symlink_metadata().is_ok() {
            foreign::rescue(leftover, &place.target)?;
            remove_tree(leftover).map_err(FolderError::io("remove", leftover))?;
        }
    }
    Ok(())
}

/// Says that the new set is complete.
fn write_journal(place: &Place) -> io::Result<()> {
    let mut journal = File::create(&place.journal)?;
    journal.write_all(b"the set in the staging folder is complete and takes the target's place\n")?;
    journal.sync_all()
}

/// Removes a folder with all in it; folders in it which may not be changed are made changeable first.
fn remove_tree(folder: &Path) -> io::Result<()> {
    match fs::remove_dir_all(folder) {
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            make_changeable(folder)?;
            fs::remove_dir_all(folder)
        }
        done => done,
    }
}

/// Gives the owner all rights on a folder and the folders in it.
fn make_changeable(folder: &Path) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(folder, fs::Permissions::from_mode(0o700))?;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            make_changeable(&entry.path())?;
        }
    }
    Ok(())
}

/// Exchanges two names in one step.
#[cfg(target_os = "linux")]
fn exchange_names(a: &Path, b: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    Ok(renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE)?)
}

/// Other systems go by the journal.
#[cfg(not(target_os = "linux"))]
fn exchange_names(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Whether the file system or the kernel has no exchange. (`EINVAL` is what file systems without it answer.)
fn cannot_exchange(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::Unsupported | io::ErrorKind::InvalidInput)
}
