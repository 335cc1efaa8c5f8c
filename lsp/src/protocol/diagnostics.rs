//! Diagnostics of the compiler as the protocol has them: notes and hints join the message, labels are related places.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Code, Diagnostic, Severity};
use tower_lsp::ls_types as lsp;

use super::convert::range;
use super::uri::uri_of;
use crate::world::documents::Encoding;
use crate::world::places::Places;

/// What stands in the message behind the sentence itself.
fn message(diagnostic: &Diagnostic) -> String {
    let mut text = diagnostic.message.clone();
    if !diagnostic.label.is_empty() && !text.contains(&diagnostic.label) {
        text += &format!(" ({})", diagnostic.label);
    }
    for note in &diagnostic.notes {
        text += &format!("\nnote: {note}");
    }
    for hint in &diagnostic.hints {
        text += &format!("\nhelp: {}", hint.text);
    }
    text
}

/// The diagnostic as the client shows it.
pub(crate) fn diagnostic(
    places: &Places,
    analysis: &Analysis,
    found: &Diagnostic,
    encoding: Encoding,
) -> lsp::Diagnostic {
    let related = found.labels.iter().filter_map(|label| {
        let uri = uri_of(&places.names, &places.path(analysis, label.span.file)?)?;
        let location = lsp::Location { uri, range: range(analysis, label.span, encoding) };
        Some(lsp::DiagnosticRelatedInformation { location, message: label.text.clone() })
    });
    let related: Vec<_> = related.collect();
    lsp::Diagnostic {
        range: range(analysis, found.span, encoding),
        severity: Some(match found.severity() {
            Severity::Error => lsp::DiagnosticSeverity::ERROR,
            Severity::Warning => lsp::DiagnosticSeverity::WARNING,
        }),
        code: Some(lsp::NumberOrString::String(found.code.name().to_owned())),
        source: Some("ifs".to_owned()),
        message: message(found),
        related_information: (!related.is_empty()).then_some(related),
        tags: (found.code == Code::W0307).then(|| vec![lsp::DiagnosticTag::UNNECESSARY]),
        ..lsp::Diagnostic::default()
    }
}

/// The diagnostic for a client that shows no related places: they are told in the message.
pub(crate) fn without_related(
    places: &Places,
    analysis: &Analysis,
    found: &Diagnostic,
    encoding: Encoding,
) -> lsp::Diagnostic {
    let mut said = diagnostic(places, analysis, found, encoding);
    said.related_information = None;
    for label in &found.labels {
        let line = range(analysis, label.span, encoding).start.line + 1;
        let elsewhere = analysis.sources.get(label.span.file).filter(|file| file.id != found.span.file);
        let file = elsewhere.map_or_else(String::new, |file| format!("{}, ", file.path));
        said.message += &format!("\n{file}line {line}: {}", label.text);
    }
    said
}
