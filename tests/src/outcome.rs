//! Running a program to its end: exit code, and what it printed as text.

use std::io::Write;
use std::process::{Command, Stdio};

/// How a program ended and what it said.
#[derive(Debug)]
pub struct Outcome {
    /// The exit code; none where a signal ended it.
    pub code: Option<i32>,
    /// Its standard output.
    pub stdout: String,
    /// Its standard error.
    pub stderr: String,
}

/// Runs a command with an empty standard input.
pub fn run(command: &mut Command) -> Outcome {
    run_with(command, b"")
}

/// Runs a command that reads `input`.
pub fn run_with(command: &mut Command, input: &[u8]) -> Outcome {
    let child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = child.unwrap_or_else(|error| panic!("{command:?} does not run: {error}"));
    // A program that does not read its input is no fault of the test.
    let _ = child.stdin.take().unwrap().write_all(input);
    let done = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("all that is printed is UTF-8");
    Outcome { code: done.status.code(), stdout: text(done.stdout), stderr: text(done.stderr) }
}

impl Outcome {
    /// Asserts that all went well and nothing was said on stderr; returns what was printed.
    pub fn good(self) -> String {
        assert!(self.code == Some(0) && self.stderr.is_empty(), "{self:?}");
        self.stdout
    }

    /// Asserts a failure: this exit code, nothing on stdout, and every one of the parts on stderr; never a panic.
    pub fn failed(&self, code: i32, parts: &[&str]) {
        assert_eq!(self.code, Some(code), "{self:?}");
        assert_eq!(self.stdout, "", "{self:?}");
        assert!(!self.stderr.contains("panicked"), "{}", self.stderr);
        for part in parts {
            assert!(self.stderr.contains(part), "no {part:?} in:\n{}", self.stderr);
        }
    }

    /// Asserts a failure that still prints what is known: this exit code, and this on stderr; never a panic.
    pub fn failed_with_data(&self, code: i32, part: &str) {
        assert_eq!(self.code, Some(code), "{self:?}");
        assert!(self.stderr.contains(part) && !self.stderr.contains("panicked"), "{self:?}");
    }
}
