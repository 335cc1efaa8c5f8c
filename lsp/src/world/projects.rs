//! What the server must know of the disk: which project a file belongs to, and where the library can be read.

use std::fmt::Debug;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{Files, ReadError};

/// The disk, as the program that starts the server sees it.
pub trait Projects: Send + Sync {
    /// The project of a design; `None` where its path cannot be one. `open` gives the text of a file that the editor has: that
    /// of an `ifs.toml` goes before the one on disk.
    fn project(&self, path: &Path, open: &dyn Fn(&Path) -> Option<String>) -> Option<Project>;

    /// Every file below a folder whose name ends so, in order: `ifs` or `glb`.
    fn files(&self, folder: &Path, ending: &str) -> Vec<PathBuf>;

    /// Every design below a folder, in order.
    fn designs(&self, folder: &Path) -> Vec<PathBuf> {
        self.files(folder, "ifs")
    }

    /// Where a module of the library can be read as a file: `curves`.
    fn library(&self, module: &str) -> Option<PathBuf>;
}

/// A design in its project.
#[derive(Clone)]
pub struct Project {
    /// The folder of the project, without links in it.
    pub root: PathBuf,
    /// The design's path from the root, with `/`.
    pub design: String,
    /// The files.
    pub files: Arc<dyn Files + Send + Sync>,
    /// What is set from outside.
    pub overrides: Overrides,
}

impl Debug for Project {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        out.debug_struct("Project")
            .field("root", &self.root)
            .field("design", &self.design)
            .finish_non_exhaustive()
    }
}

impl Project {
    /// That of a document which lies in no folder (`untitled:`), by its name.
    pub(crate) fn nowhere(name: &str) -> Project {
        Project {
            root: PathBuf::new(),
            design: name.to_owned(),
            files: Arc::new(Nowhere),
            overrides: Overrides::default(),
        }
    }
}

/// No files at all.
struct Nowhere;

impl Files for Nowhere {
    fn read(&self, _: &str) -> Result<Vec<u8>, ReadError> {
        Err(ReadError::Other("a document that was never saved lies in no folder: save it first".to_owned()))
    }
}
