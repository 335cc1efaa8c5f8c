//! Brackets: matched before the tree is built, so that the grammar only ever sees balanced ones, nested no deeper than
//! it can bear. What is missing is put in, what is left over is left out, and each is said once.

mod block;
mod matcher;

use super::lexeme::{Placed, begins_item};
use super::limits::Said;
use super::token::TokenKind;
use matcher::Matcher;
use std::ops::Range;

/// Balances the brackets.
pub(super) fn balance<'s>(lexemes: Vec<Placed<'s>>, said: &mut Said) -> Vec<Placed<'s>> {
    let mut balanced = Vec::with_capacity(lexemes.len());
    for region in regions(&lexemes) {
        let region = &lexemes[region];
        let strict = Matcher::run(region, false);
        let outcome = if strict.said.is_empty() { strict } else { Matcher::run(region, true) };
        balanced.extend(outcome.out);
        for diagnostic in outcome.said {
            said.push(|| diagnostic);
        }
    }
    balanced
}

/// The ranges from one word that begins an item, and never stands inside one, to the next.
fn regions(lexemes: &[Placed<'_>]) -> Vec<Range<usize>> {
    split(lexemes.len(), |at| begins_item(lexemes, at))
}

/// The ranges of the items in balanced lexemes; what stands before the first item is one too.
pub(super) fn items(lexemes: &[Placed<'_>]) -> Vec<Range<usize>> {
    let mut depth = 0usize;
    split(lexemes.len(), |at| {
        let kind = lexemes[at].0.kind;
        if kind.closer().is_some() {
            depth += 1;
        } else if kind.is_closer() {
            depth = depth.saturating_sub(1);
        }
        let after_pub = at > 0 && lexemes[at - 1].0.kind == TokenKind::Pub;
        depth == 0 && (begins_item(lexemes, at) || kind == TokenKind::Let && !after_pub)
    })
}

fn split(length: usize, mut begins: impl FnMut(usize) -> bool) -> Vec<Range<usize>> {
    let mut ranges = Vec::new();
    let mut start = 0;
    for at in 0..length {
        if begins(at) && at > start {
            ranges.push(start..at);
            start = at;
        }
    }
    if start < length {
        ranges.push(start..length);
    }
    ranges
}
