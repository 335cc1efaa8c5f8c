//! Where the files of an analysis lie on disk.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::FileId;

use super::names::Names;
use super::projects::Projects;

/// The disk around one analysis.
#[derive(Clone)]
pub(crate) struct Places {
    /// The folder of the project.
    pub(crate) root: PathBuf,
    pub(crate) projects: Arc<dyn Projects>,
    pub(crate) names: Names,
}

impl Places {
    /// Where a file lies; a module of the library where it can be read.
    pub(crate) fn path(&self, analysis: &Analysis, file: FileId) -> Option<PathBuf> {
        let source = analysis.sources.get(file)?;
        match source.path.strip_prefix("std.") {
            Some(module) if analysis.hir.is_library(file) => self.projects.library(module),
            _ => Some(self.root.join(&source.path)),
        }
    }

    /// The file that lies there, where it is one of the analysis.
    pub(crate) fn file(&self, analysis: &Analysis, path: &Path) -> Option<FileId> {
        self.own_file(analysis, path).or_else(|| {
            let files = analysis.sources.iter().map(|source| source.id);
            let mut library = files.filter(|file| analysis.hir.is_library(*file));
            library.find(|file| self.path(analysis, *file).as_deref() == Some(path))
        })
    }

    /// The file of the project that lies there.
    pub(crate) fn own_file(&self, analysis: &Analysis, path: &Path) -> Option<FileId> {
        let inner = path.strip_prefix(&self.root).ok()?;
        analysis.files.iter().find(|file| Path::new(&file.path) == inner).map(|file| file.file)
    }
}
