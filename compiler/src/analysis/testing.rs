//! Running the tests of a design: what is made of its figures, as values of the language, and each test's verdict.

use super::{Analysis, Elements, Fabrication};
use crate::diagnostic::{Code, Diagnostic, Severity};
use crate::fabricate::panel::Panel;
use crate::fabricate::plank::Plank;
use crate::hir::evaluate::{Evaluator, MadeValues, Overrides};
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Hir, ItemId, ItemKind, Made};
use crate::hir::value::Value;
use crate::source::Span;
use std::sync::Arc;

/// How a test ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// All that it states holds.
    Holds,
    /// Something does not hold, or could not be worked out.
    Fails,
    /// The design has errors, so that it could not be run.
    NotRun,
}

/// A test that was run.
#[derive(Clone, Debug)]
pub struct TestResult {
    /// What it shows.
    pub name: String,
    /// Where that is written.
    pub span: Span,
    /// How it ended.
    pub verdict: Verdict,
    /// What does not hold.
    pub diagnostics: Vec<Diagnostic>,
}

/// Runs the tests of an analysed design, in order. Where a requirement of the design fails they are run all the same.
pub fn run_tests(analysis: &Analysis, overrides: &Overrides) -> Vec<TestResult> {
    let made = if is_worked_out(analysis) { made_values(analysis) } else { None };
    let tests = analysis.hir.tests.iter();
    tests
        .map(|test| {
            let (verdict, diagnostics) = match &made {
                None => (Verdict::NotRun, Vec::new()),
                Some(made) => {
                    let mut evaluator = Evaluator::new(&analysis.hir, overrides).with_made(made);
                    let holds = evaluator.test(test);
                    (if holds { Verdict::Holds } else { Verdict::Fails }, evaluator.finish())
                }
            };
            TestResult { name: test.name.clone(), span: test.name_span, verdict, diagnostics }
        })
        .collect()
}

/// Whether every figure and board of the design is known: at most, requirements fail.
fn is_worked_out(analysis: &Analysis) -> bool {
    let requirements = [Code::E0810..=Code::E0819, Code::E0830..=Code::E0833];
    let errors = analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error);
    let complete = analysis.fabrications.len() == analysis.hir.fabricates.len();
    analysis.plan.is_some()
        && complete
        && errors.map(|found| found.code).all(|code| requirements.iter().any(|codes| codes.contains(&code)))
}

/// What tests can ask of each figure; `None` where the library lacks the records for it.
fn made_values(analysis: &Analysis) -> Option<MadeValues> {
    let hir = &analysis.hir;
    let lowered = analysis.plan.as_ref()?;
    let mut values = MadeValues::new();
    // A figure that is an empty list has a plan of nothing.
    for (id, item) in hir.own_items() {
        if matches!(item.kind, ItemKind::Figure(_)) {
            values.insert((id, Made::Elements), Value::Scalar(Scalar::zero()));
            values.insert((id, Made::Vertices), Value::Scalar(Scalar::zero()));
        }
    }
    for (source, count) in lowered.sources.iter().zip(&lowered.counts) {
        for (made, more) in [(Made::Elements, count.elements), (Made::Vertices, count.vertices)] {
            let entry = values.entry((source.item, made)).or_insert_with(|| Value::Scalar(Scalar::zero()));
            let sum = entry.scalar()?.plus(&Scalar::integer(i64::try_from(more).ok()?)).ok()?;
            *entry = Value::Scalar(sum);
        }
    }
    for (block, made) in hir.fabricates.iter().zip(&analysis.fabrications) {
        values.insert((block.figure, Made::Boards), boards(hir, made)?);
    }
    Some(values)
}

fn boards(hir: &Hir, made: &Fabrication) -> Option<Value> {
    let list: Option<Vec<Value>> = match &made.elements {
        Elements::Panels(made) => {
            let record = record(hir, "Board");
            made.panels.iter().map(|panel| board(hir, record?, panel)).collect()
        }
        Elements::Planks(made) => {
            let record = record(hir, "Plank");
            made.planks.iter().map(|made| plank(hir, record?, made)).collect()
        }
    };
    Some(Value::List(Arc::new(list?)))
}

