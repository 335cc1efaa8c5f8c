//! `ifs build --emit`: the plan printed, held against a golden file for every example (`UPDATE=1` rewrites them), and
//! only the files that were asked for.
#![allow(clippy::disallowed_methods, reason = "the tests read and write files")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;

use ifs_compiler::analysis::{Elements, Nest};
use ifs_tests::designs::{analysis_of, assert_same, contents, example_path, example_text, examples};
use ifs_tests::outcome::run;
use ifs_tests::referees::python_referee;
use ifs_tests::suite::is_update;
use ifs_tests::{program, root, scratch};
use serde_json::{Value, json};

#[test]
fn the_plan_of_every_example_is_the_golden_one() {
    let goldens = root().join("tests/golden");
    let out = scratch("emit-plan").join("out");
    for name in examples() {
        let printed =
            run(program().arg("build").arg(example_path(&name)).args(["--emit", "plan", "-o"]).arg(&out))
                .good();
        assert!(!out.exists(), "a plan alone writes no file");
        let golden = goldens.join(format!("{name}.plan.txt"));
        if is_update() {
            fs::create_dir_all(&goldens).unwrap();
            fs::write(&golden, &printed).unwrap();
        }
        let expected = fs::read_to_string(&golden).unwrap_or_default();
        assert!(printed == expected, "{}: UPDATE=1 rewrites it; now it is\n{printed}", golden.display());
    }
    let plans = fs::read_dir(&goldens)
        .unwrap()
        .filter(|entry| entry.as_ref().unwrap().file_name().to_string_lossy().ends_with(".plan.txt"));
    assert_eq!(plans.count(), examples().len(), "a golden file of an example that is gone");
}

#[test]
fn only_what_is_asked_for_is_written() {
    let out = scratch("emit-only").join("out");
    for name in examples() {
        let made = analysis_of(&example_text(&name)).fabrications;
        let panels = made.iter().any(|made| matches!(made.elements, Elements::Panels(_)));
        let nested = |bars: bool| {
            made.iter().any(|made| matches!(made.nest, Some(Nest::Bars(_))) == bars && made.nest.is_some())
        };
        let lists: Vec<&str> = [
            ("assembly.csv", !made.is_empty()),
            ("cutlist.csv", !made.is_empty()),
            ("nest.csv", nested(false)),
            ("planarity.csv", panels),
            ("stock.csv", nested(true)),
        ]
        .into_iter()
        .filter_map(|(list, made)| made.then_some(list))
        .collect();
        let timber: &[&str] = if made.is_empty() { &[] } else { &["model.btlx"] };
        let build = |emit: &str| {
            run(program().arg("build").arg(example_path(&name)).args(["--emit", emit, "-o"]).arg(&out)).good()
        };
        let one_each = [
            ("glb", &["model.glb"][..]),
            ("csv", &lists),
            ("btlx", timber),
            ("html", &["report.html"]),
            ("json", &["report.json"]),
        ];
        for (emit, expected) in one_each {
            build(emit);
            let mut expected: Vec<&str> =
                expected.iter().copied().chain(["diagnostics.json", "manifest.json"]).collect();
            expected.sort_unstable();
            let set = contents(&out);
            assert_eq!(set.keys().map(String::as_str).collect::<Vec<_>>(), expected, "--emit {emit}");
        }
        // Both, and the plan printed before the table.
        let printed = build("plan,glb,json");
        assert!(printed.starts_with("state 0 ") && printed.contains("\nfiles "), "{printed}");
        assert_eq!(contents(&out).len(), 4);
    }
}

#[test]
fn an_output_is_the_same_bytes_alone_and_among_others() {
    let folder = scratch("emit-alone");
    for name in examples() {
        let path = example_path(&name);
        run(program().arg("build").arg(&path).arg("-o").arg(folder.join("all"))).good();
        run(program().arg("build").arg(&path).args(["--emit", "glb", "-o"]).arg(folder.join("alone"))).good();
        let (all, alone) = (contents(&folder.join("all")), contents(&folder.join("alone")));
        assert!(all["model.glb"] == alone["model.glb"], "{name}");
    }
}

/// The rows of a list, without its headers.
fn rows(set: &BTreeMap<String, Vec<u8>>, name: &str) -> usize {
    String::from_utf8_lossy(&set[name]).lines().count() - 1
}

fn manifest(set: &BTreeMap<String, Vec<u8>>) -> Value {
    serde_json::from_slice(&set["manifest.json"]).unwrap()
}

