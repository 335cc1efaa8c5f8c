//! Characters outside the language: what was probably meant, and the invisible ones that could deceive a reader.

use super::Scanner;
use crate::diagnostic::{Code, Diagnostic};
use crate::source::{Source, Span};
use crate::syntax::limits::Said;
use crate::syntax::token::TokenKind;

/// Characters that are often written, what to write instead, and the token that is meant.
const LOOKALIKES: &[(&str, &str, TokenKind)] = &[
    ("&&", "and", TokenKind::Name),
    ("||", "or", TokenKind::Name),
    ("×", "*", TokenKind::Star),
    ("·", "*", TokenKind::Star),
    ("÷", "/", TokenKind::Slash),
    ("−", "-", TokenKind::Minus),
    ("–", "-", TokenKind::Minus),
    ("—", "-", TokenKind::Minus),
    ("≤", "<=", TokenKind::AtMost),
    ("≥", ">=", TokenKind::AtLeast),
    ("≠", "!=", TokenKind::NotEqual),
    ("→", "->", TokenKind::Arrow),
    ("\u{a0}", " ", TokenKind::Whitespace),
];

/// How far the end of a text in other quotes is looked for, in characters.
const LONGEST_QUOTED: usize = 200;

/// What people write around texts.
const QUOTES: &[(char, char)] = &[('\'', '\''), ('“', '”'), ('„', '“'), ('«', '»')];

impl Scanner<'_, '_> {
    /// A character no pattern knows; takes those that belong to it.
    pub(super) fn strange(&mut self) -> TokenKind {
        let rest = &self.source.text[self.lexer.span().start..];
        let first = rest.chars().next().unwrap_or_default();
        if first == '\u{feff}' && self.lexer.span().start == 0 {
            return TokenKind::Whitespace;
        }
        if is_bidirectional(first) {
            self.lexed.suspects.insert(self.lexer.span().start as u32);
            return TokenKind::Error;
        }
        if first.is_alphabetic() {
            self.foreign_name();
            return TokenKind::Name;
        }
        let lookalike = LOOKALIKES.iter().find(|(strange, ..)| rest.starts_with(strange));
        if let Some((strange, instead, kind)) = lookalike {
            self.lexer.bump(strange.len().saturating_sub(self.lexer.slice().len()));
            self.replace(strange, instead);
            return *kind;
        }
        if let Some((_, close)) = QUOTES.iter().find(|(open, _)| *open == first)
            && let Some(kind) = self.quoted(rest, first, *close)
        {
            return kind;
        }
        if first == '#' {
            self.take_while(|c| c != '\n');
            let span = self.span();
            let mark = Span::new(span.file, span.start, span.start + 1);
            self.complain(|| {
                Diagnostic::new(Code::E0102, mark, "`#` does not begin a comment").fix(
                    "comments begin with `//`",
                    mark,
                    "//",
                )
            });
            return TokenKind::Comment;
        }
        self.unknown(first);
        TokenKind::Error
    }

    /// Says what to write instead of the token.
    fn replace(&mut self, strange: &str, instead: &'static str) {
        let span = self.span();
        let shown = if strange == "\u{a0}" { "a no-break space".to_owned() } else { format!("`{strange}`") };
        let better = if instead == " " { "a plain space".to_owned() } else { format!("`{instead}`") };
        self.complain(|| {
            Diagnostic::new(Code::E0102, span, format!("{shown} is not used here")).fix(
                format!("write {better}"),
                span,
                instead,
            )
        });
    }

    /// A text in other quotes, if it is closed on its line.
    fn quoted(&mut self, rest: &str, open: char, close: char) -> Option<TokenKind> {
        let inner = &rest[open.len_utf8()..];
        let near = inner.char_indices().take(LONGEST_QUOTED).take_while(|(_, c)| *c != '\n');
        let length = near.into_iter().find(|(_, c)| *c == close)?.0;
        let whole = open.len_utf8() + length + close.len_utf8();
        self.lexer.bump(whole.saturating_sub(self.lexer.slice().len()));
        let (span, plain) = (self.span(), format!("\"{}\"", &inner[..length]));
        self.complain(|| {
            Diagnostic::new(Code::E0102, span, format!("texts are not written in {open}…{close}")).fix(
                "texts stand between straight double quotes",
                span,
                plain,
            )
        });
        Some(TokenKind::Text)
    }

    /// A run of characters without any meaning.
    fn unknown(&mut self, first: char) {
        let known = |c: char| {
            c.is_ascii_alphanumeric() || c.is_ascii_whitespace() || "()[]{},:.=<>+-*/_\"'#&|".contains(c)
        };
        if first != ';' {
            self.take_while(|c| !known(c) && !c.is_alphabetic() && !is_bidirectional(c) && c != ';');
        }
        let (span, shown) = (self.span(), self.lexer.slice());
        self.complain(|| {
            let found = Diagnostic::new(Code::E0102, span, format!("{} is not used here", printable(shown)));
            match first {
                ';' => found.fix("line ends and `;` are not needed: leave it out", span, ""),
                '%' => found.hint("a percentage is glued to its number: `50%`; a remainder is `mod(a, b)`"),
                '^' => found.hint("there is no `^`: multiply, or call a function"),
                '!' => found.fix("the opposite of a condition is `not`", span, "not "),
                '°' => found.hint("angles are written with the unit glued to the number: `35deg`"),
                '…' => found.hint("write out what it stands for; a range is `a .. b`"),
                '²' | '³' => found.hint("write a product: `a * a`"),
                _ => found,
            }
        });
    }

    /// `/* … */`, or to the end of the line where it is not closed.
    pub(super) fn block_comment(&mut self) -> TokenKind {
        let rest = self.lexer.remainder();
        let inner = rest.get(1..).filter(|_| !self.no_block_end).unwrap_or_default();
        let close = inner.find("*/");
        // Without this a file of unclosed `/*` would be searched again for each.
        self.no_block_end |= close.is_none();
        let end = close.map_or_else(|| rest.find('\n').unwrap_or(rest.len()), |at| at + 3);
        self.lexer.bump(end);
        let start = self.span().start;
        let span = Span::new(self.source.id, start, start + 2);
        self.complain(|| {
            Diagnostic::new(Code::E0102, span, "`/*` does not begin a comment")
                .hint("comments begin with `//` and go to the end of the line")
        });
        TokenKind::Comment
    }
}

/// The characters as they can be printed.
fn printable(text: &str) -> String {
    let shown: String = text.chars().take(8).collect();
    if shown.chars().all(|c| !c.is_control() && !c.is_whitespace()) {
        return format!("`{shown}`");
    }
    let codes: Vec<String> = shown.chars().map(|c| format!("U+{:04X}", u32::from(c))).collect();
    format!("the character {}", codes.join(" "))
}

/// Whether a character changes the direction in which the text around it is shown.
fn is_bidirectional(c: char) -> bool {
    matches!(c, '\u{061c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Says where characters stand that change the direction of the text, comments and texts included.
pub(super) fn report_bidirectional(source: &Source, said: &mut Said) {
    if source.text.is_ascii() {
        return;
    }
    for (at, c) in source.text.char_indices().filter(|(_, c)| is_bidirectional(*c)) {
        if said.is_full() {
            return;
        }
        let span = Span::new(source.id, at as u32, (at + c.len_utf8()) as u32);
        let message =
            format!("the invisible character U+{:04X} changes the direction of the text", u32::from(c));
        said.push(|| {
            Diagnostic::new(Code::E0106, span, message)
                .note("what is shown could differ from what is read")
                .fix("remove it", span, "")
        });
    }
}
