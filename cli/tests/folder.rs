//! The output folder within one process: what is written, replaced, kept, refused and mended.
#![allow(clippy::disallowed_methods, reason = "the tests look at the files")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};

use ifs_cli::folder::{
    Committed, Exchange, FolderError, Making, Manifest, OutputFolder, Provenance, SourceRecord, verify,
};

/// An empty folder of a test's own.
fn scratch(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("folder").join(test);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder.canonicalize().unwrap()
}

fn provenance() -> Provenance {
    Provenance {
        sources: vec![SourceRecord::of("vault.ifs", b"figure"), SourceRecord::of("ribs/a.ifs", b"")],
        parameters: BTreeMap::from([("span".to_owned(), "6m".to_owned())]),
        ..Provenance::default()
    }
}

fn build(target: &Path, exchange: Exchange, files: &[(&str, &str)]) -> Result<Committed, FolderError> {
    let mut staging = OutputFolder::stage_with(target, Making { exchange, ..Making::default() }, &mut || ())?;
    for (name, text) in files {
        staging.write(name, "csv", Some("vault.0.left"), text.as_bytes())?;
    }
    staging.commit(&provenance())
}

/// All files below a folder with their text; links by where they lead.
fn contents(folder: &Path) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(folder).unwrap().to_string_lossy().into_owned();
            let kind = fs::symlink_metadata(&path).unwrap();
            if kind.is_symlink() {
                all.insert(name, format!("-> {}", fs::read_link(&path).unwrap().display()));
            } else if kind.is_dir() {
                all.insert(name + "/", String::new());
                open.push(path);
            } else {
                all.insert(name, fs::read_to_string(&path).unwrap());
            }
        }
    }
    all
}

fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn a_first_build_makes_the_set_and_nothing_else() {
    let root = scratch("first");
    let target = root.join("out/vault");
    let done = build(&target, Exchange::System, &[("cutlist.csv", "a\n"), ("boards/x.nc", "%\n")]).unwrap();
    assert_eq!(done.folder, target);
    assert!(done.removed.is_empty() && done.foreign.is_empty() && done.leftover.is_none());
    assert_eq!(names_in(&root.join("out")), ["vault"]);
    let names: Vec<String> = contents(&target).into_keys().collect();
    assert_eq!(names, ["boards/", "boards/x.nc", "cutlist.csv", "manifest.json"]);
    assert_eq!(verify(&target).unwrap(), Vec::<String>::new());
}

#[test]
fn the_manifest_is_written_as_agreed() {
    let target = scratch("manifest").join("vault");
    build(&target, Exchange::System, &[("cutlist.csv", "abc")]).unwrap();
    let expected = format!(
        r#"{{
  "schema": 1,
  "program": "ifs",
  "version": "{}",
  "sources": [
    {{
      "path": "ribs/a.ifs",
      "sha256": "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
    }},
    {{
      "path": "vault.ifs",
      "sha256": "{}"
    }}
  ],
  "parameters": {{
    "span": "6m"
  }},
  "files": [
    {{
      "path": "cutlist.csv",
      "bytes": 3,
      "sha256": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
      "kind": "csv",
      "address": "vault.0.left"
    }}
  ]
}}
"#,
        env!("CARGO_PKG_VERSION"),
        SourceRecord::of("", b"figure").sha256,
    );
    assert_eq!(fs::read_to_string(target.join("manifest.json")).unwrap(), expected);
    assert_eq!(Manifest::read(&target).unwrap().unwrap().files[0].bytes, 3);
}

#[test]
fn the_order_of_writing_does_not_show() {
    let root = scratch("order");
    build(&root.join("a"), Exchange::System, &[("b.csv", "1"), ("a.csv", "2")]).unwrap();
    build(&root.join("b"), Exchange::System, &[("a.csv", "2"), ("b.csv", "1")]).unwrap();
    assert_eq!(contents(&root.join("a")), contents(&root.join("b")));
}

