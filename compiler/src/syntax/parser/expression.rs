//! The whole of an expression: operands, operators, placements and levels, each inside the others.

use super::Rule;
use super::level::placed;
use super::node::Node;
use super::operators::{negated, row};
use super::values::operand;
use crate::syntax::ast::Expr;
use chumsky::prelude::*;

/// The rules for expressions that other areas of the grammar build on; made once for a file.
#[derive(Clone)]
pub(super) struct Expressions<'s> {
    /// A whole expression.
    pub(super) whole: Rule<'s, Node>,
    /// An operand: what stands between operators.
    pub(super) operand: Rule<'s, Node>,
}

impl<'s> Expressions<'s> {
    pub(super) fn new() -> Self {
        let mut inside = None;
        let whole = recursive(|inner| {
            // The inner reference is weak: the rules do not keep each other alive for ever.
            let inner: Rule<'s, Node> = inner.boxed();
            let operand = negated(operand(inner.clone()));
            inside = Some(operand.clone());
            placed(row(operand.clone()), operand, inner)
        });
        let operand = inside.unwrap_or_else(|| whole.clone().boxed());
        Expressions { whole: whole.boxed(), operand }
    }

    /// A whole expression that ends at `stop`; an error node where there is none.
    pub(super) fn finished(&self, stop: super::recovery::Stop) -> Rule<'s, Expr> {
        super::recovery::finished(self.whole.clone(), stop, Node::error).map(|node| node.expr).boxed()
    }
}
