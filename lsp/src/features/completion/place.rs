//! What could be written at the cursor, by the tokens before it: the text is rarely whole there.

use ifs_compiler::hir::schema::SchemaKind;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;

use super::after::branch;
use crate::features::tokens::{Before, Open};

/// What could be written at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Nothing that is known yet: a new name, or nothing at all.
    Nothing,
    /// An item.
    Item,
    /// A member of an ifs.
    Member,
    /// A line of a test.
    Step,
    /// A line of a fabricate block of a kind; what it is unknown of is both.
    Entry(Option<SchemaKind>),
    /// A field in the braces after the label that stands there.
    Field(Span),
    /// A field in the braces that open there.
    FieldOf(Span),
    /// An argument of what is called by the name that stands there.
    Argument(Span),
    /// A value.
    Value,
    /// What goes on after a value.
    After,
    /// A type.
    Type,
    /// A field after a full stop.
    Part,
    /// A module of the library, or of the project.
    Module,
    /// A name of the module that stands there.
    Import(Span),
    /// `panels` or `planks`.
    Kind,
    /// A figure to be fabricated.
    Figure,
    /// A measure of a requirement of such a block.
    Measure(Option<SchemaKind>),
    /// What goes on after these words of a measure.
    Limit(Option<SchemaKind>, String),
    /// The limit of a size that a level is found by.
    SizeLimit,
    /// A transform or a boundary of a join.
    Join,
    /// A size that a level is found by.
    Size,
    /// Where an ifs lives.
    Space,
    /// A word that must stand here.
    Word(&'static str),
}

/// What could be written at the word.
pub(super) fn place(before: &Before<'_>) -> Place {
    let Some(last) = before.back(1) else { return Place::Item };
    if let Some(place) = in_list_type(before) {
        return place;
    }
    match last {
        TokenKind::Dot => return after_dot(before),
        TokenKind::Fabricate => return Place::Figure,
        TokenKind::At => return Place::Word("level"),
        TokenKind::Arrow => return Place::Type,
        TokenKind::Name if !before.new_line => {
            if let Some(place) = after_word(before) {
                return place;
            }
        }
        _ => {}
    }
    let declares = matches!(
        last,
        TokenKind::Param
            | TokenKind::Let
            | TokenKind::Fn
            | TokenKind::Record
            | TokenKind::Ifs
            | TokenKind::Figure
            | TokenKind::Test
            | TokenKind::For
    );
    if declares {
        return Place::Nothing;
    }
    if last == TokenKind::Pub {
        return Place::Item;
    }
    match before.open.last() {
        None => outside(before, last),
        Some(open) => match open.kind {
            TokenKind::OpenBrace => braces(before, *open, last),
            TokenKind::OpenParenthesis => parentheses(before, *open, last),
            _ => value_or_after(before),
        },
    }
}

/// In the brackets of the type of a list: its element is a type, which nothing follows.
fn in_list_type(before: &Before<'_>) -> Option<Place> {
    let mut lists = before.open.iter().rev().take_while(|open| open.kind == TokenKind::OpenBracket);
    let mut outer = lists.next()?.at;
    for list in lists {
        if list.at + 1 != outer {
            return None;
        }
        outer = list.at;
    }
    // No list is open there.
    (place(&before.cut(outer)) == Place::Type).then(|| match before.back(1) {
        Some(TokenKind::OpenBracket) => Place::Type,
        _ => Place::Nothing,
    })
}

fn after_dot(before: &Before<'_>) -> Place {
    match (before.item(), before.back(2)) {
        (Some(TokenKind::Use), _) if before.open.is_empty() => Place::Module,
        (_, Some(TokenKind::Number(_) | TokenKind::BadNumber)) => Place::Nothing,
        _ => Place::Part,
    }
}

/// After a word on the same line that asks for something of its own.
fn after_word(before: &Before<'_>) -> Option<Place> {
    let alone =
        !matches!(before.back(2), Some(TokenKind::Dot | TokenKind::Comma | TokenKind::OpenParenthesis));
    match before.back_text(1) {
        "as" if before.item() == Some(TokenKind::Fabricate) => Some(Place::Kind),
        "require" if before.item() == Some(TokenKind::Fabricate) && alone => {
            Some(Place::Measure(block_kind(before)))
        }
        "until" if before.back(2).is_some() && alone => Some(Place::Size),
        "each" if alone && before.back(2) != Some(TokenKind::Equals) => Some(Place::Word("until")),
        "transform" | "boundary" if before.item() == Some(TokenKind::Ifs) && alone => Some(Place::Nothing),
        _ if before.back_text(2) == "until" && before.value_ends(before.tokens.len().saturating_sub(2)) => {
            Some(Place::SizeLimit)
        }
        _ => None,
    }
}

/// Panels or planks, as the head of the block says.
pub(super) fn block_kind(before: &Before<'_>) -> Option<SchemaKind> {
    let kind = before.tokens.iter().position(|token| token.kind == TokenKind::OpenBrace)?;
    match before.written(kind.checked_sub(1)?) {
        "panels" => Some(SchemaKind::Panels),
        "planks" => Some(SchemaKind::Planks),
        _ => None,
    }
}

