//! Designs of several files as a user has them on disk: where they may lie, what is said of them and under which names,
//! and that what is built depends on nothing but the project.
#![allow(clippy::disallowed_methods, reason = "the tests start programs and write what they read")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use ifs_tests::designs::{assert_same, contents};
use ifs_tests::outcome::{run, run_with};
use ifs_tests::{program, root, scratch};
use serde_json::Value;

const DESIGN: &str = "use \"../parts/ribs.ifs\" (rib)\nfigure arch = rib(3m)\n";
const RIBS: &str = "use std.curves (bezier2)\nuse \"./sizes.ifs\" (rise)\n/// A rib.\npub fn rib(span: Length) \
                    -> Curve = bezier2 on ((0m, 0m), (span / 2, rise), (span, 0m)) at level 3\n";
const SIZES: &str = "pub param rise: Length = 2m in 1m .. 4m\n";

const PLANKS: &str = "use std.materials (sawn_spruce)\nuse std.machines (router3)\nfabricate arch as planks { \
                      material: sawn_spruce section: 60mm by 27mm stock: 4m ends: square machine: router3(tool: 8mm) \
                      }\n";

/// A project of three files, marked by an `ifs.toml`.
fn project(folder: &Path) {
    fs::create_dir_all(folder.join("designs")).unwrap();
    fs::create_dir_all(folder.join("parts")).unwrap();
    fs::write(folder.join("ifs.toml"), "").unwrap();
    fs::write(folder.join("designs/arch.ifs"), DESIGN).unwrap();
    fs::write(folder.join("parts/ribs.ifs"), RIBS).unwrap();
    fs::write(folder.join("parts/sizes.ifs"), SIZES).unwrap();
}

#[test]
fn a_project_builds_the_same_wherever_it_lies_and_whoever_calls() {
    let folder = scratch("project-same");
    let (here, there) = (folder.join("here"), folder.join("there/deeper"));
    project(&here);
    project(&there);
    let build = |from: &Path, design: &str| {
        run(program().current_dir(from).args(["build", design, "-o", "made"])).good();
        contents(&from.join("made"))
    };
    let set = build(&here, "designs/arch.ifs");
    assert_same(&set, &build(&here.join("designs"), "arch.ifs"), "from another folder");
    assert_same(&set, &build(&there.join("parts"), "../designs/./arch.ifs"), "a copy elsewhere");
    let manifest: Value = serde_json::from_slice(&set["manifest.json"]).unwrap();
    let sources: Vec<&str> = manifest["sources"]
        .as_array()
        .unwrap()
        .iter()
        .map(|source| source["path"].as_str().unwrap())
        .collect();
    assert_eq!(sources, ["designs/arch.ifs", "parts/ribs.ifs", "parts/sizes.ifs"]);
}

#[test]
fn every_file_counts_for_the_hash_of_the_design() {
    let folder = scratch("project-hash");
    project(&folder);
    let program_of = || {
        let design = folder.join("designs/arch.ifs");
        fs::write(&design, format!("{DESIGN}{PLANKS}")).unwrap();
        run(program().current_dir(&folder).args(["build", "designs/arch.ifs", "-o", "made"])).good();
        let set = contents(&folder.join("made"));
        let (_, text) = set.iter().find(|(name, _)| name.ends_with(".nc")).unwrap();
        String::from_utf8(text.clone()).unwrap()
    };
    let before = program_of();
    fs::write(folder.join("parts/sizes.ifs"), format!("{SIZES}// a word\n")).unwrap();
    let after = program_of();
    assert_ne!(before, after, "the header names the hash of all files");
}

#[test]
fn a_mesh_counts_for_the_hash_of_the_design_and_is_among_its_sources() {
    let folder = scratch("project-mesh");
    project(&folder);
    let mesh = fs::read(root().join("tests/suite/meshes/joint.glb")).unwrap();
    let design = "ifs tip in space {\n    transform half = scale(1/2) * self\n    germ import(\"../parts/joint.glb\")\n}\n\
                  figure tips = tip at level 1\nfigure again = tip at level 0\n";
    fs::write(folder.join("designs/tip.ifs"), format!("{DESIGN}{design}{PLANKS}")).unwrap();
    let built = |bytes: &[u8]| {
        fs::write(folder.join("parts/joint.glb"), bytes).unwrap();
        run(program().current_dir(&folder).args(["build", "designs/tip.ifs", "-o", "made"])).good();
        let set = contents(&folder.join("made"));
        let (_, program) = set.iter().find(|(name, _)| name.ends_with(".nc")).unwrap();
        let manifest: Value = serde_json::from_slice(&set["manifest.json"]).unwrap();
        (String::from_utf8(program.clone()).unwrap(), manifest["sources"].clone())
    };
    let (program, sources) = built(&mesh);
    let paths: Vec<&str> =
        sources.as_array().unwrap().iter().map(|source| source["path"].as_str().unwrap()).collect();
    assert_eq!(paths, ["designs/tip.ifs", "parts/joint.glb", "parts/ribs.ifs", "parts/sizes.ifs"]);
    // Bytes after the end that the file says it has: the same mesh, another file.
    let (longer, others) = built(&[mesh.as_slice(), b"more"].concat());
    assert_ne!(program, longer, "the header names the hash of all files");
    assert_ne!(sources[1]["sha256"], others[1]["sha256"]);
}

