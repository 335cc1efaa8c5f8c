//! What follows a whole expression: where an ifs is placed, and how deep it goes. Looser than every operator.

use super::expected::Expected;
use super::node::{Depth, Node, expressions};
use super::operators::{comparison, sum};
use super::primitive::{Small, lexeme, token, word};
use super::sequence::parenthesized;
use super::{Progress, Rule};
use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::ast::{Comparison, Expr, ExprKind, Level, Limit, Name, Placement, RangeExpr};
use crate::syntax::lexeme::Role;
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// What follows, before it is put on the left side.
#[derive(Clone, Debug)]
enum Suffix {
    Points(Vec<Node>, Span),
    Value(Node),
    Level(Node),
    Until(bool, Name, LimitNode),
}

/// A limit and its depth.
#[derive(Clone, Debug)]
pub(super) struct LimitNode {
    pub(super) limit: Limit,
    depth: Depth,
}

/// A row with any number of `on …`, `at level …`, `until …` after it. `inner` is a whole expression.
pub(super) fn placed<'s>(
    row: Rule<'s, Node>,
    operand: Rule<'s, Node>,
    inner: Rule<'s, Node>,
) -> Rule<'s, Node> {
    let on = operator(TokenKind::On).ignore_then(choice((
        parenthesized(Expected::Value, inner, Node::error)
            .map_with(|points, e| Suffix::Points(points, e.span())),
        row.clone().map(Suffix::Value),
    )));
    let at = operator(TokenKind::At)
        .ignore_then(word("level", Expected::Level))
        .ignore_then(sum(operand.clone()))
        .map(Suffix::Level);
    let each = word("each", Expected::Operator).or_not().map(|each| each.is_some());
    let until = each
        .then_ignore(word("until", Expected::Operator))
        .then(measure())
        .then(limit(operand))
        .map(|((each, measure), limit)| Suffix::Until(each, measure, limit));
    let suffix = choice((on, at, until)).map_with(|suffix, e| (suffix, e.span()));
    row.then(suffix.repeated().collect::<Vec<(Suffix, Span)>>())
        .map_with(|(first, suffixes), e| {
            let mut node = first;
            for (suffix, span) in suffixes {
                let whole = node.expr.span.to(span);
                node = attach(node, suffix, whole, e.state());
                if node.is_error() {
                    break;
                }
            }
            node
        })
        .boxed()
}

fn operator<'s>(kind: TokenKind) -> impl Small<'s, Span> {
    lexeme(Expected::Operator, move |found, span| (found.kind == kind).then_some(span))
}

fn attach(left: Node, suffix: Suffix, span: Span, progress: &mut Progress) -> Node {
    let depth = Depth::default().with(&left);
    let (kind, depth) = match suffix {
        Suffix::Points(points, brackets) => {
            let depth = depth.with_all(&points);
            (ExprKind::On(left.boxed(), Placement::Points(expressions(points), brackets)), depth)
        }
        Suffix::Value(value) => {
            let depth = depth.with(&value);
            (ExprKind::On(left.boxed(), Placement::Value(value.boxed())), depth)
        }
        Suffix::Level(level) => {
            let depth = depth.with(&level);
            (ExprKind::At(left.boxed(), level_of(level.expr, progress)), depth)
        }
        Suffix::Until(each, measure, LimitNode { limit, depth: inner }) => {
            (ExprKind::At(left.boxed(), Level::Until { each, measure, limit }), depth.and(inner))
        }
    };
    Node::made(span, kind, depth, progress)
}

/// `4`, or the pair `(4, 3)`.
fn level_of(level: Expr, progress: &mut Progress) -> Level {
    let ExprKind::Tuple(parts) = level.kind else { return Level::Uniform(Box::new(level)) };
    match <[Expr; 2]>::try_from(parts) {
        Ok([u, v]) => Level::Pair(Box::new(u), Box::new(v)),
        Err(_) => {
            let message = "a level is one whole number, or two in brackets for u and v";
            progress
                .said
                .push(Diagnostic::new(Code::E0201, level.span, message).hint("write `at level (4, 3)`"));
            Level::Uniform(Box::new(Expr { span: level.span, kind: ExprKind::Error }))
        }
    }
}

/// The words of a measure, joined by one space.
pub(super) fn measure<'s>() -> Rule<'s, Name> {
    let words = |expected| {
        lexeme(expected, |found, span| {
            let fits = found.kind == TokenKind::Name && found.role != Role::Label;
            fits.then(|| Name { text: found.text.to_owned(), span })
        })
    };
    words(Expected::Measure)
        .then(words(Expected::Comparison).repeated().collect::<Vec<_>>())
        .map(|(first, rest)| {
            rest.into_iter().fold(first, |all, next| Name {
                text: format!("{} {}", all.text, next.text),
                span: all.span.to(next.span),
            })
        })
        .boxed()
}

/// `>= 80mm`, `in 150mm .. 1200mm`
pub(super) fn limit<'s>(operand: Rule<'s, Node>) -> Rule<'s, LimitNode> {
    let compare = comparison().then(sum(operand.clone())).map(|(comparison, node)| compare(comparison, node));
    let within = lexeme(Expected::Comparison, |found, _| (found.kind == TokenKind::In).then_some(()))
        .ignore_then(range(operand))
        .map(|(range, depth)| LimitNode { limit: Limit::Within(Box::new(range)), depth });
    compare.or(within).boxed()
}

fn compare(comparison: Comparison, node: Node) -> LimitNode {
    let depth = Depth::default().with(&node);
    LimitNode { limit: Limit::Compare(comparison, node.boxed()), depth }
}

/// `a .. b` where nothing but a range can stand.
pub(super) fn range<'s>(operand: Rule<'s, Node>) -> Rule<'s, (RangeExpr, Depth)> {
    let end = sum(operand);
    end.clone()
        .then_ignore(token(TokenKind::DotDot))
        .then(end)
        .map(|(from, to)| {
            let span = from.expr.span.to(to.expr.span);
            let depth = Depth::default().with(&from).with(&to);
            (RangeExpr { from: from.expr, to: to.expr, span }, depth)
        })
        .boxed()
}
