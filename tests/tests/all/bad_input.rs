//! Bad designs, settings and arguments as a user meets them: the exit code, a message on stderr that says what would
//! mend it, nothing on stdout, and the outputs of the last good build untouched.
#![allow(clippy::disallowed_methods, reason = "the tests start programs and write what they read")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use ifs_tests::designs::{assert_same, contents, example_path, example_text};
use ifs_tests::outcome::{Outcome, run, run_with};
use ifs_tests::{program, scratch};

/// No bad input may keep a person waiting for longer, not even in a debug build on a busy machine.
const PATIENCE: Duration = Duration::from_secs(20);

/// A folder with the outputs of a good build, which must survive.
struct Place {
    root: PathBuf,
    out: PathBuf,
    before: BTreeMap<String, Vec<u8>>,
}

impl Place {
    fn new(test: &str) -> Place {
        let root = scratch(test);
        let out = root.join("out");
        run(program().arg("build").arg(example_path("vault")).arg("-o").arg(&out)).good();
        fs::write(out.join("notes.txt"), "mine").unwrap();
        let before = contents(&out);
        Place { root, out, before }
    }

    /// Builds a design over the good outputs, with more arguments.
    fn build(&self, design: impl AsRef<Path>, more: &[&str]) -> Outcome {
        let begun = Instant::now();
        let done = run(program().arg("build").arg(design.as_ref()).arg("-o").arg(&self.out).args(more));
        assert!(begun.elapsed() < PATIENCE, "{} took {:?}", design.as_ref().display(), begun.elapsed());
        done
    }

    /// The same for a design of this text.
    fn build_text(&self, text: impl AsRef<[u8]>) -> Outcome {
        let path = self.root.join("design.ifs");
        fs::write(&path, text).unwrap();
        self.build(path, &[])
    }
}

/// A set of outputs without what a failed build changes: what it said, and the list of files.
fn boards(set: &BTreeMap<String, Vec<u8>>) -> BTreeMap<String, Vec<u8>> {
    let said = |name: &&String| !["diagnostics.json", "manifest.json"].contains(&name.as_str());
    set.iter().filter(|(name, _)| said(name)).map(|(name, bytes)| (name.clone(), bytes.clone())).collect()
}

/// Whatever a test did, the good outputs are there afterwards and nothing of a build lies beside them.
impl Drop for Place {
    fn drop(&mut self) {
        if std::thread::panicking() {
            return;
        }
        assert_same(&boards(&self.before), &boards(&contents(&self.out)), "after bad input");
        for entry in fs::read_dir(&self.root).unwrap() {
            let name = entry.unwrap().file_name().to_string_lossy().into_owned();
            assert!(!name.contains(".ifs-"), "{name} was left behind");
        }
    }
}

#[test]
fn a_design_that_cannot_be_read() {
    let place = Place::new("bad-unreadable");
    place
        .build(place.root.join("valt.ifs"), &[])
        .failed(3, &["E0306", "valt.ifs", "no such file", "is the path right?"]);
    place.build(&place.root, &[]).failed(3, &["E0306", "it is a folder"]);
    place.build(place.out.join("notes.txt/vault.ifs"), &[]).failed(3, &["E0306", "cannot be read"]);
    // Only that: of a text that is not there nothing else is said.
    let missing = place.build("valt.ifs", &["--set", "span=4m"]);
    missing.failed(3, &["E0306", "1 error\n"]);
}

