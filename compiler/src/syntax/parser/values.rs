//! Operands: literals, names, brackets of every kind, conditions, and the calls, fields and indices after them.

use super::expected::{Expected, Miss};
use super::names::{field_name, label, name};
use super::node::{ArgumentNode, Depth, Node, arguments, expressions};
use super::primitive::{Small, lexeme, not_closer, token};
use super::recovery::{Stop, finished};
use super::sequence::{block, elements, opening, parenthesized};
use super::{Extra, Progress, Rule, Tokens};
use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::ast::{Clause, ExprKind, Name, Unit};
use crate::syntax::lexeme::{Lexeme, Role};
use crate::syntax::lexer::text::unescape;
use crate::syntax::limits::MAX_NESTING;
use crate::syntax::token::TokenKind;
use chumsky::input::InputRef;
use chumsky::prelude::*;

/// One operand with its calls, fields and indices. `inner` is a whole expression.
pub(super) fn operand<'s>(inner: Rule<'s, Node>) -> Rule<'s, Node> {
    let fields = block(given_field(inner.clone()), Stop::Entry, failed_argument, Expected::Value);
    let fields = fields.map_with(|fields, e| {
        let depth = depth_of(&fields);
        Node::made(e.span(), ExprKind::Fields(arguments(fields)), depth, e.state())
    });
    let first =
        choice((leaf(), bracketed(inner.clone()), list(inner.clone()), fields, condition(inner.clone())));
    postfix(first.boxed(), inner)
}

/// A literal or a name.
fn leaf<'s>() -> impl Small<'s, Node> {
    lexeme(Expected::Value, |found, span| leaf_kind(found).map(|kind| Node::leaf(span, kind)))
}

fn leaf_kind(found: Lexeme<'_>) -> Option<ExprKind> {
    Some(match found.kind {
        TokenKind::Number(unit) => number(found.text, unit),
        TokenKind::Text => ExprKind::Text(unescape(found.text)),
        TokenKind::True => ExprKind::Bool(true),
        TokenKind::False => ExprKind::Bool(false),
        TokenKind::Itself => ExprKind::Name(found.text.to_owned()),
        TokenKind::Name if found.role == Role::Plain => ExprKind::Name(found.text.to_owned()),
        TokenKind::BadNumber | TokenKind::Error => ExprKind::Error,
        _ => return None,
    })
}

fn number(text: &str, unit: Option<Unit>) -> ExprKind {
    let suffix = unit.map_or("", Unit::suffix);
    let digits = text.strip_suffix(suffix).unwrap_or(text).to_owned();
    ExprKind::Number { digits, unit }
}

/// `(x)`, `(a, b)`
fn bracketed<'s>(inner: Rule<'s, Node>) -> Rule<'s, Node> {
    parenthesized(Expected::Value, argument(inner), failed_argument)
        .map_with(|given, e| {
            let span = e.span();
            if let Some(label) = given.iter().find_map(|argument| argument.name.as_ref()) {
                e.emit(Miss::new(Expected::Value, label.span));
            }
            let mut parts: Vec<Node> = given.into_iter().map(|argument| argument.value).collect();
            let depth = Depth::default().with_all(&parts);
            match parts.len() {
                0 => {
                    let found = Diagnostic::new(Code::E0201, span, "expected a value between the brackets");
                    e.state().said.push(found);
                    Node::error(span)
                }
                1 => {
                    let only = parts.pop().unwrap_or_else(|| Node::error(span));
                    Node::made(span, ExprKind::Group(only.boxed()), depth, e.state())
                }
                _ => Node::made(span, ExprKind::Tuple(expressions(parts)), depth, e.state()),
            }
        })
        .boxed()
}

/// What follows the first element of a list.
enum Rest {
    Elements(Vec<Node>),
    Clauses(Vec<(Clause, Depth)>),
}

/// `[a, b]`, `[f(i) for i in 0..7 if i != 3]`
fn list<'s>(inner: Rule<'s, Node>) -> Rule<'s, Node> {
    let first = not_closer().ignore_then(finished(inner.clone(), Stop::ListElement, Node::error));
    let of = |depth: Depth, node: &Node| depth.with(node);
    let every = token(TokenKind::For)
        .ignore_then(super::names::declared(super::names::Case::Snake))
        .then_ignore(token(TokenKind::In))
        .then(finished(inner.clone(), Stop::Clause, Node::error))
        .map(move |(name, over)| {
            let depth = of(Depth::default(), &over);
            (Clause::For(name, over.expr), depth)
        });
    let only = keyword(TokenKind::If).ignore_then(finished(inner.clone(), Stop::Clause, Node::error)).map(
        move |condition| {
            let depth = of(Depth::default(), &condition);
            (Clause::If(condition.expr), depth)
        },
    );
    let clauses =
        every.clone().then(every.or(only).repeated().collect::<Vec<_>>()).map(|(first, mut rest)| {
            rest.insert(0, first);
            Rest::Clauses(rest)
        });
    let more = token(TokenKind::Comma).ignore_then(elements(inner, Node::error)).map(Rest::Elements);
    let rest = choice((clauses, more)).or_not();
    first
        .then(rest)
        .or_not()
        .delimited_by(opening(TokenKind::OpenBracket, Expected::Value), token(TokenKind::CloseBracket))
        .map_with(|content, e| list_node(content, e.span(), e.state()))
        .recover_with(via_parser(bracket_skipped().map(Node::error)))
        .boxed()
}

