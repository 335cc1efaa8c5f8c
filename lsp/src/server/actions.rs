//! Code actions: quick fixes at the diagnostics of a range, and what is done to a whole file.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Edit};
use ifs_compiler::source::Span;
use tower_lsp::ls_types::*;

use super::completions::paths;
use super::judged::judged;
use super::neighbours::{imports, read_with, siblings};
use crate::features::fixes::{self, Mend};
use crate::features::format::line_edits;
use crate::features::refactor::{self, Refactoring};
use crate::protocol::capabilities::FIX_ALL;
use crate::protocol::diagnostics::diagnostic;
use crate::world::Snapshot;

/// What can be done in a range, of the kinds that the client asks for; all where it asks for none.
pub(super) fn actions(snapshot: &Snapshot, range: Range, context: &CodeActionContext) -> CodeActionResponse {
    let only = context.only.as_deref();
    let wanted = |kind: &CodeActionKind| {
        only.is_none_or(|only| only.iter().any(|asked| is_within(kind.as_str(), asked.as_str())))
    };
    let mut found = Vec::new();
    if wanted(&CodeActionKind::QUICKFIX) {
        for found_here in here(snapshot, range) {
            let told = diagnostic(&snapshot.places, &snapshot.analysis, found_here, snapshot.encoding);
            let mut mends = fixes::mends(&snapshot.analysis, found_here);
            mends.extend(imports(snapshot, found_here));
            mends.extend(siblings(snapshot, found_here));
            mends.extend(fixes::nearest(&snapshot.analysis, found_here, &|| paths(snapshot)));
            let mends = judged(snapshot, found_here, mends);
            found.extend(mends.into_iter().filter_map(|mend| quick_fix(snapshot, mend, &told)));
        }
    }
    // Each is a reading of the design: not at every step of the caret.
    if context.trigger_kind != Some(CodeActionTriggerKind::AUTOMATIC) {
        if wanted(&CodeActionKind::REFACTOR_EXTRACT) && range.start != range.end {
            let span =
                Span::new(snapshot.analysis.root, snapshot.offset(range.start), snapshot.offset(range.end));
            let extracted = refactor::extract(&snapshot.analysis, span);
            found.extend(extracted.and_then(|it| kept(snapshot, it, CodeActionKind::REFACTOR_EXTRACT)));
        }
        if wanted(&CodeActionKind::REFACTOR_INLINE) {
            let at = snapshot.offset(range.start);
            let inlined = refactor::inline(&snapshot.analysis, snapshot.analysis.root, at);
            found.extend(inlined.and_then(|it| kept(snapshot, it, CodeActionKind::REFACTOR_INLINE)));
        }
    }
    // What is done to a whole file is offered where it is asked for: not beside every mistake.
    if only.is_some() && wanted(&FIX_ALL) {
        found.extend(whole(snapshot, "mend all that is safe to mend", FIX_ALL, safe(snapshot)));
    }
    if only.is_some() && wanted(&CodeActionKind::SOURCE_ORGANIZE_IMPORTS) {
        let edits = fixes::organized(&snapshot.analysis, &snapshot.diagnostics, snapshot.analysis.root);
        let title = "put imports in order, without those that are not used";
        found.extend(whole(snapshot, title, CodeActionKind::SOURCE_ORGANIZE_IMPORTS, edits));
    }
    found.into_iter().map(CodeActionOrCommand::CodeAction).collect()
}

/// Whether a kind is the other or below it: `source.fixAll.ifs` is below `source`.
fn is_within(kind: &str, other: &str) -> bool {
    other.is_empty() || kind.strip_prefix(other).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}

/// The diagnostics that touch a range of the document.
fn here(snapshot: &Snapshot, range: Range) -> impl Iterator<Item = &Diagnostic> {
    let root = snapshot.analysis.root;
    let (start, end) = (snapshot.offset(range.start), snapshot.offset(range.end));
    let touches = move |found: &&Diagnostic| {
        found.span.file == root && found.span.start <= end && start <= found.span.end
    };
    snapshot.diagnostics.iter().filter(touches)
}