/// Where no bracket is open.
fn outside(before: &Before<'_>, last: TokenKind) -> Place {
    let item = before.item();
    if item == Some(TokenKind::Use) {
        return match last {
            TokenKind::Use => Place::Module,
            _ if before.new_line => Place::Item,
            _ => Place::Nothing,
        };
    }
    if line_ends(before) {
        return Place::Item;
    }
    match (item, last) {
        (Some(TokenKind::Fabricate), TokenKind::Name) => Place::Word("as"),
        (Some(TokenKind::Ifs), TokenKind::Name | TokenKind::CloseParenthesis) => Place::Space,
        (Some(TokenKind::Ifs), TokenKind::In) => Place::Space,
        (Some(TokenKind::Param | TokenKind::Let | TokenKind::Figure), TokenKind::Colon) => Place::Type,
        // What has ended, and something else on its line.
        (_, TokenKind::CloseBrace) => Place::Item,
        _ => value_or_after(before),
    }
}

/// Whether what stands before the word may be whole, and its line has ended.
fn line_ends(before: &Before<'_>) -> bool {
    before.new_line && before.after_value() && branch(before).is_none()
}

fn value_or_after(before: &Before<'_>) -> Place {
    if before.after_value() { Place::After } else { Place::Value }
}

fn braces(before: &Before<'_>, open: Open, last: TokenKind) -> Place {
    let begins = matches!(last, TokenKind::OpenBrace | TokenKind::Comma);
    let ended = begins || line_ends(before);
    let outermost = before.open.len() == 1;
    match before.item() {
        Some(TokenKind::Fabricate) if outermost => {
            if ended {
                Place::Entry(block_kind(before))
            } else {
                limit(before).unwrap_or_else(|| value_or_after(before))
            }
        }
        Some(TokenKind::Ifs) if outermost => {
            if ended {
                Place::Member
            } else {
                join(before).unwrap_or_else(|| typed_or_value(before))
            }
        }
        Some(TokenKind::Test) if outermost => {
            if ended {
                Place::Step
            } else {
                typed_or_value(before)
            }
        }
        Some(TokenKind::Record) if outermost => field(before, last),
        _ if ended => match open.at.checked_sub(2).map(|at| before.tokens[at]) {
            Some(label) if before.tokens[open.at - 1].kind == TokenKind::Colon => Place::Field(label.span),
            _ => Place::FieldOf(before.tokens[open.at].span),
        },
        _ => value_or_after(before),
    }
}

/// In a `let` of an ifs or a test, which may say its type.
fn typed_or_value(before: &Before<'_>) -> Place {
    let first = before.statement().first().map(|at| before.tokens[*at].kind);
    match (first, before.back(1)) {
        (Some(TokenKind::Let), Some(TokenKind::Colon)) => Place::Type,
        _ => value_or_after(before),
    }
}

/// After words of a measure that is required.
fn limit(before: &Before<'_>) -> Option<Place> {
    let statement = before.statement();
    let (first, words) = statement.split_first()?;
    let measure = words.iter().all(|at| before.tokens[*at].kind == TokenKind::Name);
    if before.written(*first) != "require" || words.is_empty() || !measure {
        return None;
    }
    let words: Vec<&str> = words.iter().map(|at| before.written(*at)).collect();
    Some(Place::Limit(block_kind(before), words.join(" ")))
}

/// In a join: a path on each side of its sign.
fn join(before: &Before<'_>) -> Option<Place> {
    let statement = before.statement();
    if before.written(*statement.first()?) != "join" {
        return None;
    }
    let sides = statement.iter().any(|at| before.tokens[*at].kind == TokenKind::Equals);
    Some(match before.back(1) {
        Some(TokenKind::Equals) => Place::Join,
        _ if statement.len() == 1 => Place::Join,
        _ if sides => Place::Nothing,
        _ => Place::Word("="),
    })
}

/// In a parameter or a field that is declared: its name, its type, its default.
fn field(before: &Before<'_>, last: TokenKind) -> Place {
    use TokenKind::{Colon, Comma, Equals, Name, OpenBrace, OpenParenthesis};
    match (before.back(2), last) {
        (_, Colon) => Place::Type,
        (_, Equals) => Place::Value,
        _ if before.new_line => Place::Nothing,
        (Some(Colon), Name) => Place::Word("="),
        (Some(OpenParenthesis | OpenBrace | Comma), Name) => Place::Word(":"),
        _ => Place::Nothing,
    }
}

fn parentheses(before: &Before<'_>, open: Open, last: TokenKind) -> Place {
    let begins = matches!(last, TokenKind::OpenParenthesis | TokenKind::Comma);
    let before_open = open.at.checked_sub(1).map(|at| before.tokens[at].kind);
    let before_name = open.at.checked_sub(2).map(|at| before.tokens[at].kind);
    let item = before.item();
    if item == Some(TokenKind::Use) {
        let module = before.tokens[..open.at].iter().map(|token| token.span);
        let path = module.skip(1).reduce(|first, next| first.to(next));
        return path.map_or(Place::Nothing, Place::Import);
    }
    if matches!(before_name, Some(TokenKind::Fn | TokenKind::Ifs)) {
        return field(before, last);
    }
    let braces = before.open.iter().any(|open| open.kind == TokenKind::OpenBrace);
    if item == Some(TokenKind::Ifs) && !braces && before_open == Some(TokenKind::On) {
        return Place::Nothing;
    }
    let called = matches!(before_open, Some(TokenKind::Name | TokenKind::Itself));
    let glued = called && before.tokens[open.at - 1].span.end == before.tokens[open.at].span.start;
    if begins && glued {
        return Place::Argument(before.tokens[open.at - 1].span);
    }
    value_or_after(before)
}
