//! What is kept of an analysis for the next one of a design that has changed a little: the trees of its files.

use super::{Analysis, ProjectFile};
use crate::source::{Source, SourceMap};
use crate::syntax::Parse;
use std::sync::Arc;

/// The trees of the files of a design as it was before.
#[derive(Debug)]
pub struct Earlier {
    sources: Arc<SourceMap>,
    files: Arc<Vec<ProjectFile>>,
}

impl Earlier {
    /// Of an analysis, which is given up but for them.
    pub fn of(analysis: Arc<Analysis>) -> Earlier {
        match Arc::try_unwrap(analysis) {
            Ok(analysis) => Earlier { sources: analysis.sources, files: analysis.files },
            Err(shared) => Earlier::beside(&shared),
        }
    }

    /// Of an analysis that stays: what is taken is copied.
    pub fn beside(analysis: &Analysis) -> Earlier {
        Earlier { sources: Arc::clone(&analysis.sources), files: Arc::clone(&analysis.files) }
    }

    /// The text of a file and its tree; no other has to ask for them again.
    pub(super) fn take(&mut self, path: &str) -> Option<(Arc<Source>, Parse)> {
        let place = self.files.iter().position(|known| known.path == path)?;
        let source = self.sources.shared(self.files[place].file)?;
        let parse = match Arc::get_mut(&mut self.files) {
            Some(files) => std::mem::take(&mut files[place].parse),
            None => self.files[place].parse.tree(),
        };
        Some((source, parse))
    }
}
