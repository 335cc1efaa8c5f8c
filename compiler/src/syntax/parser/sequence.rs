//! Comma-separated elements in brackets, and fields with optional commas in braces.

use super::expected::Expected;
use super::primitive::{Small, lexeme, not_closer, token};
use super::recovery::{Stop, finished, skip};
use super::{Extra, Rule, Tokens};
use crate::source::Span;
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// `a, b, c,`: elements up to a closing bracket. An element that fails is passed over.
pub(super) fn elements<'s, O: 's>(
    element: impl Parser<'s, Tokens<'s>, O, Extra<'s>> + Clone + 's,
    fallback: impl Fn(Span) -> O + Clone + 's,
) -> Rule<'s, Vec<O>> {
    not_closer()
        .ignore_then(finished(element, Stop::Element, fallback))
        .separated_by(token(TokenKind::Comma))
        .allow_trailing()
        .collect()
        .boxed()
}

/// The same between parentheses, of which the opening one is expected as `open`.
pub(super) fn parenthesized<'s, O: 's>(
    open: Expected,
    element: impl Parser<'s, Tokens<'s>, O, Extra<'s>> + Clone + 's,
    fallback: impl Fn(Span) -> O + Clone + 's,
) -> Rule<'s, Vec<O>> {
    let opening = opening(TokenKind::OpenParenthesis, open);
    elements(element, fallback).delimited_by(opening, token(TokenKind::CloseParenthesis)).boxed()
}

/// An opening bracket, expected as `open`.
pub(super) fn opening<'s>(kind: TokenKind, open: Expected) -> impl Small<'s, ()> {
    lexeme(open, move |found, _| (found.kind == kind).then_some(()))
}

/// `{ … }` with entries that end at `stop`; a comma between them is optional. What fails is passed over.
pub(super) fn block<'s, O: 's>(
    entry: impl Parser<'s, Tokens<'s>, O, Extra<'s>> + Clone + 's,
    stop: Stop,
    fallback: impl Fn(Span) -> O + Clone + 's,
    open: Expected,
) -> Rule<'s, Vec<O>> {
    let comma = token(TokenKind::Comma).or_not();
    let rest = super::recovery::complete(stop).recover_with(via_parser(skip(stop, false).ignored()));
    let entry = entry.recover_with(via_parser(skip(stop, true).map(fallback))).then_ignore(rest);
    let entries = not_closer().ignore_then(entry).then_ignore(comma).repeated().collect();
    entries.delimited_by(opening(TokenKind::OpenBrace, open), token(TokenKind::CloseBrace)).boxed()
}
