//! The one I/O trait: how the compiler asks for the bytes of a file it was told of.

use std::collections::BTreeMap;

/// Why a file could not be read. The text says what the system said, without the path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadError {
    /// There is no such file.
    NotFound,
    /// The path would leave the project's root.
    OutsideRoot,
    /// Anything else, as the system words it.
    Other(String),
}

/// Where sources come from. Paths are relative to the root of the project, with `/`.
pub trait Files {
    /// The bytes of a file.
    ///
    /// # Errors
    /// See [`ReadError`].
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError>;

    /// The one path of a file that may go by several, as through links between folders.
    ///
    /// # Errors
    /// See [`ReadError`].
    fn resolve(&self, path: &str) -> Result<String, ReadError> {
        Ok(path.to_owned())
    }
}

/// Files held in memory, for tests, editors and documentation.
#[derive(Clone, Debug, Default)]
pub struct MemoryFiles {
    files: BTreeMap<String, Vec<u8>>,
}

impl MemoryFiles {
    /// One file.
    pub fn single(path: &str, text: &str) -> Self {
        Self::default().with(path, text)
    }

    /// The same files and one more.
    #[must_use]
    pub fn with(mut self, path: &str, bytes: impl Into<Vec<u8>>) -> Self {
        self.files.insert(path.to_owned(), bytes.into());
        self
    }
}

impl Files for MemoryFiles {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        self.files.get(path).cloned().ok_or(ReadError::NotFound)
    }
}
