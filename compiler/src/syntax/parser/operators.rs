//! Operators between operands: read as a flat row, then put together by precedence without recursion.

use super::expected::Expected;
use super::node::{Depth, Node};
use super::primitive::{Small, lexeme};
use super::{Extra, Progress, Rule, Tokens};
use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::ast::{BinaryOperator, Comparison, ExprKind, RangeExpr, UnaryOperator};
use crate::syntax::lexeme::Lexeme;
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// An operator of a row, with its place.
#[derive(Clone, Copy, Debug)]
enum Operator {
    Not,
    Range,
    Binary(BinaryOperator),
}

impl Operator {
    /// How tightly it binds.
    fn precedence(self) -> u8 {
        match self {
            Operator::Binary(BinaryOperator::Or) => 1,
            Operator::Binary(BinaryOperator::And) => 2,
            Operator::Not => 3,
            Operator::Binary(BinaryOperator::Compare(_)) => 4,
            Operator::Range => 5,
            Operator::Binary(BinaryOperator::By) => 6,
            Operator::Binary(BinaryOperator::Add | BinaryOperator::Subtract) => 7,
            Operator::Binary(BinaryOperator::Multiply | BinaryOperator::Divide) => 8,
        }
    }

    /// Whether `a op b op c` means nothing.
    fn stands_alone(self) -> bool {
        matches!(self, Operator::Range | Operator::Binary(BinaryOperator::Compare(_)))
    }
}

/// What follows the first operand of a row: an operator, the `not`s after it, and an operand.
type Link = ((Operator, Span), Vec<Span>, Node);

/// Rows of all operators: `not a + b * c == d and e`, `a .. b`.
pub(super) fn row<'s>(operand: Rule<'s, Node>) -> Rule<'s, Node> {
    let nots = not().repeated().collect::<Vec<_>>();
    let logical = lexeme(Expected::Operator, logical).then(nots).then(operand.clone());
    let tight = lexeme(Expected::Operator, |found, span| arithmetic(found, span).or(comparing(found, span)))
        .then(operand.clone())
        .map(|(operator, operand)| ((operator, Vec::new()), operand));
    let links = choice((tight, logical))
        .map(|((operator, nots), operand)| (operator, nots, operand))
        .repeated()
        .collect::<Vec<Link>>();
    nots.then(operand)
        .then(links)
        .map_with(|((nots, first), links), e| Tree::of(nots, first, links, e.state()))
        .boxed()
}

/// Rows of `+ - * / by` only, for ends of ranges and for limits.
pub(super) fn sum<'s>(operand: Rule<'s, Node>) -> Rule<'s, Node> {
    let links = lexeme(Expected::Operator, arithmetic)
        .then(operand.clone())
        .map(|(operator, operand)| (operator, Vec::new(), operand))
        .repeated()
        .collect::<Vec<Link>>();
    operand.then(links).map_with(|(first, links), e| Tree::of(Vec::new(), first, links, e.state())).boxed()
}

/// `not` before what can be its operand.
fn not<'s>() -> impl Small<'s, Span> {
    custom(|input: &mut chumsky::input::InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let before = input.save();
        let start = input.cursor();
        let is_not = input.next().is_some_and(|found| found.is_word("not"));
        let span = input.span_since(&start);
        if is_not && input.peek().is_some_and(begins_operand) {
            return Ok(span);
        }
        input.rewind(before);
        Err(super::expected::Miss::new(Expected::Value, span))
    })
}

fn begins_operand(next: Lexeme<'_>) -> bool {
    use TokenKind::*;
    let value = matches!(next.kind, Number(_) | BadNumber | Text | True | False | If | Itself | Error);
    let infix = ["and", "or", "by", "until", "each"].contains(&next.text);
    value || matches!(next.kind, OpenParenthesis | OpenBracket) || next.kind == Name && !infix
}

fn logical(found: Lexeme<'_>, span: Span) -> Option<(Operator, Span)> {
    let operator = if found.is_word("and") {
        BinaryOperator::And
    } else if found.is_word("or") {
        BinaryOperator::Or
    } else {
        return None;
    };
    Some((Operator::Binary(operator), span))
}

fn arithmetic(found: Lexeme<'_>, span: Span) -> Option<(Operator, Span)> {
    let operator = match found.kind {
        TokenKind::Plus => BinaryOperator::Add,
        TokenKind::Minus => BinaryOperator::Subtract,
        TokenKind::Star => BinaryOperator::Multiply,
        TokenKind::Slash => BinaryOperator::Divide,
        _ if found.is_word("by") => BinaryOperator::By,
        _ => return None,
    };
    Some((Operator::Binary(operator), span))
}

fn comparing(found: Lexeme<'_>, span: Span) -> Option<(Operator, Span)> {
    if found.kind == TokenKind::DotDot {
        return Some((Operator::Range, span));
    }
    comparison_of(found.kind).map(|comparison| (Operator::Binary(BinaryOperator::Compare(comparison)), span))
}

