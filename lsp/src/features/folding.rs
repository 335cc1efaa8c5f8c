//! What can be folded: items, brackets, comments, and imports that follow each other.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::{FileId, Source, Span};
use ifs_compiler::syntax::{Token, TokenKind, ast};

/// What kind of text is folded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Fold {
    Comment,
    Imports,
    Code,
}

/// The lines that can be folded into the first of them, from 0.
pub(crate) fn folding(analysis: &Analysis, file: FileId) -> Vec<(u32, u32, Fold)> {
    let Some(parsed) = analysis.files.iter().find(|parsed| parsed.file == file) else { return Vec::new() };
    let Some(source) = analysis.sources.get(file) else { return Vec::new() };
    let line = |offset: u32| source.lines.bytes(offset).line;
    let tokens = &parsed.parse.tokens;
    let mut found = comments(source, tokens);
    found.extend(brackets(tokens).into_iter().filter_map(|span| {
        // The line of what closes stays in sight.
        let (from, to) = (line(span.start), line(span.end.saturating_sub(1)));
        (to > from + 1).then(|| (from, to - 1, Fold::Code))
    }));
    let items = &parsed.parse.ast.items;
    let is_use = |item: &ast::Item| matches!(item.kind, ast::ItemKind::Use(_));
    for run in items.chunk_by(|one, next| is_use(one) == is_use(next)) {
        if let (Some(first), Some(last)) = (run.first(), run.last())
            && is_use(first)
        {
            found.push((line(first.span.start), line(last.span.end), Fold::Imports));
        }
    }
    let others = items.iter().filter(|item| !is_use(item));
    found.extend(others.map(|item| (line(item.span.start), line(item.span.end), Fold::Code)));
    found.retain(|(from, to, _)| to > from);
    // Of two that begin on a line an editor takes the first: the longest.
    found.sort_by_key(|(from, to, fold)| (*from, std::cmp::Reverse(*to), *fold));
    found.dedup_by_key(|(from, ..)| *from);
    found
}

/// Comments of whole lines that follow each other.
fn comments(source: &Source, tokens: &[Token]) -> Vec<(u32, u32, Fold)> {
    let comment = |kind| matches!(kind, TokenKind::Comment | TokenKind::ItemDocs | TokenKind::FileDocs);
    let mut runs: Vec<(u32, u32, TokenKind)> = Vec::new();
    for token in tokens.iter().filter(|token| comment(token.kind)) {
        let place = source.lines.bytes(token.span.start);
        let start = source.lines.line_start(place.line).unwrap_or(0);
        if !source.slice(Span::new(source.id, start, token.span.start)).trim().is_empty() {
            continue;
        }
        match runs.last_mut() {
            Some((_, to, kind)) if *kind == token.kind && *to + 1 == place.line => *to = place.line,
            _ => runs.push((place.line, place.line, token.kind)),
        }
    }
    runs.into_iter().map(|(from, to, _)| (from, to, Fold::Comment)).collect()
}

/// The brackets that close what they open, with what is between them.
pub(super) fn brackets(tokens: &[Token]) -> Vec<Span> {
    let mut open: Vec<Token> = Vec::new();
    let mut found = Vec::new();
    for token in tokens {
        if token.kind.closer().is_some() {
            open.push(*token);
        } else if token.kind.is_closer()
            && let Some(place) = open.iter().rposition(|open| open.kind.closer() == Some(token.kind))
        {
            found.push(open[place].span.to(token.span));
            open.truncate(place);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    #[test]
    fn blocks_comments_and_imports() {
        let text = "//! One.\n//! Two.\n\nuse std.curves (bezier2)\nuse std.surfaces (sheet)\n\n// a\n// b\nlet net = [\n    1,\n    2,\n]\nifs c on (p, q) {\n    germ segment(\n        p,\n        q,\n    )\n}\nlet a = 1 // at the end\n// alone\nfigure x = (";
        let design = fixture(text);
        let found = folding(&design.analysis, design.analysis.root);
        let expected = [
            (0, 1, Fold::Comment),
            (3, 4, Fold::Imports),
            (6, 7, Fold::Comment),
            (8, 11, Fold::Code),
            (12, 17, Fold::Code),
            (13, 15, Fold::Code),
        ];
        assert_eq!(found, expected);
    }
}
