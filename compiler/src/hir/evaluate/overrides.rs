//! Parameters set from outside, their ranges, and levels shifted while a remedy is looked for.

use super::{Evaluator, Limits, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::exact::Rational;
use crate::hir::dimension::{Worth, unit_worth};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{ItemId, Param, is_literal};
use crate::hir::types::Type;
use crate::hir::value::Value;
use crate::syntax::ast::Unit;
use std::collections::BTreeMap;

/// What is set from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Parameters by name, as written: `7m`, `0.46`, `true`.
    pub parameters: BTreeMap<String, String>,
    /// Values for parameters that a design may have or not, as written, each with the words for where it comes from.
    /// `parameters` win.
    pub defaults: BTreeMap<String, (String, String)>,
    /// The machine that takes the place of those the fabricate blocks name.
    pub machine: Option<MachineName>,
    /// Parameters by name, worked out already; these win. For looking for remedies.
    pub values: BTreeMap<String, Scalar>,
    /// A figure whose levels are read higher or lower by so much.
    pub level_shift: Option<(String, i32)>,
    /// How surfaces are planarized. For looking for remedies.
    pub planarizing: Planarizing,
    /// What the design may ask for.
    pub limits: Limits,
}

/// How surfaces are planarized.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Planarizing {
    /// As their blocks ask.
    #[default]
    AsAsked,
    /// Not at all.
    Never,
    /// One figure with a setting of `planarize` beside those that its block names, or with none; others as they ask.
    With {
        /// The name of the figure.
        figure: String,
        /// The name of the setting and its value.
        setting: Option<(&'static str, Value)>,
    },
}

/// A machine that is named from outside: a value of a file of the project.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MachineName {
    /// The path of the file from the root of the project, with `/`.
    pub file: String,
    /// The name of the value in it.
    pub name: String,
    /// The words for where it comes from: `--machine`.
    pub whence: String,
}

impl MachineName {
    /// File and name out of a text such as `machines.ifs:router`; none where one of them is missing.
    #[must_use]
    pub fn split(text: &str) -> Option<(&str, &str)> {
        text.rsplit_once(':').filter(|(file, name)| !file.trim().is_empty() && !name.trim().is_empty())
    }
}

/// A parameter's value as it is used, for reports.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterValue {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: Value,
    /// Its type.
    pub ty: Type,
}

/// Why a text is no value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OverrideError {
    /// It cannot be read as a number with a unit of the dimension, a truth or a text.
    NotAValue,
}

/// Reads a value as it is written after `--set name=`.
///
/// # Errors
/// When it is no value of the type.
pub fn read_value(text: &str, ty: &Type) -> Result<Value, OverrideError> {
    let text = text.trim();
    match ty {
        Type::Text => Ok(Value::Text(text.into())),
        Type::Bool => match text {
            "true" => Ok(Value::Bool(true)),
            "false" => Ok(Value::Bool(false)),
            _ => Err(OverrideError::NotAValue),
        },
        _ => read_number(text, ty).map(Value::Scalar).ok_or(OverrideError::NotAValue),
    }
}

fn read_number(text: &str, ty: &Type) -> Option<Scalar> {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let unit = Unit::ALL
        .iter()
        .filter(|unit| digits.ends_with(unit.suffix()))
        .max_by_key(|unit| unit.suffix().len());
    let number = unit.map_or(digits, |unit| &digits[..digits.len() - unit.suffix().len()]);
    let number = number.trim_end();
    let well_formed = number.starts_with(|c: char| c.is_ascii_digit())
        && number.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '+' | '-'));
    if !well_formed {
        return None;
    }
    let value = Rational::from_decimal(number).ok()?;
    let value = if negative { -value } else { value };
    let dimension = ty.dimension()?;
    let Some(unit) = unit else {
        let plain = dimension == crate::hir::dimension::Dimension::NUMBER;
        let whole = *ty != Type::Int || value.is_integer();
        return (plain && whole).then_some(Scalar::Exact(value));
    };
    let (of, worth) = unit_worth(*unit);
    let whole = *ty != Type::Int;
    (of == dimension && whole).then(|| match worth {
        Worth::Exact(worth) => Scalar::Exact(&value * &worth),
        Worth::TimesPi(worth) => Scalar::Pi(&value * &worth),
    })
}

