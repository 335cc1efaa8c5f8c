//! Where a name is declared, and where the type of an expression is.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::{FileId, Span};

/// What stands at a place, and the place where it is declared; the start of a file for a module.
pub(crate) fn definition(analysis: &Analysis, file: FileId, offset: u32) -> Option<(Span, Span)> {
    let name = analysis.index.name_at(file, offset)?;
    let declared = match name.target {
        Target::Declared(span) => span,
        Target::Module(file) => Span::new(file, 0, 0),
        _ => return None,
    };
    Some((name.span, declared))
}

/// The record that the expression or the declared thing at a place is one of, or a list of.
pub(crate) fn type_definition(analysis: &Analysis, file: FileId, offset: u32) -> Option<(Span, Span)> {
    let name = analysis.index.name_at(file, offset);
    let declared = name.and_then(|name| match name.target {
        Target::Declared(span) => Some((name.span, &analysis.index.declaration(span)?.ty)),
        _ => None,
    });
    let (span, ty) = declared.or_else(|| analysis.index.type_at(file, offset))?;
    let mut ty = ty;
    while let Type::List(element) = ty {
        ty = element;
    }
    let Type::Record(id) = ty else { return None };
    Some((span, analysis.hir.item(*id).name_span))
}