fn record(hir: &Hir, name: &str) -> Option<ItemId> {
    let ids = (0..hir.items.len() as u32).map(ItemId);
    ids.zip(&hir.items)
        .find(|(_, item)| {
            let is_record = matches!(item.kind, ItemKind::Record(_));
            is_record && item.name == name && hir.is_library(item.name_span.file)
        })
        .map(|(id, _)| id)
}

/// A record of the library with its fields filled by name.
fn filled(hir: &Hir, record: ItemId, value: impl Fn(&str) -> Option<Value>) -> Option<Value> {
    let ItemKind::Record(fields) = &hir.item(record).kind else { return None };
    let values: Option<Vec<Value>> = fields.iter().map(|field| value(&field.name)).collect();
    Some(Value::Record(record, Arc::new(values?)))
}

fn number(value: f64) -> Option<Value> {
    Scalar::real(value).ok().map(Value::Scalar)
}

fn numbers(values: &[f64]) -> Option<Value> {
    let list: Option<Vec<Value>> = values.iter().map(|value| number(*value)).collect();
    Some(Value::List(Arc::new(list?)))
}

fn whole(value: u32) -> Option<Value> {
    Some(Value::Scalar(Scalar::integer(i64::from(value))))
}

/// Addresses, an empty text where there is none.
fn texts(values: &[Option<String>]) -> Option<Value> {
    let texts = values.iter().map(|text| Value::Text(text.as_deref().unwrap_or_default().into()));
    Some(Value::List(Arc::new(texts.collect())))
}

fn board(hir: &Hir, record: ItemId, panel: &Panel) -> Option<Value> {
    let size = panel.size();
    filled(hir, record, |field| match field {
        "address" => Some(Value::Text(panel.label.address.as_str().into())),
        "alias" => Some(Value::Text(panel.label.alias.as_str().into())),
        "length" => number(size.x),
        "width" => number(size.y),
        "thickness" => number(panel.thickness),
        "area" => number(panel.area),
        "mass" => number(panel.mass.unwrap_or(0.0)),
        "least_width" => number(panel.least_width()),
        "edges" => numbers(&panel.edges),
        "angles" => numbers(&panel.angles()),
        // On the border there is none.
        "bevels" => numbers(&panel.bevels.map(|bevel| bevel.unwrap_or(0.0))),
        "neighbours" => texts(&panel.neighbours),
        "relief" => numbers(&panel.relief),
        "corner_gaps" => numbers(&panel.corner_gaps),
        "ring" => whole(panel.ring),
        "order" => whole(panel.order),
        "diagonal" => number(panel.diagonal),
        // The diagonals of a convex quad are never parallel.
        "diagonal_ratio" => number(panel.diagonal_ratio.unwrap_or(0.0)),
        "fold" => number(panel.fold),
        "planarity" => number(panel.planarity),
        "moved" => number(panel.moved),
        _ => None,
    })
}

fn plank(hir: &Hir, record: ItemId, plank: &Plank) -> Option<Value> {
    filled(hir, record, |field| match field {
        "address" => Some(Value::Text(plank.label.address.as_str().into())),
        "alias" => Some(Value::Text(plank.label.alias.as_str().into())),
        "length" => number(plank.length),
        "inner_length" => number(plank.inner_length),
        "outer_length" => number(plank.outer_length),
        "depth" => number(plank.depth),
        "width" => number(plank.width),
        "mass" => number(plank.mass.unwrap_or(0.0)),
        "mitres" => numbers(&plank.mitres.map(f64::abs)),
        "bevels" => numbers(&plank.bevels.map(f64::abs)),
        "neighbours" => texts(&plank.neighbours),
        "ring" => whole(plank.ring),
        "order" => whole(plank.order),
        _ => None,
    })
}
