//! Which messages of the checker only follow from text that the parser could not understand. They are left out: the
//! syntax error is what has to be mended, and they are found again after that if they are true.
//!
//! What lies in the smallest piece around a syntax error (a member of an ifs, a line of a fabricate block, else the whole
//! item) is not judged, and a name that occurs in a piece that is no item or member at all may have been declared there;
//! where such a piece has no name, any unknown one may.

use std::collections::BTreeSet;
use std::ops::Range;

use super::ProjectFile;
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::source::{FileId, SourceMap, Span};
use crate::syntax::Parse;
use crate::syntax::ast::{EntryKind, Item, ItemKind, MemberKind};

/// The messages that stand without the syntax errors of the files they speak of.
pub(super) fn without(
    mut found: Vec<Diagnostic>,
    files: &[ProjectFile],
    sources: &SourceMap,
) -> Vec<Diagnostic> {
    for file in files {
        if !file.readable {
            found.retain(|diagnostic| diagnostic.span.file != file.file);
        }
        // An import is not unused whose use could not be read.
        if !file.parse.diagnostics.is_empty() {
            found.retain(|diagnostic| diagnostic.code != Code::W0307 || diagnostic.span.file != file.file);
        }
        let text = sources.get(file.file).map_or("", |source| source.text.as_str());
        found = without_those_of(found, text, &file.parse, file.file);
    }
    found
}

/// The messages that stand without the syntax errors of one file, whose text this is.
fn without_those_of(found: Vec<Diagnostic>, text: &str, parse: &Parse, file: FileId) -> Vec<Diagnostic> {
    let errors = parse.diagnostics.iter().filter(|error| breaks(error));
    let broken: Vec<Piece> = errors.filter_map(|error| piece_around(parse, text, error.span)).collect();
    if broken.is_empty() {
        return found;
    }
    let lost: BTreeSet<&str> =
        broken.iter().filter(|piece| piece.lost).flat_map(|piece| names(text, piece)).collect();
    // An item whose very name is missing may be the one that others look for.
    let nameless = broken.iter().any(|piece| piece.lost && declares_nothing(text, piece));
    let inside = |span: Span| broken.iter().any(|piece| piece.range.contains(&span.start));
    let names_lost = |diagnostic: &Diagnostic| {
        matches!(diagnostic.code, Code::E0301 | Code::E0409)
            && (nameless || text.get(diagnostic.span.range()).is_some_and(|name| lost.contains(name)))
    };
    let stands = |diagnostic: &Diagnostic| {
        diagnostic.span.file != file || (!inside(diagnostic.span) && !names_lost(diagnostic))
    };
    found.into_iter().filter(stands).collect()
}

/// Whether an error of the parser leaves something out of the tree. Wrong characters do not: they are passed over, and
/// wrong numbers and texts are errors that the checker knows of.
pub(super) fn breaks(error: &Diagnostic) -> bool {
    let harmless = matches!(
        error.code,
        Code::E0102 | Code::E0103 | Code::E0104 | Code::E0105 | Code::E0106 | Code::E0204 | Code::E0205
    );
    error.severity() == Severity::Error && !harmless
}

struct Piece {
    range: Range<u32>,
    /// Whether nothing of it is in the tree.
    lost: bool,
}

fn piece_around(parse: &Parse, text: &str, at: Span) -> Option<Piece> {
    let items = &parse.ast.items;
    let end = u32::try_from(text.len()).unwrap_or(u32::MAX);
    let starts = items.iter().map(|item| (item.span.start, item.kind == ItemKind::Error));
    let (place, item) = smallest(starts, end, at)?;
    match parts(&items[place]) {
        // Before its first part stands the head of an item: an error there concerns all of it.
        Some(parts) => Some(smallest(parts.into_iter(), item.range.end, at).map_or(item, |(_, part)| part)),
        None => Some(item),
    }
}

/// The parts of an item that are judged one by one: where each begins, and whether it is lost.
fn parts(item: &Item) -> Option<Vec<(u32, bool)>> {
    match &item.kind {
        ItemKind::Ifs(ifs) => {
            let members = ifs.members.iter();
            Some(members.map(|member| (member.span.start, member.kind == MemberKind::Error)).collect())
        }
        ItemKind::Fabricate(block) => {
            let entries = block.entries.iter();
            Some(entries.map(|entry| (entry.span.start, entry.kind == EntryKind::Error)).collect())
        }
        _ => None,
    }
}

/// The piece that a place lies in, each reaching to the beginning of the next one.
fn smallest(pieces: impl Iterator<Item = (u32, bool)>, end: u32, at: Span) -> Option<(usize, Piece)> {
    let mut found: Option<(usize, Piece)> = None;
    for (index, (start, lost)) in pieces.enumerate() {
        if start > at.start {
            if let Some((_, piece)) = &mut found {
                piece.range.end = start;
            }
            break;
        }
        found = Some((index, Piece { range: start..end, lost }));
    }
    found
}

/// The words in a piece of text that may be names.
fn names<'t>(text: &'t str, piece: &Piece) -> Vec<&'t str> {
    let part = text.get(piece.range.start as usize..piece.range.end as usize).unwrap_or("");
    part.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| !word.is_empty()).collect()
}

/// Whether no name follows the keyword of a lost item: `param = 27mm`.
fn declares_nothing(text: &str, piece: &Piece) -> bool {
    let part = text.get(piece.range.start as usize..piece.range.end as usize).unwrap_or("");
    let after = part.trim_start().trim_start_matches(|c: char| c.is_ascii_lowercase()).trim_start();
    !after.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
}
