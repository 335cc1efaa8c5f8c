//! The kinds of token, with the patterns that find them, and the words the language keeps for itself. How numbers end,
//! and what is said of strange characters, is the lexer's.

use super::ast::Unit;
use crate::source::Span;
use logos::Logos;

/// A piece of the text. The tokens of a file follow each other without gaps and cover every byte.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands; never empty.
    pub span: Span,
}

macro_rules! token_kinds {
    ($(#[$about:meta])* $($variant:ident $text:literal,)* ; keywords $($keyword:ident $word:literal,)*) => {
        $(#[$about])*
        #[derive(Logos, Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum TokenKind {
            /// Spaces, tabs, line ends.
            #[regex(r"[ \t\r\n\f]+")]
            Whitespace,
            /// `// …` and `//// …`
            #[regex(r"//[^\n]*", allow_greedy = true)]
            Comment,
            /// `/// …`: documents what follows.
            ItemDocs,
            /// `//! …`: documents the file.
            FileDocs,
            /// `12`, `0.46`, `27mm`: digits with the unit that is glued to them.
            #[regex(r"[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]+)?", |_| Some(None))]
            Number(Option<Unit>),
            /// A number that cannot be used: with an unknown unit, or too large.
            BadNumber,
            /// `"…"`
            #[regex(r#""([^"\\\n]|\\[^\n])*"?"#)]
            Text,
            /// A name, or a word that means something only in its place (`by`, `level`, `until`, …).
            #[regex(r"[A-Za-z_][A-Za-z0-9_]*")]
            Name,
            /// Characters that mean nothing.
            Error,
            $(#[doc = concat!("`", $text, "`")] #[token($text)] $variant,)*
            $(#[doc = concat!("`", $word, "`")] #[token($word)] $keyword,)*
        }

        impl TokenKind {
            /// How it is written, for kinds that are always written the same.
            pub fn text(self) -> Option<&'static str> {
                match self {
                    $(TokenKind::$variant => Some($text),)*
                    $(TokenKind::$keyword => Some($word),)*
                    _ => None,
                }
            }

            /// All reserved words, in the order of the table.
            pub fn keywords() -> impl Iterator<Item = TokenKind> {
                [$(TokenKind::$keyword),*].into_iter()
            }

            /// Whether it is a reserved word.
            pub fn is_keyword(self) -> bool {
                matches!(self, $(TokenKind::$keyword)|*)
            }
        }
    };
}

token_kinds! {
    /// What a token is.
    OpenParenthesis "(",
    CloseParenthesis ")",
    OpenBracket "[",
    CloseBracket "]",
    OpenBrace "{",
    CloseBrace "}",
    Comma ",",
    Colon ":",
    Dot ".",
    DotDot "..",
    Arrow "->",
    Equals "=",
    EqualEqual "==",
    NotEqual "!=",
    Less "<",
    AtMost "<=",
    Greater ">",
    AtLeast ">=",
    Plus "+",
    Minus "-",
    Star "*",
    Slash "/",
    ;
    keywords
    Use "use",
    Pub "pub",
    Param "param",
    Let "let",
    Fn "fn",
    Record "record",
    Ifs "ifs",
    Figure "figure",
    Fabricate "fabricate",
    Test "test",
    If "if",
    Then "then",
    Else "else",
    For "for",
    In "in",
    On "on",
    At "at",
    Itself "self",
    True "true",
    False "false",
}

impl TokenKind {
    /// Whether the grammar passes over it: space, comments and docs.
    pub fn is_trivia(self) -> bool {
        use TokenKind::*;
        matches!(self, Whitespace | Comment | ItemDocs | FileDocs)
    }

    /// Whether it opens a bracket; then what closes it.
    pub fn closer(self) -> Option<TokenKind> {
        match self {
            TokenKind::OpenParenthesis => Some(TokenKind::CloseParenthesis),
            TokenKind::OpenBracket => Some(TokenKind::CloseBracket),
            TokenKind::OpenBrace => Some(TokenKind::CloseBrace),
            _ => None,
        }
    }

    /// Whether it closes a bracket.
    pub fn is_closer(self) -> bool {
        use TokenKind::*;
        matches!(self, CloseParenthesis | CloseBracket | CloseBrace)
    }

    /// Whether it is a word that begins an item and never stands inside one; `let` begins members too.
    pub fn is_item_keyword(self) -> bool {
        use TokenKind::*;
        matches!(self, Use | Pub | Param | Fn | Record | Ifs | Figure | Fabricate | Test)
    }
}