#[test]
fn stale_files_vanish_and_foreign_ones_stay() {
    for exchange in [Exchange::System, Exchange::Journal] {
        let root = scratch(&format!("replace-{exchange:?}"));
        let target = root.join("vault");
        build(&target, exchange, &[("a.csv", "old"), ("boards/x.nc", "old"), ("boards/y.nc", "old")])
            .unwrap();
        fs::write(target.join("notes.txt"), "mine").unwrap();
        fs::write(target.join("boards/photo.jpg"), "mine").unwrap();
        fs::create_dir_all(target.join("ours/deep")).unwrap();
        fs::write(target.join("ours/deep/plan.txt"), "mine").unwrap();
        symlink("/nowhere", target.join("link")).unwrap();
        let done = build(&target, exchange, &[("a.csv", "new"), ("boards/y.nc", "new"), ("b.csv", "new")]);
        let done = done.unwrap();
        assert_eq!(done.removed, ["boards/x.nc"]);
        assert_eq!(done.foreign, ["boards/photo.jpg", "link", "notes.txt", "ours/"]);
        assert!(done.leftover.is_none());
        let mut found = contents(&target);
        found.remove("manifest.json");
        let expected = [
            ("a.csv", "new"),
            ("b.csv", "new"),
            ("boards/", ""),
            ("boards/photo.jpg", "mine"),
            ("boards/y.nc", "new"),
            ("link", "-> /nowhere"),
            ("notes.txt", "mine"),
            ("ours/", ""),
            ("ours/deep/", ""),
            ("ours/deep/plan.txt", "mine"),
        ];
        assert_eq!(found, expected.map(|(a, b)| (a.to_owned(), b.to_owned())).into());
        assert_eq!(verify(&target).unwrap(), Vec::<String>::new());
        assert_eq!(names_in(&root), ["vault"]);
        // A foreign file in a folder of which the set no longer has anything.
        let done = build(&target, exchange, &[("a.csv", "newer")]).unwrap();
        assert_eq!(done.foreign, ["boards/photo.jpg", "link", "notes.txt", "ours/"]);
        assert_eq!(contents(&target)["boards/photo.jpg"], "mine");
    }
}

#[test]
fn what_no_build_wrote_is_never_overwritten() {
    let root = scratch("in-the-way");
    for (case, foreign) in [("file", "a.csv"), ("for-a-folder", "boards"), ("folder", "c.csv/x")] {
        let target = root.join(case);
        let path = target.join(foreign);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, "mine").unwrap();
        let before = contents(&target);
        let failed =
            build(&target, Exchange::System, &[("a.csv", "1"), ("boards/x.nc", "2"), ("c.csv", "3")]);
        assert!(matches!(failed, Err(FolderError::ForeignInTheWay(_))), "{case}: {failed:?}");
        assert_eq!(contents(&target), before);
    }
    assert_eq!(names_in(&root).len(), 3);
}

#[test]
fn a_manifest_of_another_program_is_refused_before_anything_is_made() {
    let root = scratch("not-ours");
    let target = root.join("vault");
    fs::create_dir(&target).unwrap();
    for text in ["{\"name\": \"web page\"}", "", "{", "null", &"[".repeat(100_000)] {
        fs::write(target.join("manifest.json"), text).unwrap();
        let failed = OutputFolder::stage(&target);
        assert!(matches!(failed, Err(FolderError::NotOurManifest { .. })), "{failed:?}");
        assert_eq!(names_in(&root), ["vault"]);
    }
    let way_out = r#"{"schema":1,"program":"ifs","version":"0","sources":[],"parameters":{},
        "files":[{"path":"../../etc/passwd","bytes":0,"sha256":"","kind":"csv"}]}"#;
    fs::write(target.join("manifest.json"), way_out).unwrap();
    assert!(matches!(OutputFolder::stage(&target), Err(FolderError::NotOurManifest { .. })));
}

