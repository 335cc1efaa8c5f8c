//! Lines that stand in the braces of something else, and what a block of boards is made as.

use super::{Way, kind, say};
use crate::syntax::lexeme::MEMBER_WORDS;
use crate::syntax::parser::expected::Expected;
use crate::syntax::parser::message::Scene;
use crate::syntax::token::TokenKind;

/// `require planarity >= 1`, `germ segment(a, b)`, `assert a` where an item stands.
pub(super) fn line_of_a_block(scene: &Scene<'_>) -> Option<Way> {
    let (found, _) = scene.found.filter(|(found, _)| found.kind == TokenKind::Name)?;
    if !scene.miss.has(Expected::Item) && !scene.miss.has(Expected::NextItem) {
        return None;
    }
    let block = match found.text {
        "require" => "a `fabricate` block: `fabricate name as panels { require … }`",
        "assert" => "a test: `test \"what is so\" { assert … }`",
        word if MEMBER_WORDS.contains(&word) => "an ifs: `ifs name on (a, b) { … }`",
        _ => return None,
    };
    say(format!("`{}` stands in the braces of {block}", found.text))
}

/// `fabricate roof { … }`
pub(super) fn made_as(scene: &Scene<'_>) -> Option<Way> {
    if !scene.miss.has(Expected::As) || kind(scene.found) != Some(TokenKind::OpenBrace) {
        return None;
    }
    say("what is made of it stands behind `as`: `as panels` of a surface, `as planks` of a curve")
}
