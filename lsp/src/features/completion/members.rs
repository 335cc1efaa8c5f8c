//! What can stand after a full stop: fields of records, coordinates, and what is made of a figure.

use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::tree::Made;
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::{PointSpace, Type};
use ifs_compiler::syntax::TokenKind;

use super::{Kind, Known, Offer};

/// The parts of what stands before the full stop.
pub(super) fn parts(known: &Known<'_>) -> Vec<Offer> {
    if joins(known) {
        return boundaries(known);
    }
    // The dot is the last token before the name; what it is of ends there.
    let Some(end) = known.before.tokens.iter().rev().nth(1).map(|token| token.span.end) else {
        return Vec::new();
    };
    let of = known.index().types.iter().filter(|(span, _)| span.file == known.name.file && span.end == end);
    let Some((_, ty)) = of.min_by_key(|(span, _)| span.start) else { return Vec::new() };
    let each = matches!(ty, Type::List(_));
    let one = if let Type::List(element) = ty { element } else { ty };
    match one {
        Type::Record(id) => {
            let name = known.hir().item(*id).name_span;
            let fields = known.index().parameters(Target::Declared(name)).unwrap_or_default().iter();
            let fields = fields.enumerate().map(|(place, field)| {
                let ty = type_name(&known.hir().items, &field.ty);
                let ty = if each { format!("[{ty}]") } else { ty };
                Offer::new(&field.name, Kind::Field).detail(ty).rank(place as u8)
            });
            fields.collect()
        }
        one if one.is_figure() && known.before.item() == Some(TokenKind::Test) => {
            let made = Made::ALL.into_iter();
            made.map(|(word, _, doc)| Offer::new(word, Kind::Field).docs(doc)).collect()
        }
        Type::Point(space) | Type::Vector(space) if !each && *space != PointSpace::Control => {
            let axes: &[&str] = if *space == PointSpace::Plane { &["x", "y"] } else { &["x", "y", "z"] };
            axes.iter().map(|axis| Offer::new(axis, Kind::Field).detail("Length")).collect()
        }
        _ => Vec::new(),
    }
}

/// Whether the word stands in a `join`.
fn joins(known: &Known<'_>) -> bool {
    let tokens = &known.before.tokens;
    let word = |at: usize| known.before.written(at);
    let start = (0..tokens.len())
        .rev()
        .take(8)
        .find(|at| matches!(word(*at), "join" | "transform" | "boundary" | "germ" | "keep" | "let" | "{"));
    start.is_some_and(|at| word(at) == "join")
}

/// The boundaries that a transform of a join has: those of the ifs it continues with, most often this one.
fn boundaries(known: &Known<'_>) -> Vec<Offer> {
    use ifs_compiler::hir::index::DeclarationKind;
    let around = known.before.tokens.iter().position(|token| token.kind == TokenKind::Ifs);
    let Some(name) = around.and_then(|at| known.before.tokens.get(at + 1)) else { return Vec::new() };
    let id = match known.analysis.index.declaration(name.span).map(|declared| declared.kind) {
        Some(DeclarationKind::Item(id)) => Some(id),
        _ => None,
    };
    let mut names: Vec<String> = known
        .index()
        .declarations
        .iter()
        .filter(|declared| matches!(declared.kind, DeclarationKind::Boundary(of) if Some(of) == id))
        .map(|declared| declared.name.clone())
        .collect();
    if names.is_empty() {
        names = ["start", "end"].map(str::to_owned).to_vec();
    }
    names.iter().map(|name| Offer::new(name, Kind::Field).detail("boundary")).collect()
}
