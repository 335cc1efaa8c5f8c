//! The items of a file: which keyword begins which, `pub`, `use`, and what stands between items.

use super::expected::Expected;
use super::expression::Expressions;
use super::names::name;
use super::primitive::{lexeme, token};
use super::recovery::{Stop, complete, skip};
use super::sequence::parenthesized;
use super::{Rule, fabricate, figures, ifs};
use crate::source::Span;
use crate::syntax::ast::{Item, ItemKind, ModulePath, Name, TextLiteral, Use};
use crate::syntax::lexer::text::unescape;
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// One item. What follows it in its range is passed over with an error.
pub(super) fn item<'s>() -> Rule<'s, Item> {
    let expressions = Expressions::new();
    let kinds = choice((
        import().map(ItemKind::Use),
        figures::param(&expressions).map(ItemKind::Param),
        figures::named_value(&expressions, Stop::Item).map(ItemKind::Let),
        figures::function(&expressions).map(ItemKind::Function),
        figures::record(&expressions).map(ItemKind::Record),
        ifs::ifs(&expressions).map(ItemKind::Ifs),
        figures::figure(&expressions).map(ItemKind::Figure),
        fabricate::fabricate(&expressions).map(ItemKind::Fabricate),
        figures::test(&expressions).map(ItemKind::Test),
    ));
    let kind = kinds
        .boxed()
        .map_with(|kind, e| (kind, e.span()))
        .recover_with(via_parser(skip(Stop::Item, false).map(|span| (ItemKind::Error, span))));
    let rest = complete(Stop::Item).recover_with(via_parser(skip(Stop::Item, false).ignored()));
    let public = item_token(TokenKind::Pub).or_not();
    public
        .then(kind)
        .then_ignore(rest)
        .map(|(public, (kind, span))| {
            let span = public.map_or(span, |public| public.to(span));
            Item { span, docs: Vec::new(), public, kind }
        })
        .boxed()
}

/// A keyword that begins an item.
pub(super) fn item_token<'s>(kind: TokenKind) -> impl super::primitive::Small<'s, Span> {
    lexeme(Expected::Item, move |found, span| (found.kind == kind).then_some(span))
}

/// A quoted text.
pub(super) fn text<'s>(expected: Expected) -> impl super::primitive::Small<'s, TextLiteral> {
    lexeme(expected, |found, span| {
        (found.kind == TokenKind::Text).then(|| TextLiteral { value: unescape(found.text), span })
    })
}

/// `use std.curves (bezier3)`, `use "./ribs.ifs" (rib)`
fn import<'s>() -> Rule<'s, Use> {
    let library = name()
        .labelled(Expected::Module)
        .separated_by(token(TokenKind::Dot))
        .at_least(1)
        .collect::<Vec<_>>()
        .map(ModulePath::Library);
    let file = text(Expected::Module).map(ModulePath::File);
    let nowhere = |span| Name { text: String::new(), span };
    let names = parenthesized(Expected::OpenParenthesis, name(), nowhere)
        .map(|names| names.into_iter().filter(|name| !name.text.is_empty()).collect());
    item_token(TokenKind::Use)
        .ignore_then(choice((file, library)))
        .then(names)
        .map(|(module, names)| Use { module, names })
        .boxed()
}
