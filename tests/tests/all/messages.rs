//! What the program tells of designs, in its three forms: for people, one line each, and JSON for programs; how many
//! are shown; and the pages of `ifs explain`.
#![allow(clippy::disallowed_methods, reason = "the tests start programs and write what they read")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::path::{Path, PathBuf};

use ifs_compiler::diagnostic::{Code, Severity};
use ifs_tests::outcome::{Outcome, run};
use ifs_tests::{program, scratch};
use serde_json::Value;

/// Designs with diagnostics of several rooms, errors and warnings, behind characters of several bytes.
const DESIGNS: &[(&str, &str)] = &[
    ("names.ifs", "// größe 😀\nlet a = bb /* no */\nlet c = 2\nlet d = ccc + c\n"),
    ("open.ifs", "let größe = 1\nlet a = (1 + 2\nlet b = [1, 2\n"),
    ("units.ifs", "let a = 3 parsecs\nlet b = 3mm + 2s\nlet c = 12mmm\n"),
    ("unused.ifs", "use std.curves (bezier3, bezier2)\nlet a = 1\n"),
    (
        "requires.ifs",
        "use std.curves (bezier3)\nuse std.materials (sawn_spruce)\nuse std.machines (router3)\n\
         figure arch = bezier3 on ((0m, 0m), (1m, 3m), (4m, 3m), (5m, 0m)) at level 2\n\
         fabricate arch as planks {\n    material: sawn_spruce\n    section: 120mm by 27mm\n    stock: 9m\n    \
         ends: mitred\n    machine: router3(tool: 8mm, feed: 5m/min)\n    require length in 20mm .. 30mm\n    \
         require mitre <= 1deg\n}\n",
    ),
];

fn written(test: &str) -> Vec<(PathBuf, &'static str)> {
    let folder = scratch(test);
    DESIGNS
        .iter()
        .map(|(name, text)| {
            fs::write(folder.join(name), text).unwrap();
            (folder.join(name), *text)
        })
        .collect()
}

fn check(path: &Path, format: &str) -> Outcome {
    run(program().args(["check", "--message-format", format]).arg(path))
}

fn json_lines(text: &str) -> Vec<Value> {
    let parse = |line: &str| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"));
    text.lines().map(parse).collect()
}

/// A place has its line and column from 1, in characters, where its bytes are.
fn assert_place(place: &Value, path: &Path, text: &str) {
    let number = |key: &str| {
        usize::try_from(place[key].as_u64().unwrap_or_else(|| panic!("{key} of {place}"))).unwrap()
    };
    assert_eq!(place["file"].as_str(), path.to_str());
    for (byte, line, column) in [("byte_start", "line", "column"), ("byte_end", "end_line", "end_column")] {
        let before = &text[..number(byte)];
        assert_eq!(number(line), before.matches('\n').count() + 1, "{place}");
        assert_eq!(number(column), before.rsplit('\n').next().unwrap().chars().count() + 1, "{place}");
    }
    assert!(number("byte_start") <= number("byte_end") && place["text"].is_string());
}

#[test]
fn each_line_of_json_is_a_diagnostic() {
    let mut fixes = 0;
    for (path, text) in written("messages-json") {
        let done = check(&path, "json");
        assert_eq!(done.stderr, "", "{path:?}");
        let told = json_lines(&done.stdout);
        assert!(!told.is_empty(), "{path:?}");
        for diagnostic in &told {
            let code = Code::parse(diagnostic["code"].as_str().unwrap()).unwrap();
            let severity = if code.severity() == Severity::Error { "error" } else { "warning" };
            assert_eq!(diagnostic["severity"], severity);
            assert!(!diagnostic["message"].as_str().unwrap().is_empty());
            assert_place(&diagnostic["at"], &path, text);
            for also in diagnostic["also"].as_array().unwrap() {
                assert_place(also, &path, text);
            }
            assert!(diagnostic["notes"].as_array().unwrap().iter().all(Value::is_string));
            for hint in diagnostic["hints"].as_array().unwrap() {
                assert!(!hint["text"].as_str().unwrap().is_empty());
                for fix in hint["fixes"].as_array().unwrap() {
                    assert!(!fix["title"].as_str().unwrap().is_empty());
                    for edit in fix["edits"].as_array().unwrap() {
                        assert_place(&edit["at"], &path, text);
                        assert!(edit["replacement"].is_string());
                        fixes += 1;
                    }
                }
            }
        }
        let errors = told.iter().any(|diagnostic| diagnostic["severity"] == "error");
        assert_eq!(done.code, Some(i32::from(errors)), "warnings alone are good");
    }
    assert!(fixes > 0, "no hint with a change of the text");
}

#[test]
fn short_is_one_line_each_and_says_the_same() {
    for (path, _) in written("messages-short") {
        let (short, json) = (check(&path, "short"), json_lines(&check(&path, "json").stdout));
        assert_eq!(short.stdout, "", "messages go to stderr");
        let mut lines = short.stderr.lines();
        for told in &json {
            let at = &told["at"];
            let text = |value: &Value| value.as_str().unwrap().to_owned();
            let expected = format!(
                "{}:{}:{}: {}[{}]: {}",
                path.display(),
                at["line"],
                at["column"],
                text(&told["severity"]),
                text(&told["code"]),
                text(&told["message"])
            );
            assert_eq!(lines.next(), Some(expected.as_str()));
        }
        let count = |severity: &str| json.iter().filter(|told| told["severity"] == severity).count();
        let words = [(count("error"), "error"), (count("warning"), "warning")]
            .into_iter()
            .filter(|(number, _)| *number > 0)
            .map(|(number, word)| format!("{number} {word}{}", if number == 1 { "" } else { "s" }));
        assert_eq!(lines.next(), Some(words.collect::<Vec<_>>().join(", ").as_str()));
        assert_eq!(lines.next(), None);
    }
}

