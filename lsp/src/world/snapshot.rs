//! What a reader gets: a document at one moment with what the compiler knows of it.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::hir::evaluate::Overrides;

use super::documents::Encoding;
use super::overlay::Open;
use super::places::Places;

/// A document read with its names and types, and what was last worked out of it.
#[derive(Clone)]
pub(crate) struct Snapshot {
    /// Its path without links.
    pub(crate) path: PathBuf,
    /// Read with its index; its own file is the root.
    pub(crate) analysis: Arc<Analysis>,
    /// What is set from outside.
    pub(crate) overrides: Arc<Overrides>,
    /// The last that was worked out without errors.
    pub(crate) made: Option<Made>,
    /// What is wrong with it and worked out so far.
    pub(crate) diagnostics: Arc<Vec<Diagnostic>>,
    pub(crate) places: Places,
    pub(crate) open: Arc<Open>,
    pub(crate) encoding: Encoding,
    /// Whether the document is still as it is here.
    pub(super) fresh: Arc<AtomicBool>,
}

impl Snapshot {
    /// Whether the document has changed since: what is found in this one is then of no use.
    pub(crate) fn is_stale(&self) -> bool {
        !self.fresh.load(Ordering::Relaxed)
    }
}

/// A design that was worked out to its boards.
#[derive(Clone)]
pub(crate) struct Made {
    pub(crate) analysis: Arc<Analysis>,
    /// Whether it is of the text as it is now.
    pub(crate) current: bool,
}
