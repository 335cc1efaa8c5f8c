//! Where a text names meshes: `import("joint.glb")`, found by its tokens. Whether `import` means that there is the
//! checker's business.

use super::ast::TextLiteral;
use super::lexer::text::unescape;
use super::{Parse, Token, TokenKind};
use crate::source::Source;

/// The paths that stand in `import("…")`, also as `import(path: "…")`.
pub fn imported_paths(source: &Source, parse: &Parse) -> Vec<TextLiteral> {
    let mut tokens = parse.tokens.iter().filter(|token| !token.kind.is_trivia());
    let mut found = Vec::new();
    while let Some(token) = tokens.next() {
        if token.kind != TokenKind::Name || source.slice(token.span) != "import" {
            continue;
        }
        let mut after = tokens.clone();
        if after.next().is_none_or(|token| token.kind != TokenKind::OpenParenthesis) {
            continue;
        }
        found.extend(
            path(source, after)
                .map(|token| TextLiteral { value: unescape(source.slice(token.span)), span: token.span }),
        );
    }
    found
}

/// The text that follows, after a name and a colon or not.
fn path<'t>(source: &Source, mut tokens: impl Iterator<Item = &'t Token>) -> Option<&'t Token> {
    let first = tokens.next()?;
    let path = match first.kind {
        TokenKind::Name if source.slice(first.span) == "path" => {
            tokens.next().filter(|token| token.kind == TokenKind::Colon)?;
            tokens.next()?
        }
        _ => first,
    };
    Some(path).filter(|token| token.kind == TokenKind::Text)
}
