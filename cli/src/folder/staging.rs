//! The set in the making: writing files, then committing them all.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::hashed::HashedFile;
use super::lock::Lock;
use super::manifest::{FileRecord, Manifest, Provenance};
use super::names::{MANIFEST, check_relative, check_source};
use super::place::Place;
use super::replace;
use super::{FolderError, Making, foreign};

/// Up to so many files are flushed one by one.
const FLUSHED_ONE_BY_ONE: usize = 16;

/// A set of outputs in the making. Dropped without a commit it leaves no trace.
#[derive(Debug)]
pub struct Staging {
    pub(super) place: Place,
    making: Making,
    pub(super) files: BTreeMap<String, FileRecord>,
    folders: BTreeSet<PathBuf>,
    /// Files that are written but perhaps not on the disk yet.
    unflushed: Vec<PathBuf>,
    /// Freed last: the staging folder is removed under it.
    _lock: Lock,
}

/// What a commit did.
#[derive(Debug)]
pub struct Committed {
    /// The output folder, absolute.
    pub folder: PathBuf,
    /// What was written.
    pub manifest: Manifest,
    /// Names of an earlier build that this one did not make and which are gone, in order.
    pub removed: Vec<String>,
    /// What no build wrote and which was kept, in order; a whole folder ends with `/`.
    pub foreign: Vec<String>,
    /// The new set is in place, but something beside it could not be cleaned up; the next build tries again.
    pub leftover: Option<FolderError>,
}

impl Staging {
    /// Makes the staging folder. The lock is held and nothing of an earlier build lies beside the target.
    pub(super) fn open(place: Place, lock: Lock, making: Making) -> Result<Staging, FolderError> {
        Manifest::read(&place.target)?;
        fs::create_dir(&place.staging).map_err(FolderError::io("make the folder", &place.staging))?;
        let staging = Staging {
            folders: BTreeSet::from([place.staging.clone()]),
            place,
            making,
            files: BTreeMap::new(),
            unflushed: Vec::new(),
            _lock: lock,
        };
        if let Ok(old) = fs::metadata(&staging.place.target) {
            fs::set_permissions(&staging.place.staging, old.permissions())
                .map_err(FolderError::io("set the permissions of", &staging.place.staging))?;
        }
        Ok(staging)
    }

    /// Writes one file of the set. `relative` is its name in the folder (`boards/shell.0.left.nc`; see
    /// [`ifs_compiler::outputs::names::safe_file_name`]), `kind` and `address` go into the manifest.
    ///
    /// # Errors
    /// The name is refused or was written before, or the system refuses.
    pub fn write(
        &mut self,
        relative: &str,
        kind: &str,
        address: Option<&str>,
        bytes: &[u8],
    ) -> Result<(), FolderError> {
        self.write_with(relative, kind, address, |out| out.write_all(bytes))
    }

    /// As [`Staging::write`], for what is better written piece by piece. The writer is buffered.
    ///
    /// # Errors
    /// As [`Staging::write`], and what `fill` returns.
    pub fn write_with(
        &mut self,
        relative: &str,
        kind: &str,
        address: Option<&str>,
        fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), FolderError> {
        self.go_on()?;
        check_relative(relative)?;
        if self.files.contains_key(relative) {
            return Err(FolderError::Duplicate(relative.to_owned()));
        }
        let path = self.place.staging.join(relative);
        self.make_folders(&path)?;
        let written = write_hashed(&path, self.making.stop, fill);
        let (_, bytes, sha256) = written.map_err(|error| match self.go_on() {
            Err(stopped) => stopped,
            Ok(()) => FolderError::io("write", &self.place.target.join(relative))(error),
        })?;
        self.unflushed.push(path);
        let record = FileRecord {
            path: relative.to_owned(),
            bytes,
            sha256,
            kind: kind.to_owned(),
            address: address.map(str::to_owned),
        };
        self.files.insert(relative.to_owned(), record);
        Ok(())
    }

    /// An error where the set is given up.
    pub(super) fn go_on(&self) -> Result<(), FolderError> {
        if (self.making.stop)() { Err(FolderError::Stopped) } else { Ok(()) }
    }

