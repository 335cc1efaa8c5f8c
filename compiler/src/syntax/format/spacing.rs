//! The space between two pieces that stand on one line.

use super::piece::Piece;
use crate::syntax::token::TokenKind;

/// How many spaces part what stands side by side on a line without a comma.
pub(super) const APART: usize = 3;

/// The number of spaces before the piece at `at`; `commas` says which pieces have one after them.
pub(super) fn space(pieces: &[Piece<'_>], commas: &[bool], at: usize) -> usize {
    let Some(before) = at.checked_sub(1).and_then(|before| pieces.get(before)) else { return 0 };
    let piece = &pieces[at];
    if before.kind == TokenKind::OpenBrace || piece.kind == TokenKind::CloseBrace {
        let empty = before.kind == TokenKind::OpenBrace && piece.kind == TokenKind::CloseBrace;
        return usize::from(!empty);
    }
    if is_step(piece) || piece.mark.statement.is_some() && !commas[at - 1] {
        return APART;
    }
    let tight = piece.mark.glued
        || before.mark.sign
        || closes(piece.kind)
        || opens(before.kind)
        || is_tight(pieces, at)
        || is_tight(pieces, at - 1) && before.kind != TokenKind::Colon;
    usize::from(!tight)
}

/// The step of a parameter stands apart.
fn is_step(piece: &Piece<'_>) -> bool {
    piece.mark.column == Some(2) && piece.kind == TokenKind::Name
}

fn opens(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::OpenParenthesis | TokenKind::OpenBracket)
}

fn closes(kind: TokenKind) -> bool {
    matches!(kind, TokenKind::CloseParenthesis | TokenKind::CloseBracket)
}

/// Whether there is no space before a piece, and none after it but after a colon.
fn is_tight(pieces: &[Piece<'_>], at: usize) -> bool {
    match pieces[at].kind {
        TokenKind::Dot | TokenKind::Colon => true,
        TokenKind::DotDot => !pieces[at].mark.loose,
        TokenKind::Slash => is_fraction(pieces, at),
        _ => false,
    }
}

/// Whether a `/` stands between two plain numbers, and the first is not divided already: `4/3`, but `a / 4 / 3`.
fn is_fraction(pieces: &[Piece<'_>], at: usize) -> bool {
    let plain = |at: usize| pieces.get(at).is_some_and(|piece| piece.kind == TokenKind::Number(None));
    let divided = at > 1 && pieces[at - 2].kind == TokenKind::Slash;
    at > 0 && plain(at - 1) && plain(at + 1) && !divided
}

/// Whether the author's line end before the piece at `at` may stay, elements of brackets and entries apart.
pub(super) fn may_break(pieces: &[Piece<'_>], at: usize, in_statement: bool) -> bool {
    use TokenKind::*;
    let Some(before) = at.checked_sub(1).and_then(|before| pieces.get(before)) else { return false };
    let piece = &pieces[at];
    let operator = |piece: &Piece<'_>| {
        let compares = matches!(piece.kind, EqualEqual | NotEqual | Less | AtMost | Greater | AtLeast);
        piece.mark.operator && !is_fraction(pieces, at) || compares
    };
    let begins = matches!(piece.kind, On | At | Then | Else) || piece.mark.breakable || operator(piece);
    let ends = matches!(before.kind, Then | Else) || operator(before);
    let value = before.kind == Equals && in_statement;
    (begins || ends || value) && !is_tight(pieces, at) && !is_tight(pieces, at - 1)
}