#[test]
fn targets_that_are_no_folders() {
    let root = scratch("targets");
    fs::write(root.join("file"), "x").unwrap();
    assert!(matches!(OutputFolder::stage(&root.join("file")), Err(FolderError::NotAFolder(_))));
    let below = OutputFolder::stage(&root.join("file/out")).unwrap_err().to_string();
    assert!(below.contains("file/out"), "{below}");
    symlink("missing/place", root.join("dangling")).unwrap();
    let dangling = OutputFolder::stage(&root.join("dangling")).unwrap_err().to_string();
    assert!(dangling.starts_with("could not follow ") && dangling.contains("dangling"), "{dangling}");
    assert_eq!(fs::read_to_string(root.join("file")).unwrap(), "x");
    assert_eq!(names_in(&root), ["dangling", "file"]);
}

#[test]
fn a_link_to_a_folder_stays_a_link() {
    let root = scratch("link");
    fs::create_dir_all(root.join("store/real")).unwrap();
    symlink("store/real", root.join("out")).unwrap();
    for text in ["1", "2"] {
        let done = build(&root.join("out"), Exchange::System, &[("a.csv", text)]).unwrap();
        assert_eq!(done.folder, root.join("store/real"));
        assert_eq!(fs::read_link(root.join("out")).unwrap(), Path::new("store/real"));
        assert_eq!(contents(&root.join("store/real"))["a.csv"], text);
    }
    assert_eq!(names_in(&root.join("store")), ["real"]);
}

#[test]
fn names_that_lead_out_write_nothing() {
    let root = scratch("names");
    let mut staging = OutputFolder::stage(&root.join("out/vault")).unwrap();
    for name in ["../x.csv", "/x.csv", "a/../../x.csv", "manifest.json", "con.csv", "A.csv", ""] {
        let failed = staging.write(name, "csv", None, b"x");
        assert!(matches!(failed, Err(FolderError::BadName { .. })), "{name:?}");
    }
    staging.write("a.csv", "csv", None, b"x").unwrap();
    assert!(matches!(staging.write("a.csv", "csv", None, b"x"), Err(FolderError::Duplicate(_))));
    let absolute =
        Provenance { sources: vec![SourceRecord::of("/home/x.ifs", b"")], ..Provenance::default() };
    assert!(matches!(staging.commit(&absolute), Err(FolderError::BadName { .. })));
    assert_eq!(names_in(&root), ["out"]);
    assert_eq!(names_in(&root.join("out")), Vec::<String>::new());
}

#[test]
fn a_build_given_up_leaves_the_old_set_and_no_trace() {
    let root = scratch("dropped");
    let target = root.join("vault");
    build(&target, Exchange::System, &[("a.csv", "old")]).unwrap();
    let before = contents(&target);
    let mut staging = OutputFolder::stage(&target).unwrap();
    staging.write("a.csv", "csv", None, b"new").unwrap();
    let failed = staging.write_with("b.csv", "csv", None, |_| Err(std::io::Error::other("no figures")));
    let text = failed.unwrap_err().to_string();
    assert!(text.contains("vault/b.csv") && text.ends_with("no figures"), "{text}");
    drop(staging);
    assert_eq!(contents(&target), before);
    assert_eq!(names_in(&root), ["vault"]);
}

#[test]
fn a_parent_that_cannot_be_written_is_named() {
    // Nobody may make files in /sys, not even root.
    let failed = OutputFolder::stage(Path::new("/sys/kernel/vault")).unwrap_err();
    assert!(matches!(failed, FolderError::Io { doing: "make the lock", .. }), "{failed:?}");
    assert!(failed.to_string().contains("/sys/kernel/.vault.ifs-lock"), "{failed}");
}

#[test]
fn the_working_folder_is_not_replaced() {
    let working = std::env::current_dir().unwrap();
    for target in [Path::new("."), working.parent().unwrap(), Path::new("/")] {
        assert!(matches!(OutputFolder::stage(target), Err(FolderError::HoldsWorkingFolder(_))), "{target:?}");
    }
}

/// What a kill may leave, made by hand: every state between the steps of a replacement.
mod leftovers {
    use super::*;

