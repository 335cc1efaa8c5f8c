//! Every place of a name: in one file, and in every file that one analysis knows.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::index::Target;
use ifs_compiler::source::{FileId, Span};

/// The uses of what stands at a place, and its declaration where it has one, in the order of files.
pub(crate) struct Uses {
    pub(crate) declaration: Option<Span>,
    pub(crate) uses: Vec<Span>,
}

/// Every place of what is named at a place.
pub(crate) fn references(analysis: &Analysis, file: FileId, offset: u32) -> Option<Uses> {
    let name = analysis.index.name_at(file, offset)?;
    Some(of_target(analysis, name.target))
}

/// Every place of a target.
pub(crate) fn of_target(analysis: &Analysis, target: Target) -> Uses {
    let declaration = match target {
        Target::Declared(span) => Some(span),
        _ => None,
    };
    Uses { declaration, uses: analysis.index.uses(target).collect() }
}

/// The places in the file itself, each with whether it is the declaration.
pub(crate) fn highlights(analysis: &Analysis, file: FileId, offset: u32) -> Vec<(Span, bool)> {
    let Some(found) = references(analysis, file, offset) else { return Vec::new() };
    let declared = found.declaration.map(|span| (span, true));
    let uses = found.uses.into_iter().map(|span| (span, false));
    let mut all: Vec<(Span, bool)> =
        declared.into_iter().chain(uses).filter(|(span, _)| span.file == file).collect();
    all.sort_by_key(|(span, _)| span.start);
    all.dedup_by_key(|(span, _)| *span);
    all
}