    /// Makes the folders between the staging folder and a file.
    pub(super) fn make_folders(&mut self, path: &Path) -> Result<(), FolderError> {
        let Some(parent) = path.parent() else { return Ok(()) };
        if self.folders.contains(parent) {
            return Ok(());
        }
        fs::create_dir_all(parent).map_err(FolderError::io("make the folder", parent))?;
        let inside = parent.ancestors().take_while(|folder| folder.starts_with(&self.place.staging));
        self.folders.extend(inside.map(Path::to_path_buf));
        Ok(())
    }

    /// Writes the manifest and puts the set in the place of the old one, in one step. What an earlier build wrote and
    /// this one did not is gone afterwards; what no build wrote is kept.
    ///
    /// # Errors
    /// A file that no build wrote is in the way, or the system refuses; the old set is untouched then.
    pub fn commit(mut self, provenance: &Provenance) -> Result<Committed, FolderError> {
        for source in &provenance.sources {
            check_source(&source.path)?;
        }
        let manifest = Manifest::new(provenance, std::mem::take(&mut self.files));
        let before = foreign::Before::read(&self.place.target)?;
        before.link_into(&self.place.staging, &mut self.folders)?;
        self.go_on()?;
        flush_files(&self.place.staging, &self.unflushed)?;
        let path = self.place.staging.join(MANIFEST);
        manifest
            .to_bytes()
            .and_then(|bytes| write_hashed(&path, || false, |out| out.write_all(&bytes)))
            .and_then(|(file, _, _)| file.sync_all())
            .map_err(FolderError::io("write", &self.place.target.join(MANIFEST)))?;
        for folder in self.folders.iter().rev() {
            flush_folder(folder)?;
        }
        self.go_on()?;
        replace::replace(&self.place, self.making.exchange)?;
        let leftover = replace::sweep(&self.place).err();
        let names = manifest.names();
        let removed = before.own.iter().filter(|name| !names.contains(*name));
        Ok(Committed {
            folder: self.place.target.clone(),
            removed: removed.map(|name| name.to_string_lossy().into_owned()).collect(),
            foreign: before.named(),
            manifest,
            leftover,
        })
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // After a commit nothing is left. Otherwise this is what the next build would do; if it fails here, it does.
        let _ = replace::recover(&self.place);
    }
}

/// Writes a new file, unless it is stopped on the way; returns it with its length and hash.
fn write_hashed(
    path: &Path,
    stop: fn() -> bool,
    fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<(File, u64, String)> {
    let file = OpenOptions::new().write(true).create_new(true).open(path)?;
    let mut out = BufWriter::with_capacity(1 << 16, HashedFile::new(file, stop));
    fill(&mut out)?;
    out.into_inner().map_err(io::IntoInnerError::into_error)?.finish()
}

/// Flushes written files to the disk: a few one by one, many with all else on their file system, which is quicker.
fn flush_files(staging: &Path, files: &[PathBuf]) -> Result<(), FolderError> {
    if files.len() > FLUSHED_ONE_BY_ONE && flush_file_system(staging)? {
        return Ok(());
    }
    for path in files {
        let flushed = File::open(path).and_then(|file| file.sync_all());
        flushed.map_err(FolderError::io("flush", path))?;
    }
    Ok(())
}

/// Flushes the whole file system of the staging folder; `false` where the system cannot.
#[cfg(target_os = "linux")]
fn flush_file_system(staging: &Path) -> Result<bool, FolderError> {
    let open = File::open(staging).map_err(FolderError::io("flush", staging))?;
    match rustix::fs::syncfs(&open) {
        Ok(()) => Ok(true),
        Err(rustix::io::Errno::NOSYS) => Ok(false),
        Err(error) => Err(FolderError::io("flush", staging)(error.into())),
    }
}

#[cfg(not(target_os = "linux"))]
fn flush_file_system(_: &Path) -> Result<bool, FolderError> {
    Ok(false)
}

/// Flushes a folder's list of names to the disk.
pub(super) fn flush_folder(folder: &Path) -> Result<(), FolderError> {
    match File::open(folder).and_then(|open| open.sync_all()) {
        // Some file systems have nothing to flush here and say so.
        Err(error) if error.kind() != io::ErrorKind::InvalidInput => {
            Err(FolderError::io("flush the folder", folder)(error))
        }
        _ => Ok(()),
    }
}
