//! What holds for every text, shown on many.

use super::language::PROGRAMS;
use super::parsed;
use crate::diagnostic::{HumanStyle, render_human};
use crate::source::{FileId, Source, SourceMap};
use crate::syntax::ast::{Item, ItemKind};
use crate::syntax::{Parse, Token, parse};
use proptest::prelude::*;

/// Pieces of programs, good and bad.
pub(super) const PIECES: &[&str] = &[
    "let",
    "fn",
    "ifs",
    "figure",
    "fabricate",
    "test",
    "record",
    "param",
    "use",
    "pub",
    "if",
    "then",
    "else",
    "for",
    "in",
    "on",
    "at",
    "self",
    "true",
    "level",
    "until",
    "each",
    "by",
    "and",
    "or",
    "not",
    "as",
    "step",
    "transform",
    "germ",
    "keep",
    "boundary",
    "join",
    "require",
    "assert",
    "plane",
    "space",
    "x",
    "y",
    "name",
    "Type",
    "12mm",
    "3",
    "0.5",
    "50%",
    "1e999",
    "3foo",
    "\"text\"",
    "\"open",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    ":",
    ".",
    "..",
    "->",
    "=",
    "==",
    "<",
    ">=",
    "+",
    "-",
    "*",
    "/",
    ";",
    "&&",
    "'",
    "@",
    "ß",
    "\u{202e}",
    "// c",
    "/// d",
    "//! e",
    "/*",
    "*/",
    "\n",
    "\n    ",
    "#",
    "\\",
    "“",
    "…",
    "x:",
    "edge",
    "bend radius",
    "ifs a on (p, q) {",
    "transform left = self on (",
    "fabricate a as planks {",
];

fn soup() -> impl Strategy<Value = String> {
    prop::collection::vec(prop::sample::select(PIECES), 0..60).prop_map(|pieces| pieces.join(" "))
}

/// Every number after `start: ` and `end: ` in the printed tree: all its spans.
fn spans_of(printed: &str) -> Vec<(usize, usize)> {
    let number = |text: &str| text.split(|c: char| !c.is_ascii_digit()).next().and_then(|n| n.parse().ok());
    let ends = |part: &str| {
        let end = &part[part.find("end: ")? + 5..];
        Some((number(part)?, number(end)?))
    };
    printed.split("Span { file: FileId(0), start: ").skip(1).map(|part| ends(part).unwrap()).collect()
}

fn check_spans(text: &str, parse: &Parse) {
    let printed = format!("{:?} {:?}", parse.ast, parse.diagnostics);
    for (start, end) in spans_of(&printed) {
        assert!(start <= end && end <= text.len(), "{start}..{end} in {text:?}");
        assert!(text.is_char_boundary(start) && text.is_char_boundary(end), "{start}..{end} in {text:?}");
    }
}

fn check_tokens(text: &str, tokens: &[Token]) {
    let mut at = 0;
    for token in tokens {
        assert_eq!(token.span.start, at, "{text:?}");
        assert!(token.span.end > token.span.start, "{text:?}");
        assert!(text.is_char_boundary(token.span.end as usize), "{text:?}");
        at = token.span.end;
    }
    assert_eq!(at as usize, text.len(), "{text:?}");
}

fn check(text: &str) -> Parse {
    let parse = parsed(text);
    check_tokens(text, &parse.tokens);
    check_spans(text, &parse);
    let errors = format!("{:?}", parse.ast).contains("Error");
    assert!(!errors || !parse.diagnostics.is_empty(), "an error node without a diagnostic: {text:?}");
    parse
}