/// The comparison a token stands for.
fn comparison_of(kind: TokenKind) -> Option<Comparison> {
    Some(match kind {
        TokenKind::EqualEqual => Comparison::Equal,
        TokenKind::NotEqual => Comparison::NotEqual,
        TokenKind::Less => Comparison::Less,
        TokenKind::AtMost => Comparison::AtMost,
        TokenKind::Greater => Comparison::Greater,
        TokenKind::AtLeast => Comparison::AtLeast,
        _ => return None,
    })
}

/// `<=` and the like.
pub(super) fn comparison<'s>() -> impl Small<'s, Comparison> {
    lexeme(Expected::Comparison, |found, _| comparison_of(found.kind))
}

/// A tree that is being put together: operands and the operators that wait for theirs.
struct Tree<'p> {
    operands: Vec<Node>,
    waiting: Vec<(Operator, Span)>,
    progress: &'p mut Progress,
    /// The tree became too deep, and the rest of the row is let go.
    too_deep: bool,
    /// The row has comparisons or ranges in a chain, and it was said.
    chained: bool,
}

impl Tree<'_> {
    fn of(nots: Vec<Span>, first: Node, links: Vec<Link>, progress: &mut Progress) -> Node {
        if links.is_empty() && nots.is_empty() {
            return first;
        }
        let mut tree =
            Tree { operands: Vec::new(), waiting: Vec::new(), progress, too_deep: false, chained: false };
        tree.operand(nots, first);
        for ((operator, span), nots, operand) in links {
            if tree.too_deep {
                break;
            }
            tree.infix(operator, span);
            tree.operand(nots, operand);
        }
        while !tree.waiting.is_empty() {
            tree.reduce();
        }
        tree.operands.pop().unwrap_or_else(|| Node::error(Span::default()))
    }

    fn operand(&mut self, nots: Vec<Span>, operand: Node) {
        self.waiting.extend(nots.into_iter().map(|span| (Operator::Not, span)));
        self.operands.push(operand);
    }

    fn infix(&mut self, operator: Operator, span: Span) {
        while let Some((waiting, before)) = self.waiting.last().copied() {
            if waiting.precedence() < operator.precedence() {
                break;
            }
            if waiting.precedence() == operator.precedence() && operator.stands_alone() && !self.chained {
                self.chained = true;
                self.progress.said.push(chained(operator, before, span));
            }
            self.reduce();
        }
        self.waiting.push((operator, span));
    }

    /// Gives the last waiting operator its operands.
    fn reduce(&mut self) {
        let (Some((operator, at)), Some(right)) = (self.waiting.pop(), self.operands.pop()) else { return };
        let depth = Depth::default().with(&right);
        let (span, depth, kind) = match operator {
            Operator::Not => {
                (at.to(right.expr.span), depth, ExprKind::Unary(UnaryOperator::Not, right.boxed()))
            }
            Operator::Range | Operator::Binary(_) => {
                let Some(left) = self.operands.pop() else { return };
                let (span, depth) = (left.expr.span.to(right.expr.span), depth.with(&left));
                let kind = match operator {
                    Operator::Binary(operator) => ExprKind::Binary(operator, at, left.boxed(), right.boxed()),
                    _ => ExprKind::Range(Box::new(RangeExpr { from: left.expr, to: right.expr, span })),
                };
                (span, depth, kind)
            }
        };
        let made =
            if self.too_deep { Node::error(span) } else { Node::made(span, kind, depth, self.progress) };
        self.too_deep |= made.is_error();
        self.operands.push(made);
    }
}

fn chained(operator: Operator, before: Span, span: Span) -> Diagnostic {
    let (message, hint) = match operator {
        Operator::Range => ("a range has two ends", "write `a .. b`"),
        _ => ("comparisons cannot be chained", "write `a < b and b < c`"),
    };
    Diagnostic::new(Code::E0201, span, message).also(before, "after this one").hint(hint)
}

/// `- - x`: minus signs before an operand that binds tighter.
pub(super) fn negated<'s>(operand: Rule<'s, Node>) -> Rule<'s, Node> {
    let minus = lexeme(Expected::Value, |found, span| (found.kind == TokenKind::Minus).then_some(span));
    minus
        .repeated()
        .collect::<Vec<_>>()
        .then(operand)
        .map_with(|(signs, operand), e| {
            signs.into_iter().rev().fold((operand, false), |(inner, stop), sign| {
                if stop {
                    return (inner, stop);
                }
                let (span, depth) = (sign.to(inner.expr.span), Depth::default().with(&inner));
                let kind = ExprKind::Unary(UnaryOperator::Negate, inner.boxed());
                let made = Node::made(span, kind, depth, e.state());
                let stop = made.is_error();
                (made, stop)
            })
        })
        .map(|(node, _)| node)
        .boxed()
}