    /// A root with the sets `old` and `new` in folders of these names.
    fn two_sets(test: &str) -> PathBuf {
        let root = scratch(test);
        build(&root.join("old"), Exchange::System, &[("a.csv", "old"), ("b.csv", "old")]).unwrap();
        build(&root.join("new"), Exchange::System, &[("a.csv", "new")]).unwrap();
        root
    }

    fn put(root: &Path, from: &str, to: &str) {
        fs::rename(root.join(from), root.join(to)).unwrap();
    }

    fn after_recovery(root: &Path) -> BTreeMap<String, String> {
        OutputFolder::recover(&root.join("vault")).unwrap();
        assert_eq!(names_in(root), ["vault"]);
        assert_eq!(verify(&root.join("vault")).unwrap(), Vec::<String>::new());
        contents(&root.join("vault"))
    }

    #[test]
    fn a_half_made_set_is_removed() {
        let root = two_sets("half-made");
        put(&root, "old", "vault");
        put(&root, "new", ".vault.ifs-staging");
        fs::remove_file(root.join(".vault.ifs-staging/manifest.json")).unwrap();
        fs::write(root.join(".vault.ifs-lock"), "").unwrap();
        let done = build(&root.join("vault"), Exchange::System, &[("c.csv", "newer")]).unwrap();
        assert_eq!(done.removed, ["a.csv", "b.csv"]);
        assert_eq!(names_in(&root), ["vault"]);
    }

    #[test]
    fn a_complete_set_without_a_journal_is_given_up() {
        let root = two_sets("complete");
        put(&root, "old", "vault");
        put(&root, "new", ".vault.ifs-staging");
        assert_eq!(after_recovery(&root)["a.csv"], "old");
    }

    #[test]
    fn a_journal_before_the_first_rename_keeps_the_old_set() {
        let root = two_sets("journal-first");
        put(&root, "old", "vault");
        put(&root, "new", ".vault.ifs-staging");
        fs::write(root.join(".vault.ifs-journal"), "").unwrap();
        assert_eq!(after_recovery(&root)["a.csv"], "old");
    }

    #[test]
    fn a_journal_between_the_renames_is_finished() {
        let root = two_sets("journal-between");
        put(&root, "old", ".vault.ifs-old");
        put(&root, "new", ".vault.ifs-staging");
        fs::write(root.join(".vault.ifs-journal"), "").unwrap();
        let found = after_recovery(&root);
        assert_eq!((found["a.csv"].as_str(), found.contains_key("b.csv")), ("new", false));
    }

    #[test]
    fn a_damaged_new_set_is_rolled_back() {
        let root = two_sets("journal-damaged");
        put(&root, "old", ".vault.ifs-old");
        put(&root, "new", ".vault.ifs-staging");
        fs::write(root.join(".vault.ifs-staging/a.csv"), "nex").unwrap();
        fs::write(root.join(".vault.ifs-journal"), "").unwrap();
        assert_eq!(after_recovery(&root)["a.csv"], "old");
    }

    #[test]
    fn a_journal_after_the_renames_keeps_the_new_set() {
        let root = two_sets("journal-after");
        put(&root, "old", ".vault.ifs-old");
        put(&root, "new", "vault");
        fs::write(root.join(".vault.ifs-journal"), "").unwrap();
        assert_eq!(after_recovery(&root)["a.csv"], "new");
    }

    #[test]
    fn what_came_into_the_old_set_at_the_last_moment_is_kept() {
        let root = two_sets("late");
        fs::create_dir(root.join("old/ours")).unwrap();
        fs::write(root.join("old/ours/late.txt"), "late").unwrap();
        fs::write(root.join("new/saved.txt"), "before").unwrap();
        std::thread::sleep(std::time::Duration::from_millis(20));
        fs::write(root.join("old/saved.txt"), "after").unwrap();
        put(&root, "old", ".vault.ifs-staging");
        put(&root, "new", "vault");
        let found = after_recovery(&root);
        assert_eq!((found["a.csv"].as_str(), found.contains_key("b.csv")), ("new", false));
        assert_eq!(found["ours/late.txt"], "late");
        assert_eq!(found["saved.txt"], "after");
    }
}
