//! What holds for every text holds for the corpus and for random designs: no panic, an end, places inside the text, the
//! same twice. The fuzz targets in `fuzz/` check the same on many more.

#![allow(clippy::disallowed_methods, reason = "the tests read the corpus")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::cell::Cell;
use std::fs;
use std::path::PathBuf;

use ifs_tests::invariants::{MODEST, analysis_holds, parse_holds};
use ifs_tests::{generate, root, sources};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

/// Every text of the tree, and every text that once broke something.
fn texts() -> Vec<PathBuf> {
    let folders = ["tests/suite", "tests/corpus", "examples", "stdlib"];
    folders.iter().flat_map(|folder| sources::files(&root().join(folder), "ifs")).collect()
}

#[test]
fn the_corpus_holds() {
    let texts = texts();
    assert!(texts.len() > 100, "the corpus is gone");
    for path in texts {
        let bytes = fs::read(&path).unwrap();
        let found = parse_holds(&bytes).and_then(|()| analysis_holds(&bytes, MODEST));
        assert_eq!(found, Ok(()), "{}", path.display());
    }
}

#[test]
fn no_bytes_give_a_design_without_errors() {
    let text = generate::design(&[]);
    let found = ifs_tests::designs::analysis_of(&text);
    assert_eq!(found.plan.unwrap().plan.figures().len(), 1, "{text}");
}

/// Random designs hold, and enough of them are worked out: a generator of nonsense would test the type checker only.
#[test]
fn random_designs_hold() {
    let config = ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let (good, runs) = (Cell::new(0), Cell::new(0));
    let held = runner.run(&prop::collection::vec(any::<u8>(), 0..400), |bytes| {
        let text = generate::design(&bytes);
        let found = parse_holds(text.as_bytes()).and_then(|()| analysis_holds(text.as_bytes(), MODEST));
        prop_assert_eq!(found, Ok(()), "{}", text);
        runs.set(runs.get() + 1);
        good.set(good.get() + usize::from(is_good(&text)));
        Ok(())
    });
    assert!(held.is_ok(), "{}", held.unwrap_err());
    let (good, runs) = (good.get(), runs.get());
    assert!(good * 20 >= runs, "{good} of {runs} random designs have no errors");
}

fn is_good(text: &str) -> bool {
    use ifs_compiler::analysis::analyse;
    use ifs_compiler::hir::evaluate::Overrides;
    use ifs_compiler::source::MemoryFiles;
    let overrides = Overrides { limits: MODEST, ..Overrides::default() };
    !analyse(&MemoryFiles::single("a.ifs", text), "a.ifs", &overrides).has_errors()
}
