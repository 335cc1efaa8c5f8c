//! `ifs build --emit`: the plan printed, held against a golden file for every example (`UPDATE=1` rewrites them), and
//! only the files that were asked for.
#![allow(clippy::disallowed_methods, reason = "the tests read and write files")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;

use ifs_compiler::analysis::Elements;
use ifs_tests::designs::{analysis_of, contents, example_path, example_text, examples};
use ifs_tests::outcome::run;
use ifs_tests::suite::is_update;
use ifs_tests::{program, root, scratch};

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
        let lists: &[&str] = match (made.is_empty(), panels) {
            (true, _) => &[],
            (_, false) => &["cutlist.csv"],
            (_, true) => &["cutlist.csv", "planarity.csv"],
        };
        let build = |emit: &str| {
            run(program().arg("build").arg(example_path(&name)).args(["--emit", emit, "-o"]).arg(&out)).good()
        };
        let one_each = [
            ("glb", &["model.glb"][..]),
            ("csv", lists),
            ("html", &["report.html"]),
            ("json", &["report.json"]),
        ];
        for (emit, expected) in one_each {
            build(emit);
            let mut expected: Vec<&str> = expected.iter().copied().chain(["manifest.json"]).collect();
            expected.sort_unstable();
            let set = contents(&out);
            assert_eq!(set.keys().map(String::as_str).collect::<Vec<_>>(), expected, "--emit {emit}");
        }
        // Both, and the plan printed before the table.
        let printed = build("plan,glb,json");
        assert!(printed.starts_with("state 0 ") && printed.contains("\nfiles "), "{printed}");
        assert_eq!(contents(&out).len(), 3);
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
