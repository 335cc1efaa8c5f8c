//! The layout of texts: what it does to each construct, and what holds for all of them.

mod rules;

use crate::source::{FileId, Source};
use crate::syntax::format::format;
use crate::syntax::parse;

/// The layout of a text without errors.
fn formatted(text: &str) -> String {
    let source = Source::new(FileId(0), "a.ifs", text);
    let parse = parse(&source);
    format(&parse, &source).unwrap_or_else(|| panic!("{text}\n{:?}", parse.diagnostics))
}

/// A text comes out as another, which then stays.
fn becomes(text: &str, expected: &str) {
    assert_eq!(formatted(text), expected);
    assert_eq!(formatted(expected), expected, "the second time");
}

/// A text stays as it is.
fn stays(text: &str) {
    becomes(text, text);
}
