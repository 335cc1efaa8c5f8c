//! Names that cannot be: one that is declared twice gets another that nothing has, a word of the language one that is none.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;

use super::dropped;
use super::tokens::words;
use crate::features::words::written;

/// The second under a free name; where it is an import, that out.
pub(super) fn renamed(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let imported = dropped::import(analysis, found);
    if !imported.is_empty() {
        return imported;
    }
    let name = written(analysis, found.span);
    if !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        return Vec::new();
    }
    let words = words(analysis, found.span);
    let taken = |new: &str| {
        words.iter().any(|token| token.kind == TokenKind::Name && written(analysis, token.span) == new)
    };
    let free = (2..1000).map(|number| match name.starts_with(|c: char| c.is_ascii_uppercase()) {
        true => format!("{name}{number}"),
        false => format!("{name}_{number}"),
    });
    let new = free.into_iter().find(|new| !taken(new));
    let fix = |new: String| {
        Fix::titled(format!("call the second `{new}`: `{name}` still means the first")).with(found.span, new)
    };
    new.map(fix).into_iter().collect()
}

/// A word of the language where a name is declared, with an underscore behind it.
pub(super) fn reserved(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let words = words(analysis, found.span);
    let Some(place) = words.iter().position(|token| token.span == found.span) else { return Vec::new() };
    let declares = place.checked_sub(1).and_then(|before| words.get(before)).is_some_and(|before| {
        matches!(written(analysis, before.span), "let" | "param" | "fn" | "ifs" | "figure" | "transform")
    });
    let same_line = |before: Span| {
        let between = Span::new(before.file, before.start, found.span.start);
        !written(analysis, between).contains('\n')
    };
    let word = written(analysis, found.span);
    let together = place.checked_sub(1).is_some_and(|before| same_line(words[before].span));
    let assigned = words.get(place + 1).is_some_and(|next| {
        matches!(next.kind, TokenKind::Equals | TokenKind::Colon | TokenKind::OpenParenthesis)
    });
    if !declares || !together || !assigned || !words[place].kind.is_keyword() {
        return Vec::new();
    }
    let title = format!("call it `{word}_`: `{word}` is a word of the language");
    vec![Fix::titled(title).with(found.span, format!("{word}_"))]
}
