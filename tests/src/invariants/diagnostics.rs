//! A diagnostic is well-formed: its places lie in the texts, and all its forms can be printed.

use ifs_compiler::diagnostic::{Diagnostic, HumanStyle, render_human, render_json, render_short};
use ifs_compiler::source::{SourceMap, Span};

use super::{Holds, holds};

/// At most so many are drawn: the drawing of thousands takes longer than finding them.
const DRAWN: usize = 30;

/// All forms of the diagnostics, after every check of them.
pub(super) fn printed(diagnostics: &[Diagnostic], sources: &SourceMap) -> Result<String, String> {
    let mut text = String::new();
    for diagnostic in diagnostics {
        well_formed(diagnostic, sources)?;
    }
    for diagnostic in diagnostics.iter().take(DRAWN) {
        text.push_str(&forms(diagnostic, sources)?);
    }
    Ok(text)
}

fn well_formed(diagnostic: &Diagnostic, sources: &SourceMap) -> Holds {
    let name = diagnostic.code.name();
    holds(!diagnostic.message.trim().is_empty(), || format!("{name} says nothing"))?;
    lies_inside(diagnostic.span, sources).map_err(|why| format!("{name}: {why}"))?;
    for label in &diagnostic.labels {
        lies_inside(label.span, sources).map_err(|why| format!("{name}, `{}`: {why}", label.text))?;
    }
    for fix in diagnostic.fixes() {
        for edit in &fix.edits {
            lies_inside(edit.span, sources).map_err(|why| format!("{name}, a fix: {why}"))?;
        }
        let ordered = fix.edits.windows(2).all(|pair| pair[0].span.end < pair[1].span.start);
        holds(ordered && !fix.edits.is_empty(), || format!("{name}: the places of {fix:?} overlap"))?;
    }
    Ok(())
}

/// A span lies in its text, from character to character.
pub(super) fn lies_inside(span: Span, sources: &SourceMap) -> Holds {
    let source = sources.get(span.file).ok_or_else(|| format!("{span:?} is in no file"))?;
    let found = span.start <= span.end && source.text.get(span.range()).is_some();
    holds(found, || format!("{span:?} is no part of its text of {} bytes", source.text.len()))
}

fn forms(diagnostic: &Diagnostic, sources: &SourceMap) -> Result<String, String> {
    let name = diagnostic.code.name();
    let short = render_short(diagnostic, sources);
    let plain = HumanStyle { color: false, unicode: true };
    let human = render_human(diagnostic, sources, plain);
    let coloured = render_human(diagnostic, sources, HumanStyle { color: true, unicode: false });
    let json = render_json(diagnostic, sources);
    for form in [&short, &human, &coloured, &json] {
        holds(form.contains(name), || format!("{name} is not named in: {form}"))?;
    }
    holds(short.lines().count() == 1, || format!("{name} is short in several lines: {short}"))?;
    let value: serde_json::Value =
        serde_json::from_str(&json).map_err(|error| format!("{name} as JSON: {error}"))?;
    holds(!json.contains('\n') && value["code"] == name, || format!("{name} is no line of JSON: {json}"))?;
    Ok(short + &human + &json)
}
