//! The expression of the tree that stands at a place.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::Expr;

use crate::features::walk::expressions;

/// The outermost expression with exactly this span.
pub(in crate::features) fn expression_at(analysis: &Analysis, span: Span) -> Option<&Expr> {
    let file = analysis.files.iter().find(|file| file.file == span.file)?;
    let mut found = None;
    expressions(&file.parse.ast, |expr| {
        if expr.span == span && found.is_none() {
            found = Some(expr);
        }
    });
    found
}