#[test]
fn files_are_named_from_where_the_design_was_named() {
    let folder = scratch("project-names");
    project(&folder);
    fs::write(folder.join("parts/sizes.ifs"), "pub let rise = 2m + 1deg\n").unwrap();
    for (from, design, shown) in [
        ("", "designs/arch.ifs", "parts/sizes.ifs"),
        ("designs", "arch.ifs", "../parts/sizes.ifs"),
        ("parts", "../designs/arch.ifs", "../parts/sizes.ifs"),
    ] {
        let done =
            run(program().current_dir(folder.join(from)).args(["check", design, "--message-format", "json"]));
        assert_eq!(done.code, Some(1), "{done:?}");
        let found: Value = serde_json::from_str(&done.stdout).unwrap();
        assert_eq!(found["code"], "E0402");
        assert_eq!(found["at"]["file"], shown);
        assert_eq!(found["at"]["line"], 1);
    }
    let whole = folder.join("designs/arch.ifs");
    run(program().arg("check").arg(&whole)).failed(1, &["E0402", "parts/sizes.ifs:1:"]);
}

#[cfg(unix)]
#[test]
fn nothing_outside_of_the_project_is_read() {
    use std::os::unix::fs::symlink;
    let folder = scratch("project-outside");
    let inside = folder.join("project");
    project(&inside);
    fs::write(folder.join("secret.ifs"), "pub fn rib(span: Length) -> Length = span\n").unwrap();
    let check = |text: &str| {
        fs::write(inside.join("designs/arch.ifs"), text).unwrap();
        run(program().arg("check").arg(inside.join("designs/arch.ifs")))
    };
    symlink(folder.join("secret.ifs"), inside.join("parts/link.ifs")).unwrap();
    symlink(&folder, inside.join("up")).unwrap();
    for path in ["../../secret.ifs", "../parts/link.ifs", "../up/secret.ifs"] {
        check(&format!("use \"{path}\" (rib)\n")).failed(3, &["E0306", "outside of the project"]);
    }
    check("use \"../parts\" (rib)\n").failed(3, &["E0306", "it is a folder"]);
    assert!(
        std::process::Command::new("mkfifo").arg(inside.join("parts/pipe.ifs")).status().unwrap().success()
    );
    check("use \"../parts/pipe.ifs\" (rib)\n").failed(3, &["E0306", "no ordinary file"]);
    fs::write(inside.join("parts/latin.ifs"), b"pub let a = \"\xfc\"\n").unwrap();
    check("use \"../parts/latin.ifs\" (a, lost)\nlet b = [a, lost]\n")
        .failed(1, &["E0101", "parts/latin.ifs", "1 error\n"]);

    // A link to a file of the project is that file.
    symlink(inside.join("parts/sizes.ifs"), inside.join("parts/same.ifs")).unwrap();
    fs::write(inside.join("parts/sizes.ifs"), "pub record Size { a: Length }\npub let one = Size(a: 1m)\n")
        .unwrap();
    run_with(
        program().args(["check", "-"]).current_dir(inside.join("designs")),
        b"use \"../parts/sizes.ifs\" (Size)\nuse \"../parts/same.ifs\" (one)\nlet a: Size = one\n",
    )
    .good();
    // The design itself is read from where it was named, also through a link.
    symlink(inside.join("parts/sizes.ifs"), folder.join("linked.ifs")).unwrap();
    run(program().arg("check").arg(folder.join("linked.ifs"))).good();
}

/// The value of `span` in the report of a build.
fn span_of(out: &Path) -> String {
    let report: Value = serde_json::from_slice(&fs::read(out.join("report.json")).unwrap()).unwrap();
    report["parameters"][0]["value"].as_str().unwrap().to_owned()
}

