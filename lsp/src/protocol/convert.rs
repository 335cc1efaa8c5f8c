//! Places and ranges of the protocol from bytes, and back.

use std::path::Path;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::{LineIndex, Source, Span};
use tower_lsp::ls_types::{Location, Position, Range, TextEdit, Uri};

use super::uri::uri_of;
use crate::world::Snapshot;
use crate::world::documents::{Encoding, Place, offset, place};

pub(crate) fn position(text: &str, lines: &LineIndex, at: u32, encoding: Encoding) -> Position {
    let found = place(text, lines, at, encoding);
    Position { line: found.line, character: found.column }
}

pub(crate) fn from_position(position: Position) -> Place {
    Place { line: position.line, column: position.character }
}

/// The range of a span of an analysis.
pub(crate) fn range(analysis: &Analysis, span: Span, encoding: Encoding) -> Range {
    analysis.sources.get(span.file).map_or_else(Range::default, |source| range_in(source, span, encoding))
}

/// The range of a span of a text.
pub(crate) fn range_in(source: &Source, span: Span, encoding: Encoding) -> Range {
    let at = |offset| position(&source.text, &source.lines, offset, encoding);
    Range { start: at(span.start), end: at(span.end) }
}

impl Snapshot {
    /// The byte of a position of the document.
    pub(crate) fn offset(&self, position: Position) -> u32 {
        let Some(source) = self.analysis.sources.get(self.analysis.root) else { return 0 };
        offset(&source.text, &source.lines, from_position(position), self.encoding)
    }

    pub(crate) fn range(&self, span: Span) -> Range {
        range(&self.analysis, span, self.encoding)
    }

    /// Where a span lies, in a file that an editor can open.
    pub(crate) fn location(&self, span: Span) -> Option<Location> {
        let uri = self.uri(&self.places.path(&self.analysis, span.file)?)?;
        Some(Location { uri, range: self.range(span) })
    }

    /// A path as the client calls it.
    pub(crate) fn uri(&self, path: &Path) -> Option<Uri> {
        uri_of(&self.places.names, path)
    }

    pub(crate) fn edit(&self, span: Span, new_text: impl Into<String>) -> TextEdit {
        TextEdit { range: self.range(span), new_text: new_text.into() }
    }
}
