//! The same sources and parameters give the same bytes: again, elsewhere, in another environment, beside fifteen other
//! builds, in the other build profile. Whole folders are compared, byte by byte.
#![allow(clippy::disallowed_methods, reason = "the tests start programs and read what they write")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use ifs_tests::designs::{assert_same, contents, example_path, example_text};
use ifs_tests::outcome::run;
use ifs_tests::{other_program, program, scratch};
use serde_json::Value;

/// A set of outputs: names and bytes.
type Set = BTreeMap<String, Vec<u8>>;

/// Builds an example by this command into a folder; returns the set and what was printed below the folder's name.
fn build(mut command: Command, example: &str, folder: &Path) -> Set {
    run(command.arg("build").arg(example_path(example)).arg("-o").arg(folder)).good();
    contents(folder)
}

/// The examples that are built again and again: planarized boards, planks, a model, and separate pieces.
const BUILT: [&str; 4] = ["column", "model", "shell", "vault"];

/// Each of these with its first build.
fn first(test: &str) -> Vec<(String, Set)> {
    let folder = scratch(test);
    BUILT
        .iter()
        .map(|name| ((*name).to_owned(), build(program(), name, &folder.join("first").join(name))))
        .collect()
}

#[test]
fn two_builds_are_the_same_and_so_is_one_over_another_design() {
    let folder = scratch("same-again");
    for (name, set) in first("same-first") {
        assert_same(&set, &build(program(), &name, &folder.join(&name)), "a second build");
        assert_same(&set, &build(program(), &name, &folder.join(&name)), "a build over itself");
        assert_same(&set, &build(program(), &name, &folder.join("one")), "a build over another design");
    }
}

#[test]
fn the_environment_changes_nothing() {
    let environments: &[(&str, &[(&str, &str)])] = &[
        ("turkish", &[("LANG", "tr_TR.UTF-8"), ("LC_ALL", "tr_TR.UTF-8"), ("LANGUAGE", "tr")]),
        ("c", &[("LC_ALL", "C")]),
        ("german", &[("LC_NUMERIC", "de_DE.UTF-8")]),
        ("kiritimati", &[("TZ", "Pacific/Kiritimati")]),
        ("one-thread", &[("RAYON_NUM_THREADS", "1")]),
        ("sixteen-threads", &[("RAYON_NUM_THREADS", "16")]),
        ("other-user", &[("USER", "somebody"), ("LOGNAME", "somebody"), ("HOSTNAME", "elsewhere")]),
        (
            "debugging",
            &[("RUST_BACKTRACE", "1"), ("RUST_LOG", "trace"), ("NO_COLOR", "1"), ("SOURCE_DATE_EPOCH", "1")],
        ),
    ];
    let folder = scratch("same-environment");
    for (name, set) in first("same-environment-first") {
        for (which, variables) in environments {
            let mut command = program();
            command.envs(variables.iter().copied());
            assert_same(&set, &build(command, &name, &folder.join(which).join(&name)), which);
        }
        let mut homeless = program();
        homeless.env_remove("HOME");
        assert_same(&set, &build(homeless, &name, &folder.join("homeless").join(&name)), "HOME unset");
        let mut bare = program();
        bare.env_clear();
        assert_same(&set, &build(bare, &name, &folder.join("bare").join(&name)), "no environment at all");
    }
}

#[test]
fn the_place_changes_nothing() {
    let folder = scratch("same-place");
    for (name, set) in first("same-place-first") {
        let elsewhere = folder.join("an elsewhere with blanks, ümlauts").join(&name);
        fs::create_dir_all(&elsewhere).unwrap();
        let file = format!("{name}.ifs");
        fs::copy(example_path(&name), elsewhere.join(&file)).unwrap();
        // As a user types it: in the design's folder, and with the output folder of the program's choice.
        let printed = run(program().args(["build", &file]).current_dir(&elsewhere)).good();
        assert!(printed.contains(&format!("in out/{name}\n")), "{printed}");
        assert_same(
            &set,
            &contents(&elsewhere.join("out").join(&name)),
            "a relative path and another working folder",
        );
        let path = Path::new("..").join(&name).join(&file);
        run(program().arg("build").arg(path).args(["-o", "x/y/z"]).current_dir(&elsewhere)).good();
        assert_same(&set, &contents(&elsewhere.join("x/y/z")), "another name of the output folder");
    }
}