#[test]
fn what_a_project_sets_loses_against_what_is_nearer() {
    let folder = scratch("project-sets");
    fs::create_dir(folder.join("designs")).unwrap();
    let design = "use std.curves (bezier2)\nparam span: Length = 3m in 1m .. 9m\n\
                  figure arch = bezier2 on ((0m, 0m), (span / 2, 2m), (span, 0m)) at level 2\n";
    fs::write(folder.join("designs/arch.ifs"), design).unwrap();
    let built = |text: &str, variables: &[(&str, &str)], more: &[&str]| {
        fs::write(folder.join("ifs.toml"), text).unwrap();
        let mut command = program();
        command.current_dir(folder.join("designs")).args(["build", "arch.ifs"]).args(more);
        run(command.envs(variables.iter().copied()))
    };
    let project = "out = \"made\"\n[params]\nspan = \"4m\"\nwidth = \"27mm\"\n";
    built("", &[], &[]).good();
    assert_eq!(span_of(&folder.join("designs/out/arch")), "3000mm");
    built(project, &[], &[]).good();
    assert_eq!(span_of(&folder.join("made/arch")), "4000mm");
    let variables = [("IFS_OUT", "elsewhere"), ("IFS_PARAM_SPAN", "5m"), ("IFS_PARAM_OTHER", "x")];
    built(project, &variables, &[]).good();
    assert_eq!(span_of(&folder.join("designs/elsewhere/arch")), "5000mm");
    built(project, &variables, &["--set", "span=6m", "-o", "here"]).good();
    assert_eq!(span_of(&folder.join("designs/here")), "6000mm");

    // What is wrong is said where it is set.
    let wrong = built("[params]\nspan = \"10m\"\n", &[], &[]);
    wrong.failed(1, &["E0601", "`ifs.toml` sets it"]);
    let wrong = built("", &[("IFS_PARAM_SPAN", "7deg")], &[]);
    wrong.failed(1, &["E0606", "the variable `IFS_PARAM_SPAN` sets it"]);
    let warned = built("[params]\nspam = \"4m\"\n", &[], &[]);
    assert_eq!(warned.code, Some(0));
    assert!(warned.stderr.contains("W0316") && warned.stderr.contains("../ifs.toml:2:1"), "{warned:?}");
    built("outt = \"x\"\n", &[], &[]).failed(1, &["E0314", "../ifs.toml:1:1", "did you mean `out`?"]);
    built("machine = \"router3\"\n", &[], &[]).failed(1, &["E0315", "is no file and name"]);
    fs::write(folder.join("ifs.toml"), b"\xff").unwrap();
    run(program().current_dir(&folder).args(["check", "designs/arch.ifs"]))
        .failed(1, &["E0313", "not UTF-8"]);
}

const SHOP: &str = "use std.machines (router3)\nlet travel = 2m\nlet grbl = router3(tool: 8mm, dialect: grbl)\nlet fanuc = \
                    router3(tool: 8mm, dialect: fanuc)\n";

#[test]
fn a_machine_of_a_file_takes_the_place_of_the_designs() {
    let folder = scratch("project-machine");
    project(&folder);
    fs::write(folder.join("designs/arch.ifs"), format!("{DESIGN}{PLANKS}")).unwrap();
    fs::write(folder.join("shop.ifs"), SHOP).unwrap();
    let build = |arguments: &[&str], variable: Option<&str>| {
        let mut command = program();
        command
            .current_dir(folder.join("designs"))
            .args(["build", "arch.ifs", "-o", "../made"])
            .args(arguments);
        if let Some(variable) = variable {
            command.env("IFS_MACHINE", variable);
        }
        command
    };
    let machine = |set: &BTreeMap<String, Vec<u8>>| -> (String, String, usize) {
        let of = |name: &str| -> String {
            let json: Value = serde_json::from_slice(&set[name]).unwrap();
            json["machine"].as_str().unwrap_or("none").to_owned()
        };
        (of("manifest.json"), of("report.json"), set.keys().filter(|name| name.ends_with(".t1.nc")).count())
    };
    let made = || contents(&folder.join("made"));
    run(&mut build(&[], None)).good();
    let own = made();
    assert_eq!(machine(&own), ("none".to_owned(), "none".to_owned(), 0));
    run(&mut build(&["--machine", "../shop.ifs:grbl"], None)).good();
    let grbl = made();
    let named = "shop.ifs:grbl".to_owned();
    assert_eq!(machine(&grbl), (named.clone(), named.clone(), 8));
    let manifest: Value = serde_json::from_slice(&grbl["manifest.json"]).unwrap();
    assert!(manifest["sources"].as_array().unwrap().iter().any(|source| source["path"] == "shop.ifs"));
    // The same by the environment and by the project; the argument wins.
    run(&mut build(&[], Some("../shop.ifs:grbl"))).good();
    assert_same(&grbl, &made(), "IFS_MACHINE");
    fs::write(folder.join("ifs.toml"), "machine = \"shop.ifs:grbl\"\n").unwrap();
    run(&mut build(&[], None)).good();
    assert_same(&grbl, &made(), "ifs.toml");
    run(&mut build(&["--machine", "../shop.ifs:fanuc"], None)).good();
    assert_eq!(machine(&made()).0, "shop.ifs:fanuc");
    fs::write(folder.join("ifs.toml"), "").unwrap();
    let outside = scratch("project-machine-outside").join("shop.ifs");
    fs::write(&outside, SHOP).unwrap();
    let outside = format!("{}:grbl", outside.display());
    for (named, code, said) in [
        ("../none.ifs:grbl", "E0860", "there is no such file"),
        (outside.as_str(), "E0860", "outside of the project"),
        ("../shop.ifs:grbll", "E0861", "did you mean `grbl`?"),
        ("../shop.ifs:travel", "E0862", "is no machine"),
    ] {
        let found = build(&["--machine", named], None).output().unwrap();
        let text = String::from_utf8(found.stderr).unwrap();
        assert_eq!(found.status.code(), Some(1), "{named}: {text}");
        assert!(text.contains(code) && text.contains(said), "{named}: {text}");
    }
    assert_eq!(build(&["--machine", "shop.ifs"], None).output().unwrap().status.code(), Some(2));
}
