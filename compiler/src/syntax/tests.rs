//! The programs of `LANGUAGE.md`, the shapes of trees, the messages, the limits, and what holds for every text.

mod again;
mod format;
mod language;
mod lexing;
mod limits;
mod messages;
mod pages;
mod printer;
mod properties;
mod recovery;
mod shapes;

use super::{Parse, parse};
use crate::source::{FileId, Source};

/// Parses a text.
fn parsed(text: &str) -> Parse {
    parse(&Source::new(FileId(0), "a.ifs", text))
}
