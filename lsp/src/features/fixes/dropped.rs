//! What is taken out: imports that nothing uses, arguments too many, lines of a block that do nothing.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Code, Diagnostic, Edit, Fix};
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::{EntryKind, ItemKind, Use};

use super::tokens::{given, with_comma, words};
use crate::features::words::written;

/// A name of a `use`; all of it where it is the only one.
pub(super) fn import(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let Some((whole, import)) = import_of(analysis, found.span) else { return Vec::new() };
    let name = written(analysis, found.span);
    let span =
        if import.names.len() == 1 { whole } else { with_comma(&words(analysis, found.span), found.span) };
    vec![Fix::titled(format!("remove the import of `{name}`")).with(span, "")]
}

pub(super) fn import_of(analysis: &Analysis, name: Span) -> Option<(Span, &Use)> {
    let file = analysis.files.iter().find(|file| file.file == name.file)?;
    file.parse.ast.items.iter().find_map(|item| match &item.kind {
        ItemKind::Use(import) if import.names.iter().any(|other| other.span == name) => {
            Some((item.span, import))
        }
        _ => None,
    })
}

/// Every `use` of a file without the names that nothing uses, and the others in the order of the alphabet.
pub(crate) fn organized(analysis: &Analysis, diagnostics: &[Diagnostic], file: FileId) -> Vec<Edit> {
    let Some(read) = analysis.files.iter().find(|read| read.file == file) else { return Vec::new() };
    let unused = |span: Span| diagnostics.iter().any(|found| found.code == Code::W0307 && found.span == span);
    let mut edits = Vec::new();
    for item in &read.parse.ast.items {
        let ItemKind::Use(import) = &item.kind else { continue };
        let mut names: Vec<&str> =
            import.names.iter().filter(|name| !unused(name.span)).map(|name| name.text.as_str()).collect();
        let (Some(first), Some(last)) = (import.names.first(), import.names.last()) else { continue };
        names.sort_unstable();
        names.dedup();
        let list = Span::new(file, first.span.start, last.span.end);
        // A comment among the names would be lost.
        if written(analysis, list).contains("//") {
            continue;
        }
        if names.is_empty() {
            edits.push(Fix::replacing(item.span, ""));
        } else if names.join(", ") != written(analysis, list) {
            edits.push(Fix::replacing(list, names.join(", ")));
        }
    }
    edits.iter().filter_map(|fix| super::tidied(analysis, fix)).flatten().collect()
}

/// The second of two arguments, fields or settings of the same name.
pub(super) fn argument(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let words = words(analysis, found.span);
    let entry = entry_at(analysis, found.span);
    let span = match entry {
        Some(entry) => entry,
        None => with_comma(&words, given(&words, found.span).unwrap_or(found.span)),
    };
    let what = written(analysis, entry.unwrap_or(span)).trim_matches([',', ' ', '\n']).to_owned();
    vec![Fix::titled(format!("remove the second, `{what}`")).with(span, "")]
}

/// An argument, field or setting that is not known, with its value.
pub(super) fn unknown(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let words = words(analysis, found.span);
    let Some(all) = entry_at(analysis, found.span).or_else(|| given(&words, found.span)) else {
        return Vec::new();
    };
    let what = written(analysis, all).split_whitespace().collect::<Vec<_>>().join(" ");
    let span = if entry_at(analysis, found.span).is_some() { all } else { with_comma(&words, all) };
    vec![Fix::titled(format!("remove `{what}`")).with(span, "")]
}

/// The second block of a figure.
pub(super) fn block(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let file = analysis.files.iter().find(|file| file.file == found.span.file);
    let mut items = file.into_iter().flat_map(|file| &file.parse.ast.items);
    let second = items
        .find(|item| matches!(&item.kind, ItemKind::Fabricate(block) if block.figure.span == found.span));
    let Some(second) = second else { return Vec::new() };
    let lines = written(analysis, second.span).lines().count();
    let title = format!("remove the second block of `{}`, {lines} lines", written(analysis, found.span));
    vec![Fix::titled(title.replace(" 1 lines", " one line")).with(second.span, "")]
}

