//! A name in the wrong case, changed wherever the design uses it. The compiler's own fix knows the declaration only.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;

use super::tokens::words;
use crate::features::words::written;

/// The name that the compiler offers, at the declaration and at every word of the file that is the same.
pub(super) fn renamed(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let Some(new) = found.fixes().next().and_then(|fix| fix.edits.first()) else { return Vec::new() };
    let old = written(analysis, found.span);
    let words = words(analysis, found.span);
    // A type of that name keeps it.
    let is_type = |at: usize| {
        let before = at.checked_sub(1).map(|before| words[before].kind);
        matches!(before, Some(TokenKind::Colon | TokenKind::Arrow))
    };
    let mut places: Vec<Span> = words
        .iter()
        .enumerate()
        .filter(|(_, token)| token.kind == TokenKind::Name && written(analysis, token.span) == old)
        .filter(|(at, token)| token.span == found.span || !is_type(*at))
        .map(|(_, token)| token.span)
        .collect();
    if places.len() < 2 {
        return Vec::new();
    }
    places.sort();
    let count = places.len();
    let title =
        format!("write `{}` instead of `{old}` here and at {} more places", new.replacement, count - 1);
    let title = if count == 2 { title.replace("1 more places", "its use") } else { title };
    vec![places.into_iter().fold(Fix::titled(title), |fix, place| fix.with(place, &new.replacement))]
}
