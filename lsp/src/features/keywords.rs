//! What the words of the language mean, in a line each. Names are not among them: what they stand for is said of them.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::dimension::{Dimension, unit_worth};
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::Unit;

use super::words::written;

/// Words and what they mean, as Markdown.
const WORDS: &[(&str, &str)] = &[
    ("and", "Both are true; the second is not worked out where the first is false."),
    ("as", "What the boards of a figure are: `as panels` or `as planks`."),
    ("assert", "What must be true where a test is run: `assert len(roof.boards) == 64`."),
    ("at", "How deep a figure goes: `at level 3`, for a surface also `at level (3, 2)`."),
    ("boundary", "Names an ifs on the end or the side of this one: `boundary start = point on (a)`."),
    ("by", "The second side of a size: `2500mm by 1250mm`."),
    ("each", "With `until`: every branch stops on its own as soon as it is small enough."),
    ("else", "The value where the condition is not true: `if a < b then a else b`."),
    ("fabricate", "Makes boards out of a figure, with what they are cut from and what is required of them."),
    ("false", "What a condition is that does not hold."),
    ("figure", "An ifs at a level, on points: what is drawn, and made of boards. An output of the design."),
    ("fn", "A function: `fn arch(i: Int) -> Length = i * 1m`."),
    ("for", "A list of what is made of each: `[i * 1m for i in 0..5]`."),
    ("germ", "What an ifs draws at the last level in the place of its smaller copies."),
    ("if", "One of two values: `if a < b then a else b`; behind `for` only those that it is true of."),
    ("ifs", "An iterated function system: a figure made of smaller copies of itself."),
    ("in", "What a number runs through or lies between; in the head of an ifs, where it lives: `in plane`."),
    ("join", "States that two boundaries of the pieces are the same; the compiler proves it."),
    ("keep", "What an ifs draws at every level on the way, not only at the last."),
    ("let", "A name for a value."),
    ("level", "How many times an ifs is taken apart into its transforms."),
    ("not", "True where what follows is not."),
    ("on", "The points that an ifs is placed on, or in its head the control points that it has."),
    ("or", "One of both is true; the second is not worked out where the first is."),
    ("panels", "Boards of the quads of a surface: `fabricate roof as panels { … }`."),
    ("param", "A number of the design that can be set from outside, with its range and step."),
    ("planks", "Straight pieces of the segments of a curve: `fabricate arch as planks { … }`."),
    ("pub", "What follows can be used by other files too."),
    ("record", "A type with fields."),
    ("require", "What must be true of every board, else the design is not built."),
    ("self", "The ifs around, with its own arguments."),
    ("step", "The step between the values that a parameter can have."),
    ("test", "What is stated of the design; `ifs test` runs it."),
    ("then", "The value where the condition is true: `if a < b then a else b`."),
    ("transform", "A smaller copy: the ifs that it continues with, and where."),
    ("true", "What a condition is that holds."),
    ("until", "A level by size: the first at which every element is so small."),
    ("use", "Takes names from a module of the library or from another file."),
];

/// Types that the language has of its own, but for quantities.
const TYPES: &[(&str, &str)] = &[
    ("Int", "A whole number."),
    ("Bool", "`true` or `false`."),
    ("Text", "Letters between quotes."),
    (
        "Point",
        "A place: of control points, an affine combination of them; of coordinates, two or three lengths.",
    ),
    ("Vector", "The difference of two points."),
    ("Map", "An affine map of the plane or of space: `translate`, `rotate`, `scale`, and products of them."),
    ("Plane", "A plane of space: `plane(point, normal)`."),
    ("Cut", "How the free end of a plank is cut: `square`, or `cut(plane)`."),
    ("Ifs", "An iterated function system that is not placed on points yet."),
    ("Germ", "What an ifs draws at the last level."),
    ("Curve", "A figure whose segments are proved to join: planks can be made of it."),
    ("Surface", "A figure of quads that are proved to join: panels can be made of it."),
    ("Figure", "An ifs at a level, on points: what is drawn."),
    ("Dialect", "The language of a machine's programs."),
    ("CutDirection", "Which way the cutter turns along an edge."),
    ("ZZero", "Where a program's Z is zero."),
];

