//! Comparisons in a chain, as mathematics writes them: each becomes a comparison of its own.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::{Token, TokenKind};

use super::tokens::words;
use crate::features::words::written;

/// `a < b < c` as `a < b and b < c`.
pub(super) fn apart(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let Some(before) = found.labels.first().map(|label| label.span) else { return Vec::new() };
    let words = words(analysis, found.span);
    let first = words.iter().position(|token| token.span == before);
    let Some(first) = first.filter(|at| is_comparison(words[*at].kind)) else { return Vec::new() };
    let signs = signs(analysis, &words, first);
    let mut fix = Fix::titled("");
    let mut title = Vec::new();
    for pair in signs.windows(2) {
        let (from, to) = (words[pair[0] + 1].span, words[pair[1] - 1].span);
        if pair[1] < pair[0] + 2 {
            return Vec::new();
        }
        let middle = written(analysis, Span::new(from.file, from.start, to.end)).to_owned();
        title.push(format!("`and {middle}`"));
        fix = fix.with(Span::new(to.file, to.end, to.end), format!(" and {middle}"));
    }
    if fix.edits.is_empty() {
        return Vec::new();
    }
    let said = format!("compare one by one: insert {}", title.join(", "));
    vec![fix.edits.into_iter().fold(Fix::titled(said), |fix, edit| fix.with(edit.span, edit.replacement))]
}

fn is_comparison(kind: TokenKind) -> bool {
    kind.text().is_some_and(|text| matches!(text, "<" | "<=" | ">" | ">=" | "==" | "!="))
}

/// The comparisons of the chain from the first on, as far as something ends it.
fn signs(analysis: &Analysis, words: &[Token], first: usize) -> Vec<usize> {
    let (mut signs, mut depth) = (vec![first], 0usize);
    for (at, token) in words.iter().enumerate().skip(first + 1) {
        let between = Span::new(token.span.file, words[at - 1].span.end, token.span.start);
        let word = written(analysis, token.span);
        let ends = matches!(word, "and" | "or" | "then" | "else" | "," | "for" | "if")
            || written(analysis, between).contains('\n')
            || token.kind.is_closer();
        match token.kind {
            _ if depth == 0 && ends => break,
            kind if kind.closer().is_some() => depth += 1,
            kind if kind.is_closer() => depth = depth.saturating_sub(1),
            kind if depth == 0 && is_comparison(kind) => signs.push(at),
            _ => {}
        }
    }
    signs
}
