//! An ifs: its space and its members.

use super::Rule;
use super::expected::Expected;
use super::expression::Expressions;
use super::figures::{named_value, parameters, value_after_equals};
use super::items::item_token;
use super::names::{Case, declared, name};
use super::primitive::{lexeme, token, word};
use super::recovery::Stop;
use super::sequence::{block, parenthesized};
use crate::source::Span;
use crate::syntax::ast::{ControlPoint, Ifs, JoinPart, Member, MemberKind, Name, Space, Transform};
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// `ifs bezier3(t: Number = 1/2) on (p0, p1, p2, p3) { … }`
pub(super) fn ifs<'s>(expressions: &Expressions<'s>) -> Rule<'s, Ifs> {
    let failed = |span| Member { span, docs: Vec::new(), kind: MemberKind::Error };
    item_token(TokenKind::Ifs)
        .ignore_then(declared(Case::Snake))
        .then(parameters(expressions).or_not())
        .then(space(expressions))
        .then(block(member(expressions), Stop::Member, failed, Expected::OpenBrace))
        .map(|(((name, parameters), space), members)| Ifs {
            name,
            parameters: parameters.unwrap_or_default(),
            space,
            members,
        })
        .boxed()
}

/// `on (p0, p1)`, `on (p[n + 1])`, `in plane`, `in space`
fn space<'s>(expressions: &Expressions<'s>) -> Rule<'s, Space> {
    let nowhere = |span| ControlPoint { name: Name { text: String::new(), span }, count: None };
    let count = expressions
        .whole
        .clone()
        .map(|count| count.expr)
        .then_ignore(token(TokenKind::Comma).or_not())
        .delimited_by(token(TokenKind::OpenBracket), token(TokenKind::CloseBracket));
    let point =
        declared(Case::Snake).then(count.or_not()).map(|(name, count)| ControlPoint { name, count }).boxed();
    let points = parenthesized(Expected::OpenParenthesis, point, nowhere)
        .map(|points| points.into_iter().filter(|point: &ControlPoint| !point.name.text.is_empty()).collect())
        .map_with(|points, e| Space::On(points, e.span()));
    let on = token(TokenKind::On).labelled(Expected::Space).ignore_then(points);
    let whole = lexeme(Expected::Unit, |found, _| match found.text {
        "plane" => Some(Space::Plane as fn(Span) -> Space),
        "space" => Some(Space::Space as fn(Span) -> Space),
        _ => None,
    });
    let within =
        token(TokenKind::In).labelled(Expected::Space).ignore_then(whole.map_with(|make, e| make(e.span())));
    on.or(within).boxed()
}

/// A member, which ends where the next begins.
fn member<'s>(expressions: &Expressions<'s>) -> Rule<'s, Member> {
    let begin = |text: &'static str| word(text, Expected::NextMember);
    let value = expressions.finished(Stop::Member);
    let kinds = choice((
        named_value(expressions, Stop::Member).map(MemberKind::Let),
        transform(expressions).map(MemberKind::Transform),
        begin("germ").ignore_then(value.clone()).map(MemberKind::Germ),
        begin("keep").ignore_then(value).map(MemberKind::Keep),
        begin("boundary")
            .ignore_then(declared(Case::Snake))
            .then(value_after_equals(expressions, Stop::Member))
            .map(|(name, value)| MemberKind::Boundary(name, value)),
        begin("join")
            .ignore_then(path(expressions))
            .then_ignore(token(TokenKind::Equals))
            .then(path(expressions))
            .map(|(left, right)| MemberKind::Join(left, right)),
    ));
    kinds.map_with(|kind, e| Member { span: e.span(), docs: Vec::new(), kind }).boxed()
}

/// `transform left = self on (…)`, `transform branch[i in 0..3] = …`
fn transform<'s>(expressions: &Expressions<'s>) -> Rule<'s, Transform> {
    let family = declared(Case::Snake)
        .then_ignore(token(TokenKind::In))
        .then(expressions.whole.clone())
        .map(|(name, range)| (name, range.expr))
        .delimited_by(
            token(TokenKind::OpenBracket).labelled(Expected::Family),
            token(TokenKind::CloseBracket),
        );
    word("transform", Expected::NextMember)
        .ignore_then(declared(Case::Snake))
        .then(family.or_not())
        .then(value_after_equals(expressions, Stop::Member))
        .map(|((name, family), value)| Transform { name, family, value })
        .boxed()
}

/// `left.end`, `start`, `branch[0].end`
fn path<'s>(expressions: &Expressions<'s>) -> Rule<'s, Vec<JoinPart>> {
    let member = expressions
        .whole
        .clone()
        .map(|member| member.expr)
        .then_ignore(token(TokenKind::Comma).or_not())
        .delimited_by(token(TokenKind::OpenBracket), token(TokenKind::CloseBracket));
    let part = name().then(member.or_not()).map(|(name, member)| JoinPart { name, member }).boxed();
    part.clone()
        .then(token(TokenKind::Dot).ignore_then(part).or_not())
        .map(|(first, second)| std::iter::once(first).chain(second).collect())
        .boxed()
}
