//! The settings of a fabricate block as the workshop's types: materials, machines, planarizing.

use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::material::{LeastBendRadius, Material};
use crate::hir::tree::{Hir, ItemKind};
use crate::hir::value::Value;
use crate::planarize::{Perturbation, Pin};
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

/// The parameters of the perturbation method; `goal` is the block's `require planarity`.
pub(super) fn perturbation(
    settings: &Value,
    span: Span,
    goal: Option<f64>,
) -> Result<Perturbation, Diagnostic> {
    let Value::Settings(settings) = settings else {
        return Perturbation::try_new(Perturbation::default())
            .map_err(|error| wrong(span, &error.to_string()));
    };
    let find = |name: &str| settings.iter().find(|(known, _, _)| *known == name);
    let number =
        |name: &str, default: f64| find(name).and_then(|(_, value, _)| value.number()).unwrap_or(default);
    let default = Perturbation::default();
    let pin = match choice(find("pin")) {
        Some(1) => Pin::None,
        Some(2) => Pin::Corners,
        Some(_) => Pin::Boundary,
        None => default.pin,
    };
    // An error names its parameter in backticks; it stands at that one where it was given.
    let refused = |why: &str| {
        let named =
            why.split('`').nth(1).and_then(|name| find(if name == "move_length" { "move" } else { name }));
        wrong(named.map_or(span, |(_, _, place)| *place), why)
    };
    let iterations = number("iterations", f64::from(default.iterations));
    if iterations < 0.0 {
        return Err(refused(&format!("`iterations` is a number of steps, 0 or more, but is {iterations}")));
    }
    let iterations = iterations.min(f64::from(u32::MAX)) as u32;
    let given = Perturbation {
        worst: number("worst", default.worst),
        average: number("average", default.average),
        select: number("select", default.select),
        threshold: number("threshold", goal.unwrap_or(default.threshold)),
        step: number("step", default.step),
        move_length: number("move", default.move_length),
        iterations,
        pin,
    };
    Perturbation::try_new(given).map_err(|error| refused(&error.to_string()))
}

fn wrong(span: Span, why: &str) -> Diagnostic {
    let message = format!("planarizing cannot work with these settings: {why}");
    Diagnostic::new(Code::E0804, span, message).label("cannot be used")
}
