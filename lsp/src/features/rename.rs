//! Renaming: what can be renamed, to what, and what would clash.

use std::collections::BTreeSet;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Severity;
use ifs_compiler::hir::index::{DeclarationKind, Target};
use ifs_compiler::hir::tree::ItemKind;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;

use super::references::of_target;
use super::words::written;

/// What can be renamed at a place: its name there, and its declaration. Else why not.
pub(crate) fn prepare(analysis: &Analysis, file: FileId, offset: u32) -> Result<(Span, Span), String> {
    let Some(name) = analysis.index.name_at(file, offset) else {
        return Err("there is no name here".to_owned());
    };
    let word = written(analysis, name.span);
    match name.target {
        Target::Declared(_) if word == "self" => Err("`self` always has this name".to_owned()),
        Target::Declared(span) if analysis.hir.is_library(span.file) => {
            Err(format!("`{word}` is of the library, which cannot be changed"))
        }
        Target::Declared(span) if analysis.index.declaration(span).is_none() => {
            Err(format!("`{word}` is a word of the language here"))
        }
        Target::Declared(span) => Ok((name.span, span)),
        Target::Module(_) => Err("a file is renamed where it lies".to_owned()),
        _ => Err(format!("`{word}` is a word of the language")),
    }
}

/// The places to be changed so that what is declared at `declaration` is called `new`; or why that cannot be.
pub(crate) fn rename(analysis: &Analysis, declaration: Span, new: &str) -> Result<Vec<Span>, String> {
    let Some(declared) = analysis.index.declaration(declaration) else {
        return Err("there is nothing of that name any more".to_owned());
    };
    let is_type = matches!(declared.kind, DeclarationKind::Item(id)
        if matches!(analysis.hir.item(id).kind, ItemKind::Record(_)) || declared.name.starts_with(char::is_uppercase));
    spelt(new, is_type)?;
    let found = of_target(analysis, Target::Declared(declaration));
    clash(analysis, declaration, &found.uses, new)?;
    let mut places: Vec<Span> = found.uses.into_iter().chain([declaration]).collect();
    places.retain(|span| written(analysis, *span) == declared.name);
    places.sort();
    places.dedup();
    Ok(places)
}

/// Whether a word can be the name of a value, or of a type.
fn spelt(new: &str, is_type: bool) -> Result<(), String> {
    let rest = new.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let first = new.chars().next();
    if !rest || first.is_none_or(|c| c.is_ascii_digit()) {
        return Err(format!("`{new}` is no name: names are of letters, digits and `_`"));
    }
    let capital = first.is_some_and(|c| c.is_ascii_uppercase());
    let small = !new.chars().any(|c| c.is_ascii_uppercase());
    if is_type && !capital {
        return Err(format!("`{new}` is no name of a type: these start with a capital letter"));
    }
    if !is_type && !small {
        return Err(format!("`{new}` is no name of a value: these are written in small letters"));
    }
    if keyword(new) {
        return Err(format!("`{new}` is a word of the language"));
    }
    Ok(())
}

fn keyword(word: &str) -> bool {
    TokenKind::keywords().any(|kind| kind.text() == Some(word))
}

/// Whether the new name is taken where the thing is declared, or would be taken for something else where it is used.
fn clash(analysis: &Analysis, declaration: Span, uses: &[Span], new: &str) -> Result<(), String> {
    let Some(declared) = analysis.index.declaration(declaration) else { return Ok(()) };
    let others =
        analysis.index.declarations.iter().filter(|other| other.name == new && other.span != declaration);
    for other in others {
        let taken = match (declared.kind, other.kind) {
            (DeclarationKind::Item(_), DeclarationKind::Item(_)) => {
                other.span.file == declaration.file || uses.iter().any(|used| used.file == other.span.file)
            }
            (DeclarationKind::Field(mine, _), DeclarationKind::Field(theirs, _)) => mine == theirs,
            (
                DeclarationKind::Transform(mine) | DeclarationKind::Boundary(mine),
                DeclarationKind::Transform(theirs) | DeclarationKind::Boundary(theirs),
            ) => mine == theirs,
            // A local of that name hides the renamed one where both can be seen, or the other way round.
            _ => {
                let sees = |scope: Option<Span>, place: Span| {
                    scope.is_some_and(|scope| {
                        scope.file == place.file && scope.start <= place.start && place.end <= scope.end
                    })
                };
                uses.iter().any(|used| sees(other.scope, *used))
                    || sees(declared.scope, other.span)
                    || analysis
                        .index
                        .uses(Target::Declared(other.span))
                        .any(|used| sees(declared.scope, used))
            }
        };
        if taken {
            let source = analysis.sources.get(other.span.file);
            let place = source.map_or_else(String::new, |source| {
                format!(" in {}, line {}", source.path, source.lines.bytes(other.span.start).line + 1)
            });
            return Err(format!("`{new}` is already declared{place}"));
        }
    }
    Ok(())
}

/// Whether a design in which these places say `new` means what it meant before: no name stands for anything else, and no
/// mistake is new. Else why not.
pub(crate) fn same_meaning(
    before: &Analysis,
    after: &Analysis,
    changed: &[Span],
    new: &str,
) -> Result<(), String> {
    let moved = |span: Span| {
        let grown = |place: &Span| i64::from(new.len() as u32) - i64::from(place.end - place.start);
        let by = |offset: u32| {
            let earlier = changed.iter().filter(|place| place.file == span.file && place.end <= offset);
            (i64::from(offset) + earlier.map(grown).sum::<i64>()) as u32
        };
        Span::new(span.file, by(span.start), by(span.end))
    };
    let same = |span: Span| span;
    let names = |analysis: &Analysis, moved: &dyn Fn(Span) -> Span| -> BTreeSet<(Span, Target)> {
        let own = analysis.index.references.iter().filter(|name| !analysis.hir.is_library(name.span.file));
        own.map(|name| match name.target {
            Target::Declared(span) => (moved(name.span), Target::Declared(moved(span))),
            target => (moved(name.span), target),
        })
        .collect()
    };
    let place = |span: Span| {
        let source = after.sources.get(span.file)?;
        Some(format!(" in {}, line {}", source.path, source.lines.bytes(span.start).line + 1))
    };
    let errors = |analysis: &Analysis| {
        analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error).count()
    };
    let (were, are) = (names(before, &moved), names(after, &same));
    if let Some((span, _)) = were.symmetric_difference(&are).next() {
        let place = place(*span).unwrap_or_default();
        return Err(format!("`{new}` would be taken for something else{place}"));
    }
    if errors(after) > errors(before)
        && let Some(found) = after.diagnostics.iter().find(|found| found.severity() == Severity::Error)
    {
        let place = place(found.span).unwrap_or_default();
        return Err(format!("with `{new}`, {}{place}", found.message));
    }
    Ok(())
}
