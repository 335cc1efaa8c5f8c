//! What can stand after a full stop: fields of records, coordinates, and what is made of a figure.

use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::tree::Made;
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::{PointSpace, Type};
use ifs_compiler::syntax::TokenKind;

use super::{Kind, Known, Offer, joins};

/// The parts of what stands before the full stop.
pub(super) fn parts(known: &Known<'_>) -> Vec<Offer> {
    if joins::is_join(known) {
        return joins::parts(known);
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
