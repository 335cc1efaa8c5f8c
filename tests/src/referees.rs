//! Runs the foreign referees of `tests/referees`. A referee that is not installed fails the test: `tests/setup.sh`
//! installs them all.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::root;

/// What a referee said.
#[derive(Debug)]
pub struct Verdict {
    /// Whether it found no fault.
    pub good: bool,
    /// Its line of counts.
    pub counts: serde_json::Value,
    /// The faults, as it words them.
    pub faults: String,
}

/// The Python with the referees' packages.
///
/// # Panics
/// They are not installed.
pub fn python() -> PathBuf {
    installed("target/referees/bin/python")
}

/// Runs a Python referee: `python_referee("curves.py", …)`.
///
/// # Panics
/// It is not installed, or it ends neither with a verdict of good (0) nor of bad (1).
pub fn python_referee(script: &str, arguments: &[&Path]) -> Verdict {
    let mut command = Command::new(python());
    // No __pycache__ in the tree, and no packages but the pinned ones.
    command.args(["-B", "-s"]).arg(root().join("tests/referees").join(script)).args(arguments);
    verdict(script, command)
}

/// Runs the glTF validator over GLB files; no error and no warning is good. The counts are of the first file.
///
/// # Panics
/// As [`python_referee`].
pub fn gltf_validator(files: &[&Path]) -> Verdict {
    installed("tests/referees/node_modules/gltf-validator/package.json");
    let mut command = Command::new("node");
    command.arg(root().join("tests/referees/glb.mjs")).args(files);
    verdict("glb.mjs", command)
}

/// Colours designs with the TextMate grammar, by VS Code's own engine; good where none of the words is without a colour.
///
/// # Panics
/// As [`python_referee`].
pub fn colours(words: &[&str], files: &[PathBuf]) -> Verdict {
    installed("tests/referees/node_modules/vscode-textmate/package.json");
    let mut command = Command::new("node");
    command.arg(root().join("tests/referees/colours.mjs")).arg(words.join(",")).args(files);
    verdict("colours.mjs", command)
}

/// The program that refines nets with OpenSubdiv.
///
/// # Panics
/// It is not built.
pub fn opensubdiv() -> PathBuf {
    installed("target/referees/opensubdiv")
}

fn installed(path: &str) -> PathBuf {
    let path = root().join(path);
    assert!(path.exists(), "{} is missing: run tests/setup.sh", path.display());
    path
}

fn verdict(name: &str, mut command: Command) -> Verdict {
    let Output { status, stdout, stderr } =
        command.output().unwrap_or_else(|error| panic!("{name} does not run ({error}): run tests/setup.sh"));
    let (stdout, faults) = (String::from_utf8_lossy(&stdout), String::from_utf8_lossy(&stderr).into_owned());
    let line = stdout.lines().next().unwrap_or_default();
    let counts = serde_json::from_str(line)
        .unwrap_or_else(|error| panic!("{name} printed no counts ({error}):\n{stdout}\n{faults}"));
    match status.code() {
        Some(code @ (0 | 1)) => Verdict { good: code == 0, counts, faults },
        _ => panic!("{name} ended with {status}:\n{faults}"),
    }
}
