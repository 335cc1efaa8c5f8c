//! Values in words, for messages and for editors.

use super::expression::quantity_words;
use crate::hir::dimension::Dimension;
use crate::hir::scalar::Scalar;
use crate::hir::types::Type;
use crate::hir::value::{Terms, Value};

/// How many elements of a list are shown.
const SHOWN: usize = 4;

/// A value in words; `None` for one that numbers, texts and words do not tell: an ifs, a figure, a record.
pub fn value_words(value: &Value, ty: &Type) -> Option<String> {
    is_told(value).then(|| words(value, ty, false))
}

fn is_told(value: &Value) -> bool {
    match value {
        Value::Scalar(_) | Value::Bool(_) | Value::Text(_) | Value::Size(..) | Value::Choice(..) => true,
        Value::Combination(sum) => matches!(sum.terms, Terms::Coordinates(_)),
        Value::List(list) => list.iter().take(SHOWN).all(is_told),
        _ => false,
    }
}

/// A value in words; `exact` with all digits.
pub(super) fn words(value: &Value, ty: &Type, exact: bool) -> String {
    let number = |scalar: &Scalar, dimension: Dimension| match scalar.to_f64() {
        Some(value) if exact => {
            let (unit, worth) = dimension.display_unit();
            format!("{}{unit}", value / worth)
        }
        Some(value) => quantity_words(value, dimension),
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
