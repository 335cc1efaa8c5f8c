//! What editors show beside the text: hints, lenses, folds, selections; and the layout of a part.

use ifs_compiler::source::Span;
use serde_json::json;
use tower_lsp::ls_types::*;

use crate::features::{folding, format, hints, lens, selection};
use crate::protocol::commands::{BUILD, Commands, PREVIEW, SHOW_REPORT};
use crate::world::Snapshot;

fn part(snapshot: &Snapshot, range: Range) -> Span {
    Span::new(snapshot.analysis.root, snapshot.offset(range.start), snapshot.offset(range.end))
}

pub(super) fn hints(snapshot: &Snapshot, range: Range) -> Vec<InlayHint> {
    let root = snapshot.analysis.root;
    // What came out last stays while the text is unfinished: nothing beside it comes and goes at every letter.
    let made = snapshot.made.as_ref();
    let now = |then: Span| made.and_then(|made| made.place(then));
    let facts = made.map(|made| hints::Facts { made: &made.analysis, now: &now });
    let found = hints::hints(&snapshot.analysis, &snapshot.overrides, facts, part(snapshot, range));
    let hints = found.into_iter().map(|hint| {
        let position = snapshot.range(Span::new(root, hint.at, hint.at)).start;
        let edit = |new_text| TextEdit { range: Range { start: position, end: position }, new_text };
        InlayHint {
            position,
            label: InlayHintLabel::String(hint.text),
            kind: match hint.kind {
                hints::Kind::Type => Some(InlayHintKind::TYPE),
                hints::Kind::Parameter => Some(InlayHintKind::PARAMETER),
                hints::Kind::Fact => None,
            },
            text_edits: hint.insert.map(|text| vec![edit(text)]),
            tooltip: None,
            padding_left: (hint.kind == hints::Kind::Fact).then_some(true),
            padding_right: (hint.kind == hints::Kind::Parameter).then_some(true),
            data: None,
        }
    });
    hints.collect()
}

/// The lenses whose command the client can carry out, and those that only say something.
pub(super) fn lenses(snapshot: &Snapshot, uri: &Uri, known: Commands) -> Vec<CodeLens> {
    let design =
        snapshot.path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let made = snapshot.made.as_ref().map(|made| &*made.analysis);
    let found = lens::lenses(&snapshot.analysis, made, snapshot.analysis.root);
    let lenses = found.into_iter().filter_map(|found| {
        let of_design = vec![json!(uri.as_str())];
        let (is_known, title, command, arguments) = match found.shows {
            lens::Shows::Said(words) => (true, words, "", None),
            lens::Shows::Build => (known.build, format!("build {design}"), BUILD, Some(of_design)),
            lens::Shows::Report => {
                (known.show_report, format!("show report of {design}"), SHOW_REPORT, Some(of_design))
            }
            lens::Shows::Preview(figure) => {
                let title = format!("preview outputs of {figure}");
                (known.preview, title, PREVIEW, Some(vec![json!(uri.as_str()), json!(figure)]))
            }
        };
        let command = Command { title, command: command.to_owned(), arguments };
        is_known.then(|| CodeLens { range: snapshot.range(found.span), command: Some(command), data: None })
    });
    lenses.collect()
}

pub(super) fn folding(snapshot: &Snapshot) -> Vec<FoldingRange> {
    let found = folding::folding(&snapshot.analysis, snapshot.analysis.root);
    let folds = found.into_iter().map(|(start_line, end_line, fold)| FoldingRange {
        start_line,
        end_line,
        kind: match fold {
            folding::Fold::Comment => Some(FoldingRangeKind::Comment),
            folding::Fold::Imports => Some(FoldingRangeKind::Imports),
            folding::Fold::Code => None,
        },
        ..FoldingRange::default()
    });
    folds.collect()
}

pub(super) fn selections(snapshot: &Snapshot, positions: &[Position]) -> Vec<SelectionRange> {
    let root = snapshot.analysis.root;
    let chain = |position: &Position| {
        let spans = selection::selection(&snapshot.analysis, root, snapshot.offset(*position));
        let outer_first = spans.into_iter().rev();
        outer_first.fold(None, |parent, span| {
            Some(SelectionRange { range: snapshot.range(span), parent: parent.map(Box::new) })
        })
    };
    let nothing = |position: &Position| SelectionRange {
        range: Range { start: *position, end: *position },
        parent: None,
    };
    // Each position has its answer, in their order.
    positions.iter().map(|position| chain(position).unwrap_or_else(|| nothing(position))).collect()
}

pub(super) fn format_part(snapshot: &Snapshot, range: Range) -> Option<Vec<TextEdit>> {
    let edits = format::part_edits(&snapshot.analysis, part(snapshot, range))?;
    Some(edits.into_iter().map(|(span, text)| snapshot.edit(span, text)).collect())
}

pub(super) fn format_ended(snapshot: &Snapshot, position: Position) -> Option<Vec<TextEdit>> {
    let edits = format::ended_edits(&snapshot.analysis, snapshot.analysis.root, snapshot.offset(position))?;
    Some(edits.into_iter().map(|(span, text)| snapshot.edit(span, text)).collect())
}
