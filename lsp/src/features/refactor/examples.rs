//! In the examples, what is offered and found to keep the meaning does: expressions of all of them are named and names
//! written out, and what is made is compared to the last digit.
#![allow(clippy::disallowed_methods, reason = "the test reads the examples")]

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use ifs_compiler::analysis::{analyse, read_indexed};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{MemoryFiles, Span};

use super::*;
use crate::features::walk::expressions;

/// What is made of a text: counts, values of parameters, boards.
fn made(text: &str) -> (Option<String>, Vec<String>) {
    let made = analyse(&MemoryFiles::single("design.ifs", text), "design.ifs", &Overrides::default());
    let elements = made.fabrications.iter().map(|made| format!("{:?}", made.elements)).collect();
    (made.plan.map(|plan| format!("{:?}", plan.counts)), elements)
}

#[test]
fn nothing_that_is_made_changes() {
    let read = |text: &str| {
        read_indexed(&MemoryFiles::single("design.ifs", text), "design.ifs", &Overrides::default())
    };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "ifs"));
    paths.sort();
    let (start, most) = (Instant::now(), Duration::from_secs(4));
    let (mut extracted, mut inlined) = (0, 0);
    // Each time round another expression of each example; slow machines go round less often.
    'all: for round in 0..40 {
        for path in &paths {
            let text = fs::read_to_string(path).unwrap();
            let before = read(&text);
            let mut spans: Vec<Span> = Vec::new();
            expressions(&before.files[0].parse.ast, |expr| spans.push(expr.span));
            let Some(span) = spans.get((round * 7919 + 13) % spans.len().max(1)).copied() else { continue };
            let names = (&mut extracted, extract(&before, span));
            let places = (&mut inlined, inline(&before, before.root, span.start));
            for (count, refactoring) in [names, places] {
                let Some(refactoring) = refactoring else { continue };
                let new = refactoring.applied(&text);
                if !refactoring.keeps(&before, &read(&new)) {
                    continue;
                }
                assert!(made(&text) == made(&new), "{}, {}:\n{new}", path.display(), refactoring.title);
                *count += 1;
            }
            if start.elapsed() > most {
                break 'all;
            }
        }
    }
    assert!(extracted > 5, "{extracted} extracted, {inlined} inlined");
    println!("{extracted} extracted, {inlined} inlined");
}
