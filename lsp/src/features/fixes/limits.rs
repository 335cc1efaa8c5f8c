//! Two requirements that exclude each other: one of the two is taken out, or both become one range.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{Comparison, EntryKind, ItemKind, Limit, Requirement};

use crate::features::words::written;

/// Either of the two out; where each has one end, the two ends the other way round.
pub(super) fn one_of_two(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let Some(other) = found.labels.first().map(|label| label.span) else { return Vec::new() };
    let mut fixes: Vec<Fix> = [found.span, other]
        .into_iter()
        .map(|line| {
            let what = written(analysis, line);
            Fix::titled(format!("remove `{what}`")).with(line, "")
        })
        .collect();
    let ends = requirement(analysis, found.span).zip(requirement(analysis, other));
    if let Some((second, first)) = ends
        && let (Limit::Compare(one, a), Limit::Compare(two, b)) = (&second.limit, &first.limit)
        && is_least(*one).zip(is_least(*two)).is_some_and(|(one, two)| one != two)
    {
        // The two cannot be: with the limits exchanged they can.
        let [a, b] = [a.span, b.span];
        let (low, high) = if is_least(*one) == Some(true) { (b, a) } else { (a, b) };
        let [low, high] = [low, high].map(|end| written(analysis, end).to_owned());
        let line = format!("require {} in {low} .. {high}", second.measure.text);
        fixes.push(Fix::titled(format!("write both as `{line}`")).with(found.span, line).with(other, ""));
    }
    fixes
}

fn is_least(comparison: Comparison) -> Option<bool> {
    match comparison {
        Comparison::AtLeast | Comparison::Greater => Some(true),
        Comparison::AtMost | Comparison::Less => Some(false),
        Comparison::Equal | Comparison::NotEqual => None,
    }
}

fn requirement(analysis: &Analysis, line: Span) -> Option<&Requirement> {
    let file = analysis.files.iter().find(|file| file.file == line.file)?;
    let blocks = file.parse.ast.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Fabricate(block) => Some(block),
        _ => None,
    });
    blocks.flat_map(|block| &block.entries).find_map(|entry| match &entry.kind {
        EntryKind::Require(requirement) if entry.span == line => Some(requirement),
        _ => None,
    })
}
