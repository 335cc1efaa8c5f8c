//! Every word of the examples is offered where it stands, when it is taken away.

#![allow(clippy::disallowed_methods, reason = "the test reads the designs")]

use super::{completion, fixture};
use ifs_compiler::syntax::TokenKind;
use std::fs;
use std::path::Path;

#[test]
fn every_word_is_offered_where_it_stands() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let mut missed = Vec::new();
    let mut words = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ext| ext != "ifs") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let whole = fixture(&text);
        let analysis = &whole.analysis;
        let tokens = &analysis.files[0].parse.tokens;
        for token in tokens.iter().filter(|token| token.kind == TokenKind::Name || token.kind.is_keyword()) {
            let span = token.span;
            let word = &text[span.range()];
            if analysis.index.declaration(span).is_some() {
                continue;
            }
            // Between two full stops, which would be a range, its first letter stays.
            let stops =
                text[..span.start as usize].ends_with('.') && text[span.end as usize..].starts_with('.');
            let left = if stops { &word[..1] } else { "" };
            let mut cut = text.clone();
            cut.replace_range(span.range(), &format!("{left}$0"));
            let design = fixture(&cut);
            let found = completion(&design.analysis, design.analysis.root, design.at, &Vec::new);
            let offers = found.map_or(Vec::new(), |found| found.offers);
            words += 1;
            if !offers.iter().any(|offer| offer.label.split([' ', ':', '.']).any(|part| part == word)) {
                let line = analysis.sources.get(span.file).unwrap().lines.bytes(span.start).line + 1;
                missed.push(format!("{}:{line} {word}", path.file_name().unwrap().to_string_lossy()));
            }
        }
    }
    assert!(words > 1000, "{words}");
    assert!(missed.is_empty(), "{} of {words}:\n{}", missed.len(), missed.join("\n"));
}
