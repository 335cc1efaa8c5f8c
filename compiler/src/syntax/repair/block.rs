//! The `{` of an item's block where only its `}` was written.

use super::matcher::put_in;
use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::lexeme::Placed;
use crate::syntax::token::TokenKind;

/// Puts the missing `{` of an item into its lexemes, if the item has a block and none was opened.
pub(super) fn open(out: &mut Vec<Placed<'_>>) -> Option<Diagnostic> {
    let first = usize::from(out.first()?.0.kind == TokenKind::Pub);
    let kind = |at: usize| out.get(at).map(|(lexeme, _)| lexeme.kind);
    let place = match kind(first)? {
        TokenKind::Record | TokenKind::Test => first + 2,
        TokenKind::Fabricate if out.get(first + 2)?.0.is_word("as") => first + 4,
        TokenKind::Ifs => {
            let space =
                (first..out.len()).find(|at| matches!(kind(*at), Some(TokenKind::On | TokenKind::In)))?;
            match kind(space + 1)? {
                TokenKind::OpenParenthesis => closing(out, space + 1)? + 1,
                _ => space + 2,
            }
        }
        _ => return None,
    };
    if kind(place) == Some(TokenKind::OpenBrace) {
        return None;
    }
    let before = out.get(place.checked_sub(1)?)?.1;
    let span = out.get(place).map_or(before.after(), |(_, span)| *span);
    out.insert(place, (put_in(TokenKind::OpenBrace), before.after()));
    if let Some((next, _)) = out.get_mut(place + 1) {
        next.suspect = true;
    }
    Some(missing(span, before.after()))
}

/// Where the bracket at `at` is closed.
fn closing(out: &[Placed<'_>], at: usize) -> Option<usize> {
    let mut depth = 0usize;
    for (place, (lexeme, _)) in out.iter().enumerate().skip(at) {
        if lexeme.kind.closer().is_some() {
            depth += 1;
        } else if lexeme.kind.is_closer() {
            depth -= 1;
        }
        if depth == 0 {
            return Some(place);
        }
    }
    None
}

fn missing(found: Span, place: Span) -> Diagnostic {
    Diagnostic::new(Code::E0201, found, "expected `{` before this")
        .note("the block is closed with `}` further down")
        .fix("open the block with `{`", place, " {")
}
