//! Whatever a text is, no feature panics at any place of it: examples, pages of the suite and the library, whole, cut off,
//! and with pieces of them taken out or moved.
#![allow(clippy::disallowed_methods, reason = "the test reads the designs")]

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use ifs_compiler::analysis::read_indexed;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{MemoryFiles, Span};

use super::facts::WorkedOut;
use super::*;

/// A generator of numbers that are the same each time (xorshift, Marsaglia 2003).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound.max(1) as u64) as usize
    }
}

fn designs(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            designs(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "ifs") {
            found.push(path);
        }
    }
}

/// Asks every feature at a place.
fn ask(text: &str, at: u32) {
    let files = MemoryFiles::single("design.ifs", text);
    let analysis = read_indexed(&files, "design.ifs", &Overrides::default());
    let root = analysis.root;
    let whole = Span::new(root, 0, text.len() as u32);
    let paths = || vec!["design.ifs".to_owned(), "parts/a.ifs".to_owned()];
    if let Some(found) = completion::completion(&analysis, root, at, &paths) {
        assert!(found.span.start <= at && at <= found.span.end, "{:?} at {at}", found.span);
        assert!(text.get(found.span.range()).is_some_and(|word| !word.contains('\n')), "{:?}", found.span);
    }
    if let Some(found) = signature::signature(&analysis, root, at) {
        assert!(found.active.is_none_or(|active| (active as usize) < found.parameters.len()));
    }
    let tokens = semantics::semantics(&analysis, root, None);
    assert!(tokens.is_sorted_by(|one, next| one.span.end <= next.span.start));
    for hint in hints::hints(&analysis, &Overrides::default(), None, whole) {
        assert!(text.is_char_boundary(hint.at as usize));
    }
    let selected = selection::selection(&analysis, root, at);
    assert!(selected.windows(2).all(|pair| pair[1].start <= pair[0].start && pair[0].end <= pair[1].end));
    assert_eq!(selected.last(), Some(&whole));
    assert!(folding::folding(&analysis, root).iter().all(|(from, to, _)| from < to));
    lens::lenses(&analysis, None, root);
    let known = WorkedOut { made: None, current: false, overrides: &Overrides::default() };
    hover::hover(&analysis, known, root, at);
    definition::definition(&analysis, root, at);
    references::references(&analysis, root, at);
    format::part_edits(&analysis, Span::new(root, at, at));
    if let Some(name) = calls::called_at(&analysis, root, at) {
        calls::outgoing(&analysis, name);
        calls::incoming(&analysis, name);
    }
    search::search(&analysis.files[0].parse.ast, "a");
}

/// The nearest bound of characters at or below a byte.
fn bound(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0)
}

#[test]
fn no_text_and_no_place_is_too_strange() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut paths = Vec::new();
    for folder in ["examples", "stdlib", "tests/suite"] {
        designs(&root.join(folder), &mut paths);
    }
    assert!(paths.len() > 100, "only {} designs", paths.len());
    let mut numbers = Numbers(0x1f5_2026);
    let (start, most) = (Instant::now(), Duration::from_secs(4));
    let mut asked = 0;
    // Each run takes another text; a slow machine gets through fewer of them.
    while start.elapsed() < most && asked < 600 {
        let path = &paths[numbers.below(paths.len())];
        let Ok(mut text) = fs::read_to_string(path) else { continue };
        if text.len() > 20_000 {
            continue;
        }
        match numbers.below(4) {
            0 => {}
            1 => text.truncate(bound(&text, numbers.below(text.len() + 1))),
            2 => {
                let from = bound(&text, numbers.below(text.len() + 1));
                let to = bound(&text, from + numbers.below(40)).max(from);
                text.replace_range(from..to, "");
            }
            _ => {
                let at = bound(&text, numbers.below(text.len() + 1));
                let pieces =
                    ["(", "}", "\"", "let ", ".", "12m", "😀", "\r\n", "use ", "{", "fabricate ", "//"];
                text.insert_str(at, pieces[numbers.below(pieces.len())]);
            }
        }
        let at = bound(&text, numbers.below(text.len() + 1)) as u32;
        let (asked_text, name) = (text.clone(), path.display());
        let done = std::panic::catch_unwind(|| ask(&asked_text, at));
        assert!(done.is_ok(), "{name} at {at}:\n{text}");
        asked += 1;
    }
    assert!(asked > 20, "only {asked} places in {most:?}");
}
