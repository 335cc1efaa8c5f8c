//! The diagnostic of a requirement that fails, and of elements larger than what they are cut from: the worst of them, how
//! many there are, and what would mend it.

use super::unmeasured::unmeasured;
use super::words::{beyond_words, plural, value_words};
use super::{LimitValue, RequirementResult};
use crate::analysis::fabrication::{Elements, Fabrication};
use crate::analysis::mend::{Asked, Remedies};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::checks::{Limit, Measured};
use crate::hir::schema::Measure;

/// How many elements a message shows.
const SHOWN: usize = 4;

/// A diagnostic for elements of a block that are too large, and one for each requirement of it that fails or measures
/// nothing; with what would mend them where remedies are looked for.
pub(in crate::analysis) fn diagnostics(
    fabrication: &Fabrication,
    mut remedies: Option<&mut Remedies<'_>>,
) -> Vec<Diagnostic> {
    let mut found: Vec<Diagnostic> = too_large(fabrication, remedies.as_deref_mut()).into_iter().collect();
    let requirements = fabrication.requirements.iter().enumerate();
    found.extend(requirements.filter_map(|(place, requirement)| match requirement.result.holds() {
        false => Some(failure(fabrication, place, requirement, remedies.as_deref_mut())),
        true => unmeasured(fabrication, requirement),
    }));
    found
}

fn failure(
    fabrication: &Fabrication,
    place: usize,
    requirement: &RequirementResult,
    remedies: Option<&mut Remedies<'_>>,
) -> Diagnostic {
    let measure = requirement.measure;
    let result = &requirement.result;
    let limit = requirement.limit.words(measure);
    let sentence = |measured: &Measured| sentence(fabrication, requirement, measured);
    let mut diagnostic = match result.measured.first() {
        Some(worst) => {
            let message = format!("{}, but the design asks for {limit}", sentence(worst));
            Diagnostic::new(code(measure), requirement.span, message)
        }
        None => Diagnostic::new(code(measure), requirement.span, "nothing could be measured"),
    };
    diagnostic = diagnostic.label(match measure {
        Measure::Count if result.below > 0 => "too few".to_owned(),
        Measure::Count => "too many".to_owned(),
        _ => format!("{} of {} {} fail", result.failing, result.total, counted(fabrication, measure)),
    });
    let shown = result.failing.min(result.measured.len()).min(SHOWN);
    for other in result.measured.get(1..shown).unwrap_or_default() {
        diagnostic = diagnostic.note(sentence(other));
    }
    if let Some(note) = spread(requirement) {
        diagnostic = diagnostic.note(note);
    }
    for remedy in
        remedies.into_iter().flat_map(|remedies| remedies.of(fabrication, Asked::Requirement(place)))
    {
        diagnostic = diagnostic.ways(remedy.text, remedy.fixes);
    }
    diagnostic
}

/// Elements that are larger than the raw board, or longer than the bar, said at that setting.
fn too_large(fabrication: &Fabrication, remedies: Option<&mut Remedies<'_>>) -> Option<Diagnostic> {
    let refused = fabrication.elements.too_large();
    let (label, reason) = refused.first()?;
    let (setting, made) = match &fabrication.elements {
        Elements::Panels(_) => ("board", "boards"),
        Elements::Planks(_) => ("stock", "planks"),
    };
    let span = fabrication.settings.iter().find(|(name, _, _)| *name == setting).map(|(_, _, span)| *span)?;
    let message = format!("{} ({}) cannot be made: {reason}", label.alias, label.address);
    let total = fabrication.elements.total();
    let mut diagnostic = Diagnostic::new(Code::E0834, span, message)
        .label(format!("{} of {total} {made} are too large for it", refused.len()));
    if refused.len() > 1 {
        let others: Vec<&str> =
            refused.iter().skip(1).take(SHOWN).map(|(label, _)| label.alias.as_str()).collect();
        let more = if refused.len() > SHOWN + 1 { ", …" } else { "" };
        let others = others.join(", ");
        diagnostic = diagnostic.note(format!("and {} more: {others}{more}", refused.len() - 1));
    }
    for remedy in remedies.into_iter().flat_map(|remedies| remedies.of(fabrication, Asked::Stock)) {
        diagnostic = diagnostic.ways(remedy.text, remedy.fixes);
    }
    Some(diagnostic)
}

/// How the values lie, and where no scaling could bring them within their limit.
fn spread(requirement: &RequirementResult) -> Option<String> {
    let (measure, result) = (requirement.measure, &requirement.result);
    let (least, most) = result.extremes?;
    let [low, high] = [least, most].map(|value| beyond_words(measure, value, &requirement.limit));
    if low == high {
        return None;
    }
    let mut note = format!("the {} go from {low} to {high}", plural(measure));
    let LimitValue::Plain(Limit::Within(from, to)) = requirement.limit else { return Some(note) };
    let (below, above) = (result.below, result.failing - result.below);
    if below > 0 && above > 0 {
        let [from, to] = [from, to].map(|value| value_words(measure, value));
        note = format!("{note}: {below} are below {from}, {above} above {to}");
    }
    let sizes = matches!(measure, Measure::Edge | Measure::Length | Measure::Width | Measure::Area);
    if sizes && least > 0.0 && from > 0.0 && most / least > to / from * 1.005 {
        note = format!(
            "{note}; the largest is {:.2} times the smallest, and the limits allow {:.2} times, so making all of them \
             larger or smaller is not enough",
            most / least,
            to / from
        );
    }
    Some(note)
}

/// `the length of vault-1-03 (vault.1.left…) is 1204.2mm`
fn sentence(fabrication: &Fabrication, requirement: &RequirementResult, measured: &Measured) -> String {
    let measure = requirement.measure;
    let value = beyond_words(measure, measured.value, &requirement.limit);
    let place = if measured.place.is_empty() { String::new() } else { format!(", {}", measured.place) };
    match measure {
        Measure::Overlap => format!("the joints {} are {value} apart", measured.place),
        Measure::Count => {
            format!("`{}` is made of {value} {}", fabrication.figure, counted(fabrication, measure))
        }
        _ => {
            format!("the {} of {} ({}{place}) is {value}", measure.words(), measured.alias, measured.address)
        }
    }
}

/// What the measurements are counted in.
fn counted(fabrication: &Fabrication, measure: Measure) -> &'static str {
    match (measure, &fabrication.elements) {
        (Measure::Edge | Measure::Bevel, _) => "edges",
        (Measure::Angle, _) => "corners",
        (Measure::Mitre, _) => "ends",
        (Measure::Overlap, _) => "pairs of neighbours",
        (_, Elements::Panels(_)) => "boards",
        (_, Elements::Planks(_)) => "planks",
    }
}

fn code(measure: Measure) -> Code {
    match measure {
        Measure::Planarity => Code::E0810,
        Measure::Edge => Code::E0811,
        Measure::Length => Code::E0812,
        Measure::Mitre => Code::E0813,
        Measure::Overlap => Code::E0814,
        Measure::BendRadius => Code::E0815,
        Measure::Fold => Code::E0816,
        Measure::DiagonalRatio => Code::E0817,
        Measure::Width => Code::E0818,
        Measure::Area => Code::E0819,
        Measure::Angle => Code::E0830,
        Measure::Bevel => Code::E0831,
        Measure::Mass => Code::E0832,
        Measure::Count => Code::E0833,
    }
}
