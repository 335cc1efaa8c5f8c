//! What is selected around a place, step by step: the word, the expressions it is of, the line of its block, its item, the
//! file.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::{TokenKind, ast};

use super::folding::brackets;
use super::walk::of_item;

/// The spans around a place, each in the next.
pub(crate) fn selection(analysis: &Analysis, file: FileId, offset: u32) -> Vec<Span> {
    let Some(parsed) = analysis.files.iter().find(|parsed| parsed.file == file) else { return Vec::new() };
    let Some(source) = analysis.sources.get(file) else { return Vec::new() };
    let length = source.text.len() as u32;
    let around = |span: &Span| span.start <= offset && offset <= span.end;
    let mut spans = vec![Span::new(file, 0, length)];
    // Of two tokens that touch the word counts.
    let touching = parsed.parse.tokens.iter().filter(|token| around(&token.span));
    let token = touching
        .filter(|token| token.kind != TokenKind::Whitespace)
        .max_by_key(|token| (matches!(token.kind, TokenKind::Name | TokenKind::Number(_)), token.span.start));
    spans.extend(token.map(|token| token.span));
    for bracket in brackets(&parsed.parse.tokens) {
        spans.push(bracket);
        spans.push(Span::new(file, bracket.start + 1, bracket.end.saturating_sub(1)));
    }
    for item in parsed.parse.ast.items.iter().filter(|item| around(&item.span)) {
        spans.push(item.span);
        of_item(item, &mut |expr| spans.push(expr.span));
        match &item.kind {
            ast::ItemKind::Ifs(ifs) => spans.extend(ifs.members.iter().map(|member| member.span)),
            ast::ItemKind::Fabricate(block) => spans.extend(block.entries.iter().map(|entry| entry.span)),
            ast::ItemKind::Function(function) => spans.extend(fields(&function.parameters)),
            ast::ItemKind::Record(record) => spans.extend(fields(&record.fields)),
            _ => {}
        }
    }
    spans.retain(|span| around(span) && span.end <= length);
    spans.sort_by_key(|span| (span.end - span.start, span.start));
    spans.dedup();
    let mut nested: Vec<Span> = Vec::new();
    for span in spans {
        if nested.last().is_none_or(|inner| span.start <= inner.start && inner.end <= span.end) {
            nested.push(span);
        }
    }
    nested
}

fn fields(fields: &[ast::Field]) -> impl Iterator<Item = Span> + '_ {
    fields.iter().map(|field| {
        let end = field.default.as_ref().map_or(field.ty.span, |value| value.span);
        field.name.span.to(end)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;
    use crate::features::words::written;

    fn shown(text: &str) -> Vec<String> {
        let design = fixture(text);
        let found = selection(&design.analysis, design.analysis.root, design.at);
        found.iter().map(|span| written(&design.analysis, *span).to_owned()).collect()
    }

    #[test]
    fn from_the_word_to_the_file() {
        let expected = [
            "b",
            "b + 1",
            "a, b + 1",
            "(a, b + 1)",
            "f(a, b + 1)",
            "2 * f(a, b + 1)",
            "let x = 2 * f(a, b + 1)",
        ];
        assert_eq!(shown("let x = 2 * f(a, $0b + 1)"), expected);
        let found = shown("let y = 1\nifs c on (p, q) {\n    germ segment(p$0, q)\n}\nlet = ");
        assert_eq!(found[..5], ["p", "p, q", "(p, q)", "segment(p, q)", "germ segment(p, q)"]);
        assert_eq!(shown("$0"), [""]);
    }
}
