//! Names: as they are used, and as they are declared in the case of their kind.

use super::expected::{Expected, Miss};
use super::primitive::{Small, lexeme};
use super::{Extra, Tokens};
use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::ast::Name;
use crate::syntax::lexeme::Role;
use crate::syntax::token::TokenKind;
use chumsky::input::InputRef;
use chumsky::prelude::*;

/// How a declared name is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Case {
    /// `snake_case`, for values.
    Snake,
    /// `CamelCase`, for types.
    Camel,
}

/// A name in any case.
pub(super) fn name<'s>() -> impl Small<'s, Name> {
    lexeme(Expected::Name, |found, span| {
        (found.kind == TokenKind::Name).then(|| Name { text: found.text.to_owned(), span })
    })
}

/// The name of a field that is given a value.
pub(super) fn field_name<'s>() -> impl Small<'s, Name> {
    lexeme(Expected::NextEntry, |found, span| {
        let fits = found.kind == TokenKind::Name && found.role != Role::Require;
        fits.then(|| Name { text: found.text.to_owned(), span })
    })
}

/// A name where it is declared.
pub(super) fn declared<'s>(case: Case) -> impl Small<'s, Name> {
    custom(move |input: &mut InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let before = input.save();
        let start = input.cursor();
        let found = input.next();
        let span = input.span_since(&start);
        match found.filter(|found| found.kind == TokenKind::Name) {
            Some(found) => {
                if !found.suspect && !fits(case, found.text) {
                    input.state().said.push(wrong_case(case, found.text, span));
                }
                Ok(Name { text: found.text.to_owned(), span })
            }
            None => {
                input.rewind(before);
                Err(Miss::new(Expected::Name, span))
            }
        }
    })
}

/// `name :` before a value; gives the name.
pub(super) fn label<'s>() -> impl Small<'s, Name> {
    custom(move |input: &mut InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let before = input.save();
        let start = input.cursor();
        let found = input.next();
        let span = input.span_since(&start);
        let Some(found) = found.filter(|found| found.kind == TokenKind::Name) else {
            input.rewind(before);
            return Err(Miss::any(&[], span));
        };
        if input.next().is_none_or(|next| next.kind != TokenKind::Colon) {
            input.rewind(before);
            return Err(Miss::any(&[], span));
        }
        Ok(Name { text: found.text.to_owned(), span })
    })
}

fn fits(case: Case, name: &str) -> bool {
    let first = name.trim_start_matches('_').chars().next();
    match case {
        Case::Snake => !name.contains(|c: char| c.is_ascii_uppercase()),
        Case::Camel => first.is_some_and(|c| c.is_ascii_uppercase()) && !name.contains('_'),
    }
}

fn wrong_case(case: Case, name: &str, span: Span) -> Diagnostic {
    let better = corrected(case, name);
    let (what, form) = match case {
        Case::Snake => ("a value", "snake_case"),
        Case::Camel => ("a type", "CamelCase"),
    };
    Diagnostic::new(Code::E0205, span, format!("the name of {what} is written in {form}, not `{name}`")).fix(
        format!("call it `{better}`"),
        span,
        better,
    )
}

/// The name in the other case: `myRecord` and `my_record` are `MyRecord`, and the other way round.
fn corrected(case: Case, name: &str) -> String {
    let words = words(name);
    match case {
        Case::Snake => words.join("_"),
        Case::Camel => words
            .iter()
            .map(|word| {
                let mut letters = word.chars();
                let first = letters.next().map(|c| c.to_ascii_uppercase());
                first.into_iter().chain(letters).collect::<String>()
            })
            .collect(),
    }
}

/// The words of a name, in lower case.
fn words(name: &str) -> Vec<String> {
    let letters: Vec<char> = name.chars().collect();
    let mut words: Vec<String> = Vec::new();
    let mut current = String::new();
    for (at, c) in letters.iter().enumerate() {
        let after_lower = at > 0 && !letters[at - 1].is_ascii_uppercase();
        let before_lower = letters.get(at + 1).is_some_and(|next| next.is_ascii_lowercase());
        let begins = c.is_ascii_uppercase() && (after_lower || before_lower && at > 0);
        if (*c == '_' || begins) && !current.is_empty() {
            words.push(std::mem::take(&mut current));
        }
        if *c != '_' {
            current.push(c.to_ascii_lowercase());
        }
    }
    if !current.is_empty() {
        words.push(current);
    }
    words
}
