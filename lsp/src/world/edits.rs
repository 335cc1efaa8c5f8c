//! What was known of an older text, moved to where it stands after edits.

use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::source::Span;

use super::documents::Edit;

/// The span after an edit of its file; what the edit touched shrinks to what is left of it.
pub(crate) fn moved(span: Span, edit: Edit) -> Span {
    let at = |offset: u32, end: bool| {
        if offset < edit.start || (offset == edit.start && (end || edit.start < edit.end)) {
            offset
        } else if offset >= edit.end {
            offset - edit.end + edit.start + edit.length
        } else if end {
            edit.start
        } else {
            edit.start + edit.length
        }
    };
    let start = at(span.start, false);
    Span::new(span.file, start, at(span.end, true).max(start))
}

/// A diagnostic after an edit of a file it speaks of.
pub(crate) fn moved_diagnostic(diagnostic: &mut Diagnostic, file: ifs_compiler::source::FileId, edit: Edit) {
    let shift = |span: &mut Span| {
        if span.file == file {
            *span = moved(*span, edit);
        }
    };
    shift(&mut diagnostic.span);
    for label in &mut diagnostic.labels {
        shift(&mut label.span);
    }
    // A fix of another text mends nothing.
    for hint in &mut diagnostic.hints {
        hint.fixes.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ifs_compiler::source::FileId;

    #[test]
    fn spans_follow_their_text() {
        let span = Span::new(FileId(0), 10, 20);
        let moved = |start, end, length| {
            let span = moved(span, Edit { start, end, length });
            (span.start, span.end)
        };
        assert_eq!(moved(0, 0, 5), (15, 25), "before");
        assert_eq!(moved(30, 31, 0), (10, 20), "behind");
        assert_eq!(moved(12, 14, 0), (10, 18), "inside");
        assert_eq!(moved(5, 15, 2), (7, 12), "over its start");
        assert_eq!(moved(15, 25, 1), (10, 15), "over its end");
        assert_eq!(moved(20, 20, 3), (10, 20), "right behind");
    }
}
