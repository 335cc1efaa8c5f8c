//! A range that is written from its larger end to its smaller one.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;

use super::tokens::words;
use crate::features::words::written;

/// The two ends in each other's place.
pub(super) fn ends(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let span = found.span;
    let inside: Vec<_> = words(analysis, span)
        .into_iter()
        .filter(|token| span.start <= token.span.start && token.span.end <= span.end)
        .collect();
    let mut dots = inside.iter().enumerate().filter(|(_, token)| token.kind == TokenKind::DotDot);
    let (Some((place, _)), None) = (dots.next(), dots.next()) else { return Vec::new() };
    let (Some(first), Some(last)) = (inside.first(), inside.last()) else { return Vec::new() };
    let (Some(before), Some(after)) =
        (place.checked_sub(1).and_then(|place| inside.get(place)), inside.get(place + 1))
    else {
        return Vec::new();
    };
    let from = Span::new(span.file, first.span.start, before.span.end);
    let to = Span::new(span.file, after.span.start, last.span.end);
    let [low, high] = [to, from].map(|part| written(analysis, part).to_owned());
    vec![
        Fix::titled(format!("write the smaller end first: `{low} .. {high}`")).with(from, low).with(to, high),
    ]
}
