//! Expressions as they are built: each knows its depth, so that no tree grows deeper than later walks can bear.

use super::Progress;
use crate::diagnostic::{Code, Diagnostic};
use crate::source::Span;
use crate::syntax::ast::{Argument, Expr, ExprKind, Name};
use crate::syntax::limits::MAX_DEPTH;

/// An expression and the depth of its tree.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) expr: Expr,
    depth: u32,
}

/// An argument and the depth of its value.
#[derive(Clone, Debug)]
pub(super) struct ArgumentNode {
    pub(super) name: Option<Name>,
    pub(super) value: Node,
}

/// The deepest of what goes into a new expression.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Depth(u32);

impl Depth {
    /// With one more part.
    pub(super) fn with(self, node: &Node) -> Depth {
        Depth(self.0.max(node.depth))
    }

    /// With several more parts.
    pub(super) fn with_all<'n>(self, nodes: impl IntoIterator<Item = &'n Node>) -> Depth {
        nodes.into_iter().fold(self, Depth::with)
    }

    /// With the parts of another.
    pub(super) fn and(self, other: Depth) -> Depth {
        Depth(self.0.max(other.0))
    }
}

impl Node {
    /// An expression without parts.
    pub(super) fn leaf(span: Span, kind: ExprKind) -> Node {
        Node { expr: Expr { span, kind }, depth: 1 }
    }

    /// What could not be understood.
    pub(super) fn error(span: Span) -> Node {
        Node::leaf(span, ExprKind::Error)
    }

    /// An expression made of parts; an error where it would be too deep.
    pub(super) fn made(span: Span, kind: ExprKind, parts: Depth, progress: &mut Progress) -> Node {
        if parts.0 >= MAX_DEPTH {
            if progress.said.iter().all(|said| said.code != Code::E0107) {
                progress.said.push(too_deep(span));
            }
            return Node::error(span);
        }
        Node { expr: Expr { span, kind }, depth: parts.0 + 1 }
    }

    /// The same without its depth, on the heap.
    pub(super) fn boxed(self) -> Box<Expr> {
        Box::new(self.expr)
    }

    /// Whether it could not be understood.
    pub(super) fn is_error(&self) -> bool {
        self.expr.kind == ExprKind::Error
    }
}

fn too_deep(span: Span) -> Diagnostic {
    Diagnostic::new(Code::E0107, span, format!("this expression is nested more than {MAX_DEPTH} deep"))
        .note("every operator of a chain counts, and every bracket")
        .hint("give a part of it a name with `let`")
}

/// The expressions of nodes.
pub(super) fn expressions(nodes: Vec<Node>) -> Vec<Expr> {
    nodes.into_iter().map(|node| node.expr).collect()
}

/// The arguments of nodes.
pub(super) fn arguments(nodes: Vec<ArgumentNode>) -> Vec<Argument> {
    nodes.into_iter().map(|node| Argument { name: node.name, value: node.value.expr }).collect()
}
