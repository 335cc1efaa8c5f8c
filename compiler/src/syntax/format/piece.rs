//! The text as a row of pieces: tokens without commas and spaces, each with the comments and line ends before it, and
//! with what the tree says of it.

use crate::source::Source;
use crate::syntax::token::{Token, TokenKind};

/// A token, or the end of the text.
#[derive(Clone, Debug)]
pub(super) struct Piece<'s> {
    /// What it is; at the end of the text, where it is empty, a space.
    pub(super) kind: TokenKind,
    /// How it is written.
    pub(super) text: &'s str,
    /// Its first byte.
    pub(super) start: u32,
    /// The comments before it.
    pub(super) comments: Vec<Comment<'s>>,
    /// Whether a line ends before it.
    pub(super) newline: bool,
    /// Whether a blank line stands just before it.
    pub(super) blank: bool,
    /// Whether a comma follows it.
    pub(super) comma: bool,
    /// What the tree says of it.
    pub(super) mark: Mark,
}

/// A comment of any kind, without spaces at its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Comment<'s> {
    /// With its slashes.
    pub(super) text: &'s str,
    /// Whether nothing stands before it on its line.
    pub(super) own_line: bool,
    /// Whether a blank line stands just before it.
    pub(super) blank: bool,
}

/// What a token does in its place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Mark {
    /// It begins an item, or an entry of a block.
    pub(super) statement: Option<Statement>,
    /// It begins a field of a record literal.
    pub(super) field: bool,
    /// It begins a clause of a comprehension.
    pub(super) clause: bool,
    /// A bracket that belongs to the name or the operand before it.
    pub(super) glued: bool,
    /// A bracket that never spans lines: of a type, of a family.
    pub(super) fixed: bool,
    /// A sign before its operand.
    pub(super) sign: bool,
    /// An operator between its operands.
    pub(super) operator: bool,
    /// A `..` with spaces.
    pub(super) loose: bool,
    /// A line may end before it.
    pub(super) breakable: bool,
    /// It may stand in a column with its like on the lines around; which of the columns of the line.
    pub(super) column: Option<u8>,
}

/// What begins, as far as the layout makes a difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Statement {
    Let,
    Param,
    Figure,
    Transform,
    Boundary,
    Setting,
    /// A record or a fabricate block, whose entries may have commas.
    Fields,
    /// An ifs or a test, whose entries have none.
    Members,
    Other,
}

/// What is collected before the next piece.
#[derive(Default)]
struct Before<'s> {
    comments: Vec<Comment<'s>>,
    /// Line ends since the last token or comment.
    lines: usize,
    newline: bool,
    /// Whether no token stands before.
    at_start: bool,
}

/// The pieces of a text; the last is its end.
pub(super) fn pieces<'s>(source: &'s Source, tokens: &[Token]) -> Vec<Piece<'s>> {
    let mut found: Vec<Piece<'s>> = Vec::with_capacity(tokens.len() / 2 + 1);
    let mut before = Before { newline: true, at_start: true, ..Before::default() };
    for token in tokens {
        let text = source.slice(token.span);
        match token.kind {
            TokenKind::Whitespace => {
                before.lines += text.bytes().filter(|byte| *byte == b'\n').count();
                before.newline |= before.lines > 0;
            }
            kind if kind.is_trivia() => before.comment(text),
            TokenKind::Comma => {
                if let Some(last) = found.last_mut() {
                    last.comma = true;
                }
                before.lines = 0;
            }
            kind => found.push(before.piece(kind, text, token.span.start)),
        }
    }
    found.push(before.piece(TokenKind::Whitespace, "", source.text.len() as u32));
    found
}

impl<'s> Before<'s> {
    fn comment(&mut self, text: &'s str) {
        let first = self.comments.is_empty() && !self.at_start;
        let own_line = self.lines > 0 || !first;
        self.comments.push(Comment { text: text.trim_end(), own_line, blank: self.lines > 1 });
        self.lines = 0;
        self.newline = true;
    }

    fn piece(&mut self, kind: TokenKind, text: &'s str, start: u32) -> Piece<'s> {
        let blank = self.lines > 1;
        let Before { comments, newline, .. } = std::mem::take(self);
        Piece { kind, text, start, comments, newline, blank, comma: false, mark: Mark::default() }
    }
}
