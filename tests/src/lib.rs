//! Shared pieces of the test suites: where the tree lies, and how programs are run.

#![allow(
    clippy::disallowed_methods,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "this crate is for tests: it reads files, and a failure ends the test"
)]

pub mod annotations;
pub mod client;
pub mod designs;
pub mod fraction;
pub mod generate;
pub mod imports;
pub mod invariants;
pub mod layout;
pub mod outcome;
pub mod pages;
pub mod programs;
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
    Command::new(program_path(is_release()))
}

/// The `ifs` program of the other profile than the running test's, built from the present sources: release for a debug
/// test and the other way round.
pub fn other_program() -> Command {
    Command::new(program_path(!is_release()))
}

/// Where the `ifs` program of a profile lies, after it has been built.
pub fn program_path(release: bool) -> &'static Path {
    static BUILT: [OnceLock<PathBuf>; 2] = [OnceLock::new(), OnceLock::new()];
    BUILT[usize::from(release)].get_or_init(|| {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        // As the README's command selects it, so that one build serves both.
        cargo.args(["build", "--quiet", "--bin", "ifs"]).current_dir(root());
        if release {
            cargo.arg("--release");
        }
        assert!(cargo.status().expect("cargo runs").success(), "the program does not build");
        profile_folder().with_file_name(if release { "release" } else { "debug" }).join("ifs")
    })
}

/// `target/<profile>` of the running test, which is `target/<profile>/deps/<test>`.
fn profile_folder() -> PathBuf {
    let test = std::env::current_exe().expect("a test is a program");
    test.ancestors().nth(2).expect("tests are built below target/").to_path_buf()
}

/// Whether the running test is built for release.
pub fn is_release() -> bool {
    profile_folder().ends_with("release")
}