#[test]
fn sixteen_builds_at_once_are_the_same() {
    let folder = scratch("same-at-once");
    for (name, set) in first("same-at-once-first") {
        program();
        let sets: Vec<Set> = std::thread::scope(|scope| {
            let one = |number: u32| build(program(), &name, &folder.join(format!("{name}-{number}")));
            let threads: Vec<_> = (0..16).map(|number| scope.spawn(move || one(number))).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        });
        for other in &sets {
            assert_same(&set, other, "sixteen at once");
        }
    }
}

#[test]
fn debug_and_release_are_the_same() {
    let folder = scratch("same-profile");
    for (name, set) in first("same-profile-first") {
        assert_same(&set, &build(other_program(), &name, &folder.join(&name)), "the other profile");
    }
}

/// The set without its manifest and the report for people, which say what was set; and the report as a value.
fn outputs_and_report(mut set: Set) -> (Set, Value) {
    set.remove("manifest.json").unwrap();
    set.remove("report.html").unwrap();
    let report = set.remove("report.json").unwrap();
    (set, serde_json::from_slice(&report).unwrap())
}

#[test]
fn a_parameter_set_to_its_default_changes_no_part() {
    let folder = scratch("same-default");
    let (plain, mut report) = outputs_and_report(build(program(), "vault", &folder.join("plain")));
    assert_eq!(report["parameters"][0]["set"], false);
    for spelt in ["span=6m", "span=6000mm", "span=600cm"] {
        let mut command = program();
        command.args(["--message-format", "short"]);
        run(command
            .arg("build")
            .arg(example_path("vault"))
            .args(["--set", spelt, "-o"])
            .arg(folder.join("set")))
        .good();
        let (set, set_report) = outputs_and_report(contents(&folder.join("set")));
        assert_same(&plain, &set, spelt);
        assert_eq!(set_report["parameters"][0]["set"], true, "the report says that it was set");
        report["parameters"][0]["set"] = true.into();
        assert_eq!(report, set_report, "{spelt}");
    }
}

#[test]
fn a_parameter_set_and_a_default_rewritten_give_the_same_parts() {
    let folder = scratch("same-set");
    let design = folder.join("vault.ifs");
    let text = example_text("vault");
    let rewritten = text.replace("span: Length = 6m ", "span: Length = 7m ");
    assert_ne!(text, rewritten);
    fs::write(&design, rewritten).unwrap();
    run(program().arg("build").arg(&design).arg("-o").arg(folder.join("rewritten"))).good();
    let set = run(program()
        .arg("build")
        .arg(example_path("vault"))
        .args(["--set", "span=7m", "-o"])
        .arg(folder.join("set")));
    set.good();
    let (rewritten, rewritten_report) = outputs_and_report(contents(&folder.join("rewritten")));
    let (set, set_report) = outputs_and_report(contents(&folder.join("set")));
    // The NC programs, where there are any, name the hash of the design's text, which is another one.
    let without_programs =
        |set: Set| set.into_iter().filter(|(name, _)| !name.ends_with(".nc")).collect::<Set>();
    assert_same(&without_programs(rewritten), &without_programs(set), "span=7m");
    assert_eq!(rewritten_report["fabrications"], set_report["fabrications"]);
    assert_ne!(
        contents(&folder.join("set"))["cutlist.csv"],
        build(program(), "vault", &folder.join("default"))["cutlist.csv"],
        "the parameter does change the planks"
    );
}
