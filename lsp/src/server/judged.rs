//! Mends tried before they are offered: the changed design is read, and what it says then tells good ones from bad ones.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Severity};

use super::neighbours::read_with;
use crate::features::fixes::Mend;
use crate::world::Snapshot;
use crate::world::project_file::project_file;

/// The most mends of one diagnostic that are tried; the others are offered as they are.
const MOST_TRIED: usize = 8;

/// How good a mend is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Verdict {
    /// Nothing is wrong at its place any more.
    Good,
    /// Something else is wrong there then, which may have been wrong before.
    Doubtful,
    /// The text is worse with it.
    Bad,
}

/// The mends without bad ones, good ones first; only one that is good alone is preferred.
pub(super) fn judged(snapshot: &Snapshot, found: &Diagnostic, mends: Vec<Mend>) -> Vec<Mend> {
    let mut judged: Vec<(Verdict, Mend)> = Vec::new();
    for (place, mut mend) in mends.into_iter().enumerate() {
        let verdict = if place < MOST_TRIED { verdict(snapshot, found, &mend) } else { Verdict::Good };
        mend.preferred &= verdict == Verdict::Good;
        judged.push((verdict, mend));
    }
    judged.retain(|(verdict, _)| *verdict != Verdict::Bad);
    judged.sort_by_key(|(verdict, _)| *verdict);
    judged.into_iter().map(|(_, mend)| mend).collect()
}

fn verdict(snapshot: &Snapshot, found: &Diagnostic, mend: &Mend) -> Verdict {
    let before = &snapshot.analysis;
    let Some(source) = before.sources.get(before.root) else { return Verdict::Good };
    // What is changed in another file is not read here, nor is an `ifs.toml` a design.
    if project_file(before) == Some(before.root)
        || mend.edits.iter().any(|edit| edit.span.file != before.root)
    {
        return Verdict::Good;
    }
    let mut text = source.text.clone();
    for edit in mend.edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.replacement);
    }
    let Some(after) = read_with(snapshot, text) else { return Verdict::Good };
    let is_form = |one: &Diagnostic| one.code.name().starts_with("E01") || one.code.name().starts_with("E02");
    if errors(&after).count() > errors(before).count() && !is_form(found) {
        return Verdict::Bad;
    }
    let is_new =
        |one: &&Diagnostic| errors(before).all(|old| old.code != one.code || old.message != one.message);
    let new = errors(&after).filter(is_new).map(|one| match nearness(&after, one, mend) {
        Nearness::Touching if is_form(one) => Verdict::Bad,
        Nearness::Touching | Nearness::SameLine => Verdict::Doubtful,
        Nearness::Elsewhere => Verdict::Good,
    });
    new.max().unwrap_or(Verdict::Good)
}

/// Where something is wrong in a changed text.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Nearness {
    /// In what was written, or right behind it.
    Touching,
    /// On a line of it.
    SameLine,
    Elsewhere,
}

fn errors(analysis: &Analysis) -> impl Iterator<Item = &Diagnostic> {
    analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error)
}

/// How near to a change a diagnostic of the changed text begins.
fn nearness(after: &Analysis, found: &Diagnostic, mend: &Mend) -> Nearness {
    let Some(source) = after.sources.get(after.root).filter(|source| source.id == found.span.file) else {
        return Nearness::Elsewhere;
    };
    let line = |offset: u32| source.lines.bytes(offset).line;
    let at = found.span.start;
    let mut moved = 0_i64;
    let of_edits = mend.edits.iter().map(|edit| {
        let start = (i64::from(edit.span.start) + moved).max(0) as u32;
        let end = start + edit.replacement.len() as u32;
        moved += edit.replacement.len() as i64 - i64::from(edit.span.end - edit.span.start);
        let between = source.text.get(end as usize..at.max(end) as usize).unwrap_or("");
        let overlap = at <= end && start <= found.span.end;
        if overlap || start <= at && between.trim().is_empty() {
            Nearness::Touching
        } else if (line(start)..=line(end)).contains(&line(at)) {
            Nearness::SameLine
        } else {
            Nearness::Elsewhere
        }
    });
    of_edits.min().unwrap_or(Nearness::Elsewhere)
}
