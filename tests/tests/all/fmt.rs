//! `ifs fmt` as people and scripts meet it: what it writes, what it says, how it ends, and what it leaves alone.
#![cfg(unix)]
#![allow(clippy::disallowed_methods, reason = "the tests start programs and write what they read")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};

use ifs_tests::outcome::{Outcome, run, run_with};
use ifs_tests::{program, root, scratch};
use serde_json::Value;

const UGLY: &str = "let a=1\nlet bc=[a ,2]\n";
const NEAT: &str = "let a  = 1\nlet bc = [a, 2]\n";

/// A folder of a test's own, in which the program runs.
struct Place(PathBuf);

impl Place {
    fn new(test: &str) -> Place {
        Place(scratch(&format!("fmt-{test}")))
    }

    fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), text).unwrap();
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }

    fn fmt(&self, arguments: &[&str]) -> Outcome {
        run(program().arg("fmt").args(arguments).current_dir(&self.0))
    }

    fn stdin(&self, arguments: &[&str], input: &[u8]) -> Outcome {
        run_with(program().arg("fmt").args(arguments).current_dir(&self.0), input)
    }

    /// Nothing lies in the folder but these.
    fn holds(&self, names: &[&str]) {
        let mut found: Vec<String> = fs::read_dir(&self.0)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        found.sort();
        assert_eq!(found, names);
    }
}

/// All went well, and this was said on stderr.
fn said(done: &Outcome, stderr: &str) {
    assert_eq!((done.code, done.stdout.as_str(), done.stderr.as_str()), (Some(0), "", stderr));
}

#[test]
fn files_are_rewritten_once() {
    let place = Place::new("rewritten");
    place.write("a.ifs", UGLY);
    place.write("b.ifs", NEAT);
    let before = fs::metadata(place.0.join("b.ifs")).unwrap().modified().unwrap();
    said(&place.fmt(&["a.ifs", "b.ifs"]), "formatted a.ifs\n");
    assert_eq!(place.read("a.ifs"), NEAT);
    assert_eq!(fs::metadata(place.0.join("b.ifs")).unwrap().modified().unwrap(), before);
    said(&place.fmt(&["a.ifs", "b.ifs"]), "");
    place.holds(&["a.ifs", "b.ifs"]);
}

#[test]
fn check_and_diff_write_nothing() {
    let place = Place::new("check");
    place.write("a.ifs", UGLY);
    place.write("b.ifs", NEAT);
    place.fmt(&["--check", "a.ifs", "b.ifs"]).failed(1, &["a.ifs is not formatted\n"]);
    said(&place.fmt(&["--check", "b.ifs"]), "");
    said(&place.fmt(&["--check", "--diff", "b.ifs"]), "");
    let done = place.fmt(&["--diff", "b.ifs", "a.ifs"]);
    assert_eq!((done.code, done.stderr.as_str()), (Some(1), ""));
    let diff =
        "--- a.ifs\n+++ a.ifs\n@@ -1,2 +1,2 @@\n-let a=1\n-let bc=[a ,2]\n+let a  = 1\n+let bc = [a, 2]\n";
    assert_eq!(done.stdout, diff);
    let both = place.fmt(&["--diff", "--check", "a.ifs"]);
    assert_eq!((both.code, both.stdout.as_str()), (Some(1), diff));
    assert_eq!(both.stderr, "a.ifs is not formatted\n");
    assert_eq!(place.read("a.ifs"), UGLY);
}

#[test]
fn the_standard_input_goes_to_the_standard_output() {
    let place = Place::new("stdin");
    assert_eq!(place.stdin(&["-"], UGLY.as_bytes()).good(), NEAT);
    assert_eq!(place.stdin(&["-"], NEAT.as_bytes()).good(), NEAT);
    assert_eq!(place.stdin(&["-"], b"").good(), "");
    place.stdin(&["--check", "-"], UGLY.as_bytes()).failed(1, &["the standard input is not formatted\n"]);
    assert_eq!(place.stdin(&["--check", "-"], NEAT.as_bytes()).good(), "");
    let done = place.stdin(&["--diff", "-"], UGLY.as_bytes());
    assert!(done.code == Some(1) && done.stdout.contains("\n+let a  = 1\n"), "{done:?}");
    place.stdin(&["-"], b"let a = (1").failed(1, &["E0202", "1 error\n"]);
    place.holds(&[]);
}