/// The word of the language at a place, and what it means.
pub(super) fn keyword(analysis: &Analysis, file: FileId, offset: u32) -> Option<(Span, String)> {
    let (span, word) = word(analysis, file, offset)?;
    let (_, meaning) = WORDS.iter().find(|(known, _)| *known == word)?;
    Some((span, meant(word, meaning)))
}

/// The type of the language at a place, and what it means.
pub(super) fn built_in_type(analysis: &Analysis, file: FileId, offset: u32) -> Option<(Span, String)> {
    let (span, word) = word(analysis, file, offset)?;
    Some((span, meant(word, &type_meaning(word)?)))
}

fn type_meaning(name: &str) -> Option<String> {
    if let Some((_, meaning)) = TYPES.iter().find(|(known, _)| *known == name) {
        return Some((*meaning).to_owned());
    }
    let dimension = Dimension::named(name)?;
    if dimension == Dimension::NUMBER {
        return Some("A number without a unit.".to_owned());
    }
    let units = Unit::ALL.iter().filter(|unit| unit_worth(**unit).0 == dimension);
    let units: Vec<String> = units.map(|unit| format!("`{}`", unit.suffix())).collect();
    Some(match units.is_empty() {
        true => format!("A quantity, in {}.", dimension.display_unit().0),
        false => format!("A quantity, in {}.", units.join(", ")),
    })
}

fn word(analysis: &Analysis, file: FileId, offset: u32) -> Option<(Span, &str)> {
    let parse = &analysis.files.iter().find(|parsed| parsed.file == file)?.parse;
    let token = parse.tokens.iter().find(|token| token.span.start <= offset && offset < token.span.end)?;
    let is_word = token.kind == TokenKind::Name || token.kind.is_keyword();
    is_word.then(|| (token.span, written(analysis, token.span)))
}

fn meant(word: &str, meaning: &str) -> String {
    format!("```ifs\n{word}\n```\n---\n{meaning}")
}

#[cfg(test)]
mod tests {
    use super::{TokenKind, WORDS, type_meaning};
    use crate::features::fixture::fixture;
    use crate::features::hover::hover;
    use ifs_compiler::hir::type_names::type_names;

    fn shown(text: &str) -> String {
        let design = fixture(text);
        let found = hover(&design.analysis, design.known(None), design.analysis.root, design.at);
        found.map_or(String::new(), |found| found.markdown)
    }

    #[test]
    fn words_are_told_and_names_stay_names() {
        let without = TokenKind::keywords().filter_map(TokenKind::text);
        let without: Vec<&str> =
            without.filter(|word| !WORDS.iter().any(|(known, _)| known == word)).collect();
        assert!(without.is_empty(), "nothing is said of {without:?}");
        assert!(WORDS.windows(2).all(|pair| pair[0].0 < pair[1].0), "in the order of the alphabet");
        assert!(shown("fi$0gure f = g").contains("An output of the design"));
        assert!(shown("figure f = g at le$0vel 3").contains("taken apart"), "in a text that is wrong too");
        assert!(shown("param a: Len$0gth = 3m\n").contains("in `mm`, `cm`, `m`"));
        let untold: Vec<&str> = type_names().filter(|name| type_meaning(name).is_none()).collect();
        assert!(untold.is_empty(), "nothing is said of {untold:?}");
        assert!(shown("figure f = g until ed$0ge <= 1m").contains("the sides of each element"));
        let test = "use std.curves (line)\nfigure f = line on ((0m, 0m), (1m, 0m)) at level 2\ntest \"t\" { assert f.ver$0tices == 5 }\n";
        assert!(shown(test).contains("joined ones counted once"));
        // A name that is such a word.
        let named = shown("let step = 3m\nlet a = st$0ep\n");
        assert!(named.contains("let step: Length") && !named.contains("can have"), "{named}");
        assert_eq!(shown("let a = \"at le$0vel 3\"\n"), "```ifs\nText\n```");
    }
}
