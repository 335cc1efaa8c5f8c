//! Text to tokens: every byte belongs to one, trivia and errors included. Where numbers end is in `number`, what is
//! said of characters outside the language in `strange`.

mod number;
mod strange;
pub(super) mod text;

use super::limits::Said;
use super::token::{Token, TokenKind};
use crate::diagnostic::{Code, Diagnostic};
use crate::source::{Source, Span};
use logos::{Lexer, Logos};
use std::collections::BTreeSet;

/// The tokens of a file.
pub(super) struct Lexed {
    /// All of them, in order, without gaps.
    pub(super) tokens: Vec<Token>,
    /// Where the tokens start of which something has been said.
    pub(super) suspects: BTreeSet<u32>,
}

/// Splits a text into tokens.
pub(super) fn lex(source: &Source, said: &mut Said) -> Lexed {
    let mut scanner = Scanner {
        source,
        lexer: TokenKind::lexer(&source.text),
        said,
        no_block_end: false,
        lexed: Lexed { tokens: Vec::with_capacity(source.text.len() / 3), suspects: BTreeSet::new() },
    };
    while let Some(found) = scanner.lexer.next() {
        scanner.token(found.unwrap_or(TokenKind::Error));
    }
    let lexed = scanner.lexed;
    strange::report_bidirectional(source, said);
    lexed
}

/// The state of a run of the lexer.
struct Scanner<'s, 'd> {
    source: &'s Source,
    lexer: Lexer<'s, TokenKind>,
    said: &'d mut Said,
    /// Whether it is known that no `*/` follows.
    no_block_end: bool,
    lexed: Lexed,
}

impl<'s> Scanner<'s, '_> {
    /// Finishes the token that was just found, and keeps it.
    fn token(&mut self, found: TokenKind) {
        let kind = match found {
            TokenKind::Comment => comment_kind(self.lexer.slice()),
            TokenKind::Number(_) => self.number(),
            TokenKind::Name => self.name(),
            TokenKind::Text => self.text(),
            TokenKind::Slash if self.lexer.remainder().starts_with('*') => self.block_comment(),
            TokenKind::Error => self.strange(),
            other => other,
        };
        let span = self.span();
        self.lexed.tokens.push(Token { kind, span });
    }

    /// The span of the token as it is now.
    fn span(&self) -> Span {
        let range = self.lexer.span();
        Span::new(self.source.id, range.start as u32, range.end as u32)
    }

    /// Marks the token and says something of it.
    fn complain(&mut self, make: impl FnOnce() -> Diagnostic) {
        self.lexed.suspects.insert(self.lexer.span().start as u32);
        self.said.push(make);
    }

    /// Takes more characters into the token while they please.
    fn take_while(&mut self, pleases: impl Fn(char) -> bool) {
        let rest = self.lexer.remainder();
        let end = rest.find(|c| !pleases(c)).unwrap_or(rest.len());
        self.lexer.bump(end);
    }

    /// A name; letters outside ASCII are taken with it and complained of.
    fn name(&mut self) -> TokenKind {
        if self.lexer.remainder().chars().next().is_some_and(|c| !c.is_ascii() && c.is_alphanumeric()) {
            self.foreign_name();
        }
        TokenKind::Name
    }

    /// The rest of a name with letters outside ASCII.
    fn foreign_name(&mut self) {
        self.take_while(|c| c.is_alphanumeric() || c == '_');
        let (span, text) = (self.span(), self.lexer.slice());
        self.complain(|| {
            Diagnostic::new(Code::E0102, span, format!("the name `{text}` has letters outside a–z"))
                .hint("names are written with the letters a to z, digits and `_`")
        });
    }

    /// A text, closed or not.
    fn text(&mut self) -> TokenKind {
        let (span, slice) = (self.span(), self.lexer.slice());
        if !text::is_closed(slice) {
            // A backslash before the line end is left outside by the pattern.
            self.take_while(|c| c == '\\');
            let end = self.span().after();
            self.complain(|| {
                Diagnostic::new(Code::E0103, span, "this text has no closing quote")
                    .label("opened here")
                    .note("a text ends on the line it begins on")
                    .fix("close it with `\"`", end, "\"")
            });
            return TokenKind::Text;
        }
        for escape in text::unknown_escapes(slice) {
            let at = span.start + escape.start as u32;
            let place = Span::new(span.file, at, at + escape.len() as u32);
            let shown = &slice[escape];
            self.complain(|| {
                Diagnostic::new(Code::E0102, place, format!("`{shown}` is not an escape of a text"))
                    .note("the escapes are `\\\"`, `\\\\`, `\\n` and `\\t`")
                    .fix("a backslash itself is written twice", place, format!("\\{shown}"))
            });
        }
        TokenKind::Text
    }
}

/// Which of the comments a text from `//` to the line end is.
fn comment_kind(text: &str) -> TokenKind {
    if text.starts_with("//!") {
        TokenKind::FileDocs
    } else if text.starts_with("///") && !text.starts_with("////") {
        TokenKind::ItemDocs
    } else {
        TokenKind::Comment
    }
}
