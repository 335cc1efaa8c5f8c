//! Shared pieces of the test suites: where the tree lies, and how programs are run.

#![allow(
    clippy::disallowed_methods,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "this crate is for tests: it reads files, and a failure ends the test"
)]

pub mod annotations;
pub mod imports;
pub mod referees;
pub mod sources;
pub mod suite;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// The root of the tree.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the crate lies in the tree")
}

/// An empty folder of a test's own, below `target/`.
pub fn scratch(test: &str) -> PathBuf {
    let folder = root().join("target/tmp/ifs-tests").join(test);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).expect("the scratch folder can be emptied");
    }
    std::fs::create_dir_all(&folder).expect("the scratch folder can be made");
    folder
}

/// The `ifs` program, built from the present sources in the profile of the running test.
pub fn program() -> Command {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    Command::new(PROGRAM.get_or_init(|| {
        let test = std::env::current_exe().expect("a test is a program");
        // target/<profile>/deps/<test>
        let folder = test.ancestors().nth(2).expect("tests are built below target/");
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(["build", "--quiet", "-p", "ifs-cli", "--bin", "ifs"]).current_dir(root());
        if folder.ends_with("release") {
            cargo.arg("--release");
        }
        assert!(cargo.status().expect("cargo runs").success(), "the program does not build");
        folder.join("ifs")
    }))
}
