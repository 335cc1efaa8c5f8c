//! Places between the words of a file: what stands before, what belongs to a list.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::{Token, TokenKind};

/// The words of the file that a place lies in, without spaces and comments.
pub(super) fn words(analysis: &Analysis, at: Span) -> Vec<Token> {
    let file = analysis.files.iter().find(|file| file.file == at.file);
    let all = file.map_or(&[][..], |file| &file.parse.tokens);
    all.iter().filter(|token| !token.kind.is_trivia()).copied().collect()
}

/// An element of a list in brackets with the comma that goes with it: that behind it, else that before it.
pub(super) fn with_comma(words: &[Token], element: Span) -> Span {
    let inside = |token: &&Token| token.span.start >= element.end;
    let mut after = words.iter().filter(inside);
    if let (Some(comma), next) = (after.next().filter(|token| token.kind == TokenKind::Comma), after.next()) {
        let end = next.map_or(comma.span.end, |next| next.span.start);
        let closed = next.is_some_and(|next| next.kind.is_closer());
        return Span::new(element.file, element.start, if closed { comma.span.end } else { end });
    }
    let before = words.iter().rev().find(|token| token.span.end <= element.start);
    match before {
        Some(comma) if comma.kind == TokenKind::Comma => {
            Span::new(element.file, comma.span.start, element.end)
        }
        _ => element,
    }
}

/// What is given as `name: value` from its name on, as far as the comma, the bracket or the next name before a colon.
pub(super) fn given(words: &[Token], name: Span) -> Option<Span> {
    let first = words.iter().position(|token| token.span.start == name.start)?;
    if words.get(first + 1)?.kind != TokenKind::Colon {
        return None;
    }
    let mut depth = 0usize;
    let mut end = name.end;
    for (place, token) in words.iter().enumerate().skip(first + 2) {
        let ends = match token.kind {
            TokenKind::Comma => depth == 0,
            kind if kind.is_closer() => depth == 0,
            TokenKind::Name => {
                depth == 0 && words.get(place + 1).is_some_and(|next| next.kind == TokenKind::Colon)
            }
            _ => false,
        };
        if ends {
            break;
        }
        match token.kind {
            kind if kind.closer().is_some() => depth += 1,
            kind if kind.is_closer() => depth -= 1,
            _ => {}
        }
        end = token.span.end;
    }
    Some(Span::new(name.file, name.start, end))
}
