//! Doc comments: `//!` for the file, `///` for the item, member or field that follows. They are no part of the grammar,
//! so that one in an odd place does no harm.

use super::ast::{Field, File, ItemKind};
use super::limits::Said;
use super::token::{Token, TokenKind};
use crate::diagnostic::{Code, Diagnostic};
use crate::source::{Source, Span};
use std::collections::BTreeMap;

/// Puts the doc comments of `tokens` on the nodes that they stand before.
pub(super) fn attach(source: &Source, tokens: &[Token], file: &mut File, said: &mut Said) {
    let before = |kind| matches!(kind, TokenKind::Whitespace | TokenKind::Comment | TokenKind::FileDocs);
    let first = tokens.iter().find(|token| !before(token.kind));
    let start = first.map_or(source.text.len() as u32, |token| token.span.start);
    file.first = Span::new(source.id, start, start);
    let mut docs = collect(source, tokens, file, said);
    for item in &mut file.items {
        item.docs = docs.remove(&item.span.start).unwrap_or_default();
        match &mut item.kind {
            ItemKind::Function(function) => fields(&mut function.parameters, &mut docs),
            ItemKind::Record(record) => fields(&mut record.fields, &mut docs),
            ItemKind::Ifs(ifs) => {
                fields(&mut ifs.parameters, &mut docs);
                for member in &mut ifs.members {
                    member.docs = docs.remove(&member.span.start).unwrap_or_default();
                }
            }
            _ => {}
        }
    }
}

fn fields(fields: &mut [Field], docs: &mut BTreeMap<u32, Vec<String>>) {
    for field in fields {
        field.docs = docs.remove(&field.name.span.start).unwrap_or_default();
    }
}

/// The `///` lines, by where the token after them starts. Those of the file go to it.
fn collect(
    source: &Source,
    tokens: &[Token],
    file: &mut File,
    said: &mut Said,
) -> BTreeMap<u32, Vec<String>> {
    let mut all = BTreeMap::new();
    let mut waiting = Vec::new();
    let mut item_seen = false;
    for token in tokens {
        let text = source.slice(token.span);
        match token.kind {
            TokenKind::ItemDocs => waiting.push(unmarked(text, "///")),
            TokenKind::FileDocs if item_seen => said.push(|| late(token.span)),
            TokenKind::FileDocs => file.docs.push(unmarked(text, "//!")),
            kind if kind.is_trivia() || kind == TokenKind::Error => {}
            _ => {
                item_seen = true;
                if !waiting.is_empty() {
                    all.insert(token.span.start, std::mem::take(&mut waiting));
                }
            }
        }
    }
    all
}

/// A line without its mark, and without the space after it.
fn unmarked(text: &str, mark: &str) -> String {
    let line = text.strip_prefix(mark).unwrap_or(text);
    line.strip_prefix(' ').unwrap_or(line).trim_end().to_owned()
}

fn late(span: Span) -> Diagnostic {
    let mark = Span::new(span.file, span.start, span.start + 3);
    Diagnostic::new(Code::E0204, mark, "`//!` documents the file and stands before its first item")
        .fix("to document the next item, write `///`", mark, "///")
        .hint("an ordinary comment is written `//`")
}
