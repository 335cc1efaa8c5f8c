//! How well a thing of some type fits a place that would like another.

use ifs_compiler::hir::dimension::Dimension;
use ifs_compiler::hir::index::{Index, Target};
use ifs_compiler::hir::schema::SchemaKind;
use ifs_compiler::hir::tree::Hir;
use ifs_compiler::hir::type_names::PLAIN;
use ifs_compiler::hir::types::Type;

/// How well something fits, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fit {
    Yes,
    Unknown,
    No,
}

impl Fit {
    /// Of a value of type `from` where `to` is wanted.
    pub(super) fn of(index: &Index, from: &Type, to: Option<&Type>) -> Fit {
        let Some(to) = to else { return Fit::Unknown };
        let fits = match (from, to) {
            (Type::Error, _) | (_, Type::Error) => return Fit::Unknown,
            (Type::Record(id), Type::Material) => index.materials.contains(id),
            (Type::Figure, Type::Curve | Type::Surface) => return Fit::Unknown,
            // Put on points, or of the plane or of space, it is one.
            (Type::Ifs, Type::Figure) => return Fit::Yes,
            (Type::Ifs, to) if to.is_figure() => return Fit::Unknown,
            (Type::List(figures), Type::Figure) if figures.is_figure() => return Fit::Yes,
            (Type::Curve | Type::Surface, Type::Figure) => true,
            (Type::WeightedSum(a), Type::Weighted(b) | Type::Point(b) | Type::Vector(b))
            | (Type::Point(a) | Type::Weighted(a), Type::Weighted(b))
            | (Type::Point(a), Type::Point(b))
            | (Type::Vector(a), Type::Vector(b))
            | (Type::Map(a), Type::Map(b)) => a.join(*b).is_some(),
            (Type::Point(_), Type::Vector(_)) | (Type::Vector(_), Type::Point(_)) => return Fit::Unknown,
            (Type::List(a), Type::List(b)) => return Fit::of(index, a, Some(b)),
            // One side of it.
            (from, Type::Size) => *from == Type::LENGTH || *from == Type::Size,
            (a, b) => {
                a == b || a.dimension().is_some_and(|has| *b != Type::Int && b.dimension() == Some(has))
            }
        };
        // A number of another dimension, or a list or a record, may still be a part of what is written.
        let made = to.dimension().is_some()
            || matches!(to, Type::Point(_) | Type::Vector(_) | Type::Bool | Type::Text | Type::List(_));
        let part = from.dimension().is_some() && (to.dimension().is_some() || *to == Type::Bool)
            || made && matches!(from, Type::List(_) | Type::Record(_));
        match (fits, part) {
            (true, _) => Fit::Yes,
            (false, true) => Fit::Unknown,
            (false, false) => Fit::No,
        }
    }

    /// Of what a function of the program gives, as its signature says it.
    pub(super) fn of_words(index: &Index, gives: &str, to: Option<&Type>) -> Fit {
        let Some(expected) = to else { return Fit::Unknown };
        let ty = match gives {
            "Quantity" if expected.dimension().is_some() => return Fit::Yes,
            // One side of a comparison.
            "Quantity" if *expected == Type::Bool => return Fit::Unknown,
            "Quantity" => return Fit::No,
            "germ" => Type::Germ,
            "control point" => {
                let fits = matches!(expected, Type::Weighted(_));
                return if fits { Fit::Yes } else { Fit::No };
            }
            list if list.contains("list") => Type::List(Box::new(Type::Error)),
            word => match (Dimension::named(word), PLAIN.iter().find(|(name, _)| *name == word)) {
                (Some(dimension), _) => Type::Quantity(dimension),
                (None, Some((_, ty))) => ty.clone(),
                (None, None) => return Fit::Unknown,
            },
        };
        Fit::of(index, &ty, to)
    }
}

/// Whether a block of a kind can be made of a material: panels take their thickness from it.
pub(super) fn serves(index: &Index, hir: &Hir, material: &Type, kind: Option<SchemaKind>) -> bool {
    let Type::Record(id) = material else { return true };
    let fields = index.parameters(Target::Declared(hir.item(*id).name_span)).unwrap_or_default();
    kind != Some(SchemaKind::Panels) || fields.iter().any(|field| field.name == "thickness")
}
