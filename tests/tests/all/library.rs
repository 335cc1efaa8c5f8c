//! The documentation of the library: every example in it can be used as it stands, and the page of all is up to date
//! (`UPDATE=1` rewrites it).
#![allow(clippy::disallowed_methods, reason = "the tests read and rewrite the documentation")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;

use ifs_compiler::analysis::{analyse, run_tests};
use ifs_compiler::diagnostic::Code;
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::hir::{library_docs, library_page};
use ifs_compiler::source::MemoryFiles;
use ifs_tests::{root, suite};

/// The mesh that examples import.
const JOINT: &[u8] = include_bytes!("../../suite/meshes/joint.glb");

/// The designs in a doc comment.
fn designs(docs: &[String]) -> Vec<String> {
    let mut found = Vec::new();
    let mut lines = docs.iter();
    while let Some(line) = lines.next() {
        if let Some(words) = line.trim_start().strip_prefix("```") {
            let inner: Vec<&str> =
                lines.by_ref().map(String::as_str).take_while(|line| line.trim() != "```").collect();
            if words.split_whitespace().next() == Some("ifs") {
                found.push(inner.join("\n"));
            }
        }
    }
    found
}

#[test]
fn every_example_in_the_library_can_be_used() {
    let (mut seen, mut faults) = (0, Vec::new());
    for module in library_docs() {
        let own = (module.path(), module.docs.clone());
        let items =
            module.items.iter().map(|item| (format!("{}.{}", module.path(), item.name), item.docs.clone()));
        for (name, docs) in [own].into_iter().chain(items) {
            for design in designs(&docs) {
                seen += 1;
                let overrides = Overrides::default();
                let files = MemoryFiles::single("design.ifs", &design).with("joint.glb", JOINT);
                let analysis = analyse(&files, "design.ifs", &overrides);
                let tested = run_tests(&analysis, &overrides);
                let tested = tested.iter().flat_map(|result| &result.diagnostics);
                // That irrational coefficients are rounded is said wherever it is so.
                let said =
                    analysis.diagnostics.iter().chain(tested).filter(|found| found.code != Code::W0546);
                faults.extend(said.map(|found| format!("{name}: {} {}", found.code.name(), found.message)));
            }
        }
    }
    assert!(seen >= 20, "only {seen} examples");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_page_of_the_library_is_up_to_date() {
    let path = root().join("docs/library.md");
    let page = library_page();
    if suite::is_update() {
        fs::write(&path, &page).unwrap();
    }
    assert!(fs::read_to_string(&path).unwrap_or_default() == page, "UPDATE=1 rewrites docs/library.md");
}
