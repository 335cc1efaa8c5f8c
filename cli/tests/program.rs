//! The `ifs` program as a process: exit codes, and what happens when nobody reads what it prints.
#![allow(clippy::disallowed_methods, reason = "the tests start processes and open devices")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs::OpenOptions;
use std::process::{Command, Stdio};

fn ifs(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ifs"));
    command.args(arguments);
    command
}

#[test]
fn help_and_version_are_data() {
    for argument in ["--help", "--version", "-h"] {
        let done = ifs(&[argument]).output().unwrap();
        assert_eq!(done.status.code(), Some(0));
        assert!(String::from_utf8(done.stdout).unwrap().contains("ifs"));
        assert!(done.stderr.is_empty());
    }
}

#[test]
fn wrong_usage_is_2_and_a_message() {
    for arguments in [&[][..], &["--nonsense"], &["build"], &["build", "a.ifs", "--set", "x"], &["explain"]] {
        let done = ifs(arguments).output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{arguments:?}");
        assert!(done.stdout.is_empty());
        assert!(!done.stderr.is_empty());
    }
}

#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let done = ifs(&["--help"]).stdout(writer).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{done:?}");
    assert!(done.stderr.is_empty(), "{done:?}");
}

#[test]
fn closed_streams_are_no_panic() {
    for (line, code) in
        [("\"$0\" --help >&-", 0), ("\"$0\" build >&- 2>&-", 2), ("\"$0\" build 2>/dev/full", 2)]
    {
        let done = Command::new("sh").args(["-c", line, env!("CARGO_BIN_EXE_ifs")]).output().unwrap();
        assert_eq!(done.status.code(), Some(code), "{line}: {done:?}");
    }
}

#[test]
fn a_full_disk_under_stdout_is_3() {
    let full = OpenOptions::new().write(true).open("/dev/full").unwrap();
    let done = ifs(&["--help"]).stdout(full).stderr(Stdio::piped()).output().unwrap();
    assert_eq!(done.status.code(), Some(3));
    assert!(
        String::from_utf8(done.stderr)
            .unwrap()
            .starts_with("error: could not write to the standard output: ")
    );
}
