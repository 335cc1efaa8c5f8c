//! Diagnostics for programs: one JSON object a line.

use super::{Diagnostic, Fix, Severity};
use crate::source::{SourceMap, Span};
use serde::Serialize;

#[derive(Serialize)]
struct JsonPlace<'a> {
    file: &'a str,
    byte_start: u32,
    byte_end: u32,
    line: u32,
    column: u32,
    end_line: u32,
    end_column: u32,
    text: &'a str,
}

#[derive(Serialize)]
struct JsonEdit<'a> {
    at: JsonPlace<'a>,
    replacement: &'a str,
}

#[derive(Serialize)]
struct JsonFix<'a> {
    title: String,
    edits: Vec<JsonEdit<'a>>,
}

#[derive(Serialize)]
struct JsonHint<'a> {
    text: &'a str,
    fixes: Vec<JsonFix<'a>>,
}

#[derive(Serialize)]
struct JsonDiagnostic<'a> {
    code: &'static str,
    severity: &'static str,
    message: &'a str,
    at: JsonPlace<'a>,
    also: Vec<JsonPlace<'a>>,
    notes: &'a [String],
    hints: Vec<JsonHint<'a>>,
}

/// One line of JSON, without its line end. Lines and columns start at 1; columns count characters.
pub fn render_json(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let severity = match diagnostic.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let hints = diagnostic.hints.iter().map(|hint| JsonHint {
        text: &hint.text,
        fixes: hint.fixes.iter().map(|fix| json_fix(fix, sources)).collect(),
    });
    let json = JsonDiagnostic {
        code: diagnostic.code.name(),
        severity,
        message: &diagnostic.message,
        at: place(diagnostic.span, &diagnostic.label, sources),
        also: diagnostic.labels.iter().map(|label| place(label.span, &label.text, sources)).collect(),
        notes: &diagnostic.notes,
        hints: hints.collect(),
    };
    serde_json::to_string(&json).unwrap_or_default()
}

fn json_fix<'a>(fix: &'a Fix, sources: &'a SourceMap) -> JsonFix<'a> {
    let edits = fix
        .edits
        .iter()
        .map(|edit| JsonEdit { at: place(edit.span, "", sources), replacement: &edit.replacement });
    JsonFix { title: fix.title(sources), edits: edits.collect() }
}

fn place<'a>(span: Span, text: &'a str, sources: &'a SourceMap) -> JsonPlace<'a> {
    let source = sources.get(span.file);
    let at = |offset| source.map(|source| source.lines.characters(&source.text, offset));
    let (start, end) = (at(span.start), at(span.end));
    JsonPlace {
        file: source.map_or("", |source| source.path.as_str()),
        byte_start: span.start,
        byte_end: span.end,
        line: start.map_or(0, |place| place.line + 1),
        column: start.map_or(0, |place| place.column + 1),
        end_line: end.map_or(0, |place| place.line + 1),
        end_column: end.map_or(0, |place| place.column + 1),
        text,
    }
}
