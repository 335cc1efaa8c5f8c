//! What the grammar reads: tokens without trivia, with the little context that settles what a word means in its place.

use super::lexer::Lexed;
use super::token::TokenKind;
use crate::source::{Source, Span};

/// A token as the grammar sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lexeme<'s> {
    /// What it is.
    pub(super) kind: TokenKind,
    /// The text.
    pub(super) text: &'s str,
    /// What a word means here.
    pub(super) role: Role,
    /// The column, in bytes, of a token that is the first on its line.
    pub(super) indent: Option<u32>,
    /// Something has been said of it, or of what stood before it; or it was put in.
    pub(super) suspect: bool,
}

/// A lexeme and its place.
pub(super) type Placed<'s> = (Lexeme<'s>, Span);

/// What a word means, by what follows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// What its kind says.
    Plain,
    /// It stands before `:`.
    Label,
    /// It begins a member of an ifs.
    Member,
    /// `require` before a measure.
    Require,
    /// `assert` before a condition.
    Assert,
}

/// The words that begin a member of an ifs, beside `let`.
pub(super) const MEMBER_WORDS: &[&str] = &["transform", "germ", "keep", "boundary", "join"];

/// The words that stand between two operands, or open what follows one.
const INFIX_WORDS: &[&str] = &["and", "or", "by", "until", "each", "step", "as", "level"];

impl Lexeme<'_> {
    /// Whether it is this word, not a label.
    pub(super) fn is_word(&self, word: &str) -> bool {
        self.kind == TokenKind::Name && self.role != Role::Label && self.text == word
    }

    /// Whether it could begin a member of an ifs after a complete one.
    pub(super) fn may_begin_member(&self) -> bool {
        let word = self.kind == TokenKind::Name && self.role != Role::Label;
        self.kind == TokenKind::Let || word && MEMBER_WORDS.contains(&self.text)
    }
}

/// The tokens without trivia and errors.
pub(super) fn lexemes<'s>(source: &'s Source, lexed: &Lexed) -> Vec<Placed<'s>> {
    let mut found = Vec::with_capacity(lexed.tokens.len() / 2 + 1);
    let mut indent = Some(0);
    let mut after_error = false;
    for token in &lexed.tokens {
        let range = token.span.range();
        let text = &source.text[range];
        match token.kind {
            TokenKind::Whitespace => {
                if let Some(at) = text.rfind('\n') {
                    indent = Some((text.len() - at - 1) as u32);
                }
            }
            TokenKind::Error => {
                after_error = true;
                if let Some((last, _)) = found.last_mut() {
                    mark(last);
                }
            }
            kind if kind.is_trivia() => {}
            kind => {
                let suspect = after_error || lexed.suspects.contains(&token.span.start);
                let text = meant(kind, text);
                let lexeme = Lexeme { kind, text, role: Role::Plain, indent: indent.take(), suspect };
                found.push((lexeme, token.span));
                after_error = false;
            }
        }
    }
    found
}

fn mark(lexeme: &mut Lexeme<'_>) {
    lexeme.suspect = true;
}

/// The text of a token, where the characters stand for a word.
fn meant(kind: TokenKind, text: &str) -> &str {
    match (kind, text) {
        (TokenKind::Name, "&&") => "and",
        (TokenKind::Name, "||") => "or",
        _ => text,
    }
}

/// Finds what each word means by what follows it.
pub(super) fn assign_roles(lexemes: &mut [Placed<'_>]) {
    for at in 0..lexemes.len() {
        let next = lexemes.get(at + 1).map(|(next, _)| *next);
        let lexeme = &mut lexemes[at].0;
        if let Some(next) = next.filter(|_| lexeme.kind == TokenKind::Name) {
            lexeme.role = role(lexeme.text, next);
        }
    }
}

fn role(word: &str, next: Lexeme<'_>) -> Role {
    let name = next.kind == TokenKind::Name && !INFIX_WORDS.contains(&next.text);
    let value = name || {
        use TokenKind::*;
        matches!(next.kind, Number(_) | BadNumber | Text | True | False | If | Itself)
    };
    match word {
        _ if next.kind == TokenKind::Colon => Role::Label,
        "transform" | "boundary" | "join" if name => Role::Member,
        "germ" | "keep" if value => Role::Member,
        "require" if name => Role::Require,
        "assert" if value => Role::Assert,
        _ => Role::Plain,
    }
}

/// Whether an item begins at `at`: an item keyword which is followed by what it needs, or begins its line.
pub(super) fn begins_item(lexemes: &[Placed<'_>], at: usize) -> bool {
    let Some((lexeme, _)) = lexemes.get(at).filter(|(lexeme, _)| lexeme.kind.is_item_keyword()) else {
        return false;
    };
    if at > 0 && lexemes[at - 1].0.kind == TokenKind::Pub && lexeme.kind != TokenKind::Pub {
        return false;
    }
    let Some((next, _)) = lexemes.get(at + 1) else { return lexeme.indent.is_some() };
    let plausible = match lexeme.kind {
        TokenKind::Pub => next.kind.is_item_keyword() || next.kind == TokenKind::Let,
        TokenKind::Test => next.kind == TokenKind::Text,
        TokenKind::Use => matches!(next.kind, TokenKind::Name | TokenKind::Text),
        _ => next.kind == TokenKind::Name,
    };
    plausible || lexeme.indent.is_some() && next.kind != TokenKind::Colon
}