#[test]
fn broken_files_are_left_alone_and_others_are_not() {
    let place = Place::new("broken");
    place.write("a.ifs", "let  a = (1\n");
    place.write("b.ifs", UGLY);
    place.write("c.ifs", b"let  a = 1 // \xff\n");
    let done = place.fmt(&["a.ifs", "c.ifs", "b.ifs"]);
    done.failed(1, &["E0202", "a.ifs", "E0101", "c.ifs", "formatted b.ifs\n"]);
    let checked = run(program().args(["check", "a.ifs"]).current_dir(&place.0));
    assert!(
        done.stderr.starts_with(&checked.stderr),
        "as check says it:\n{}\n{}",
        done.stderr,
        checked.stderr
    );
    assert_eq!(place.read("a.ifs"), "let  a = (1\n");
    assert_eq!(fs::read(place.0.join("c.ifs")).unwrap(), b"let  a = 1 // \xff\n");
    assert_eq!(place.read("b.ifs"), NEAT);
    place.fmt(&["--check", "a.ifs"]).failed(1, &["E0202"]);
    place.fmt(&["--diff", "a.ifs"]).failed(1, &["E0202"]);
    let short = place.fmt(&["--message-format", "short", "a.ifs"]);
    assert_eq!(short.stderr.lines().count(), 2, "{}", short.stderr);
    place.holds(&["a.ifs", "b.ifs", "c.ifs"]);
}

/// The standard output carries texts: what is said as JSON stands beside them.
#[test]
fn json_for_programs_goes_to_the_standard_error() {
    let place = Place::new("json");
    place.write("a.ifs", UGLY);
    place.write("b.ifs", "let  a = (1\n");
    let json = |done: &Outcome| -> Vec<Value> {
        done.stderr.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    };
    let done = place.stdin(&["-", "--message-format", "json"], b"let a = 3;");
    assert_eq!((done.code, done.stdout.as_str()), (Some(1), ""));
    assert!(json(&done).iter().all(|found| found["code"].as_str().unwrap().starts_with('E')), "{done:?}");
    let checked = place.fmt(&["--check", "--message-format", "json", "a.ifs", "b.ifs"]);
    assert_eq!((checked.code, checked.stdout.as_str()), (Some(1), ""));
    let said = json(&checked);
    assert_eq!(said[0], serde_json::json!({ "file": "a.ifs", "verdict": "not formatted" }));
    assert_eq!((said[1]["code"].as_str(), said.len()), (Some("E0202"), 2));
    let made = place.fmt(&["--message-format", "json", "a.ifs"]);
    assert_eq!((made.code, made.stdout.as_str()), (Some(0), ""));
    assert_eq!(json(&made), [serde_json::json!({ "file": "a.ifs", "verdict": "formatted" })]);
    assert_eq!(place.read("a.ifs"), NEAT);
}

/// What a file names is not looked for, and what is wrong beyond its form is no matter here.
#[test]
fn only_the_form_counts() {
    let place = Place::new("form");
    place.write("a.ifs", "use std.nowhere(x)\nlet a=1m+1kg\n");
    said(&place.fmt(&["a.ifs"]), "formatted a.ifs\n");
    assert_eq!(place.read("a.ifs"), "use std.nowhere (x)\nlet a = 1m + 1kg\n");
}

