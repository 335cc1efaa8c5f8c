//! The tree itself: imports go one way, every file says what it is for, and none grows too long.
#![allow(clippy::disallowed_methods, reason = "the tests read the sources")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;

use ifs_tests::{imports, root, sources};

#[test]
fn imports_go_one_way() {
    let mut faults = Vec::new();
    for house in [imports::COMPILER, imports::SERVER] {
        let source = root().join(house.sources);
        let files = sources::files(&source, "rs");
        assert!(files.len() > 1);
        for path in files {
            let name = path.strip_prefix(&source).unwrap();
            let found = imports::faults(house, name, &fs::read_to_string(&path).unwrap());
            faults.extend(found.into_iter().map(|fault| format!("{}: {fault}", path.display())));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn every_source_says_what_it_is_for_and_is_short() {
    let mut faults = Vec::new();
    for part in ["compiler", "cli", "lsp", "tests", "benches", "fuzz/fuzz_targets"] {
        let files = sources::files(&root().join(part), "rs");
        assert!(!files.is_empty(), "{part}");
        for path in files {
            let found = sources::faults(&fs::read_to_string(&path).unwrap());
            faults.extend(found.into_iter().map(|fault| format!("{} {fault}", path.display())));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Lock files name packages, not the places one machine fetched them from.
#[test]
fn the_lock_of_the_referees_names_public_places_only() {
    let text = fs::read_to_string(root().join("tests/referees/package-lock.json")).unwrap();
    let lock: serde_json::Value = serde_json::from_str(&text).unwrap();
    for (name, package) in lock["packages"].as_object().unwrap() {
        let place = package["resolved"].as_str().unwrap_or("https://registry.npmjs.org/");
        assert!(place.starts_with("https://registry.npmjs.org/"), "{name}: {place}");
        assert!(name.is_empty() || package["integrity"].is_string(), "{name} has no checksum");
    }
}

/// What the README tells a person to run is what every commit must pass.
#[test]
fn the_readme_and_the_gate_run_the_same_tests() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let gate = fs::read_to_string(root().join(".ci/run")).unwrap();
    let commands: Vec<&str> =
        readme.split("```sh\n").skip(1).map(|block| block.split("\n```").next().unwrap()).collect();
    assert_eq!(commands.len(), 2, "two commands remain two commands: {commands:?}");
    assert_eq!(gate.lines().last(), Some(commands[1]));
}