/// The item without its places.
fn shape(item: &Item) -> String {
    let printed = format!("{item:?}");
    printed
        .split("Span { file: FileId(0), start: ")
        .map(|part| part.split_once('}').map_or(part, |(_, rest)| rest))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn any_text_has_a_tree(text in any::<String>()) {
        check(&text);
    }

    #[test]
    fn any_ascii_text_has_a_tree(text in "[ -~\n]{0,80}") {
        check(&text);
    }

    #[test]
    fn any_pieces_have_a_tree_and_messages_that_can_be_drawn(text in soup()) {
        let parse = check(&text);
        let mut sources = SourceMap::default();
        sources.add("a.ifs", text);
        for found in &parse.diagnostics {
            let shown = render_human(found, &sources, HumanStyle { color: false, unicode: true });
            prop_assert!(shown.contains(found.code.name()));
        }
    }

    #[test]
    fn a_good_item_after_anything_is_found(text in soup(), which in 0..6usize) {
        let good = [
            "figure last = a on (p, q) at level 4",
            "fn last(i: Int) -> Length = i * 3mm",
            "record Last { width: Length }",
            "ifs last on (p, q) { germ segment(p, q) }",
            "fabricate last as panels { board: 2m by 1m }",
            "test \"last\" { assert a == b }",
        ][which];
        let alone = parsed(good);
        prop_assert!(alone.diagnostics.is_empty());
        let parse = check(&format!("{text}\n{good}"));
        let mut last = parse.ast.items.last().unwrap().clone();
        (last.docs, last.public, last.span) = (Vec::new(), None, alone.ast.items[0].span);
        prop_assert_eq!(shape(&last), shape(&alone.ast.items[0]));
    }

    #[test]
    fn a_good_item_before_anything_is_found(text in soup()) {
        let good = "figure first = a on (p, q) at level 4";
        let parse = check(&format!("{good}\nrecord Next {{ width: Length }}\n{text}"));
        prop_assert_eq!(shape(&parse.ast.items[0]), shape(&parsed(good).ast.items[0]));
    }
}

/// The name of an item, to find it again.
fn title(item: &Item) -> String {
    match &item.kind {
        ItemKind::Use(it) => format!("use {:?}", it.names.first().map(|name| &name.text)),
        ItemKind::Param(it) => it.name.text.clone(),
        ItemKind::Let(it) => it.name.text.clone(),
        ItemKind::Function(it) => it.name.text.clone(),
        ItemKind::Record(it) => it.name.text.clone(),
        ItemKind::Ifs(it) => it.name.text.clone(),
        ItemKind::Figure(it) => it.name.text.clone(),
        ItemKind::Fabricate(it) => format!("fabricate {}", it.figure.text),
        ItemKind::Test(it) => it.name.value.clone(),
        ItemKind::Error => String::new(),
    }
}

#[test]
fn without_any_one_token_all_other_items_stay() {
    let (mut runs, mut several) = (0, Vec::new());
    for (name, text) in PROGRAMS {
        let whole = parsed(text);
        for token in whole.tokens.iter().filter(|token| !token.kind.is_trivia()) {
            let mut broken = (*text).to_owned();
            broken.replace_range(token.span.range(), "");
            let parse = check(&broken);
            runs += 1;
            if parse.diagnostics.len() > 1 {
                several.push(format!("{name} {:?}: {:#?}", token.span, parse.diagnostics));
            }
            for item in &whole.ast.items {
                if item.span.start <= token.span.start && token.span.end <= item.span.end {
                    continue;
                }
                let found = parse.ast.items.iter().find(|other| title(other) == title(item));
                let found = found.map(shape);
                let place = &text[token.span.range()];
                assert_eq!(found, Some(shape(item)), "{name} without {place:?} at {}", token.span.start);
            }
        }
    }
    // One mistake, one diagnostic. Where a brace inside a block is lost, it cannot be told from two.
    assert!(
        several.len() <= 1,
        "{} of {runs} lost tokens have several: {}",
        several.len(),
        several.join("\n")
    );
}

#[test]
fn the_same_text_gives_the_same_parse() {
    for (_, text) in PROGRAMS {
        let source = Source::new(FileId(3), "b.ifs", *text);
        assert_eq!(parse(&source), parse(&source));
    }
}