#[test]
fn only_boards_that_fit_are_made() {
    let out = scratch("emit-boards").join("out");
    let build = |arguments: &[&str]| {
        run(program().arg("build").arg(example_path("shell")).arg("-o").arg(&out).args(arguments))
    };
    build(&[]).good();
    let whole = contents(&out);
    let programs = |set: &BTreeMap<String, Vec<u8>>, ending: &str| {
        set.keys().filter(|name| name.starts_with("boards/") && name.ends_with(ending)).count()
    };
    assert_eq!(programs(&whole, ".nc"), programs(&whole, ".dxf"));
    assert!(manifest(&whole).get("left_out").is_none(), "nothing is left out");

    // By the alias, two rows; the model, the report and the planarity stay those of the whole.
    let printed = build(&["--only", "shell-00-*", "--only", "shell-02-*"]).good();
    let some = contents(&out);
    let made = programs(&some, ".nc");
    assert!(made > 0 && made < programs(&whole, ".nc"));
    assert!(printed.contains(&format!("{made} boards/*.dxf, {made} boards/*.nc")), "{printed}");
    for (name, bytes) in &some {
        if name.starts_with("boards/") || name == "model.glb" || name == "planarity.csv" {
            assert!(whole[name] == *bytes, "{name} is another one");
        }
    }
    for name in ["cutlist.csv", "assembly.csv"] {
        assert_eq!(rows(&some, name), made, "{name}");
    }
    assert_eq!(rows(&some, "planarity.csv"), rows(&whole, "planarity.csv"));
    let left_out = &manifest(&some)["left_out"];
    assert_eq!(left_out["only"], json!(["shell-00-*", "shell-02-*"]));
    assert_eq!(left_out["boards"], rows(&whole, "cutlist.csv") - made);
    assert_eq!(left_out["outputs"], json!([]));

    // One board by its address, one output.
    let address = manifest(&whole)["files"]
        .as_array()
        .unwrap()
        .iter()
        .find_map(|file| file["address"].as_str())
        .unwrap()
        .to_owned();
    build(&["--only", &address, "--emit", "dxf"]).good();
    let one = contents(&out);
    assert_eq!(one.len(), 3, "{:?}", one.keys());
    let outputs = &manifest(&one)["left_out"]["outputs"];
    assert_eq!(*outputs, json!(["glb", "nc", "btlx", "csv", "svg", "html", "json"]));

    // Nothing fits: wrong usage, and the folder stays as it is.
    build(&["--only", "shell-99-*"]).failed(2, &["no board", "shell-99-*", "shell-00-00"]);
    assert_same(&contents(&out), &one, "after wrong usage");
}

#[test]
fn a_failed_build_leaves_its_diagnostics_and_the_old_files() {
    let folder = scratch("emit-failed");
    let (design, out) = (folder.join("d.ifs"), folder.join("out"));
    let build = || run(program().arg("build").arg(&design).arg("-o").arg(&out));
    let said = |set: &BTreeMap<String, Vec<u8>>| -> Value {
        serde_json::from_slice(&set["diagnostics.json"]).unwrap()
    };

    // Without a set before it there is only what it said.
    fs::write(&design, "figure x = nothing\n").unwrap();
    build().failed(1, &["nothing"]);
    let first = contents(&out);
    assert_eq!(first.keys().collect::<Vec<_>>(), ["diagnostics.json", "manifest.json"]);
    assert_eq!(manifest(&first)["failed"], true);
    let found = said(&first);
    assert_eq!((&found["failed"], &found["errors"]), (&json!(true), &json!(1)));
    assert_eq!(found["diagnostics"][0]["at"]["file"], "d.ifs");

    fs::write(&design, example_text("vault")).unwrap();
    build().good();
    let good = contents(&out);
    assert!(manifest(&good).get("failed").is_none());
    assert_eq!(said(&good)["failed"], false);

    // Over a good set all else stays, byte by byte, and the manifest holds.
    fs::write(&design, "figure x = nothing\n").unwrap();
    build().failed(1, &["nothing"]);
    let after = contents(&out);
    for (name, bytes) in &good {
        let changed = ["diagnostics.json", "manifest.json"].contains(&name.as_str());
        assert!((after[name] != *bytes) == changed, "{name}");
    }
    assert_eq!(after.len(), good.len());
    assert_eq!(manifest(&after)["sources"], manifest(&good)["sources"], "those of the files that stayed");
    let verdict = python_referee("outputs.py", &[&out]);
    assert!(verdict.good, "{}", verdict.faults);

    // A design that is not there says nothing about itself.
    fs::remove_file(&design).unwrap();
    build().failed(3, &["E0306"]);
    assert_same(&contents(&out), &after, "after a design that cannot be read");
    fs::write(&design, example_text("vault")).unwrap();
    build().good();
    assert_same(&contents(&out), &good, "mended");
}
