//! What lies in the output folder that no build wrote. It is kept: linked over into the new set before the exchange,
//! so that at every moment both folders have it.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::ops::Bound;
use std::path::{Path, PathBuf};

use super::FolderError;
use super::manifest::Manifest;

/// What a folder holds, parted into an earlier build's files and the others.
#[derive(Debug, Default)]
pub(super) struct Before {
    folder: PathBuf,
    /// Names of its manifest that are there, the manifest among them.
    pub(super) own: BTreeSet<PathBuf>,
    /// Everything else, in order; a folder without anything of the set in it stands for all it holds.
    foreign: Vec<(PathBuf, bool)>,
}

/// What to do where both folders have the same name.
#[derive(Clone, Copy)]
enum Same<'a> {
    /// The new set's file would be overwritten: an error.
    Refuse,
    /// Both are somebody's: the later one stays. The names of the set itself stay as they are.
    KeepLater(&'a BTreeSet<PathBuf>),
}

impl Before {
    /// Looks through a folder; one that does not exist holds nothing.
    pub(super) fn read(folder: &Path) -> Result<Before, FolderError> {
        let mut before = Before { folder: folder.to_path_buf(), ..Before::default() };
        if folder.is_dir() {
            let listed = Manifest::read(folder)?.map(|manifest| manifest.names()).unwrap_or_default();
            before.walk(Path::new(""), &listed)?;
        }
        Ok(before)
    }

    fn walk(&mut self, relative: &Path, listed: &BTreeSet<PathBuf>) -> Result<(), FolderError> {
        for name in sorted_names(&self.folder.join(relative))? {
            let name = relative.join(name);
            let path = self.folder.join(&name);
            let kind = fs::symlink_metadata(&path).map_err(FolderError::io("look at", &path))?;
            // Names are ordered by segments: what lies in a folder comes straight after it.
            let mut after = listed.range::<PathBuf, _>((Bound::Excluded(&name), Bound::Unbounded));
            if kind.is_dir() && after.next().is_some_and(|next| next.starts_with(&name)) {
                self.walk(&name, listed)?;
            } else if !kind.is_dir() && listed.contains(&name) {
                self.own.insert(name);
            } else {
                self.foreign.push((name, kind.is_dir()));
            }
        }
        Ok(())
    }

    /// The names of what is kept, for a person.
    pub(super) fn named(&self) -> Vec<String> {
        let name = |(path, is_folder): &(PathBuf, bool)| {
            format!("{}{}", path.to_string_lossy(), if *is_folder { "/" } else { "" })
        };
        self.foreign.iter().map(name).collect()
    }

    /// Links everything foreign into the new set; the folders made or filled are added to `folders`, to be flushed.
    pub(super) fn link_into(&self, new: &Path, folders: &mut BTreeSet<PathBuf>) -> Result<(), FolderError> {
        for (name, _) in &self.foreign {
            link_tree(&self.folder, new, name, Same::Refuse, folders)?;
        }
        Ok(())
    }
}

/// Brings over what came into `old` after it was looked through: an old set that has been replaced is about to be
/// removed. Without a target there is nothing to bring it to.
pub(super) fn rescue(old: &Path, target: &Path) -> Result<(), FolderError> {
    let Some(manifest) = Manifest::read(target).ok().flatten() else { return Ok(()) };
    // Without a readable list a leftover is a set in the making: its own files, and links to what the target has.
    if !matches!(Manifest::read(old), Ok(Some(_))) {
        return Ok(());
    }
    let mut folders = BTreeSet::new();
    for (name, _) in &Before::read(old)?.foreign {
        link_tree(old, target, name, Same::KeepLater(&manifest.names()), &mut folders)?;
    }
    folders.iter().rev().try_for_each(|folder| super::staging::flush_folder(folder))
}

/// Links `from/name` to `to/name`, with all below it.
fn link_tree(
    from: &Path,
    to: &Path,
    name: &Path,
    same: Same<'_>,
    folders: &mut BTreeSet<PathBuf>,
) -> Result<(), FolderError> {
    let (source, copy) = (from.join(name), to.join(name));
    let kind = fs::symlink_metadata(&source).map_err(FolderError::io("look at", &source))?;
    let there = fs::symlink_metadata(&copy).ok();
    if let Some(parent) = copy.parent()
        && !folders.contains(parent)
    {
        fs::create_dir_all(parent).map_err(|_| FolderError::ForeignInTheWay(source.clone()))?;
        folders.extend(parent.ancestors().take_while(|a| a.starts_with(to)).map(Path::to_path_buf));
    }
    match &there {
        Some(there) if there.is_dir() && kind.is_dir() => {}
        Some(there) => {
            return match same {
                Same::Refuse => Err(FolderError::ForeignInTheWay(source)),
                Same::KeepLater(own) if own.contains(name) || there.is_dir() || kind.is_dir() => Ok(()),
                Same::KeepLater(_) if is_later(&kind, there) => {
                    fs::rename(&source, &copy).map_err(FolderError::io("keep", &copy))
                }
                Same::KeepLater(_) => Ok(()),
            };
        }
        None if kind.is_dir() => {
            fs::create_dir(&copy).map_err(FolderError::io("make the folder", &copy))?;
        }
        None => return link(&source, &copy).map_err(FolderError::io("keep", &source)),
    }
    folders.insert(copy.clone());
    for child in sorted_names(&source)? {
        link_tree(from, to, &name.join(child), same, folders)?;
    }
    if there.is_none() {
        fs::set_permissions(&copy, kind.permissions())
            .map_err(FolderError::io("set the permissions of", &copy))?;
    }
    Ok(())
}

/// A second name for a file (or link, or pipe) that is no folder; a copy where the file system has no second names or
/// the file is another user's.
pub(super) fn link(source: &Path, copy: &Path) -> io::Result<()> {
    match fs::hard_link(source, copy) {
        // Another file system is mounted in the folder: copying it, and then removing the original, is not ours to do.
        Err(error) if error.kind() == io::ErrorKind::CrossesDevices => Err(error),
        Err(error) => {
            let kind = fs::symlink_metadata(source)?;
            if !kind.is_file() {
                return Err(error);
            }
            fs::copy(source, copy)?;
            let copied = fs::File::options().write(true).open(copy)?;
            copied.set_times(fs::FileTimes::new().set_modified(kind.modified()?))?;
            copied.sync_all()
        }
        Ok(()) => Ok(()),
    }
}

/// Whether `a` was written after `b`; not where the system does not know.
fn is_later(a: &fs::Metadata, b: &fs::Metadata) -> bool {
    matches!((a.modified(), b.modified()), (Ok(a), Ok(b)) if a > b)
}

/// The names in a folder, in order.
fn sorted_names(folder: &Path) -> Result<Vec<PathBuf>, FolderError> {
    let names = fs::read_dir(folder).and_then(|entries| {
        entries.map(|entry| Ok(PathBuf::from(entry?.file_name()))).collect::<io::Result<Vec<_>>>()
    });
    let mut names = names.map_err(FolderError::io("read the folder", folder))?;
    names.sort();
    Ok(names)
}
