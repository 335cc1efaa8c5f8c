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

/// Parses the items of a file, each in its range of the lexemes. Every range gives an item.
pub(super) fn parse_items<'s>(
    lexemes: &'s [Placed<'s>],
    items: Vec<Range<usize>>,
    said: &mut Said,
) -> Vec<ast::Item> {
    let rule = items::item();
    items.into_iter().map(|range| parse_item(&rule, lexemes, range, said)).collect()
}

fn parse_item<'s>(
    rule: &Rule<'s, ast::Item>,
    lexemes: &'s [Placed<'s>],
    range: Range<usize>,
    said: &mut Said,
) -> ast::Item {
    let slice = &lexemes[range.clone()];
    let whole = match (slice.first(), slice.last()) {
        (Some((_, first)), Some((_, last))) => first.to(*last),
        _ => Span::default(),
    };
    let mut progress = Progress::default();
    let result = rule.parse_with_state(slice.split_token_span(whole.after()), &mut progress);
    let (item, misses) = result.into_output_errors();
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
    item.unwrap_or(ast::Item { span: whole, docs: Vec::new(), public: None, kind: ast::ItemKind::Error })
}
