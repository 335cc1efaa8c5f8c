//! Files as the editor has them: open documents first, then the disk.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use ifs_compiler::source::{Files, ReadError};

use super::documents::Document;
use super::projects::Project;

/// The open documents by their paths, without links in them.
pub(crate) type Open = BTreeMap<PathBuf, Arc<Document>>;

/// The files of a project with open documents before them.
#[derive(Clone, Debug)]
pub(crate) struct Overlay {
    pub(crate) project: Project,
    pub(crate) open: Arc<Open>,
}

impl Files for Overlay {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        match self.open.get(&self.project.root.join(path)) {
            Some(document) => Ok(document.text.clone().into_bytes()),
            None => self.project.files.read(path),
        }
    }

    fn resolve(&self, path: &str) -> Result<String, ReadError> {
        // A new document that was never saved lies nowhere yet.
        if self.open.contains_key(&self.project.root.join(path)) && !path.contains("..") {
            return Ok(path.to_owned());
        }
        self.project.files.resolve(path)
    }
}
