//! Requirements: their limits worked out, and the diagnostic at the line that asked when one fails.

use super::fabrication::{Elements, Fabrication};
use super::mend::Remedies;
use super::settings;
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::checks::{CheckResult, Limit, Measured};
use crate::fabricate::material::LeastBendRadius;
use crate::hir::evaluate::{Evaluator, quantity_words};
use crate::hir::schema::Measure;
use crate::hir::tree::{self, Fabricate, Hir, Requirement};
use crate::hir::value::Value;
use crate::source::Span;
use crate::syntax::ast::Comparison;

/// The limit of a requirement, worked out.
#[derive(Clone, Debug, PartialEq)]
pub enum LimitValue {
    /// Against plain numbers: mm, rad, or a cosine.
    Plain(Limit),
    /// Against the least radii across and along the grain.
    Grain(LeastBendRadius),
}

impl LimitValue {
    /// The least value that holds, where there is one.
    pub(super) fn least(&self) -> Option<f64> {
        match self {
            LimitValue::Plain(Limit::AtLeast(least) | Limit::Within(least, _) | Limit::Above(least)) => {
                Some(*least)
            }
            _ => None,
        }
    }

    /// The limit in words: `at least 80mm`.
    pub fn words(&self, measure: Measure) -> String {
        let words = |value: f64| quantity_words(value, measure.dimension());
        match self {
            LimitValue::Plain(limit) => match limit {
                Limit::AtLeast(value) => format!("at least {}", words(*value)),
                Limit::AtMost(value) => format!("at most {}", words(*value)),
                Limit::Within(from, to) => format!("{} .. {}", words(*from), words(*to)),
                Limit::Above(value) => format!("above {}", words(*value)),
                Limit::Below(value) => format!("below {}", words(*value)),
                Limit::Equal(value) => words(*value),
            },
            LimitValue::Grain(least) => {
                format!("at least {} across and {} along the grain", words(least.across), words(least.along))
            }
        }
    }
}

/// A requirement, measured.
#[derive(Clone, Debug, PartialEq)]
pub struct RequirementResult {
    /// What is measured.
    pub measure: Measure,
    /// The whole line.
    pub span: Span,
    /// The limit.
    pub limit: LimitValue,
    /// What was found.
    pub result: CheckResult,
}

/// The limit of a requirement; `None` after a report.
pub(super) fn evaluate_limit(
    hir: &Hir,
    evaluator: &mut Evaluator<'_>,
    block: &Fabricate,
    requirement: &Requirement,
    material: Option<&Value>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<LimitValue> {
    let mut value = |expr: &tree::Expr| evaluator.in_block(expr, block.slots, material).ok();
    match &requirement.limit {
        tree::Limit::Within(from, to) => {
            let span = from.span.to(to.span);
            let (from, to) = (value(from)?.number()?, value(to)?.number()?);
            if from > to {
                let words = |value: f64| quantity_words(value, requirement.measure.dimension());
                let message = format!("nothing lies within {} .. {}", words(from), words(to));
                let diagnostic = Diagnostic::new(Code::E0607, span, message).label("empty");
                diagnostics.push(diagnostic.hint("write the smaller end first"));
                return None;
            }
            Some(LimitValue::Plain(Limit::Within(from, to)))
        }
        tree::Limit::Compare(comparison, expr) => {
            let value = value(expr)?;
            if let Some(least) = settings::radius(hir, &value) {
                return Some(LimitValue::Grain(least));
            }
            let value = value.number()?;
            Some(LimitValue::Plain(match comparison {
                Comparison::AtLeast => Limit::AtLeast(value),
                Comparison::AtMost => Limit::AtMost(value),
                Comparison::Greater => Limit::Above(value),
                Comparison::Less => Limit::Below(value),
                Comparison::Equal => Limit::Equal(value),
                // The checker lets no such requirement through.
                Comparison::NotEqual => return None,
            }))
        }
    }
}

/// A diagnostic for each requirement of a block that fails.
pub(super) fn diagnostics(fabrication: &Fabrication, remedies: &Remedies<'_>) -> Vec<Diagnostic> {
    let requirements = fabrication.requirements.iter().enumerate();
    requirements
        .filter_map(|(place, requirement)| match requirement.result.holds() {
            false => Some(failure(fabrication, place, requirement, remedies)),
            true => unmeasured(fabrication, requirement),
        })
        .collect()
}

/// Joints of neighbours that have none: a requirement that holds whatever it asks for.
fn unmeasured(fabrication: &Fabrication, requirement: &RequirementResult) -> Option<Diagnostic> {
    let Elements::Planks(planks) = &fabrication.elements else { return None };
    if requirement.measure != Measure::Overlap || requirement.result.total > 0 {
        return None;
    }
    let name = &fabrication.figure;
    let why = match planks.figures.len() {
        1 => format!("`{name}` is one curve, which has no neighbour"),
        _ => format!("no two neighbours of `{name}` both have joints between planks"),
    };
    let message = format!("`require overlap` has nothing to measure: {why}");
    let diagnostic =
        Diagnostic::new(Code::W0608, requirement.span, message).label("holds whatever it asks for");
    Some(diagnostic.hint(
        "a list of curves has neighbours: `figure vault = [arch(i) for i in 0..5]`; else take the line out",
    ))
}

fn failure(
    fabrication: &Fabrication,
    place: usize,
    requirement: &RequirementResult,
    remedies: &Remedies<'_>,
) -> Diagnostic {
    let measure = requirement.measure;
    let result = &requirement.result;
    let code = match measure {
        Measure::Planarity => Code::E0810,
        Measure::Edge => Code::E0811,
        Measure::Length => Code::E0812,
        Measure::Mitre => Code::E0813,
        Measure::Overlap => Code::E0814,
        Measure::BendRadius => Code::E0815,
    };
    let limit = requirement.limit.words(measure);
    let mut diagnostic = match result.measured.first() {
        Some(worst) => {
            let message = format!("{}, but the design asks for {limit}", sentence(measure, worst));
            Diagnostic::new(code, requirement.span, message)
        }
        None => Diagnostic::new(code, requirement.span, "nothing could be measured"),
    };
    diagnostic = diagnostic.label(format!("{} of {} fail", result.failing, result.total));
    let shown = result.failing.min(result.measured.len()).min(4);
    for other in result.measured.get(1..shown).unwrap_or_default() {
        diagnostic = diagnostic.note(sentence(measure, other));
    }
    if let Some((least, most)) = result.extremes {
        let words = |value: f64| quantity_words(value, measure.dimension());
        let (least, most) = (words(least), words(most));
        if least != most {
            diagnostic = diagnostic.note(format!("{} goes from {least} to {most}", measure.words()));
        }
    }
    for remedy in remedies.of(fabrication, place) {
        diagnostic = diagnostic.hint(remedy);
    }
    diagnostic
}

/// `vault-1-03 (vault.1.left…) has a length of 1204.2mm`
fn sentence(measure: Measure, measured: &Measured) -> String {
    let value = quantity_words(measured.value, measure.dimension());
    let place = if measured.place.is_empty() { String::new() } else { format!(", {}", measured.place) };
    match measure {
        Measure::Overlap => format!("the joints {} are {value} apart", measured.place),
        _ => {
            format!("the {} of {} ({}{place}) is {value}", measure.words(), measured.alias, measured.address)
        }
    }
}