/// The second of two levels where there is one.
pub(super) fn level(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let words = words(analysis, found.span);
    let before = words.iter().rev().find(|token| token.span.end <= found.span.start);
    let after = words.iter().find(|token| token.span.start >= found.span.end);
    let (Some(open), Some(close)) = (before, after) else { return Vec::new() };
    let pair = (open.kind, close.kind) == (TokenKind::OpenParenthesis, TokenKind::CloseParenthesis);
    let inside =
        words.iter().filter(|token| found.span.start <= token.span.start && token.span.end <= found.span.end);
    let inside: Vec<_> = inside.collect();
    // Two numbers or names.
    let ([first, comma, second], true) = (inside.as_slice(), pair) else { return Vec::new() };
    if comma.kind != TokenKind::Comma {
        return Vec::new();
    }
    let all = Span::new(found.span.file, open.span.start, close.span.end);
    let one = |level: Span| {
        let level = written(analysis, level);
        Fix::titled(format!("take level {level} instead of {}", written(analysis, all))).with(all, level)
    };
    let mut fixes = vec![one(first.span)];
    if written(analysis, first.span) != written(analysis, second.span) {
        fixes.push(one(second.span));
    }
    fixes
}

/// The arguments beyond those that are taken.
pub(super) fn surplus(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let words = words(analysis, found.span);
    let mut depth = 0usize;
    let Some(closer) = words.iter().filter(|token| token.span.start >= found.span.end).find(|token| {
        let closes = token.kind.is_closer() && depth == 0;
        match token.kind {
            kind if kind.closer().is_some() => depth += 1,
            kind if kind.is_closer() => depth = depth.saturating_sub(1),
            _ => {}
        }
        closes
    }) else {
        return Vec::new();
    };
    let before = words.iter().rev().find(|token| token.span.end <= found.span.start);
    let start = match before {
        Some(comma) if comma.kind == TokenKind::Comma => comma.span.start,
        _ => found.span.start,
    };
    vec![Fix::replacing(Span::new(found.span.file, start, closer.span.start), "")]
}

/// The line of a block that a place lies in, or what is given there in braces.
pub(super) fn entry(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let words = words(analysis, found.span);
    let place = found.span;
    if found.code == Code::E0820 {
        // The value stands there; its name and the colon before it.
        let before: Vec<_> =
            words.iter().rev().filter(|token| token.span.end <= place.start).take(2).collect();
        let [colon, name] = before.as_slice() else { return Vec::new() };
        if colon.kind != TokenKind::Colon {
            return Vec::new();
        }
        let Some(all) = given(&words, name.span) else { return Vec::new() };
        return vec![Fix::replacing(with_comma(&words, all), "")];
    }
    let Some(entry) = entry_at(analysis, place) else { return Vec::new() };
    vec![Fix::replacing(entry, "")]
}

/// The setting or requirement of a block around a place; of a setting only where the place is its name or its value.
fn entry_at(analysis: &Analysis, place: Span) -> Option<Span> {
    let file = analysis.files.iter().find(|file| file.file == place.file)?;
    let blocks = file.parse.ast.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Fabricate(block) => Some(block),
        _ => None,
    });
    let mut entries = blocks.flat_map(|block| &block.entries);
    let found = entries.find(|entry| match &entry.kind {
        EntryKind::Setting(name, value) => name.span == place || value.span == place,
        EntryKind::Require(_) => entry.span.start <= place.start && place.end <= entry.span.end,
        EntryKind::Error => false,
    })?;
    Some(found.span)
}

/// The word `each` before `until`.
pub(super) fn each(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let words = words(analysis, found.span);
    let each = words.windows(2).rev().find(|pair| {
        pair[0].span.start < found.span.end.max(found.span.start + 1)
            && written(analysis, pair[0].span) == "each"
            && written(analysis, pair[1].span) == "until"
    });
    let Some([each, until]) = each else { return Vec::new() };
    let span = Span::new(found.span.file, each.span.start, until.span.start);
    vec![Fix::titled("leave `each` out: all branches go equally deep").with(span, "")]
}