impl Evaluator<'_> {
    pub(super) fn parameter(&mut self, id: ItemId, param: &Param) -> Outcome<Value> {
        let item = self.hir.item(id);
        let (name, name_span) = (item.name.clone(), item.name_span);
        let own = name_span.file == self.hir.root;
        let given = self.overrides.parameters.get(&name).filter(|_| own);
        let default = self.overrides.defaults.get(&name).filter(|_| own && given.is_none());
        let set = given.or(default.map(|(text, _)| text));
        let tried = self.overrides.values.get(&name).filter(|_| own);
        let value = match (tried, set) {
            (Some(value), _) => Value::Scalar(value.clone()),
            (None, None) => self.body(&param.default)?,
            (None, Some(text)) => read_value(text, &param.ty).map_err(|_| {
                let message = format!("`{text}` is no value for the parameter `{name}`");
                let diagnostic = Diagnostic::new(Code::E0606, name_span, message).label("declared here");
                let diagnostic = match self.example(param, text) {
                    Some(example) => diagnostic.hint(format!("write it like `--set {name}={example}`")),
                    None => diagnostic,
                };
                let worked_out = ['+', '*', '/', '('].iter().any(|sign| text.contains(*sign));
                let diagnostic = match worked_out {
                    true => diagnostic.note("what is set is one value and not worked out: add it up first"),
                    false => diagnostic,
                };
                self.report(said_by(diagnostic, default))
            })?,
        };
        self.in_range(&name, name_span, param, &value, set.map(|_| default))?;
        Ok(value)
    }

    /// A text that is a value of a parameter and in its range: what was given with a unit, or else the default or an end of
    /// the range.
    fn example(&mut self, param: &Param, given: &str) -> Option<String> {
        let range = match &param.range {
            Some((from, to)) => Some([self.body(from).ok()?, self.body(to).ok()?]),
            None => None,
        };
        let dimension = param.ty.dimension();
        let metric = Unit::ALL.iter().filter(|unit| !matches!(unit, Unit::Inch | Unit::Foot));
        let units = metric.filter(|unit| Some(unit_worth(**unit).0) == dimension);
        let with_unit = units.map(|unit| format!("{}{}", given.trim(), unit.suffix()));
        let default = self.body(&param.default).ok();
        let values = default.iter().chain(range.iter().flatten());
        let in_words = values.filter_map(|value| match value {
            Value::Bool(truth) => Some(truth.to_string()),
            value => value.scalar().map(|scalar| super::words(scalar, &param.ty)),
        });
        let is_inside = |text: &String| {
            let Ok(value) = read_value(text, &param.ty) else { return false };
            let (Some(value), Some([least, most])) = (value.scalar(), &range) else { return true };
            let ends = (least.scalar(), most.scalar());
            let (Some(least), Some(most)) = ends else { return true };
            [(least, value), (value, most)]
                .iter()
                .all(|(a, b)| a.compare(b).is_ok_and(std::cmp::Ordering::is_le))
        };
        with_unit.chain(in_words).find(is_inside)
    }

    /// A range is stepped through upwards, so its step is above 0.
    fn rising_step(&mut self, name: &str, param: &Param) -> Outcome<()> {
        let Some(step) = &param.step else { return Ok(()) };
        let value = self.body(step)?;
        let rises = value
            .scalar()
            .is_some_and(|value| value.compare(&Scalar::zero()).is_ok_and(std::cmp::Ordering::is_gt));
        if rises {
            return Ok(());
        }
        let message = format!("the range of `{name}` has no end with a step that is not above 0");
        let diagnostic = Diagnostic::new(Code::E0607, step.value.span, message).label("not above 0");
        Err(self.report(diagnostic.hint("leave the step out, or make it larger than 0")))
    }

    fn in_range(
        &mut self,
        name: &str,
        name_span: crate::source::Span,
        param: &Param,
        value: &Value,
        set: Option<Option<&(String, String)>>,
    ) -> Outcome<()> {
        self.rising_step(name, param)?;
        let Some((from, to)) = &param.range else { return Ok(()) };
        let range_span = from.value.span.to(to.value.span);
        let (least, most) = (self.body(from)?, self.body(to)?);
        let (Some(value), Some(least), Some(most)) = (value.scalar(), least.scalar(), most.scalar()) else {
            return Err(Stop::Reported);
        };
        let inside = |a: &Scalar, b: &Scalar| a.compare(b).is_ok_and(std::cmp::Ordering::is_le);
        let words = |scalar: &Scalar| super::words(scalar, &param.ty);
        if !inside(least, most) {
            let message =
                format!("the range of `{name}` is empty: {} is above {}", words(least), words(most));
            let diagnostic = Diagnostic::new(Code::E0607, range_span, message).label("nothing lies in it");
            return Err(self.report(diagnostic.hint("write the smaller end first")));
        }
        if inside(least, value) && inside(value, most) {
            return Ok(());
        }
        let message =
            format!("`{name}` is {}, outside of its range {} .. {}", words(value), words(least), words(most));
        let nearest = if inside(value, least) { words(least) } else { words(most) };
        let place = if set.is_some() { name_span } else { param.default.value.span };
        let fixes = match (&set, is_literal(&param.default.value)) {
            (None, true) => {
                let title = format!(
                    "set `{name}` to {nearest}, the nearest in its range, instead of {}",
                    words(value)
                );
                vec![Fix::titled(title).with(place, nearest.clone())]
            }
            _ => Vec::new(),
        };
        let diagnostic = Diagnostic::new(Code::E0601, place, message)
            .label(if set.is_some() { "set from outside" } else { "its default" })
            .also(range_span, "its range")
            .ways(format!("the nearest value in the range is {nearest}"), fixes);
        Err(self.report(said_by(diagnostic, set.flatten())))
    }
}

/// With a note of where a value comes from, where it was not given for this design alone.
fn said_by(diagnostic: Diagnostic, default: Option<&(String, String)>) -> Diagnostic {
    match default {
        Some((_, from)) => diagnostic.note(format!("{from} sets it")),
        None => diagnostic,
    }
}
