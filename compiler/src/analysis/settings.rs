//! The settings of a fabricate block as the workshop's types: materials and machines. Planarizing is in `planarizing`.

use crate::fabricate::material::{LeastBendRadius, Material};
use crate::hir::tree::{Hir, ItemKind};
use crate::hir::value::Value;
use crate::source::Span;

/// A setting worked out: its name, its value, where the value stands.
pub(super) type SettingValue = (&'static str, Value, Span);

/// A field of a record by its name.
pub(crate) fn field<'v>(hir: &Hir, record: &'v Value, name: &str) -> Option<&'v Value> {
    let Value::Record(id, values) = record else { return None };
    let ItemKind::Record(fields) = &hir.item(*id).kind else { return None };
    let index = fields.iter().position(|field| field.name == name)?;
    values.get(index)
}

/// A number of a record by the name of its field, in inner units.
pub(crate) fn number(hir: &Hir, record: &Value, name: &str) -> Option<f64> {
    field(hir, record, name)?.number()
}

/// A text of a record by the name of its field.
pub(crate) fn text(hir: &Hir, record: &Value, name: &str) -> Option<String> {
    match field(hir, record, name)? {
        Value::Text(text) => Some(text.to_string()),
        _ => None,
    }
}

/// The two radii of a record such as `Radius`.
pub(super) fn radius(hir: &Hir, value: &Value) -> Option<LeastBendRadius> {
    Some(LeastBendRadius { across: number(hir, value, "across")?, along: number(hir, value, "along")? })
}

/// What a board is made of; a record without a name goes by the name of its type.
pub(super) fn material(hir: &Hir, value: &Value) -> Material {
    let type_name = match value {
        Value::Record(id, _) => hir.item(*id).name.to_lowercase(),
        _ => String::new(),
    };
    Material {
        name: text(hir, value, "name").unwrap_or(type_name),
        thickness: number(hir, value, "thickness"),
        density: number(hir, value, "density"),
        least_bend_radius: field(hir, value, "min_bend_radius").and_then(|value| radius(hir, value)),
    }
}

/// Length by width, mm.
pub(super) fn size(value: &Value) -> Option<(f64, f64)> {
    match value {
        Value::Size(length, width) => Some((length.to_f64()?, width.to_f64()?)),
        _ => None,
    }
}

/// The place of a chosen word.
pub(super) fn choice(value: Option<&SettingValue>) -> Option<usize> {
    match value {
        Some((_, Value::Choice(_, place), _)) => Some(*place),
        _ => None,
    }
}