/// A refactoring after which the design means the same.
fn kept(snapshot: &Snapshot, refactoring: Refactoring, kind: CodeActionKind) -> Option<CodeAction> {
    let source = snapshot.analysis.sources.get(snapshot.analysis.root)?;
    let after = read_with(snapshot, refactoring.applied(&source.text))?;
    let edits = if source.text.contains("\r\n") {
        refactoring.with_line_ends("\r\n")
    } else {
        refactoring.edits.clone()
    };
    let keeps = refactoring.keeps(&snapshot.analysis, &after);
    keeps.then(|| whole(snapshot, &refactoring.title, kind, edits)).flatten()
}

fn quick_fix(snapshot: &Snapshot, mend: Mend, told: &tower_lsp::ls_types::Diagnostic) -> Option<CodeAction> {
    Some(CodeAction {
        title: mend.title,
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![told.clone()]),
        edit: Some(workspace_edit(snapshot, &mend.edits)?),
        is_preferred: Some(mend.preferred),
        ..CodeAction::default()
    })
}

/// How often a text is read again while more can be mended.
const MOST_ROUNDS: usize = 20;

/// The document with all of its safe fixes made, and those that can be made then.
fn safe(snapshot: &Snapshot) -> Vec<Edit> {
    let root = snapshot.analysis.root;
    let Some(source) = snapshot.analysis.sources.get(root) else { return Vec::new() };
    let mut edits = safe_at_once(&snapshot.analysis);
    let mut text = source.text.clone();
    for _ in 0..MOST_ROUNDS {
        if edits.is_empty() {
            break;
        }
        for edit in edits.iter().rev() {
            text.replace_range(edit.span.range(), &edit.replacement);
        }
        edits = read_with(snapshot, text.clone()).map_or_else(Vec::new, |after| safe_at_once(&after));
    }
    let changed = line_edits(root, &source.text, &text);
    changed.into_iter().map(|(span, replacement)| Edit { span, replacement }).collect()
}

/// The changes of the safe fixes of a design's own file; of two that touch the same place the first.
fn safe_at_once(analysis: &Analysis) -> Vec<Edit> {
    let root = analysis.root;
    let mut chosen: Vec<Edit> = Vec::new();
    for found in analysis.diagnostics.iter().filter(|found| found.span.file == root) {
        for mend in fixes::mends(analysis, found).into_iter().filter(|mend| mend.safe) {
            let free = mend.edits.iter().all(|edit| {
                edit.span.file == root
                    && chosen
                        .iter()
                        .all(|other| edit.span.end < other.span.start || other.span.end < edit.span.start)
            });
            if free {
                chosen.extend(mend.edits);
            }
        }
    }
    chosen.sort_by_key(|edit| edit.span);
    chosen
}

fn whole(snapshot: &Snapshot, title: &str, kind: CodeActionKind, edits: Vec<Edit>) -> Option<CodeAction> {
    if edits.is_empty() {
        return None;
    }
    Some(CodeAction {
        title: title.to_owned(),
        kind: Some(kind),
        edit: Some(workspace_edit(snapshot, &edits)?),
        ..CodeAction::default()
    })
}

/// `None` where a place lies in a file that an editor cannot open.
fn workspace_edit(snapshot: &Snapshot, edits: &[Edit]) -> Option<WorkspaceEdit> {
    let mut changes: Vec<(Uri, Vec<TextEdit>)> = Vec::new();
    for edit in edits {
        let place = snapshot.location(edit.span)?;
        let change = TextEdit { range: place.range, new_text: edit.replacement.clone() };
        match changes.iter_mut().find(|(uri, _)| *uri == place.uri) {
            Some((_, of_file)) => of_file.push(change),
            None => changes.push((place.uri, vec![change])),
        }
    }
    Some(WorkspaceEdit { changes: Some(changes.into_iter().collect()), ..WorkspaceEdit::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_stand_below_each_other() {
        assert!(is_within("source.fixAll.ifs", "source.fixAll") && is_within("quickfix", ""));
        assert!(!is_within("source.fixAll", "source.fixAll.ifs") && !is_within("sourcery", "source"));
    }
}
