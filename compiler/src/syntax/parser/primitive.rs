//! The smallest rules: one token, one word, a lookahead.

use super::expected::{Expected, Miss};
use super::{Extra, Lexeme, Tokens};
use crate::source::Span;
use crate::syntax::token::TokenKind;
use chumsky::input::InputRef;
use chumsky::prelude::*;

/// A rule that is not boxed.
pub(super) trait Small<'s, O>: Parser<'s, Tokens<'s>, O, Extra<'s>> + Copy + 's {}
impl<'s, O, P: Parser<'s, Tokens<'s>, O, Extra<'s>> + Copy + 's> Small<'s, O> for P {}

/// One lexeme that pleases.
pub(super) fn lexeme<'s, O: 's>(
    expected: Expected,
    pick: impl Fn(Lexeme<'s>, Span) -> Option<O> + Copy + 's,
) -> impl Small<'s, O> {
    custom(move |input: &mut InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let before = input.save();
        let start = input.cursor();
        let found = input.next();
        let span = input.span_since(&start);
        match found.and_then(|found| pick(found, span)) {
            Some(out) => Ok(out),
            None => {
                input.rewind(before);
                Err(Miss::new(expected, span))
            }
        }
    })
}

/// A token of this kind; gives its span.
pub(super) fn token<'s>(kind: TokenKind) -> impl Small<'s, Span> {
    lexeme(Expected::of(kind), move |found, span| (found.kind == kind).then_some(span))
}

/// A word that means something here.
pub(super) fn word<'s>(word: &'static str, expected: Expected) -> impl Small<'s, Span> {
    lexeme(expected, move |found, span| found.is_word(word).then_some(span))
}

/// Takes nothing; succeeds when the next lexeme, or the end of the item, pleases.
pub(super) fn ahead<'s>(
    expected: &'static [Expected],
    pleases: impl Fn(Option<Lexeme<'s>>) -> bool + Copy + 's,
) -> impl Small<'s, ()> {
    custom(move |input: &mut InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let next = input.peek();
        if pleases(next) {
            return Ok(());
        }
        let before = input.save();
        let start = input.cursor();
        input.next();
        let span = input.span_since(&start);
        input.rewind(before);
        Err(Miss::any(expected, span))
    })
}

/// Takes nothing; fails before a closing bracket and at the end.
pub(super) fn not_closer<'s>() -> impl Small<'s, ()> {
    ahead(&[], |next| next.is_some_and(|next| !next.kind.is_closer()))
}
