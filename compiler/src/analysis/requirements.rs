//! Requirements: their limits worked out. What nothing can hold is in `conflicts`, how they are told in `words`, and the
//! diagnostic at the line that asked when one fails in `failure`.

mod conflicts;
mod failure;
mod words;

pub(super) use conflicts::conflicts;
pub(super) use failure::diagnostics;
pub(super) use words::found_words;
pub use words::value_words;

use super::settings;
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::checks::{CheckResult, Limit};
use crate::fabricate::material::LeastBendRadius;
use crate::hir::evaluate::Evaluator;
use crate::hir::schema::Measure;
use crate::hir::tree::{self, Fabricate, Hir, Requirement};
use crate::hir::value::Value;
use crate::source::Span;
use crate::syntax::ast::Comparison;

/// The limit of a requirement, worked out.
#[derive(Clone, Copy, Debug, PartialEq)]
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
                let words = |value: f64| value_words(requirement.measure, value);
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
