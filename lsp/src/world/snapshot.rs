//! What a reader gets: a document at one moment with what the compiler knows of it.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{FileId, Span};

use super::documents::{Edit, Encoding};
use super::edits::moved_whole;
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
    /// Where levels and requirements stood then, and where they stand now, unless they are written over.
    places: Arc<Vec<(Span, Option<Span>)>>,
}

impl Made {
    /// A design that was just worked out.
    pub(super) fn of(analysis: Arc<Analysis>) -> Made {
        let levels =
            analysis.plan.iter().flat_map(|lowered| &lowered.sources).map(|source| source.level_span);
        let made = analysis.fabrications.iter();
        let requirements = made.flat_map(|made| &made.requirements).map(|requirement| requirement.span);
        let mut places: Vec<_> = levels.chain(requirements).map(|span| (span, Some(span))).collect();
        places.sort();
        places.dedup();
        Made { analysis, current: true, places: Arc::new(places) }
    }

    /// Forgets where its parts stand: its files are others.
    pub(super) fn without_places(self) -> Made {
        Made { places: Arc::default(), ..self }
    }

    /// Follows an edit of a file.
    pub(super) fn edited(&mut self, file: FileId, edit: Edit) {
        for (_, now) in Arc::make_mut(&mut self.places) {
            *now = now.and_then(|span| if span.file == file { moved_whole(span, edit) } else { Some(span) });
        }
    }

    /// Where a level or a requirement of then stands now.
    pub(crate) fn place(&self, then: Span) -> Option<Span> {
        let place = self.places.binary_search_by_key(&then, |(then, _)| *then).ok()?;
        self.places[place].1
    }
}
