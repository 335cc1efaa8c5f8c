//! Where a rule that failed goes on: the places a reader would look for next.

use super::expected::Expected;
use super::primitive::{Small, ahead};
use super::{Extra, Lexeme, Tokens};
use crate::source::Span;
use crate::syntax::lexeme::Role;
use crate::syntax::token::TokenKind;
use chumsky::input::InputRef;
use chumsky::prelude::*;

/// Where something ends, beside at a closing bracket and at the end of the item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// Nowhere else.
    Item,
    /// At the next member of an ifs.
    Member,
    /// At the next field or requirement.
    Entry,
    /// At the next line of a test.
    Step,
    /// At a comma.
    Element,
    /// At a comma or a `for`.
    ListElement,
    /// At a `for` or an `if`.
    Clause,
    /// At the range or the step of a parameter.
    Param,
    /// At what follows a type.
    Type,
}

impl Stop {
    /// Whether what stood before is complete here.
    fn ends(self, next: Lexeme<'_>) -> bool {
        let kind = next.kind;
        match self {
            Stop::Item => false,
            Stop::Member => next.may_begin_member(),
            Stop::Entry => kind == TokenKind::Comma || next.role == Role::Label || next.is_word("require"),
            Stop::Step => kind == TokenKind::Let || next.is_word("assert"),
            Stop::Element => kind == TokenKind::Comma,
            Stop::ListElement => matches!(kind, TokenKind::Comma | TokenKind::For),
            Stop::Clause => matches!(kind, TokenKind::For | TokenKind::If),
            Stop::Param => kind == TokenKind::In || next.is_word("step"),
            Stop::Type => matches!(kind, TokenKind::Equals | TokenKind::Comma) || next.role == Role::Label,
        }
    }

    /// Whether a search for the next sound place stops here.
    fn resumes(self, next: Lexeme<'_>) -> bool {
        match self {
            Stop::Member => next.kind == TokenKind::Let || next.role == Role::Member,
            Stop::Step => next.kind == TokenKind::Let || next.role == Role::Assert,
            Stop::Entry => next.kind == TokenKind::Comma || matches!(next.role, Role::Label | Role::Require),
            other => other.ends(next),
        }
    }

    fn expected(self) -> &'static [Expected] {
        match self {
            Stop::Item => &[Expected::NextItem],
            Stop::Member => &[Expected::NextMember, Expected::CloseBrace],
            Stop::Entry => &[Expected::NextEntry, Expected::CloseBrace],
            Stop::Step => &[Expected::NextStep, Expected::CloseBrace],
            Stop::Element => &[Expected::Comma],
            Stop::ListElement => &[Expected::Comma, Expected::For],
            Stop::Clause => &[Expected::For],
            Stop::Param => &[Expected::Range, Expected::Step, Expected::NextItem],
            Stop::Type => &[Expected::Equals],
        }
    }
}

/// Takes nothing; succeeds where something is complete.
pub(super) fn complete<'s>(stop: Stop) -> impl Small<'s, ()> {
    ahead(stop.expected(), move |next| next.is_none_or(|next| next.kind.is_closer() || stop.ends(next)))
}

/// Passes over lexemes, brackets as a whole, up to the next sound place; at least over one where `some` is set.
pub(super) fn skip<'s>(stop: Stop, some: bool) -> impl Small<'s, Span> {
    custom(move |input: &mut InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let start = input.cursor();
        let mut depth = 0usize;
        let mut first = some;
        while let Some(next) = input.peek() {
            let kind = next.kind;
            if depth == 0 && (kind.is_closer() || !first && stop.resumes(next)) {
                break;
            }
            first = false;
            if kind.closer().is_some() {
                depth += 1;
            } else if kind.is_closer() {
                depth -= 1;
            }
            input.next();
        }
        Ok(input.span_since(&start))
    })
}

/// A rule which ends at `stop`; what it does not take up to there is passed over, with one error. Where it fails,
/// `fallback` stands for what was passed over.
pub(super) fn finished<'s, O: 's>(
    rule: impl Parser<'s, Tokens<'s>, O, Extra<'s>> + Clone + 's,
    stop: Stop,
    fallback: impl Fn(Span) -> O + Clone + 's,
) -> super::Rule<'s, O> {
    let rest = complete(stop).recover_with(via_parser(skip(stop, false).ignored()));
    rule.recover_with(via_parser(skip(stop, false).map(fallback))).then_ignore(rest).boxed()
}
