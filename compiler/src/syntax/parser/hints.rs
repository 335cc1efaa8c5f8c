//! Ways out of the mistakes people make most: habits of other languages, a missing sign, a misspelt word.

mod places;

use super::expected::Expected;
use super::message::Scene;
use crate::diagnostic::{Diagnostic, closest};
use crate::source::Span;
use crate::syntax::ast::Unit;
use crate::syntax::lexeme::{Lexeme, MEMBER_WORDS, Role};
use crate::syntax::token::TokenKind;

/// Words of other languages, and the keyword that does it here.
const FOREIGN_WORDS: &[(&str, &str)] = &[
    ("function", "fn"),
    ("func", "fn"),
    ("fun", "fn"),
    ("def", "fn"),
    ("const", "let"),
    ("var", "let"),
    ("val", "let"),
    ("struct", "record"),
    ("class", "record"),
    ("type", "record"),
    ("import", "use"),
    ("include", "use"),
    ("from", "use"),
    ("parameter", "param"),
    ("fractal", "ifs"),
    ("expect", "assert"),
    ("check", "assert"),
];

const ITEM_WORDS: &[&str] =
    &["use", "pub", "param", "let", "fn", "record", "ifs", "figure", "fabricate", "test"];

/// Adds the first hint that fits.
pub(super) fn add(diagnostic: Diagnostic, scene: &Scene<'_>) -> Diagnostic {
    let rules: &[fn(&Scene<'_>) -> Option<Way>] = &[
        glued_unit,
        size_by,
        other_equals,
        loops,
        missing_let,
        places::line_of_a_block,
        places::made_as,
        foreign_word,
        misspelt,
        reserved,
        number_point,
        conditions,
        renamed,
        family_condition,
        lone_label,
        missing_part,
        missing_sign,
        habits,
    ];
    match rules.iter().find_map(|rule| rule(scene)) {
        None => diagnostic,
        Some(Way { text, change: Some((span, replacement)) }) => diagnostic.fix(text, span, replacement),
        Some(Way { text, change: None }) => diagnostic.hint(text),
    }
}

/// A way out: what to do, and the change of the text where it is known.
struct Way {
    text: String,
    change: Option<(Span, String)>,
}

fn change(text: impl Into<String>, span: Span, replacement: impl Into<String>) -> Option<Way> {
    Some(Way { text: text.into(), change: Some((span, replacement.into())) })
}

fn say(text: impl Into<String>) -> Option<Way> {
    Some(Way { text: text.into(), change: None })
}

fn kind(placed: Option<(Lexeme<'_>, Span)>) -> Option<TokenKind> {
    placed.map(|(lexeme, _)| lexeme.kind)
}

fn is_name(placed: Option<(Lexeme<'_>, Span)>) -> bool {
    kind(placed) == Some(TokenKind::Name)
}

/// `5 mm`
fn glued_unit(scene: &Scene<'_>) -> Option<Way> {
    let ((number, before), (word, span)) = (scene.before?, scene.found?);
    let bare = number.kind == TokenKind::Number(None);
    let unit = bare && Unit::ALL.iter().any(|unit| unit.suffix() == word.text);
    let gap = Span::new(span.file, before.end, span.start);
    if !unit {
        return None;
    }
    change(format!("a unit is glued to its number: `{}{}`", number.text, word.text), gap, "")
}

/// `120mm x 27mm`
fn size_by(scene: &Scene<'_>) -> Option<Way> {
    let (_, span) = scene.found.filter(|(found, _)| found.text == "x")?;
    let number = |placed| matches!(kind(placed), Some(TokenKind::Number(Some(_))));
    if !(number(scene.before) && number(scene.after)) {
        return None;
    }
    change("a size is written with `by`: `120mm by 27mm`", span, "by")
}

/// `==` for `=`, `=` for `==` or `:`, `:=`
fn other_equals(scene: &Scene<'_>) -> Option<Way> {
    let (found, span) = scene.found?;
    match found.kind {
        TokenKind::EqualEqual if scene.miss.has(Expected::Equals) => {
            change("a name is given a value with a single `=`", span, "=")
        }
        TokenKind::Equals if scene.miss.has(Expected::Type) => {
            let colon = scene.before.filter(|(before, _)| before.kind == TokenKind::Colon);
            colon.and_then(|(_, colon)| change("leave out the `:` where no type is written", colon, ""))
        }
        TokenKind::Equals if scene.miss.has(Expected::Colon) && scene.is_typed => {
            let Some(TokenKind::Number(unit)) = kind(scene.after) else {
                return say("its type stands before the value: `: Length = 3m`");
            };
            let ty = match unit.map(Unit::suffix) {
                None => "Number",
                Some("mm" | "cm" | "m" | "in" | "ft") => "Length",
                Some("deg" | "rad") => "Angle",
                Some(_) => return say("its type stands before the value: `: Length = 3m`"),
            };
            let from = scene.before.map_or(span, |(_, before)| Span::new(span.file, before.end, span.end));
            change("its type stands before the value", from, format!(": {ty} ="))
        }
        TokenKind::Equals if scene.miss.has(Expected::Colon) => {
            change("a field is given with `:`", span, ":")
        }
        TokenKind::Equals if scene.miss.has(Expected::Comma) && is_name(scene.before) => {
            change("an argument is named with `:`", span, ":")
        }
        TokenKind::Equals if scene.miss.has(Expected::Operator) => {
            change("to compare, write `==`", span, "==")
        }
        _ => None,
    }
}

/// Whether an item, a member of an ifs or a line of a test could begin here.
fn begins(scene: &Scene<'_>) -> bool {
    let wanted = [Expected::Item, Expected::NextItem, Expected::NextMember, Expected::NextStep];
    wanted.iter().any(|one| scene.miss.has(*one))
}

/// `for i in 0..3 { … }`, `while …`
fn loops(scene: &Scene<'_>) -> Option<Way> {
    let (found, _) =
        scene.found.filter(|(found, _)| found.kind == TokenKind::For || found.is_word("while"))?;
    let named = found.kind == TokenKind::Name && kind(scene.after) == Some(TokenKind::Equals);
    if !begins(scene) || named {
        return None;
    }
    say(
        "there are no loops: a list is made by `[… for i in 0..3]`, a family of transforms by `transform t[i in 0..3] = …`",
    )
}

/// `a = 4`
fn missing_let(scene: &Scene<'_>) -> Option<Way> {
    let (found, span) = scene.found.filter(|(found, _)| found.kind == TokenKind::Name)?;
    if !begins(scene) || kind(scene.after) != Some(TokenKind::Equals) {
        return None;
    }
    let before = Span::new(span.file, span.start, span.start);
    change(format!("a value is declared with `let`: `let {} = …`", found.text), before, "let ")
}

/// `function`, `const`, …
fn foreign_word(scene: &Scene<'_>) -> Option<Way> {
    let (found, span) = scene.found.filter(|(found, _)| found.kind == TokenKind::Name)?;
    if !begins(scene) {
        return None;
    }
    let (_, keyword) = FOREIGN_WORDS.iter().find(|(word, _)| *word == found.text)?;
    change(format!("here this is written `{keyword}`"), span, *keyword)
}

/// A word that is nearly one of those expected.
fn misspelt(scene: &Scene<'_>) -> Option<Way> {
    let (found, span) = scene.found.filter(|(found, _)| found.kind == TokenKind::Name)?;
    let has = |one: Expected| scene.miss.has(one);
    let mut words: Vec<&str> = Vec::new();
    if has(Expected::Item) || has(Expected::NextItem) {
        words.extend(ITEM_WORDS);
    }
    if has(Expected::NextMember) {
        words.extend(MEMBER_WORDS);
        words.push("let");
    }
    if has(Expected::NextStep) {
        words.extend(["let", "assert"]);
    }
    for (expected, word) in [
        (Expected::Then, "then"),
        (Expected::Else, "else"),
        (Expected::Level, "level"),
        (Expected::As, "as"),
        (Expected::In, "in"),
        (Expected::Unit, "plane"),
        (Expected::Unit, "space"),
    ] {
        if has(expected) {
            words.push(word);
        }
    }
    let near = closest(found.text, words)?;
    change(format!("did you mean `{near}`?"), span, near)
}

/// A reserved word as a name.
fn reserved(scene: &Scene<'_>) -> Option<Way> {
    let (found, _) = scene.found.filter(|(found, _)| found.kind.is_keyword())?;
    if !scene.miss.has(Expected::Name) {
        return None;
    }
    say(format!("`{}` is a word of the language: choose another name", found.text))
}

/// `.5`, `5.`
fn number_point(scene: &Scene<'_>) -> Option<Way> {
    let (_, point) = scene.found.filter(|(found, _)| found.kind == TokenKind::Dot)?;
    let number = |placed| matches!(kind(placed), Some(TokenKind::Number(_)));
    if number(scene.after) && scene.miss.has(Expected::Value) {
        return change("a number begins with a digit: `0.5`", point, "0.");
    }
    None
}

/// `if` without `then` or `else`, `elif`
fn conditions(scene: &Scene<'_>) -> Option<Way> {
    let form = "a condition is written `if c then a else b`, with both values";
    if scene.miss.has(Expected::Then) && !scene.miss.has(Expected::Equals) || scene.miss.has(Expected::Else) {
        return say(form);
    }
    None
}

/// `use std.curves (bezier3 as b)`
fn renamed(scene: &Scene<'_>) -> Option<Way> {
    scene.found.filter(|(found, _)| found.text == "as")?;
    if !is_name(scene.before) || !scene.miss.has(Expected::Comma) {
        return None;
    }
    say(
        "what is used keeps its name: there is no `as`; where two names are the same, rename the one of your own",
    )
}

/// `transform t[i in 0..4 if i != 2] = …`
fn family_condition(scene: &Scene<'_>) -> Option<Way> {
    scene.found.filter(|(found, _)| found.kind == TokenKind::If)?;
    if !scene.miss.has(Expected::CloseBracket) || scene.miss.has(Expected::For) {
        return None;
    }
    say("a condition stands in a list, and a family may run over one: `t[k in [i for i in 0..4 if i != 2]]`")
}

/// A sign that is missing between what stands before and what was found.
fn missing_sign(scene: &Scene<'_>) -> Option<Way> {
    let (_, before) = scene.before?;
    let (found, span) = scene.found?;
    let has = |one: Expected| scene.miss.has(one);
    use TokenKind::*;
    let value = matches!(
        found.kind,
        Number(_) | Text | Name | True | False | Itself | OpenBracket | OpenParenthesis | Minus
    );
    let insert = |text: &str, sign: &str| change(format!("{text} `{}`", sign.trim()), before.after(), sign);
    if has(Expected::Equals)
        && found.kind == OpenBrace
        && (has(Expected::Arrow) || kind(scene.before) != Some(Name))
    {
        return say("the body of a function is one expression: `fn f(…) -> Type = …`");
    }
    if has(Expected::Level) && value {
        return change("a level is given with `at level`", before.after(), " level");
    }
    if has(Expected::NextEntry) && found.kind == Name && kind(scene.after) != Some(Equals) {
        return change("a field is given with `:`", span.after(), ":");
    }
    if !value {
        return None;
    }
    if has(Expected::Equals) {
        return insert("a value is given with", " =");
    }
    if has(Expected::Colon) {
        return insert("a field or type is given with", ":");
    }
    if has(Expected::Comma) && (has(Expected::CloseParenthesis) || !has(Expected::NextEntry)) {
        return insert("elements are separated by", ",");
    }
    None
}

/// A part of a form that is not there.
fn missing_part(scene: &Scene<'_>) -> Option<Way> {
    let has = |one: Expected| scene.miss.has(one);
    let found = kind(scene.found);
    let after_file = kind(scene.before) == Some(TokenKind::Text);
    if has(Expected::OpenParenthesis) && (has(Expected::Dot) || after_file) {
        return say("name what is used, in brackets: `use std.curves (bezier3)`");
    }
    if has(Expected::Colon) && matches!(found, Some(TokenKind::Comma | TokenKind::CloseParenthesis)) {
        return say("each parameter has a type: `a: Length`");
    }
    if has(Expected::Comparison) {
        return say("a limit is written `<= 600mm`, or `in 150mm .. 1200mm`");
    }
    if has(Expected::In) && !has(Expected::Space) {
        return say("a name runs over a range or a list with `in`: `i in 0..7`");
    }
    None
}

/// `(a: 1)` without what is called.
fn lone_label(scene: &Scene<'_>) -> Option<Way> {
    let (found, _) = scene.found.filter(|(found, _)| found.role == Role::Label)?;
    let after = matches!(kind(scene.before), Some(TokenKind::OpenParenthesis | TokenKind::Comma));
    if !after || !scene.miss.has(Expected::Value) {
        return None;
    }
    say(format!(
        "an argument with a name, like `{}:`, belongs to a call: `name({}: …)`",
        found.text, found.text
    ))
}

/// Other habits.
fn habits(scene: &Scene<'_>) -> Option<Way> {
    let before = scene.before?.0;
    if before.is_word("return") {
        return say("there is no `return`: a function is its expression");
    }
    if before.kind == TokenKind::Star && kind(scene.found) == Some(TokenKind::Star) {
        return say("there is no `**`: multiply, or call a function");
    }
    let same_line = scene.found.filter(|(found, _)| found.kind == TokenKind::Name && found.indent.is_none());
    if before.kind == TokenKind::Number(None) && same_line.is_some() {
        return say("to multiply, write `*`");
    }
    None
}
