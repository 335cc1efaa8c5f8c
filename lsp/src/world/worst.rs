//! The worst boards of a requirement that fails, as places beside its diagnostic: each names its board and what was measured,
//! at the figure that the board is of.

use ifs_compiler::analysis::{Analysis, Fabrication, RequirementResult, value_words};
use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::hir::schema::Measure;
use ifs_compiler::source::Span;

/// How many boards are named.
const NAMED: usize = 5;

/// The diagnostic with the worst boards, where it is one of a requirement.
pub(super) fn with_worst_boards(mut diagnostic: Diagnostic, analysis: &Analysis) -> Diagnostic {
    let all =
        analysis.fabrications.iter().flat_map(|made| made.requirements.iter().map(move |one| (made, one)));
    let mut failed = all.filter(|(_, requirement)| !requirement.result.holds());
    let Some((made, requirement)) = failed.find(|(_, requirement)| requirement.span == diagnostic.span)
    else {
        return diagnostic;
    };
    let Some(figure) = declared(analysis, made) else { return diagnostic };
    for text in worst(requirement) {
        diagnostic = diagnostic.also(figure, text);
    }
    diagnostic
}

/// Where the figure of a block is declared.
fn declared(analysis: &Analysis, made: &Fabrication) -> Option<Span> {
    let own = analysis.hir.own_items().map(|(_, item)| item);
    let mut named = own.filter(|item| item.name == made.figure);
    named.next().map(|item| item.name_span)
}

fn worst(requirement: &RequirementResult) -> Vec<String> {
    let measure = requirement.measure;
    if matches!(measure, Measure::Count) {
        return Vec::new();
    }
    let result = &requirement.result;
    let named = result.measured.iter().take(result.failing.min(NAMED));
    let words = named.map(|measured| {
        let value = value_words(measure, measured.value);
        match measure {
            Measure::Overlap => format!("joints {}: {value} apart", measured.place),
            _ if measured.place.is_empty() => format!("{} ({}): {value}", measured.alias, measured.address),
            _ => format!("{} ({}), {}: {value}", measured.alias, measured.address, measured.place),
        }
    });
    words.collect()
}
