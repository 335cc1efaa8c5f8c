//! Values in words, for messages and for editors.

use super::expression::{quantity_words, quantity_words_to};
use crate::hir::dimension::Dimension;
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Item, ItemId, ItemKind};
use crate::hir::types::Type;
use crate::hir::value::{Terms, Value};

/// How many elements of a list are shown.
const SHOWN: usize = 4;

/// How many fields of a record are shown.
const SHOWN_FIELDS: usize = 8;

/// How many zeros a small number may begin with; smaller ones are shown as nothing.
const MOST_ZEROS: usize = 12;

/// A value in words; `None` for one that numbers, texts and words do not tell: an ifs, a figure, a record with one in it.
/// `items` are those of the design, whose records have names.
pub fn value_words(items: &[Item], value: &Value, ty: &Type) -> Option<String> {
    match value {
        Value::Record(id, values) => record_words(items, *id, values),
        _ => is_told(value).then(|| words(value, ty, false)),
    }
}

/// `Bracket(thickness: 5mm, holes: 4)`
fn record_words(items: &[Item], id: ItemId, values: &[Value]) -> Option<String> {
    let item = items.get(id.0 as usize)?;
    let ItemKind::Record(fields) = &item.kind else { return None };
    let told = fields
        .iter()
        .zip(values)
        .take(SHOWN_FIELDS)
        .map(|(field, value)| Some(format!("{}: {}", field.name, value_words(items, value, &field.ty)?)));
    let mut told = told.collect::<Option<Vec<_>>>()?;
    if values.len() > SHOWN_FIELDS {
        told.push(format!("… {} fields in all", values.len()));
    }
    Some(format!("{}({})", item.name, told.join(", ")))
}

fn is_told(value: &Value) -> bool {
    match value {
        Value::Scalar(_) | Value::Bool(_) | Value::Text(_) | Value::Size(..) | Value::Choice(..) => true,
        Value::Combination(sum) => matches!(sum.terms, Terms::Coordinates(_)),
        Value::List(list) => list.iter().take(SHOWN).all(is_told),
        _ => false,
    }
}

/// A quantity in words; a small one with its first three digits, where rounding would make nothing of it.
fn not_nothing(value: f64, dimension: Dimension) -> String {
    let shown = libm::fabs(value / dimension.display_unit().1);
    if shown == 0.0 || shown >= 0.01 {
        return quantity_words(value, dimension);
    }
    let zeros = libm::floor(-libm::log10(shown)) as usize;
    quantity_words_to(value, dimension, zeros.min(MOST_ZEROS) + 3)
}

/// A value in words; `exact` with all digits.
pub(super) fn words(value: &Value, ty: &Type, exact: bool) -> String {
    let number = |scalar: &Scalar, dimension: Dimension| match scalar.to_f64() {
        Some(value) if exact => {
            let (unit, worth) = dimension.display_unit();
            format!("{}{unit}", value / worth)
        }
        Some(value) => not_nothing(value, dimension),
        None => "an unknown number".to_owned(),
    };
    match value {
        Value::Scalar(scalar) => number(scalar, ty.dimension().unwrap_or(Dimension::NUMBER)),
        Value::Bool(truth) => truth.to_string(),
        Value::Text(text) => format!("\"{text}\""),
        Value::List(list) => {
            let element = match ty {
                Type::List(element) => element,
                other => other,
            };
            let mut shown: Vec<String> =
                list.iter().take(SHOWN).map(|value| words(value, element, exact)).collect();
            if list.len() > SHOWN {
                shown.push(format!("… {} in all", list.len()));
            }
            format!("[{}]", shown.join(", "))
        }
        Value::Combination(sum) => match &sum.terms {
            Terms::Coordinates(coordinates) => {
                let parts: Vec<String> =
                    coordinates.iter().map(|part| number(part, Dimension::LENGTH)).collect();
                format!("({})", parts.join(", "))
            }
            Terms::Weights(_) => "a combination of control points".to_owned(),
        },
        Value::Record(..) => "a record with other fields".to_owned(),
        Value::Size(length, width) => {
            format!("{} by {}", number(length, Dimension::LENGTH), number(width, Dimension::LENGTH))
        }
        Value::Choice(kind, place) => kind.words().get(*place).map_or("a word", |word| word.name).to_owned(),
        _ => "this".to_owned(),
    }
}
