//! A requirement that measures nothing, and so holds whatever it asks for.

use super::RequirementResult;
use crate::analysis::fabrication::{Elements, Fabrication};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::schema::Measure;

/// A warning where the joints of neighbours are asked for and there are none.
pub(super) fn unmeasured(fabrication: &Fabrication, requirement: &RequirementResult) -> Option<Diagnostic> {
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
