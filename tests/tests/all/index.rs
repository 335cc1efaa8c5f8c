//! The index of names against the text: in every example and every page of the suite that has no errors, each name is a
//! use or a declaration, and what a use stands for bears its name.
#![allow(clippy::disallowed_methods, reason = "the tests read the designs")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;

use ifs_compiler::analysis::{Analysis, read_indexed};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::tree::Made;
use ifs_compiler::source::MemoryFiles;
use ifs_compiler::syntax::TokenKind;
use ifs_tests::root;
use ifs_tests::sources::files;

/// Names that stand for nothing declared: words in their places, built-in types, coordinates and the like.
const WORDS: &str = "as by step level until each join boundary start end germ keep transform plane space require assert \
    and or not std panels planks x y z control diagonal \
    bend radius material";

fn designs() -> Vec<(String, Analysis)> {
    let paths =
        ["examples", "tests/suite/page", "tests/suite/good"].map(|folder| files(&root().join(folder), "ifs"));
    let read = paths.concat().into_iter().map(|path| {
        let text = fs::read_to_string(&path).unwrap();
        let analysis =
            read_indexed(&MemoryFiles::single("design.ifs", &text), "design.ifs", &Overrides::default());
        (path.display().to_string(), analysis)
    });
    let designs: Vec<_> = read.filter(|(_, analysis)| !analysis.has_errors()).collect();
    assert!(designs.len() > 30, "only {} designs are without errors", designs.len());
    designs
}

/// The text of a span.
fn written(analysis: &Analysis, span: ifs_compiler::source::Span) -> &str {
    &analysis.sources.get(span.file).unwrap().text[span.start as usize..span.end as usize]
}

#[test]
fn every_name_is_a_use_or_a_declaration() {
    let mut unknown = Vec::new();
    for (path, analysis) in designs() {
        let tokens = &analysis.files[0].parse.tokens;
        let names = tokens.iter().filter(|token| token.kind == TokenKind::Name).map(|token| token.span);
        for span in names {
            let word = written(&analysis, span);
            let known = analysis.index.references.iter().any(|reference| {
                reference.span.file == span.file
                    && reference.span.start <= span.start
                    && span.end <= reference.span.end
            });
            let built_in =
                word.starts_with(char::is_uppercase) || WORDS.split(' ').any(|other| other == word);
            if !known && analysis.index.declaration(span).is_none() && !built_in {
                unknown.push(format!("{path}: `{word}` at {}", span.start));
            }
        }
    }
    assert!(unknown.is_empty(), "{unknown:#?}");
}

#[test]
fn what_a_name_stands_for_bears_it() {
    for (path, analysis) in designs() {
        for reference in &analysis.index.references {
            let (word, stands_for) = match reference.target {
                Target::Declared(span) => {
                    (written(&analysis, reference.span), written(&analysis, span).to_owned())
                }
                Target::Native(native) => {
                    (written(&analysis, reference.span), native.declaration().name.to_owned())
                }
                Target::Setting(_, name) => (written(&analysis, reference.span), name.to_owned()),
                Target::Choice(kind, place) => {
                    (written(&analysis, reference.span), kind.words()[place].name.to_owned())
                }
                Target::Size(size) => (written(&analysis, reference.span), size.word().to_owned()),
                Target::Made(made) => {
                    let known = Made::ALL.into_iter().find(|(_, known, _)| *known == made);
                    (written(&analysis, reference.span), known.unwrap().0.to_owned())
                }
                Target::Module(_) | Target::NativeParameter(..) | Target::Measure(_) => continue,
            };
            let synthetic = word == "material";
            assert!(word == stands_for || word == "self" || synthetic, "{path}: `{word}` is `{stands_for}`");
        }
    }
}

#[test]
fn types_are_known_inside_of_what_is_broken() {
    let text = "let a = 2m\nfigure f = a on 3\nifs c on (p, q) {\n    let m = lerp(p, q, 1/2)\n    transform t = self on (p, m, zz)\n}\n";
    let analysis =
        read_indexed(&MemoryFiles::single("design.ifs", text), "design.ifs", &Overrides::default());
    assert!(analysis.has_errors());
    let at = |word: &str| u32::try_from(text.find(word).unwrap()).unwrap();
    let file = analysis.root;
    let use_of_m = at("m, zz");
    let found = analysis.index.name_at(file, use_of_m).unwrap();
    assert_eq!(
        found.target,
        Target::Declared(ifs_compiler::source::Span::new(file, at("m = lerp"), at("m = lerp") + 1))
    );
    assert!(analysis.index.type_at(file, use_of_m).is_some());
    let visible: Vec<&str> =
        analysis.index.visible(file, use_of_m).iter().map(|declaration| declaration.name.as_str()).collect();
    assert_eq!(visible, ["m", "q", "p"]);
}