#[test]
fn a_text_that_is_no_design() {
    let place = Place::new("bad-text");
    let mut vault = example_text("vault").into_bytes();
    vault.splice(20..20, [0xff]);
    let done = place.build_text(&vault);
    done.failed(1, &["E0101", "not UTF-8", "byte 20 is 0xff", "save it as UTF-8"]);
    assert!(done.stderr.ends_with("\n1 error\n"), "one mistake, one message:\n{}", done.stderr);
    // Half a character at the end, and a picture.
    place.build_text(b"let a = 1 // \xe2\x82").failed(1, &["E0101"]);
    let picture: Vec<u8> = (0..3_000_000_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    place.build_text(picture).failed(1, &["E0101", "1 error\n"]);
    place.build_text("let a\0 = 1\n").failed(1, &["E0102"]);
    place.build_text(example_text("vault").replace("rise * 4/3", "rise * 4/")).failed(1, &["E0201"]);
}

#[test]
fn more_than_the_limits() {
    let place = Place::new("bad-limits");
    place.build_text(format!("let a = {}", "(".repeat(1_000_000))).failed(4, &["E0107", "128 deep"]);
    place
        .build_text(format!("let a = {}1\n", "1 + ".repeat(250_000)))
        .failed(4, &["E0107", "give a part of it a name"]);
    place.build_text(format!("let a = \"{}\" + 1\n", "x".repeat(10_000_000))).failed(1, &["E0402"]);
    place.build_text(format!("// {}\nlet a = b\n", "x".repeat(10_000_000))).failed(1, &["E0301"]);
    place.build_text("let a = 1e999\n").failed(1, &["E0104", "1e300"]);
    place.build_text(format!("let a = {}\n", "9".repeat(1_000_000))).failed(1, &["E0104"]);
    place.build_text(" ".repeat(17 << 20)).failed(4, &["E0108", "limit"]);
    let deep = example_text("shell").replace("at level 2 ", "at level 40 ");
    place.build_text(deep).failed(4, &["E0701", "the largest level that fits is 8"]);
    place.build_text("fn f(n: Int) -> Int = f(n + 1)\nlet a = f(0)\n").failed(4, &["E0703", "needs an end"]);
    place.build_text("let a = [x for x in 0..100000000]\n").failed(4, &["E0704"]);
    place
        .build_text("let a = [[[i + j + k for i in 0..1000] for j in 0..1000] for k in 0..1000]\n")
        .failed(4, &["E0703"]);
}

#[test]
fn settings_that_do_not_fit() {
    let place = Place::new("bad-settings");
    let set = |settings: &[&str]| {
        let more: Vec<&str> = settings.iter().flat_map(|setting| ["--set", setting]).collect();
        place.build(example_path("vault"), &more)
    };
    set(&["spam=4m"]).failed(1, &["E0605", "`spam`", "did you mean `span`?"]);
    set(&["span=40m"])
        .failed(1, &["E0601", "40000mm", "4000mm .. 9000mm", "the nearest value in the range is 9000mm"]);
    set(&["span=-6m"]).failed(1, &["E0601"]);
    for nonsense in [
        "span=nonsense",
        "span=6",
        "span=6kg",
        "span=6m)",
        "span=NaN",
        "span=1e999m",
        "span=6m 7m",
        "span=тм",
    ] {
        set(&[nonsense]).failed(1, &["E0606", "span"]);
    }
    for wrong in [&["span"][..], &["=6m"], &["span="], &["span=6m", "span=7m"], &["Span=6m"]] {
        set(wrong).failed(2, &["error: "]);
    }
    for usage in [
        &["--emit", "png"][..],
        &["--emit", ""],
        &["other.ifs"],
        &["--message-format", "xml"],
        &["--nonsense"],
    ] {
        place.build(example_path("vault"), usage).failed(2, &["error: "]);
    }
}

/// A requirement that fails is told at its line, with who, how much and what would mend it.
#[test]
fn the_vault_with_a_short_span_fails_at_its_overlap_line() {
    let place = Place::new("bad-overlap");
    let done = place.build(example_path("vault"), &["--set", "span=4m", "--message-format", "json"]);
    assert_eq!((done.code, done.stderr.as_str()), (Some(1), ""));
    let told: Vec<serde_json::Value> =
        done.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(told.len(), 1, "{told:#?}");
    let text = example_text("vault");
    let line = text.lines().position(|line| line.contains("require overlap")).unwrap() + 1;
    assert_eq!((&told[0]["code"], &told[0]["at"]["line"]), (&"E0814".into(), &line.into()));
    let message = told[0]["message"].as_str().unwrap();
    let planks = message.split_whitespace().filter(|word| word.starts_with("vault.")).count();
    assert!(planks == 2 && message.contains("79.604mm") && message.contains("80mm"), "{message}");
    let hints: Vec<&str> =
        told[0]["hints"].as_array().unwrap().iter().map(|hint| hint["text"].as_str().unwrap()).collect();
    // What it says would mend it does.
    let hint = hints.iter().find_map(|hint| hint.strip_prefix("it holds with span = ")).unwrap();
    let span = hint.split(';').next().unwrap();
    let mended = run(program()
        .arg("build")
        .arg(example_path("vault"))
        .args(["--set", &format!("span={span}"), "-o"])
        .arg(place.root.join("mended")));
    mended.good();
    place
        .build(example_path("vault"), &["--set", "span=4m"])
        .failed(1, &["E0814", "require overlap >= 80mm", "Help"]);
}

#[test]
fn a_design_from_the_standard_input() {
    let place = Place::new("bad-stdin");
    let from_stdin =
        |text: &[u8]| run_with(program().args(["build", "-", "-o", "made"]).current_dir(&place.root), text);
    let table = from_stdin(example_text("vault").as_bytes()).good();
    assert!(table.contains("80 planks") && table.contains("in made\n"), "{table}");
    let made = contents(&place.root.join("made"));
    assert!(made["cutlist.csv"] == place.before["cutlist.csv"]);
    let manifest: serde_json::Value = serde_json::from_slice(&made["manifest.json"]).unwrap();
    assert_eq!(manifest["sources"][0]["path"], "stdin.ifs");
    from_stdin(b"let a = b\n").failed(1, &["E0301"]);
    from_stdin(b"\xff").failed(1, &["E0101"]);
    assert_same(&boards(&made), &boards(&contents(&place.root.join("made"))), "after bad input on stdin");
    // Without -o the outputs lie where a person finds them.
    let named =
        run_with(program().args(["build", "-"]).current_dir(&place.root), example_text("vault").as_bytes());
    assert!(named.good().contains("in out/stdin\n"));
    fs::remove_dir_all(place.out.join("stdin")).unwrap();
}

/// Names that would make the output folder the one it should lie in.
#[test]
fn a_design_without_a_name_of_its_own() {
    let root = scratch("bad-name");
    for file in [".ifs", "..ifs", "...ifs"] {
        fs::write(root.join(file), example_text("vault")).unwrap();
        let table = run(program().args(["build", file]).current_dir(&root)).good();
        assert!(table.contains("in out/design\n"), "{file}: {table}");
    }
    assert_eq!(fs::read_dir(root.join("out")).unwrap().count(), 1);
}
