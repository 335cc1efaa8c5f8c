//! What the grammar expected and did not find: a place and a set of expectations.

use super::{Lexeme, Tokens};
use crate::source::Span;
use crate::syntax::token::TokenKind;
use chumsky::DefaultExpected;
use chumsky::error::{Error, LabelError};
use chumsky::util::MaybeRef;

/// Something the grammar expects, in the order in which a message names them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub(super) enum Expected {
    Item,
    Value,
    Name,
    Type,
    Module,
    Text,
    Measure,
    Comparison,
    Space,
    Level,
    As,
    On,
    In,
    Then,
    Else,
    Equals,
    Colon,
    Comma,
    Arrow,
    Dot,
    DotDot,
    Unit,
    OpenParenthesis,
    OpenBracket,
    OpenBrace,
    NextEntry,
    NextMember,
    NextStep,
    NextItem,
    CloseParenthesis,
    CloseBracket,
    CloseBrace,
    For,
    Range,
    Step,
    Family,
    Operator,
    /// Not an expectation: `if` is nested too deeply here.
    Shallower,
}

impl Expected {
    /// All of them, in order.
    const ALL: &[Expected] = {
        use Expected::*;
        &[
            Item,
            Value,
            Name,
            Type,
            Module,
            Text,
            Measure,
            Comparison,
            Space,
            Level,
            As,
            On,
            In,
            Then,
            Else,
            Equals,
            Colon,
            Comma,
            Arrow,
            Dot,
            DotDot,
            Unit,
            OpenParenthesis,
            OpenBracket,
            OpenBrace,
            NextEntry,
            NextMember,
            NextStep,
            NextItem,
            CloseParenthesis,
            CloseBracket,
            CloseBrace,
            For,
            Range,
            Step,
            Family,
            Operator,
            Shallower,
        ]
    };

    /// The words for it.
    pub(super) fn words(self) -> &'static str {
        use Expected::*;
        match self {
            Item => "an item",
            Value => "a value",
            Name => "a name",
            Type => "a type",
            Module => "a module such as `std.curves` or \"./ribs.ifs\"",
            Text => "a text in quotes",
            Measure => "a measure such as `edge`",
            Comparison => "`<=`, `>=` or `in`",
            Space => "a space (`on (p0, p1)`, `in plane` or `in space`)",
            Level => "`level`",
            As => "`as`",
            On => "`on`",
            In => "`in`",
            Then => "`then`",
            Else => "`else`",
            Equals => "`=`",
            Colon => "`:`",
            Comma => "`,`",
            Arrow => "`->`",
            Dot => "`.`",
            DotDot => "`..`",
            Unit => "`plane` or `space`",
            OpenParenthesis => "`(`",
            OpenBracket => "`[`",
            OpenBrace => "`{`",
            CloseParenthesis => "`)`",
            CloseBracket => "`]`",
            CloseBrace => "`}`",
            NextEntry => "the next field",
            NextMember => "a member (`let`, `transform`, `germ`, `keep`, `boundary` or `join`)",
            NextStep => "`let` or `assert`",
            NextItem => "the next item",
            For => "`for`",
            Range => "`in` and a range",
            Step => "`step`",
            Family => "`[`",
            Operator => "an operator",
            Shallower => "less nesting",
        }
    }

    /// The expectation of a kind of token that is always written the same.
    pub(super) fn of(kind: TokenKind) -> Expected {
        match kind {
            TokenKind::OpenParenthesis => Expected::OpenParenthesis,
            TokenKind::CloseParenthesis => Expected::CloseParenthesis,
            TokenKind::OpenBracket => Expected::OpenBracket,
            TokenKind::CloseBracket => Expected::CloseBracket,
            TokenKind::OpenBrace => Expected::OpenBrace,
            TokenKind::CloseBrace => Expected::CloseBrace,
            TokenKind::Comma => Expected::Comma,
            TokenKind::Colon => Expected::Colon,
            TokenKind::Arrow => Expected::Arrow,
            TokenKind::Dot => Expected::Dot,
            TokenKind::DotDot => Expected::DotDot,
            TokenKind::Equals => Expected::Equals,
            TokenKind::In => Expected::In,
            TokenKind::Then => Expected::Then,
            TokenKind::Else => Expected::Else,
            TokenKind::On => Expected::On,
            _ => Expected::Value,
        }
    }

    fn bit(self) -> u64 {
        1 << (self as u8)
    }
}

/// A missed expectation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Miss {
    /// What stood there instead; empty at the end of the item.
    pub(super) span: Span,
    set: u64,
}

impl Miss {
    /// A miss of one expectation.
    pub(super) fn new(expected: Expected, span: Span) -> Self {
        Miss { span, set: expected.bit() }
    }

    /// A miss of several.
    pub(super) fn any(expected: &[Expected], span: Span) -> Self {
        Miss { span, set: expected.iter().fold(0, |set, one| set | one.bit()) }
    }

    /// Whether this was among what was expected.
    pub(super) fn has(self, expected: Expected) -> bool {
        self.set & expected.bit() != 0
    }

    /// What was expected, in order.
    pub(super) fn expectations(self) -> impl Iterator<Item = Expected> {
        Expected::ALL.iter().copied().filter(move |one| self.has(*one))
    }
}

impl<'s> Error<'s, Tokens<'s>> for Miss {
    fn merge(self, other: Self) -> Self {
        Miss { span: self.span, set: self.set | other.set }
    }
}

impl<'s> LabelError<'s, Tokens<'s>, DefaultExpected<'s, Lexeme<'s>>> for Miss {
    fn expected_found<E: IntoIterator<Item = DefaultExpected<'s, Lexeme<'s>>>>(
        expected: E,
        _: Option<MaybeRef<'s, Lexeme<'s>>>,
        span: Span,
    ) -> Self {
        let end = |one: &DefaultExpected<'s, Lexeme<'s>>| matches!(one, DefaultExpected::EndOfInput);
        let set = if expected.into_iter().any(|one| end(&one)) { Expected::NextItem.bit() } else { 0 };
        Miss { span, set }
    }
}

impl<'s> LabelError<'s, Tokens<'s>, Expected> for Miss {
    fn expected_found<E: IntoIterator<Item = Expected>>(
        expected: E,
        _: Option<MaybeRef<'s, Lexeme<'s>>>,
        span: Span,
    ) -> Self {
        Miss { span, set: expected.into_iter().fold(0, |set, one| set | one.bit()) }
    }

    fn label_with(&mut self, label: Expected) {
        self.set = label.bit();
    }
}
