//! Items around values: `param`, `let`, `fn`, `record`, `figure` and `test`.

use super::expected::Expected;
use super::expression::Expressions;
use super::items::{item_token, text};
use super::level::range;
use super::names::{Case, declared};
use super::node::Node;
use super::primitive::{ahead, token, word};
use super::recovery::{Stop, finished, skip};
use super::sequence::{block, parenthesized};
use super::types::written_type;
use super::{Extra, Rule, Tokens};
use crate::syntax::ast::{
    Expr, Field, Figure, Function, Let, Param, Record, Test, TestStep, TypeExpr, TypeExprKind,
};
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// `param span: Length = 6m in 4m .. 9m step 100mm`
pub(super) fn param<'s>(expressions: &Expressions<'s>) -> Rule<'s, Param> {
    let range = token(TokenKind::In)
        .labelled(Expected::Range)
        .ignore_then(range(expressions.operand.clone()))
        .map(|(range, _)| range);
    let step = word("step", Expected::Step).ignore_then(expressions.finished(Stop::Item));
    item_token(TokenKind::Param)
        .ignore_then(declared(Case::Snake))
        .then(type_after_colon(Stop::Type))
        .then(value_after_equals(expressions, Stop::Param))
        .then(range.or_not())
        .then(step.or_not())
        .map(|((((name, ty), default), range), step)| Param { name, ty, default, range, step })
        .boxed()
}

/// `let width = 27mm`, of a file, an ifs or a test.
pub(super) fn named_value<'s>(expressions: &Expressions<'s>, stop: Stop) -> Rule<'s, Let> {
    let expected = match stop {
        Stop::Member => Expected::NextMember,
        Stop::Step => Expected::NextStep,
        _ => Expected::Item,
    };
    token(TokenKind::Let)
        .labelled(expected)
        .ignore_then(declared(Case::Snake))
        .then(optional_type())
        .then(value_after_equals(expressions, stop))
        .map(|((name, ty), value)| Let { name, ty, value })
        .boxed()
}

/// `fn arch(i: Int) -> Curve = …`
pub(super) fn function<'s>(expressions: &Expressions<'s>) -> Rule<'s, Function> {
    let result = token(TokenKind::Arrow).ignore_then(written_type()).or_not();
    item_token(TokenKind::Fn)
        .ignore_then(declared(Case::Snake))
        .then(parameters(expressions))
        .then(result)
        .then(value_after_equals(expressions, Stop::Item))
        .map(|(((name, parameters), result), body)| Function { name, parameters, result, body })
        .boxed()
}

/// `(i: Int, w: Length = 1m)`
pub(super) fn parameters<'s>(expressions: &Expressions<'s>) -> Rule<'s, Vec<Field>> {
    parenthesized(Expected::OpenParenthesis, field(expressions, Stop::Element), |_| None)
        .map(|fields| fields.into_iter().flatten().collect())
        .boxed()
}

/// `t: Number = 1/2`
fn field<'s>(
    expressions: &Expressions<'s>,
    stop: Stop,
) -> impl Parser<'s, Tokens<'s>, Option<Field>, Extra<'s>> + Clone + use<'s> {
    let default = token(TokenKind::Equals).ignore_then(expressions.finished(stop)).or_not();
    declared(Case::Snake)
        .then(type_after_colon(Stop::Type))
        .then(default)
        .map(|((name, ty), default)| Some(Field { docs: Vec::new(), name, ty, default }))
}

/// `record Radius { across: Length, along: Length }`
pub(super) fn record<'s>(expressions: &Expressions<'s>) -> Rule<'s, Record> {
    item_token(TokenKind::Record)
        .ignore_then(declared(Case::Camel))
        .then(block(field(expressions, Stop::Entry), Stop::Entry, |_| None, Expected::OpenBrace))
        .map(|(name, fields)| Record { name, fields: fields.into_iter().flatten().collect() })
        .boxed()
}

/// `figure shell = … at level 2`
pub(super) fn figure<'s>(expressions: &Expressions<'s>) -> Rule<'s, Figure> {
    item_token(TokenKind::Figure)
        .ignore_then(declared(Case::Snake))
        .then(optional_type())
        .then(value_after_equals(expressions, Stop::Item))
        .map(|((name, ty), value)| Figure { name, ty, value })
        .boxed()
}

/// `test "…" { let … assert … }`
pub(super) fn test<'s>(expressions: &Expressions<'s>) -> Rule<'s, Test> {
    let binding = named_value(expressions, Stop::Step).map(TestStep::Let);
    let assert = word("assert", Expected::NextStep)
        .ignore_then(expressions.finished(Stop::Step))
        .map_with(|condition, e| TestStep::Assert(condition, e.span()));
    item_token(TokenKind::Test)
        .ignore_then(text(Expected::Text))
        .then(block(binding.or(assert), Stop::Step, TestStep::Error, Expected::OpenBrace))
        .map(|(name, steps)| Test { name, steps })
        .boxed()
}

/// `: Length`, which must be there. What is no type leaves an error node.
fn type_after_colon<'s>(stop: Stop) -> Rule<'s, TypeExpr> {
    let failed = skip(stop, false).map(|span| TypeExpr { span, kind: TypeExprKind::Error });
    token(TokenKind::Colon).ignore_then(written_type()).recover_with(via_parser(failed)).boxed()
}

/// `: Length`, or nothing.
fn optional_type<'s>() -> Rule<'s, Option<TypeExpr>> {
    let colon = ahead(&[Expected::Colon], |next| next.is_some_and(|next| next.kind == TokenKind::Colon));
    colon.ignore_then(type_after_colon(Stop::Type)).or_not().boxed()
}

/// `= value` up to `stop`. A value that is missing or wrong leaves an error node, and the name before it stays.
pub(super) fn value_after_equals<'s>(expressions: &Expressions<'s>, stop: Stop) -> Rule<'s, Expr> {
    let value = token(TokenKind::Equals).ignore_then(expressions.whole.clone());
    finished(value, stop, Node::error).map(|node| node.expr).boxed()
}
