//! What a figure can be fabricated as, as far as its text says: segments are planks, faces are panels. Whether it is.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::native::Native;
use ifs_compiler::hir::schema::SchemaKind;
use ifs_compiler::hir::tree::{Expr, ExprKind, Hir, ItemId, ItemKind};
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast;

/// Whether a block of the file makes boards of the figure of that name; the one that names it at `but` does not count.
pub(super) fn is_made(analysis: &Analysis, name: &str, but: Span) -> bool {
    let files = analysis.files.iter().filter(|file| file.file == but.file);
    files.flat_map(|file| &file.parse.ast.items).any(|item| match &item.kind {
        ast::ItemKind::Fabricate(block) => block.figure.text == name && block.figure.span != but,
        _ => false,
    })
}

/// How many items are followed from one to the next.
const MOST_ITEMS: usize = 16;

/// Whether it is declared as a figure: of no other value boards can be made.
pub(super) fn is_figure(hir: &Hir, named: Target) -> bool {
    let Target::Declared(span) = named else { return false };
    hir.items.iter().any(|item| item.name_span == span && matches!(item.kind, ItemKind::Figure(_)))
}

/// What a figure can be fabricated as; `None` where that is not known, or where it is no figure.
pub(super) fn of_figure(hir: &Hir, figure: Target) -> Option<SchemaKind> {
    let Target::Declared(span) = figure else { return None };
    let item = hir.items.iter().find(|item| item.name_span == span)?;
    match &item.kind {
        ItemKind::Figure(body) => of_value(hir, &body.value, MOST_ITEMS),
        _ => None,
    }
}

fn of_type(ty: &Type) -> Option<SchemaKind> {
    match ty {
        Type::Curve => Some(SchemaKind::Planks),
        Type::Surface => Some(SchemaKind::Panels),
        Type::List(element) => of_type(element),
        _ => None,
    }
}

fn of_value(hir: &Hir, value: &Expr, items: usize) -> Option<SchemaKind> {
    of_type(&value.ty).or_else(|| match &value.kind {
        ExprKind::On(inner, ..)
        | ExprKind::At(inner, ..)
        | ExprKind::Until(inner, _)
        | ExprKind::Convert(inner)
        | ExprKind::Index(inner, _)
        | ExprKind::Slice(inner, _)
        | ExprKind::Comprehension(inner, _)
        | ExprKind::If(_, inner, _)
        | ExprKind::Arithmetic(_, _, _, inner) => of_value(hir, inner, items),
        ExprKind::List(elements) => of_value(hir, elements.first()?, items),
        ExprKind::Global(id) | ExprKind::Call(id, _) | ExprKind::Ifs(id, _) => {
            of_item(hir, *id, items.checked_sub(1)?)
        }
        ExprKind::Native(Native::Sheet | Native::Tensor, _) => Some(SchemaKind::Panels),
        _ => None,
    })
}

fn of_item(hir: &Hir, id: ItemId, items: usize) -> Option<SchemaKind> {
    match &hir.item(id).kind {
        ItemKind::Let(body) | ItemKind::Figure(body) => of_value(hir, &body.value, items),
        ItemKind::Function(function) => of_value(hir, &function.body.value, items),
        ItemKind::Ifs(ifs) => match &ifs.germ.as_ref()?.kind {
            ExprKind::Native(Native::Segment, _) | ExprKind::OwnGerm(_) => Some(SchemaKind::Planks),
            ExprKind::Native(Native::Quad | Native::Polygon, _) => Some(SchemaKind::Panels),
            _ => None,
        },
        _ => None,
    }
}
