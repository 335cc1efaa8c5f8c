//! What was known of an older text, moved to where it stands after edits.

use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::source::{FileId, Span};

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

/// The same; nothing where all of it is written over.
pub(crate) fn moved_whole(span: Span, edit: Edit) -> Option<Span> {
    let gone = span.start < span.end && edit.start <= span.start && span.end <= edit.end;
    (!gone).then(|| moved(span, edit))
}

/// A diagnostic after an edit of a file it speaks of; whether what it speaks of is still there.
pub(crate) fn moved_diagnostic(diagnostic: &mut Diagnostic, file: FileId, edit: Edit) -> bool {
    if diagnostic.span.file == file && moved_whole(diagnostic.span, edit).is_none() {
        return false;
    }
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
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use ifs_compiler::diagnostic::Code;

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

    #[test]
    fn what_is_written_over_is_spoken_of_no_more() {
        let file = FileId(0);
        let stays = |start, end, length| {
            let mut found = Diagnostic::new(Code::E0814, Span::new(file, 10, 20), "short");
            moved_diagnostic(&mut found, file, Edit { start, end, length })
        };
        assert!(!stays(10, 20, 5) && !stays(8, 21, 0));
        assert!(stays(11, 20, 5) && stays(10, 19, 0) && stays(0, 10, 0) && stays(20, 30, 0));
    }
}
