//! `ifs test`, `ifs params` and `ifs doc` as a user meets them: what is printed, where, and the exit codes.
#![allow(clippy::disallowed_methods, reason = "the tests start programs and write what they read")]
#![allow(clippy::unwrap_used, reason = "a test may fail anywhere")]

use std::fs;

use ifs_tests::designs::{example_path, examples};
use ifs_tests::outcome::run;
use ifs_tests::{program, scratch};
use serde_json::Value;

const DESIGN: &str = "use std.curves (bezier2)\n/// The span.\nparam span: Length = 6m in 4m .. 9m step 50cm\n\
    param count: Int = 3\nparam name: Text = \"north\"\nparam open: Bool = false\nparam tilt: Angle = 30deg in 0deg .. 90deg\n\
    figure arch = bezier2 on ((0m, 0m), (span / 2, 2m), (span, 0m)) at level 3\n\
    test \"eight pieces\" { assert arch.elements == 8 }\n\
    test \"wide\" {\n    assert span >= 6m\n}\n";

#[test]
fn every_example_passes_its_tests() {
    let paths = examples().into_iter().map(|name| example_path(&name));
    let done = run(program().arg("test").args(paths)).good();
    assert!(done.lines().last().unwrap().ends_with(" ok"), "{done}");
    assert!(!done.contains("FAILED") && done.contains("the shell can be built … ok"), "{done}");
}

#[test]
fn a_failing_test_is_told_with_its_sides() {
    let folder = scratch("testing-fails");
    fs::write(folder.join("a.ifs"), DESIGN).unwrap();
    let test = |more: &[&str]| run(program().current_dir(&folder).args(["test", "a.ifs"]).args(more));
    let good = test(&[]).good();
    assert_eq!(good, "a.ifs:9: eight pieces … ok\na.ifs:10: wide … ok\n2 tests, 2 ok\n");
    let bad = test(&["--set", "span=5m"]);
    assert_eq!(bad.code, Some(1));
    assert!(bad.stdout.ends_with("a.ifs:10: wide … FAILED\n2 tests, 1 ok, 1 failed\n"), "{bad:?}");
    assert!(bad.stderr.contains("E1001") && bad.stderr.contains("5000mm is below 6000mm"), "{bad:?}");

    let json = test(&["--set", "span=5m", "--message-format", "json"]);
    let lines: Vec<Value> = json.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(json.code, Some(1));
    assert_eq!((&lines[0]["verdict"], &lines[1]["verdict"]), (&Value::from("ok"), &Value::from("failed")));
    assert_eq!((&lines[1]["test"], &lines[1]["line"]), (&Value::from("wide"), &Value::from(10)));
    assert_eq!((&lines[2]["code"], lines.len()), (&Value::from("E1001"), 3));
}

#[test]
fn tests_of_a_design_with_errors_are_not_run() {
    let folder = scratch("testing-errors");
    fs::write(folder.join("a.ifs"), format!("{DESIGN}let wrong = missing\n")).unwrap();
    let done = run(program().arg("test").arg(folder.join("a.ifs")));
    assert_eq!(done.code, Some(1));
    assert!(done.stderr.contains("E0301"), "{done:?}");
    assert!(done.stdout.contains("wide … not run: the design has errors\n2 tests, 2 not run\n"), "{done:?}");
    assert_eq!(run(program().arg("test").arg(folder.join("none.ifs"))).code, Some(3));
    fs::write(folder.join("b.ifs"), "let a = 1\n").unwrap();
    assert_eq!(run(program().arg("test").arg(folder.join("b.ifs"))).good(), "0 tests\n");
}

#[test]
fn the_library_is_explained() {
    let doc = |more: &[&str]| run(program().arg("doc").args(more));
    assert!(doc(&[]).good().contains("std.materials"));
    assert!(doc(&["curves"]).good().contains("bezier3"));
    let item = doc(&["bezier3"]).good();
    assert!(item.starts_with("ifs bezier3(t: Number = 1/2) on (p0, p1, p2, p3)\n"), "{item}");
    assert!(doc(&["--markdown"]).good().starts_with("# The standard library\n"));
    doc(&["bezeir3"]).failed(2, &["the library has no `bezeir3`", "did you mean `bezier3`?"]);
    doc(&["nonsense_of_mine"]).failed(2, &["`ifs doc` lists the modules"]);
}

#[test]
fn parameters_are_listed() {
    let folder = scratch("testing-params");
    fs::write(folder.join("a.ifs"), DESIGN).unwrap();
    let params = |more: &[&str]| run(program().current_dir(&folder).args(["params", "a.ifs"]).args(more));
    assert_eq!(
        params(&["--set", "span=7m"]).good(),
        "name   type    value    default  range             step\n\
         span   Length  7000mm   6000mm   4000mm .. 9000mm  500mm  The span.\n\
         count  Int     3        3\n\
         name   Text    \"north\"  \"north\"\n\
         open   Bool    false    false\n\
         tilt   Angle   30deg    30deg    0deg .. 90deg\n"
    );
    let list: Value = serde_json::from_str(&params(&["--json", "--set", "span=7m"]).good()).unwrap();
    let span = &list[0];
    assert_eq!((&span["name"], &span["type"]), (&Value::from("span"), &Value::from("Length")));
    assert_eq!((&span["unit"], &span["doc"]), (&Value::from("mm"), &Value::from("The span.")));
    for (key, number) in
        [("default", 6000.0), ("value", 7000.0), ("min", 4000.0), ("max", 9000.0), ("step", 500.0)]
    {
        assert_eq!(span[key]["number"], number, "{key}");
    }
    assert_eq!(list[3]["value"]["text"], "false");
    assert_eq!(list[4]["value"]["number"].as_f64().unwrap().round(), 30.0);
    assert!(list[1]["min"].is_null() && list[1]["step"].is_null());
    params(&["--set", "span=10m"]).failed_with_data(1, "E0601");
    fs::write(folder.join("b.ifs"), "param a: Length = 1m in 2m .. 1m\n").unwrap();
    run(program().arg("params").arg(folder.join("b.ifs"))).failed_with_data(1, "E0607");
    let json = params(&["--json", "--set", "span=500m", "--message-format", "json"]);
    assert!(serde_json::from_str::<Value>(&json.stdout).unwrap().is_array(), "{json:?}");
    let said: Vec<Value> = json.stderr.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((said.len(), &said[0]["code"]), (1, &Value::from("E0601")), "{json:?}");
    fs::write(folder.join("c.ifs"), "let a = 1\n").unwrap();
    assert_eq!(
        run(program().arg("params").arg(folder.join("c.ifs"))).good(),
        "the design has no parameters\n"
    );
}
