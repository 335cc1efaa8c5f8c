//! Diagnostics for people: ariadne's drawing with the source lines, or one short line.

use super::{Diagnostic, Severity};
use crate::source::{Source, SourceMap, Span};
use ariadne::{CharSet, Color, Config, IndexType, Label, Report, ReportKind};
use std::ops::Range;

/// How the drawing looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HumanStyle {
    /// Whether terminal colours are used.
    pub color: bool,
    /// Whether box-drawing characters are used; else ASCII.
    pub unicode: bool,
}

/// Lines longer than this many bytes are not drawn, only named.
const LONGEST_DRAWN_LINE: usize = 400;

type Place = (String, Range<usize>);

/// The drawing, with a line end.
pub fn render_human(diagnostic: &Diagnostic, sources: &SourceMap, style: HumanStyle) -> String {
    let Some(source) = sources.get(diagnostic.span.file) else {
        return undrawn(diagnostic, sources);
    };
    let mut spans = vec![diagnostic.span];
    spans.extend(diagnostic.labels.iter().map(|label| label.span));
    if spans.iter().any(|span| sources.get(span.file).is_none_or(|source| !drawable(source, *span))) {
        return undrawn(diagnostic, sources);
    }
    let color = match diagnostic.severity() {
        Severity::Error => Color::Red,
        Severity::Warning => Color::Yellow,
    };
    let kind = match diagnostic.severity() {
        Severity::Error => ReportKind::Error,
        Severity::Warning => ReportKind::Warning,
    };
    let charset = if style.unicode { CharSet::Unicode } else { CharSet::Ascii };
    let config = Config::default()
        .with_color(style.color)
        .with_char_set(charset)
        .with_index_type(IndexType::Byte)
        .with_tab_width(4);
    let at = clamp(source, diagnostic.span);
    // A place without a word about it would not be marked at all.
    let said = if diagnostic.label.is_empty() { "here" } else { &diagnostic.label };
    let label = Label::new(at.clone()).with_message(said).with_color(color).with_priority(1);
    let mut report = Report::build(kind, at)
        .with_code(diagnostic.code.name())
        .with_message(&diagnostic.message)
        .with_config(config)
        .with_label(label);
    for other in &diagnostic.labels {
        if let Some(source) = sources.get(other.span.file) {
            let place = clamp(source, other.span);
            report.add_label(Label::new(place).with_message(&other.text).with_color(Color::Cyan));
        }
    }
    for note in &diagnostic.notes {
        report.add_note(note);
    }
    for hint in &diagnostic.hints {
        report.add_help(&hint.text);
    }
    let cache = ariadne::sources(sources.iter().map(|source| (source.path.clone(), source.text.as_str())));
    let mut out = Vec::new();
    match report.finish().write(cache, &mut out) {
        Ok(()) => String::from_utf8_lossy(&out).into_owned(),
        Err(_) => undrawn(diagnostic, sources),
    }
}

/// One line: `path:line:column: error[E0301]: message`, with its line end.
pub fn render_short(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let severity = match diagnostic.severity() {
        Severity::Error => "error",
        Severity::Warning => "warning",
    };
    let (code, message) = (diagnostic.code.name(), &diagnostic.message);
    match sources.get(diagnostic.span.file) {
        Some(source) => {
            let at = source.lines.characters(&source.text, diagnostic.span.start);
            let (line, column) = (at.line + 1, at.column + 1);
            format!("{}:{line}:{column}: {severity}[{code}]: {message}\n", source.path)
        }
        None => format!("{severity}[{code}]: {message}\n"),
    }
}

fn undrawn(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let mut text = render_short(diagnostic, sources);
    for note in &diagnostic.notes {
        text.push_str(&format!("  note: {note}\n"));
    }
    for hint in &diagnostic.hints {
        text.push_str(&format!("  help: {}\n", hint.text));
    }
    text
}

fn drawable(source: &Source, span: Span) -> bool {
    let first = source.lines.bytes(span.start).line;
    let last = source.lines.bytes(span.end).line;
    [first, last].iter().all(|line| {
        let start = source.lines.line_start(*line).unwrap_or(0) as usize;
        let end = source.lines.line_start(line + 1).map_or(source.text.len(), |end| end as usize);
        end - start <= LONGEST_DRAWN_LINE
    })
}

fn clamp(source: &Source, span: Span) -> Place {
    use crate::source::floor_boundary;
    let start = floor_boundary(&source.text, span.start as usize);
    let mut end = floor_boundary(&source.text, span.end as usize).max(start);
    if end == start {
        end += source.text[start..].chars().next().map_or(0, char::len_utf8);
    }
    (source.path.clone(), start..end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Code;

    #[test]
    fn a_drawing_shows_the_line_over_non_ascii_text() {
        let mut sources = SourceMap::default();
        let file = sources.add("a.ifs", "// größe 😀\nlet a = bb\n");
        let at = sources.get(file).unwrap().text.find("bb").unwrap() as u32;
        let diagnostic = Diagnostic::new(Code::E0301, Span::new(file, at, at + 2), "there is no `bb`")
            .label("not found")
            .hint("did you mean `b`?")
            .note("names are looked up here");
        let text = render_human(&diagnostic, &sources, HumanStyle { color: false, unicode: true });
        assert!(text.contains("let a = bb") && text.contains("a.ifs:2:9"), "{text}");
        assert!(text.contains("did you mean") && text.contains("not found"), "{text}");
        assert_eq!(render_short(&diagnostic, &sources), "a.ifs:2:9: error[E0301]: there is no `bb`\n");
    }

    #[test]
    fn a_span_anywhere_draws_something() {
        let mut sources = SourceMap::default();
        let file = sources.add("a.ifs", "ß\n");
        for start in 0..6 {
            for end in 0..6 {
                let diagnostic = Diagnostic::new(Code::E0102, Span::new(file, start, end), "odd");
                let style = HumanStyle { color: false, unicode: false };
                assert!(render_human(&diagnostic, &sources, style).contains("odd"));
            }
        }
    }
}
