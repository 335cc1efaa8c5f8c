//! Words that go on after a value, and what follows the name of an ifs.

use ifs_compiler::syntax::TokenKind;

use super::{Kind, Offer};
use crate::features::tokens::Before;

/// Where an ifs lives.
pub(super) fn spaces(before: &Before<'_>) -> Vec<Offer> {
    let space = |label: &str, snippet: &str, detail: &str| {
        Offer::new(label, Kind::Keyword).snippet(snippet).detail(detail)
    };
    if before.back(1) == Some(TokenKind::In) {
        let braces = if before.next == Some(TokenKind::OpenBrace) { "" } else { " {\n    $0\n}" };
        return ["plane", "space"].map(|word| space(word, &format!("{word}{braces}"), "")).to_vec();
    }
    vec![
        space("on", "on (${1:a, b})", "its control points"),
        space("in plane", "in plane", "an ifs of maps of the plane"),
        space("in space", "in space", "an ifs of maps of space"),
    ]
}

/// What goes on after a value.
pub(super) fn words(before: &Before<'_>) -> Vec<Offer> {
    let item = before.item();
    let word = |label: &str, snippet: &str| Offer::new(label, Kind::Keyword).snippet(snippet);
    let mut offers = Vec::new();
    let outermost = before.open.is_empty();
    if item == Some(TokenKind::Param) && outermost {
        offers.push(word("in", "in ${1:4m} .. ${2:9m}").detail("the range it may be set in"));
        offers.push(word("step", "step ${1:100mm}").detail("the step between its values"));
    }
    if matches!(item, Some(TokenKind::Figure | TokenKind::Let | TokenKind::Fn | TokenKind::Ifs)) {
        offers.push(word("on", "on ($0)").detail("the points that an ifs is placed on"));
    }
    if matches!(item, Some(TokenKind::Figure | TokenKind::Let | TokenKind::Fn)) {
        offers.push(word("at level", "at level ${1:3}").detail("how deep it goes"));
        offers.push(word("until", "until ${1|edge,size,length|} <= ${2:600mm}").detail("a level by size"));
        let each = "each until ${1:size} <= ${2:20mm}";
        offers.push(word("each until", each).detail("every branch stops on its own"));
    }
    if before.open.last().is_some_and(|open| open.kind == TokenKind::OpenBracket) {
        offers.push(word("for", "for ${1:i} in ${2:0..3}").detail("for each of a range or a list"));
        offers.push(word("in", "in ${1:0..3}").detail("what it runs through"));
        offers.push(word("if", "if $0").detail("only those"));
    }
    let count = |kind| before.tokens.iter().filter(|token| token.kind == kind).count();
    if count(TokenKind::If) > count(TokenKind::Then) {
        offers.push(word("then", "then "));
    } else if count(TokenKind::Then) > count(TokenKind::Else) {
        offers.push(word("else", "else "));
    }
    if item == Some(TokenKind::Fabricate) {
        offers.push(word("by", "by ").detail("the second side of a size"));
        offers.push(word("in", "in ${1} .. ${2}").detail("both ends of what is required"));
    }
    let logical = |offer: Offer| offer.rank(9);
    offers.extend(["and", "or"].map(|name| logical(word(name, &format!("{name} ")))));
    offers
}
