//! The expression of the tree that stands at a place.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{Expr, ExprKind, ItemKind, Level, MemberKind, Placement};

/// The outermost expression with exactly this span.
pub(super) fn expression_at(analysis: &Analysis, span: Span) -> Option<&Expr> {
    let file = analysis.files.iter().find(|file| file.file == span.file)?;
    let around = |other: Span| other.start <= span.start && span.end <= other.end;
    let item = file.parse.ast.items.iter().find(|item| around(item.span))?;
    let roots: Vec<&Expr> = match &item.kind {
        ItemKind::Let(body) => vec![&body.value],
        ItemKind::Param(param) => vec![&param.default],
        ItemKind::Figure(figure) => vec![&figure.value],
        ItemKind::Function(function) => vec![&function.body],
        ItemKind::Ifs(ifs) => {
            let values = ifs.members.iter().flat_map(|member| match &member.kind {
                MemberKind::Let(body) => vec![&body.value],
                MemberKind::Transform(transform) => vec![&transform.value],
                MemberKind::Germ(germ) => vec![germ],
                MemberKind::Boundary(_, on) => vec![on],
                _ => Vec::new(),
            });
            values.collect()
        }
        _ => Vec::new(),
    };
    roots.into_iter().find_map(|root| inside(root, span))
}

fn inside(expr: &Expr, span: Span) -> Option<&Expr> {
    if expr.span == span {
        return Some(expr);
    }
    if span.start < expr.span.start || expr.span.end < span.end {
        return None;
    }
    parts(expr).into_iter().find_map(|part| inside(part, span))
}

/// What an expression is made of.
fn parts(expr: &Expr) -> Vec<&Expr> {
    match &expr.kind {
        ExprKind::Group(inner) | ExprKind::Unary(_, inner) | ExprKind::Field(inner, _) => vec![inner],
        ExprKind::Tuple(parts) | ExprKind::List(parts) => parts.iter().collect(),
        ExprKind::Comprehension { body, .. } => vec![body],
        ExprKind::Fields(arguments) => arguments.iter().map(|argument| &argument.value).collect(),
        ExprKind::Call { callee, arguments } => {
            std::iter::once(&**callee).chain(arguments.iter().map(|argument| &argument.value)).collect()
        }
        ExprKind::Index(list, places) => std::iter::once(&**list).chain(places).collect(),
        ExprKind::Binary(_, _, left, right) => vec![left, right],
        ExprKind::Range(range) => vec![&range.from, &range.to],
        ExprKind::If(condition, then, other) => vec![condition, then, other],
        ExprKind::On(ifs, Placement::Points(points, _)) => std::iter::once(&**ifs).chain(points).collect(),
        ExprKind::On(ifs, Placement::Value(points)) => vec![ifs, points],
        ExprKind::At(figure, Level::Uniform(level)) => vec![figure, level],
        ExprKind::At(figure, _) => vec![figure],
        _ => Vec::new(),
    }
}
