//! Brackets: matched before the tree is built, so that the grammar only ever sees balanced ones, nested no deeper than
//! it can bear. What is missing is put in, what is left over is left out, and each is said once.

mod block;
mod layout;
mod matcher;

use super::lexeme::{Placed, begins_item};
use super::limits::{MAX_NESTING, Said};
use super::token::TokenKind;
use crate::source::Span;
use matcher::Matcher;
use std::ops::Range;

/// Balances the brackets; also the places where something could be wrong with them.
pub(super) fn balance<'s>(lexemes: Vec<Placed<'s>>, said: &mut Said) -> (Vec<Placed<'s>>, Vec<Span>) {
    let regions = regions(&lexemes);
    let sound: Vec<bool> = regions.iter().map(|region| is_sound(&lexemes[region.clone()])).collect();
    if sound.iter().all(|sound| *sound) {
        return (lexemes, Vec::new());
    }
    let mut balanced = Vec::with_capacity(lexemes.len() + MAX_NESTING);
    let mut unsound = Vec::new();
    for (region, sound) in regions.into_iter().zip(sound) {
        let region = &lexemes[region];
        if sound {
            balanced.extend_from_slice(region);
            continue;
        }
        if let [(_, first), ..] = region
            && let Some((_, last)) = region.last()
        {
            unsound.push(first.to(*last));
        }
        let strict = Matcher::run(region, false);
        let outcome = if strict.said.is_empty() { strict } else { Matcher::run(region, true) };
        balanced.extend(outcome.out);
        for diagnostic in outcome.said {
            said.push(|| diagnostic);
        }
    }
    (balanced, unsound)
}

/// Whether nothing can be wrong with the brackets of a region, by a quick look: most files are left as they are.
fn is_sound(region: &[Placed<'_>]) -> bool {
    let mut open: Vec<TokenKind> = Vec::new();
    let keyword = region.iter().map(|(lexeme, _)| lexeme.kind).find(|kind| *kind != TokenKind::Pub);
    let members = matches!(keyword, Some(TokenKind::Ifs | TokenKind::Test));
    for (lexeme, _) in region {
        let outermost = open.is_empty() || members && open == [TokenKind::CloseBrace];
        match lexeme.kind {
            TokenKind::Let if !outermost => return false,
            TokenKind::Arrow if !open.is_empty() => return false,
            TokenKind::OpenBrace if open.first().is_some_and(|first| *first != TokenKind::CloseBrace) => {
                return false;
            }
            kind if kind.is_closer() && open.pop() != Some(kind) => return false,
            kind => open.extend(kind.closer()),
        }
        if open.len() > MAX_NESTING {
            return false;
        }
    }
    open.is_empty()
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
