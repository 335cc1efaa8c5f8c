//! Where a bracket must have ended though nobody closed it: by what follows, or by how the lines are indented.

use super::matcher::{FAR, Matcher};
use crate::source::Span;
use crate::syntax::lexeme::{Lexeme, Role};
use crate::syntax::token::TokenKind;

impl Matcher<'_, '_> {
    /// The indent of the line after the one `at` stands on, when only little stands between.
    pub(super) fn next_line_indent(&self, at: usize) -> Option<u32> {
        if !self.layout {
            return None;
        }
        self.region[at + 1..].iter().take(FAR).find_map(|(lexeme, _)| lexeme.indent)
    }

    /// Closes what cannot be open here: `let` stands in the outermost braces or in none, `->` after parameters, and
    /// `{` directly after a value begins the block of an item.
    pub(super) fn end_by_meaning(&mut self, lexeme: Lexeme<'_>, span: Span) {
        let brace = self.open.first().is_some_and(|open| open.kind == TokenKind::OpenBrace);
        let keyword = self.region.iter().map(|(first, _)| first.kind).find(|kind| *kind != TokenKind::Pub);
        let other = keyword
            .is_some_and(|kind| kind.is_keyword() && !matches!(kind, TokenKind::Ifs | TokenKind::Test));
        let outer = brace && !other;
        let keep = match lexeme.kind {
            // The parser says what is written in place of a loop.
            TokenKind::Let if self.open.iter().any(|open| open.foreign) => return,
            TokenKind::Let => usize::from(outer),
            TokenKind::Arrow => 0,
            TokenKind::OpenBrace if !brace && self.out.last().is_some_and(|(last, _)| ends_value(*last)) => 0,
            _ => return,
        };
        self.unclosed_above(keep, span);
    }

    /// Whether what was taken last is `for … `, `while …` or `if …` without `then`, outside of brackets: there is no such block.
    pub(super) fn after_foreign_head(&self) -> bool {
        let mut depth = 0usize;
        for (lexeme, _) in self.out.iter().rev().take(FAR) {
            match lexeme.kind {
                kind if kind.is_closer() => depth += 1,
                kind if kind.closer().is_some() && depth == 0 => return false,
                kind if kind.closer().is_some() => depth -= 1,
                _ if depth > 0 => {}
                TokenKind::For | TokenKind::If => return true,
                TokenKind::Name if lexeme.is_word("while") => return true,
                TokenKind::Then | TokenKind::Else | TokenKind::Equals | TokenKind::Colon => return false,
                _ => {}
            }
        }
        false
    }

    /// Closes the brackets which, by the indent of the line that begins at `at`, have ended.
    pub(super) fn end_by_layout(&mut self, at: usize, indent: u32) {
        let (lexeme, span) = self.region[at];
        while let Some(open) = self.open.last() {
            let begins = lexeme.kind == TokenKind::Let
                || lexeme.role != Role::Plain
                || open.kind == TokenKind::OpenBrace && !lexeme.kind.is_closer();
            let own_closer = lexeme.kind == open.closer && indent >= open.indent;
            let others = self.open.iter().filter(|other| other.kind == open.kind).count();
            let outer_closer = lexeme.kind == open.closer && indent < open.indent && others > 1;
            let fits = if open.kind == TokenKind::OpenBrace { open.indented } else { !own_closer };
            let ended = indent <= open.indent && fits && (begins && !own_closer || outer_closer);
            let goes_on = |last: TokenKind| last == TokenKind::Comma || last.closer().is_some();
            let fresh =
                lexeme.role != Role::Label || self.out.last().is_some_and(|(last, _)| !goes_on(last.kind));
            if !ended || !(fresh || open.kind == TokenKind::OpenBrace) {
                return;
            }
            if let Some(open) = self.open.pop() {
                self.unclosed(&open, span);
            }
        }
    }
}

/// Whether a value can end with this.
fn ends_value(lexeme: Lexeme<'_>) -> bool {
    use TokenKind::*;
    matches!(lexeme.kind, Name | Number(_) | Text | CloseParenthesis | CloseBracket | Itself | True | False)
}
