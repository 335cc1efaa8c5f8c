//! Sources from disk and from the standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use ifs_compiler::source::{Files, ReadError};
use ifs_compiler::syntax::limits::MAX_BYTES;

/// Files as the system has them; `-` is the standard input.
#[derive(Debug, Default, Clone, Copy)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        let read =
            if path == "-" { limited(io::stdin().lock()) } else { open(Path::new(path)).and_then(limited) };
        read.map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => ReadError::NotFound,
            _ => ReadError::Other(words(&error)),
        })
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
