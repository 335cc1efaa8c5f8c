//! Files as the editor has them: open documents first, then the disk.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ifs_compiler::source::{Files, ReadError};

use super::documents::Document;
use super::projects::{Project, Projects};

/// The open documents by their paths, without links in them.
pub(crate) type Open = BTreeMap<PathBuf, Arc<Document>>;

/// The files of a project with open documents before them.
#[derive(Clone, Debug)]
pub(crate) struct Overlay {
    pub(crate) project: Project,
    pub(crate) open: Arc<Open>,
}

impl Overlay {
    /// The files of the project that a document is of; `None` where its path cannot be that of a design.
    pub(crate) fn of(projects: &dyn Projects, path: &Path, open: &Arc<Open>) -> Option<Overlay> {
        let text = |path: &Path| open.get(path).map(|document| document.text.clone());
        let project = match path.is_absolute() {
            true => projects.project(path, &text)?,
            false => Project::nowhere(path.to_str()?),
        };
        Some(Overlay { project, open: Arc::clone(open) })
    }

    fn document(&self, path: &str) -> Option<&Arc<Document>> {
        self.open.get(&self.project.root.join(path))
    }
}

impl Files for Overlay {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        match self.document(path) {
            Some(document) => Ok(document.text.clone().into_bytes()),
            None => self.project.files.read(path),
        }
    }

    fn resolve(&self, path: &str) -> Result<String, ReadError> {
        match self.project.files.resolve(path) {
            // A new document that was never saved lies nowhere yet.
            Err(ReadError::NotFound) if self.document(path).is_some() => Ok(path.to_owned()),
            resolved => resolved,
        }
    }
}
