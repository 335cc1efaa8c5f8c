//! The grammar, one file per area, over balanced lexemes of one item at a time. What is expected is collected as a
//! set of readable words; the sentences are made of it in `message`.

mod expected;
mod expression;
mod fabricate;
mod figures;
mod hints;
mod ifs;
mod items;
mod level;
mod message;
mod names;
mod node;
mod operators;
mod primitive;
mod recovery;
mod sequence;
mod types;
mod values;

pub use fabricate::MEASURES;

use super::ast;
use super::lexeme::{Lexeme, Placed};
use super::limits::Said;
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use chumsky::input::{Checkpoint, Cursor, Input, MappedInput};
use chumsky::inspector::Inspector;
use chumsky::{Boxed, Parser, extra};
use expected::Miss;
use std::ops::Range;

/// The lexemes of one item.
type Tokens<'s> = MappedInput<'s, Lexeme<'s>, Span, &'s [Placed<'s>]>;
/// Errors and state of the grammar.
type Extra<'s> = extra::Full<Miss, Progress, ()>;
/// A rule of the grammar.
type Rule<'s, O> = Boxed<'s, 's, Tokens<'s>, O, Extra<'s>>;

/// What a run keeps beside its position; taken back with it.
#[derive(Debug, Default)]
struct Progress {
    /// How many `if` are open.
    depth: usize,
    /// How many lexemes were read; not taken back.
    steps: usize,
    /// What was said beside missed expectations.
    said: Vec<Diagnostic>,
}

impl<'s> Inspector<'s, Tokens<'s>> for Progress {
    type Checkpoint = (usize, usize);

    fn on_token(&mut self, _: &Lexeme<'s>) {
        self.steps += 1;
    }

    fn on_save<'parse>(&self, _: &Cursor<'s, 'parse, Tokens<'s>>) -> Self::Checkpoint {
        (self.depth, self.said.len())
    }

    fn on_rewind<'parse>(&mut self, to: &Checkpoint<'s, 'parse, Tokens<'s>, Self::Checkpoint>) {
        let (depth, said) = to.inspector();
        self.depth = *depth;
        self.said.truncate(*said);
    }
}

impl chumsky::span::Span for Span {
    type Context = crate::source::FileId;
    type Offset = u32;

    fn new(file: Self::Context, range: Range<u32>) -> Self {
        Span::new(file, range.start, range.end)
    }

    fn context(&self) -> Self::Context {
        self.file
    }

    fn start(&self) -> u32 {
        self.start
    }

    fn end(&self) -> u32 {
        self.end
    }
}

/// Whether the brackets at the place of an item are sound, and the item where it is known already.
type Known<'k> = &'k mut dyn FnMut(Span) -> (bool, Option<ast::Item>);

/// Parses the items of a file, each in its range of the lexemes. Every range gives an item, and whether it was read without
/// a doubt.
pub(super) fn parse_items<'s>(
    lexemes: &'s [Placed<'s>],
    items: Vec<Range<usize>>,
    known: Known<'_>,
    said: &mut Said,
) -> (Vec<ast::Item>, Vec<bool>) {
    let rule = items::item();
    let read = items.into_iter().map(|range| {
        let slice = &lexemes[range.clone()];
        let whole = whole(slice);
        let (balanced, known) = known(whole);
        let plain = balanced && slice.iter().all(|(lexeme, _)| !lexeme.suspect);
        if let Some(item) = known.filter(|_| plain) {
            return (item, true);
        }
        let (item, good) = parse_item(&rule, lexemes, range, said);
        (item, plain && good)
    });
    read.unzip()
}

/// From the first lexeme to the last.
fn whole(slice: &[Placed<'_>]) -> Span {
    match (slice.first(), slice.last()) {
        (Some((_, first)), Some((_, last))) => first.to(*last),
        _ => Span::default(),
    }
}

/// An item, and whether nothing is wrong with it.
fn parse_item<'s>(
    rule: &Rule<'s, ast::Item>,
    lexemes: &'s [Placed<'s>],
    range: Range<usize>,
    said: &mut Said,
) -> (ast::Item, bool) {
    let slice = &lexemes[range.clone()];
    let whole = whole(slice);
    let mut progress = Progress::default();
    let result = rule.parse_with_state(slice.split_token_span(whole.after()), &mut progress);
    let (item, misses) = result.into_output_errors();
    let good = item.is_some() && misses.is_empty() && progress.said.is_empty();
    said.steps += progress.steps;
    for diagnostic in progress.said {
        said.push(|| diagnostic);
    }
    let reader = message::Reader { lexemes, item: range };
    for miss in misses {
        if said.is_full() {
            break;
        }
        if let Some(diagnostic) = reader.diagnostic(miss) {
            said.push(|| diagnostic);
        }
    }
    let error = || ast::Item { span: whole, docs: Vec::new(), public: None, kind: ast::ItemKind::Error };
    (item.unwrap_or_else(error), good)
}