#[test]
fn what_cannot_be_read_or_written_is_3() {
    let place = Place::new("unreadable");
    place.fmt(&["no.ifs"]).failed(3, &["E0306", "no.ifs", "no such file"]);
    place.fmt(&["."]).failed(3, &["E0306", "it is a folder"]);
    place.write("a.ifs", UGLY);
    fs::set_permissions(place.0.join("a.ifs"), fs::Permissions::from_mode(0o444)).unwrap();
    place.fmt(&["a.ifs"]).failed(3, &["a.ifs was not formatted: it is write-protected"]);
    assert_eq!(place.read("a.ifs"), UGLY);
    place.fmt(&["--check", "a.ifs"]).failed(1, &["a.ifs is not formatted"]);
    place.holds(&["a.ifs"]);
    let done = run_with(program().args(["fmt", "/dev/stdin"]), UGLY.as_bytes());
    done.failed(3, &["it is no plain file"]);
}

#[test]
fn permissions_and_links_stay() {
    let place = Place::new("links");
    place.write("real.ifs", UGLY);
    fs::set_permissions(place.0.join("real.ifs"), fs::Permissions::from_mode(0o640)).unwrap();
    symlink("real.ifs", place.0.join("link.ifs")).unwrap();
    said(&place.fmt(&["link.ifs"]), "formatted link.ifs\n");
    assert_eq!(place.read("real.ifs"), NEAT);
    assert_eq!(fs::metadata(place.0.join("real.ifs")).unwrap().permissions().mode() & 0o777, 0o640);
    assert_eq!(fs::read_link(place.0.join("link.ifs")).unwrap(), Path::new("real.ifs"));
    symlink("gone.ifs", place.0.join("dangling.ifs")).unwrap();
    place.fmt(&["dangling.ifs"]).failed(3, &["E0306"]);
    place.holds(&["dangling.ifs", "link.ifs", "real.ifs"]);
}

#[test]
fn line_ends_comments_and_nothing() {
    let place = Place::new("texts");
    place.write("crlf.ifs", "// a\r\nlet b = \"c\"\r\n\r\n");
    place.write("comments.ifs", "\n//! What it is.\n// and why   \n\n\n// end");
    place.write("empty.ifs", "");
    place.write("blank.ifs", "\n\n  \n");
    said(
        &place.fmt(&["crlf.ifs", "comments.ifs", "empty.ifs", "blank.ifs"]),
        "formatted crlf.ifs\nformatted comments.ifs\nformatted blank.ifs\n",
    );
    assert_eq!(place.read("crlf.ifs"), "// a\r\nlet b = \"c\"\r\n");
    assert_eq!(place.read("comments.ifs"), "//! What it is.\n// and why\n\n// end\n");
    assert_eq!(place.read("empty.ifs"), "");
    assert_eq!(place.read("blank.ifs"), "");
}

#[test]
fn limits_and_wrong_usage() {
    let place = Place::new("limits");
    place.write("deep.ifs", format!("let a = {}", "(".repeat(200_000)));
    place.write("large.ifs", " ".repeat(17 << 20));
    place.fmt(&["deep.ifs"]).failed(4, &["E0107"]);
    place.fmt(&["large.ifs"]).failed(4, &["E0108"]);
    let nested = format!("let a = {}1{}\n", "[f(1,\n".repeat(60), ",\n2,\n3)]".repeat(60));
    place.write("nested.ifs", nested.repeat(800));
    place.fmt(&["nested.ifs"]).failed(4, &["its indents would make it too large"]);
    place.fmt(&[]).failed(2, &["FILE"]);
    place.fmt(&["--chekc", "a.ifs"]).failed(2, &["--check"]);
}

/// What the repository ships is laid out.
#[test]
fn the_library_and_the_examples_pass_the_check() {
    let paths = ["stdlib", "examples"].map(|folder| ifs_tests::sources::files(&root().join(folder), "ifs"));
    let paths = paths.concat();
    assert!(paths.len() > 5);
    assert_eq!(run(program().args(["fmt", "--check"]).args(&paths)).good(), "");
}
