//! Types by name: how they are written in a design, or would be.

use super::dimension::Dimension;
use super::schema::ChoiceKind;
use super::tree::Item;
use super::types::{PointSpace, Type};

/// Types with a name of their own, beside dimensions and records.
pub const PLAIN: &[(&str, Type)] = &[
    ("Int", Type::Int),
    ("Bool", Type::Bool),
    ("Text", Type::Text),
    ("Point", Type::Point(PointSpace::Any)),
    ("Vector", Type::Vector(PointSpace::Any)),
    ("Map", Type::Map(PointSpace::Any)),
    ("Plane", Type::Plane),
    ("Cut", Type::Cut),
    ("Ifs", Type::Ifs),
    ("Germ", Type::Germ),
    ("Curve", Type::Curve),
    ("Surface", Type::Surface),
    ("Figure", Type::Figure),
    ("Dialect", Type::Choice(ChoiceKind::Dialect)),
    ("CutDirection", Type::Choice(ChoiceKind::CutDirection)),
    ("ZZero", Type::Choice(ChoiceKind::ZZero)),
];

/// The name of a type as it is written, or would be; `items` are those of the design, whose records have names.
pub fn type_name(items: &[Item], ty: &Type) -> String {
    match ty {
        Type::Quantity(dimension) => dimension.name(),
        Type::Point(_) => "Point".to_owned(),
        Type::Vector(_) => "Vector".to_owned(),
        Type::Map(_) => "Map".to_owned(),
        Type::WeightedSum(_) => "weighted sum of points".to_owned(),
        Type::Weighted(_) => "weighted point".to_owned(),
        Type::List(element) => format!("[{}]", type_name(items, element)),
        Type::IntRange => "range of whole numbers".to_owned(),
        Type::Size => "size (length by length)".to_owned(),
        Type::Germ => "germ".to_owned(),
        Type::Record(id) => items.get(id.0 as usize).map_or_else(String::new, |item| item.name.clone()),
        Type::Choice(kind) => {
            let words: Vec<String> = kind.words().iter().map(|word| format!("`{}`", word.name)).collect();
            words.join(" or ")
        }
        Type::Settings(kind) => format!("settings of {}", kind.name()),
        Type::Material => "material".to_owned(),
        Type::Error => "unknown".to_owned(),
        Type::Int
        | Type::Bool
        | Type::Text
        | Type::Ifs
        | Type::Curve
        | Type::Surface
        | Type::Figure
        | Type::Plane
        | Type::Cut => {
            let plain = PLAIN.iter().find(|(_, plain)| plain == ty);
            plain.map_or("", |(name, _)| *name).to_owned()
        }
    }
}

/// The names of all types that are written: dimensions, and those with a name of their own. Records have theirs.
pub fn type_names() -> impl Iterator<Item = &'static str> {
    Dimension::names().chain(PLAIN.iter().map(|(name, _)| *name))
}
