//! What the client calls its documents, and the one path each goes by here.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

#[derive(Debug, Default)]
struct Table {
    /// Of documents that are open.
    paths: BTreeMap<String, PathBuf>,
    /// Of all that were ever open: what is said of one after it was closed is said by the same name.
    names: BTreeMap<PathBuf, String>,
}

/// Names of documents; all clones are the same table. A client may reach a file through links and spell its name as it
/// likes: it gets the name back that it gave.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    table: Arc<Mutex<Table>>,
}

impl Names {
    fn table(&self) -> MutexGuard<'_, Table> {
        self.table.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A document was opened by this name.
    pub(crate) fn opened(&self, name: &str, path: &Path) {
        let mut table = self.table();
        table.paths.insert(name.to_owned(), path.to_owned());
        table.names.insert(path.to_owned(), name.to_owned());
    }

    /// The document of this name was closed.
    pub(crate) fn closed(&self, name: &str) {
        self.table().paths.remove(name);
    }

    /// The path of an open document, which stays what it was when it was opened.
    pub(crate) fn path(&self, name: &str) -> Option<PathBuf> {
        self.table().paths.get(name).cloned()
    }

    /// The name of a path, where the client gave one.
    pub(crate) fn name(&self, path: &Path) -> Option<String> {
        self.table().names.get(path).cloned()
    }
}
