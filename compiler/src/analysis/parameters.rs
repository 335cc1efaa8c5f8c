//! The parameters of a design as a list: what each takes, its range and step, its default and its present value.

use super::Analysis;
use crate::diagnostic::Diagnostic;
use crate::hir::evaluate::{Evaluator, Overrides, words};
use crate::hir::tree::{Body, ItemKind, Param};
use crate::hir::types::Type;
use crate::hir::value::Value;

/// A value of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterWords {
    /// As the language writes it: `6000mm`, `true`, `"north"`.
    pub text: String,
    /// The number in the parameter's unit, where it is one.
    pub number: Option<f64>,
}

/// A parameter of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterInfo {
    /// Its name.
    pub name: String,
    /// Its type as the language writes it: `Length`, `Int`.
    pub ty: String,
    /// The unit its values are shown in; empty for plain numbers, truths and texts.
    pub unit: &'static str,
    /// Its default.
    pub default: ParameterWords,
    /// Its present value.
    pub value: ParameterWords,
    /// The closed range, where it has one.
    pub range: Option<(ParameterWords, ParameterWords)>,
    /// The step, where it has one.
    pub step: Option<ParameterWords>,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
}

/// The parameters of a design without errors in the order of its text, and what is wrong with their values. Nothing else
/// of the design is worked out.
pub fn parameter_infos(analysis: &Analysis, overrides: &Overrides) -> (Vec<ParameterInfo>, Vec<Diagnostic>) {
    let mut evaluator = Evaluator::new(&analysis.hir, overrides);
    let mut infos = Vec::new();
    for (id, item) in analysis.hir.own_items() {
        let ItemKind::Param(param) = &item.kind else { continue };
        let Ok(value) = evaluator.global(id) else { continue };
        let mut of = |body: &Body| Some(described(&evaluator.body(body).ok()?, &param.ty));
        let Some(default) = of(&param.default) else { continue };
        let range = param.range.as_ref().and_then(|(from, to)| Some((of(from)?, of(to)?)));
        let step = param.step.as_ref().and_then(&mut of);
        infos.push(ParameterInfo {
            name: item.name.clone(),
            ty: type_name(param),
            unit: param.ty.dimension().map_or("", |dimension| dimension.display_unit().0),
            default,
            value: described(&value, &param.ty),
            range,
            step,
            docs: item.docs.clone(),
        });
    }
    (infos, evaluator.finish())
}

fn type_name(param: &Param) -> String {
    match &param.ty {
        Type::Int => "Int".to_owned(),
        Type::Bool => "Bool".to_owned(),
        Type::Text => "Text".to_owned(),
        other => other.dimension().map_or_else(String::new, |dimension| dimension.name()),
    }
}

fn described(value: &Value, ty: &Type) -> ParameterWords {
    match value {
        Value::Scalar(scalar) => {
            let worth = ty.dimension().map_or(1.0, |dimension| dimension.display_unit().1);
            let number = scalar.to_f64().map(|number| number / worth);
            ParameterWords { text: words(scalar, ty), number }
        }
        Value::Bool(truth) => ParameterWords { text: truth.to_string(), number: None },
        Value::Text(text) => ParameterWords { text: format!("\"{text}\""), number: None },
        _ => ParameterWords { text: String::new(), number: None },
    }
}
