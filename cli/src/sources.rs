//! Sources from disk and from the standard input, never from outside of the project's folder.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use ifs_compiler::source::{Files, ReadError};
use ifs_compiler::syntax::limits::MAX_BYTES;

/// The files of one project, and the design, which is read from where it was named: it may be a link, or the standard
/// input.
#[derive(Debug, Clone)]
pub struct Disk {
    /// The folder of the project, without links in it.
    pub root: PathBuf,
    /// The design's path from the root, with `/`.
    pub design: String,
    /// The design as it was named; `-` is the standard input.
    pub named: PathBuf,
}

impl Files for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        if path == self.design {
            let stdin = self.named == Path::new("-");
            let read = if stdin { limited(io::stdin().lock()) } else { open(&self.named).and_then(limited) };
            return read.map_err(|error| refused(&error));
        }
        let place = self.inside(path)?;
        let kind = place.metadata().map_err(|error| refused(&error))?.file_type();
        if kind.is_dir() {
            return Err(ReadError::Other("it is a folder".to_owned()));
        }
        // Pipes and devices may never come to an end.
        if !kind.is_file() {
            return Err(ReadError::Other("it is no ordinary file".to_owned()));
        }
        open(&place).and_then(limited).map_err(|error| refused(&error))
    }

    fn resolve(&self, path: &str) -> Result<String, ReadError> {
        if path == self.design {
            return Ok(path.to_owned());
        }
        let place = self.inside(path)?;
        let relative = place.strip_prefix(&self.root).map_err(|_| ReadError::OutsideRoot)?;
        slashed(relative).ok_or_else(|| ReadError::Other("its path is not UTF-8".to_owned()))
    }
}

impl Disk {
    /// One file as it was named, without a project around it.
    pub fn alone(path: &str) -> Disk {
        Disk { root: PathBuf::new(), design: path.to_owned(), named: path.into() }
    }

    /// Where a file really is, which is inside of the root.
    fn inside(&self, path: &str) -> Result<PathBuf, ReadError> {
        let place = self.root.join(path).canonicalize().map_err(|error| refused(&error))?;
        if place.starts_with(&self.root) { Ok(place) } else { Err(ReadError::OutsideRoot) }
    }
}

/// The text of a small file beside the sources, or why there is none.
pub(crate) fn text_of(path: &Path) -> Result<String, String> {
    let bytes = open(path).and_then(limited).map_err(|error| words(&error))?;
    if bytes.len() > MAX_BYTES {
        return Err("it is too large".to_owned());
    }
    String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text".to_owned())
}

/// A relative path with `/` on every system.
pub(crate) fn slashed(path: &Path) -> Option<String> {
    let parts: Option<Vec<&str>> = path.iter().map(|part| part.to_str()).collect();
    Some(parts?.join("/"))
}

fn refused(error: &io::Error) -> ReadError {
    match error.kind() {
        io::ErrorKind::NotFound => ReadError::NotFound,
        _ => ReadError::Other(words(error)),
    }
}

fn open(path: &Path) -> io::Result<File> {
    let file = File::open(path)?;
    if file.metadata()?.is_dir() {
        return Err(io::Error::other("it is a folder"));
    }
    Ok(file)
}

/// Everything there is, but never more than one byte beyond what the compiler takes.
fn limited(from: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What the system says, without its number.
pub(crate) fn words(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or(&text).to_lowercase()
}