/// A whole bracket, passed over.
fn bracket_skipped<'s>() -> impl Parser<'s, Tokens<'s>, Span, Extra<'s>> + Clone {
    opening(TokenKind::OpenBracket, Expected::Value)
        .then(super::recovery::skip(Stop::Item, false))
        .then(token(TokenKind::CloseBracket))
        .map_with(|_, e| e.span())
}

fn list_node(content: Option<(Node, Option<Rest>)>, span: Span, progress: &mut Progress) -> Node {
    let Some((first, rest)) = content else { return Node::leaf(span, ExprKind::List(Vec::new())) };
    let depth = Depth::default().with(&first);
    match rest {
        Some(Rest::Clauses(clauses)) => {
            let depth = clauses.iter().fold(depth, |depth, (_, clause)| depth.and(*clause));
            let clauses = clauses.into_iter().map(|(clause, _)| clause).collect();
            Node::made(span, ExprKind::Comprehension { body: first.boxed(), clauses }, depth, progress)
        }
        rest => {
            let mut all = match rest {
                Some(Rest::Elements(more)) => more,
                _ => Vec::new(),
            };
            all.insert(0, first);
            let depth = Depth::default().with_all(&all);
            Node::made(span, ExprKind::List(expressions(all)), depth, progress)
        }
    }
}

/// `if c then a else b`; how many may be open at once is limited here.
fn condition<'s>(inner: Rule<'s, Node>) -> Rule<'s, Node> {
    let open = custom(|input: &mut InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let before = input.save();
        let start = input.cursor();
        let is_if = input.next().is_some_and(|found| found.kind == TokenKind::If);
        let span = input.span_since(&start);
        let progress = input.state();
        if is_if && progress.depth < MAX_NESTING {
            progress.depth += 1;
            return Ok(());
        }
        input.rewind(before);
        Err(Miss::new(if is_if { Expected::Shallower } else { Expected::Value }, span))
    });
    let close = custom(|input: &mut InputRef<'s, '_, Tokens<'s>, Extra<'s>>| {
        let progress = input.state();
        progress.depth = progress.depth.saturating_sub(1);
        Ok(())
    });
    open.ignore_then(inner.clone())
        .then_ignore(token(TokenKind::Then))
        .then(inner.clone())
        .then_ignore(token(TokenKind::Else))
        .then(inner)
        .then_ignore(close)
        .map_with(|((condition, yes), no), e| {
            let depth = Depth::default().with(&condition).with(&yes).with(&no);
            let kind = ExprKind::If(condition.boxed(), yes.boxed(), no.boxed());
            Node::made(e.span(), kind, depth, e.state())
        })
        .boxed()
}

fn keyword<'s>(kind: TokenKind) -> impl Small<'s, Span> {
    lexeme(Expected::For, move |found, span| (found.kind == kind).then_some(span))
}

/// What may follow an operand.
enum Postfix {
    Call(Vec<ArgumentNode>),
    Index(Vec<Node>),
    Field(Name),
}

fn postfix<'s>(first: Rule<'s, Node>, inner: Rule<'s, Node>) -> Rule<'s, Node> {
    let call = parenthesized(Expected::Operator, argument(inner.clone()), failed_argument).map(Postfix::Call);
    let index = elements(inner, Node::error)
        .delimited_by(opening(TokenKind::OpenBracket, Expected::Operator), token(TokenKind::CloseBracket))
        .map(Postfix::Index);
    let field = opening(TokenKind::Dot, Expected::Operator).ignore_then(name()).map(Postfix::Field);
    let postfix = choice((call, index, field)).map_with(|found, e| (found, e.span()));
    first
        .then(postfix.repeated().collect::<Vec<(Postfix, Span)>>())
        .map_with(|(first, rest), e| {
            let mut node = first;
            for (postfix, span) in rest {
                let whole = node.expr.span.to(span);
                let failed = node.is_error();
                node = attach(node, postfix, whole, e.state());
                if node.is_error() && !failed {
                    break;
                }
            }
            node
        })
        .boxed()
}

fn attach(left: Node, postfix: Postfix, span: Span, progress: &mut Progress) -> Node {
    let depth = Depth::default().with(&left);
    let (kind, depth) = match postfix {
        Postfix::Call(given) => {
            let depth = depth.and(depth_of(&given));
            (ExprKind::Call { callee: left.boxed(), arguments: arguments(given) }, depth)
        }
        Postfix::Index(indices) => {
            let depth = depth.with_all(&indices);
            (ExprKind::Index(left.boxed(), expressions(indices)), depth)
        }
        Postfix::Field(name) => (ExprKind::Field(left.boxed(), name), depth),
    };
    Node::made(span, kind, depth, progress)
}

/// `a`, `b: c`
fn argument<'s>(inner: Rule<'s, Node>) -> Rule<'s, ArgumentNode> {
    label().or_not().then(inner).map(|(name, value)| ArgumentNode { name, value }).boxed()
}

/// `worst: 1`
fn given_field<'s>(inner: Rule<'s, Node>) -> impl Parser<'s, Tokens<'s>, ArgumentNode, Extra<'s>> + Clone {
    let value = finished(inner, Stop::Entry, Node::error);
    let named = field_name().then_ignore(token(TokenKind::Colon)).then(value);
    named.map(|(name, value)| ArgumentNode { name: Some(name), value })
}

fn failed_argument(span: Span) -> ArgumentNode {
    ArgumentNode { name: None, value: Node::error(span) }
}

fn depth_of(given: &[ArgumentNode]) -> Depth {
    Depth::default().with_all(given.iter().map(|argument| &argument.value))
}
