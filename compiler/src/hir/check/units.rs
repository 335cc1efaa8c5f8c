//! What is offered where something is not given: each unit of a dimension to a number without one, which keeps its value,
//! and a value to begin with for a field that is missing.

use crate::diagnostic::Fix;
use crate::hir::dimension::{Dimension, unit_worth};
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;
use crate::syntax::ast::Unit;

/// Units of lengths that are offered; the others are for what was measured in them.
const OF_LENGTHS: [Unit; 3] = [Unit::Millimetre, Unit::Centimetre, Unit::Metre];

/// Each unit of the dimension glued to the number at `span`; none where the dimension has no unit.
pub(super) fn with_unit(span: Span, dimension: Dimension) -> Vec<Fix> {
    let units: Vec<Unit> = match dimension {
        Dimension::LENGTH => OF_LENGTHS.to_vec(),
        _ => Unit::ALL.iter().copied().filter(|unit| unit_worth(*unit).0 == dimension).collect(),
    };
    units.into_iter().map(|unit| Fix::replacing(span.after(), unit.suffix())).collect()
}

/// A value of a type to begin with, as written; none where nothing simple is one.
pub fn placeholder(ty: &Type) -> Option<String> {
    Some(match ty {
        Type::Int => "1".to_owned(),
        Type::Quantity(dimension) if *dimension == Dimension::NUMBER => "1".to_owned(),
        Type::Quantity(dimension) if *dimension == Dimension::LENGTH => "1m".to_owned(),
        Type::Quantity(dimension) if *dimension == Dimension::ANGLE => "30deg".to_owned(),
        Type::Quantity(dimension) => match dimension.display_unit().0 {
            "" => return None,
            unit => format!("1{unit}"),
        },
        Type::Bool => "true".to_owned(),
        Type::Text => "\"\"".to_owned(),
        Type::Point(PointSpace::Plane) => "(0m, 0m)".to_owned(),
        Type::Point(PointSpace::Space | PointSpace::Any) => "(0m, 0m, 0m)".to_owned(),
        Type::Vector(PointSpace::Space | PointSpace::Any) => "(0m, 0m, 1m)".to_owned(),
        Type::Vector(PointSpace::Plane) => "(0m, 1m)".to_owned(),
        Type::Size => "2500mm by 1250mm".to_owned(),
        Type::Choice(kind) => kind.words().first()?.name.to_owned(),
        Type::Settings(_) => "{}".to_owned(),
        _ => return None,
    })
}
