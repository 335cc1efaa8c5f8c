//! The text at places, and the words of messages that several features share.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::Span;

/// What stands there.
pub(crate) fn written(analysis: &Analysis, span: Span) -> &str {
    analysis.sources.get(span.file).map_or("", |source| source.slice(span))
}
