//! The texts of one analysis.

use super::{FileId, LineIndex, Span};
use std::sync::Arc;

/// One text and the path it goes by in messages (relative, with `/`; `std.curves` for the library's own).
#[derive(Clone, Debug)]
pub struct Source {
    /// Its identity.
    pub id: FileId,
    /// The name in messages.
    pub path: String,
    /// The text.
    pub text: String,
    /// Its lines.
    pub lines: LineIndex,
}

impl Source {
    /// A source with its line index.
    pub fn new(id: FileId, path: impl Into<String>, text: impl Into<String>) -> Self {
        let text = text.into();
        let lines = LineIndex::new(&text);
        Source { id, path: path.into(), text, lines }
    }

    /// The text under a span, clamped to character bounds.
    pub fn slice(&self, span: Span) -> &str {
        let start = floor_boundary(&self.text, span.start as usize);
        let end = floor_boundary(&self.text, span.end as usize);
        &self.text[start..end.max(start)]
    }
}

/// The nearest character bound at or below `at`.
pub(crate) fn floor_boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// All sources of an analysis, in the order they were first met.
#[derive(Clone, Debug, Default)]
pub struct SourceMap {
    sources: Vec<Arc<Source>>,
}

impl SourceMap {
    /// Adds a text and gives it an identity.
    pub fn add(&mut self, path: impl Into<String>, text: impl Into<String>) -> FileId {
        let id = FileId(u32::try_from(self.sources.len()).unwrap_or(u32::MAX));
        self.sources.push(Arc::new(Source::new(id, path, text)));
        id
    }

    /// Adds a source that was made before with the identity that comes next.
    pub(crate) fn share(&mut self, source: &Arc<Source>) {
        debug_assert_eq!(source.id.0 as usize, self.sources.len(), "the identities are places");
        self.sources.push(Arc::clone(source));
    }

    /// The source of an identity, to be kept.
    pub(crate) fn shared(&self, id: FileId) -> Option<Arc<Source>> {
        self.sources.get(id.0 as usize).map(Arc::clone)
    }

    /// The source of an identity.
    pub fn get(&self, id: FileId) -> Option<&Source> {
        self.sources.get(id.0 as usize).map(Arc::as_ref)
    }

    /// The same sources with other paths, for messages: each path is what `shown` makes of it.
    #[must_use]
    pub fn shown_as(&self, shown: impl Fn(&Source) -> String) -> SourceMap {
        let shown = |source: &Source| Arc::new(Source { path: shown(source), ..source.clone() });
        let sources = self.sources.iter().map(|source| shown(source));
        SourceMap { sources: sources.collect() }
    }

    /// All sources in order.
    pub fn iter(&self) -> impl Iterator<Item = &Source> {
        self.sources.iter().map(Arc::as_ref)
    }
}
