//! Circles of `use`: files that use each other. Each is said once, where it closes, with every `use` on the way.

use super::ProjectFile;
use crate::diagnostic::{Code, Diagnostic};
use crate::source::{FileId, Span};
use std::collections::BTreeMap;

/// How many circles are told of.
const MOST_CIRCLES: usize = 20;

/// How many files of a circle are named.
const MOST_NAMED: usize = 50;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Visit {
    Never,
    Open,
    Done,
}

/// The circles of the files, found by walking from each file along its uses.
pub(super) fn circles(files: &[ProjectFile]) -> Vec<Diagnostic> {
    let places: BTreeMap<FileId, usize> =
        files.iter().enumerate().map(|(place, file)| (file.file, place)).collect();
    let mut visits = vec![Visit::Never; files.len()];
    let mut found = Vec::new();
    for start in 0..files.len() {
        if visits[start] != Visit::Never {
            continue;
        }
        visits[start] = Visit::Open;
        // Each file on the way with the number of its uses that have been followed.
        let mut way: Vec<(usize, usize)> = vec![(start, 0)];
        while let Some((place, followed)) = way.last_mut() {
            let place = *place;
            let Some((_, used)) = files[place].uses.get(*followed) else {
                visits[place] = Visit::Done;
                way.pop();
                continue;
            };
            *followed += 1;
            let Some(used) = places.get(used).copied() else { continue };
            match visits[used] {
                Visit::Done => {}
                Visit::Never => {
                    visits[used] = Visit::Open;
                    way.push((used, 0));
                }
                Visit::Open if found.len() < MOST_CIRCLES => found.push(circle(files, &way, used)),
                Visit::Open => {}
            }
        }
    }
    found
}

/// The circle that the last use on the way closes, by leading to `first`.
fn circle(files: &[ProjectFile], way: &[(usize, usize)], first: usize) -> Diagnostic {
    let begins = way.iter().position(|(place, _)| *place == first).unwrap_or(0);
    let links: Vec<(usize, Span)> = way[begins..]
        .iter()
        .filter_map(|(place, followed)| Some((*place, files[*place].uses.get(followed - 1)?.0)))
        .collect();
    let mut names: Vec<String> =
        links.iter().take(MOST_NAMED).map(|(place, _)| format!("`{}`", files[*place].path)).collect();
    if links.len() > MOST_NAMED {
        names.push(format!("{} more", links.len() - MOST_NAMED));
    }
    let back = format!("`{}`", files[first].path);
    let at = links.last().map_or(Span::default(), |(_, span)| *span);
    let message = match names.as_slice() {
        [only] => format!("{only} uses itself"),
        _ => format!("files use each other in a circle: {} → {back}", names.join(" → ")),
    };
    let mut diagnostic = Diagnostic::new(Code::E0311, at, message).label("closes the circle");
    let others = links.len().saturating_sub(1).min(MOST_NAMED);
    for (link, (place, span)) in links[..others].iter().enumerate() {
        let next = links.get(link + 1).map_or("", |(next, _)| files[*next].path.as_str());
        diagnostic = diagnostic.also(*span, format!("`{}` uses `{next}`", files[*place].path));
    }
    match names.len() {
        1 => diagnostic.hint("remove it: a file knows its own items"),
        _ => diagnostic.hint("move what both need into a file of its own, which uses neither"),
    }
}