#[test]
fn people_see_the_line_and_no_colours_where_there_is_no_terminal() {
    for (path, text) in written("messages-human") {
        let done = check(&path, "human");
        assert_eq!(done.stdout, "");
        assert!(!done.stderr.contains('\u{1b}'), "{}", done.stderr);
        for told in json_lines(&check(&path, "json").stdout) {
            let (code, at) = (told["code"].as_str().unwrap(), &told["at"]);
            assert!(done.stderr.contains(&format!("[{code}]")), "{}", done.stderr);
            let place = format!("{}:{}:{}", path.display(), at["line"], at["column"]);
            assert!(done.stderr.contains(&place), "no {place} in\n{}", done.stderr);
            let line = text.lines().nth(at["line"].as_u64().unwrap() as usize - 1).unwrap();
            assert!(done.stderr.contains(line.trim()), "no {line:?} in\n{}", done.stderr);
            for hint in told["hints"].as_array().unwrap() {
                assert!(done.stderr.contains(hint["text"].as_str().unwrap()), "{hint} in\n{}", done.stderr);
            }
        }
    }
}

#[test]
fn at_most_a_hundred_are_shown_then_a_count() {
    let path = scratch("messages-many").join("many.ifs");
    let mut text: String = "let curve = bezier3\n".into();
    text.extend((0..250).map(|n| format!("let a{n} = unknown_{n}\n")));
    fs::write(&path, &text).unwrap();
    for format in ["human", "short"] {
        let done = check(&path, format);
        assert_eq!(done.stderr.matches("E0301").count(), 100, "{format}");
        // The missing import is not among the first hundred: errors come first.
        assert!(!done.stderr.contains("W0308"));
        assert!(
            done.stderr.ends_with("\n… and 151 more\n250 errors, 1 warning\n"),
            "{format}: {}",
            done.stderr
        );
    }
    let done = check(&path, "json");
    assert_eq!(json_lines(&done.stdout).len(), 100);
    assert_eq!((done.code, done.stderr.as_str()), (Some(1), "… and 151 more\n"));
    // A hundred are all shown, and nothing is counted.
    text = (0..100).map(|n| format!("let a{n} = unknown_{n}\n")).collect();
    fs::write(&path, &text).unwrap();
    let done = check(&path, "short");
    assert_eq!(done.stderr.lines().count(), 101);
    assert!(done.stderr.ends_with("\n100 errors\n") && !done.stderr.contains("more"));
}

#[test]
fn several_files_are_checked_and_the_gravest_code_wins() {
    let paths = written("messages-several");
    let good = paths[0].0.with_file_name("good.ifs");
    fs::write(&good, "let a = 1\n").unwrap();
    let done = run(program().arg("check").arg(&good).arg(&good));
    assert_eq!(done.good(), "");
    let missing = good.with_file_name("missing.ifs");
    let done =
        run(program().args(["check", "--message-format", "short"]).args([&good, &missing, &paths[0].0]));
    done.failed(3, &["missing.ifs:1:1: error[E0306]", "names.ifs:2:9: error[E0301]"]);
}

#[test]
fn a_build_for_programs_prints_diagnostics_and_nothing_else() {
    let folder = scratch("messages-build");
    let design = folder.join("arch.ifs");
    let text = "use std.curves (bezier3, bezier2)\n\
                figure arch = bezier3 on ((0m, 0m), (1m, 3m), (4m, 3m), (5m, 0m)) at level 2\n";
    fs::write(&design, text).unwrap();
    let done = run(program()
        .args(["--message-format", "json", "build"])
        .arg(&design)
        .arg("-o")
        .arg(folder.join("out")));
    let told = json_lines(&done.good());
    assert_eq!(told.len(), 1);
    assert_eq!(told[0]["code"], "W0307");
    assert!(folder.join("out/model.glb").exists(), "a warning keeps nothing from being built");
}

#[test]
fn every_code_is_explained() {
    for code in Code::ALL {
        for name in [code.name().to_owned(), code.name().to_lowercase()] {
            let page = run(program().arg("explain").arg(&name)).good();
            assert_eq!(page, format!("{}\n", code.page().trim_end()));
            assert!(page.starts_with(&format!("# {}: {}\n", code.name(), code.title())), "{page}");
        }
    }
}

#[test]
fn a_misspelt_code_is_told_with_the_nearest() {
    for (misspelt, meant) in
        [("EO101", "E0101"), ("E0871", "E0801"), ("E00814", "E0814"), ("0814", "E0814"), ("w307", "W0307")]
    {
        let done = run(program().args(["explain", misspelt]));
        done.failed(2, &[&format!("there is no code `{misspelt}`"), &format!("did you mean `{meant}`?")]);
    }
    let far = run(program().args(["explain", "planarity"]));
    far.failed(2, &["there is no code `planarity`"]);
    assert!(!far.stderr.contains("did you mean"));
}
