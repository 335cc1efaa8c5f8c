//! Missed expectations as diagnostics: where, what was expected, what was found, and a way out.

use super::expected::{Expected, Miss};
use super::hints;
use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::lexeme::{Lexeme, Placed};
use crate::syntax::limits::MAX_NESTING;
use crate::syntax::token::TokenKind;
use std::ops::Range;

/// How many expectations a message names.
const NAMED_AT_MOST: usize = 3;

/// How far back the bracket around a place is looked for.
const FAR: usize = 2000;

/// What is needed to word a message: the lexemes of the file, and which of them the item is.
pub(super) struct Reader<'s, 'r> {
    pub(super) lexemes: &'r [Placed<'s>],
    pub(super) item: Range<usize>,
}

/// A miss with what stands around it.
pub(super) struct Scene<'s> {
    /// What was missed.
    pub(super) miss: Miss,
    /// What stands before, inside the item.
    pub(super) before: Option<Placed<'s>>,
    /// What stood there instead, inside the item.
    pub(super) found: Option<Placed<'s>>,
    /// What comes after that.
    pub(super) after: Option<Placed<'s>>,
    /// Whether the item declares names with types: a parameter or a record.
    pub(super) is_typed: bool,
}

impl<'s> Reader<'s, '_> {
    /// The diagnostic for a miss; none where something has been said of this place already.
    pub(super) fn diagnostic(&self, miss: Miss) -> Option<Diagnostic> {
        let item = &self.lexemes[self.item.clone()];
        let at = item.partition_point(|(_, span)| span.start < miss.span.start);
        let get = |at: Option<usize>| at.and_then(|at| item.get(at)).copied();
        let (before, found, after) = (get(at.checked_sub(1)), get(Some(at)), get(Some(at + 1)));
        let typed = |placed: &Placed<'_>| matches!(placed.0.kind, TokenKind::Param | TokenKind::Record);
        let scene = Scene { miss, before, found, after, is_typed: item.iter().take(2).any(typed) };
        let suspect = |placed: Option<Placed<'_>>| placed.is_some_and(|(lexeme, _)| lexeme.suspect);
        if suspect(scene.before) || suspect(scene.found) {
            return None;
        }
        if miss.has(Expected::Shallower) {
            return Some(too_deep(miss.span));
        }
        let next = self.lexemes.get(self.item.start + at).map(|(lexeme, _)| *lexeme);
        let closer = self.enclosing(self.item.start + at);
        let message = format!("expected {}, found {}", expectation(miss, closer), described(next));
        let place = self.place(&scene);
        Some(hints::add(Diagnostic::new(Code::E0201, place, message), &scene))
    }

    /// What closes the bracket around a lexeme, if it is not far.
    fn enclosing(&self, at: usize) -> Option<TokenKind> {
        let mut depth = 0usize;
        let before = self.lexemes[self.item.start..at].iter().rev().take(FAR);
        for (lexeme, _) in before {
            match lexeme.kind.closer() {
                Some(closer) if depth == 0 => return Some(closer),
                Some(_) => depth -= 1,
                None if lexeme.kind.is_closer() => depth += 1,
                None => {}
            }
        }
        None
    }

    /// Where the message points: at what was found, or after what stands before it where the item ends too early.
    fn place(&self, scene: &Scene<'s>) -> Span {
        match (scene.before, scene.found) {
            (_, Some((_, span))) => span,
            (Some((_, span)), None) => span.after(),
            (None, None) => scene.miss.span,
        }
    }
}

fn too_deep(span: Span) -> Diagnostic {
    Diagnostic::new(Code::E0107, span, format!("`if` is nested more than {MAX_NESTING} deep"))
        .hint("give the inner part a name with `let`, or put the values into a list")
}

/// The expectations in words: the most telling few.
fn expectation(miss: Miss, closer: Option<TokenKind>) -> String {
    let mut all: Vec<Expected> = miss.expectations().collect();
    let ends = [Expected::Comma, Expected::For].iter().any(|one| all.contains(one));
    if let Some(closer) = closer.map(Expected::of).filter(|closer| ends && !all.contains(closer)) {
        all.push(closer);
    }
    if all.contains(&Expected::Space) {
        all.retain(|one| *one != Expected::OpenParenthesis);
    }
    if all.len() > 2 {
        all.retain(|one| {
            !matches!(one, Expected::Operator | Expected::Family | Expected::Step | Expected::Range)
        });
    }
    all.truncate(NAMED_AT_MOST);
    let words: Vec<&str> = all.iter().map(|one| one.words()).collect();
    match words.as_slice() {
        [] => "something else".to_owned(),
        [only] => (*only).to_owned(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
    }
}

/// A lexeme in words.
pub(super) fn described(lexeme: Option<Lexeme<'_>>) -> String {
    let Some(lexeme) = lexeme else { return "the end of the file".to_owned() };
    match lexeme.kind {
        TokenKind::Number(_) | TokenKind::BadNumber => format!("the number `{}`", shortened(lexeme.text)),
        TokenKind::Text => "a text".to_owned(),
        TokenKind::Name => format!("`{}`", shortened(lexeme.text)),
        kind if kind.is_keyword() => format!("the keyword `{}`", lexeme.text),
        _ => format!("`{}`", lexeme.text),
    }
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((at, _)) => format!("{}…", &text[..at]),
        None => text.to_owned(),
    }
}
