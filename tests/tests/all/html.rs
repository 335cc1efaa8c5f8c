//! `report.html` in a browser: Chromium loads it without a word on its console and prints it on pages that hold all of it.
//! What it says is judged with the other files of the examples.
#![allow(clippy::disallowed_methods, reason = "the tests read what the program writes")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail anywhere")]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use ifs_tests::designs::example_path;
use ifs_tests::outcome::run;
use ifs_tests::referees::python_referee;
use ifs_tests::{program, scratch};

/// Loads a page and prints it as PDF; what the page said on its console.
fn print(page: &Path, pdf: &Path) -> Vec<String> {
    let profile = pdf.with_extension("profile");
    let Output { status, stderr, .. } = Command::new("chromium")
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--enable-logging=stderr",
            "--no-pdf-header-footer",
        ])
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("--print-to-pdf={}", pdf.display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .unwrap_or_else(|error| panic!("chromium does not run ({error}): run tests/setup.sh"));
    let said = String::from_utf8_lossy(&stderr);
    assert!(status.success() && pdf.exists(), "{said}");
    said.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect()
}

/// The pages of a PDF as text.
fn pages(pdf: &Path) -> Vec<String> {
    let output = Command::new("pdftotext").arg("-layout").arg(pdf).arg("-").output();
    let output =
        output.unwrap_or_else(|error| panic!("pdftotext does not run ({error}): run tests/setup.sh"));
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let mut pages: Vec<String> = text.split('\u{c}').map(str::to_owned).collect();
    assert_eq!(pages.pop().as_deref(), Some(""));
    pages
}

#[test]
fn chromium_shows_and_prints_the_report() {
    let folder = scratch("html-chromium");
    for (name, least, most) in [("shell", 7, 13), ("lattice", 7, 15)] {
        let out = folder.join(name);
        run(program().arg("build").arg(example_path(name)).args(["--emit", "html,json", "-o"]).arg(&out))
            .good();
        let pdf = folder.join(format!("{name}.pdf"));
        assert_eq!(print(&out.join("report.html"), &pdf), [""; 0], "{name}");
        let pages = pages(&pdf);
        assert!((least..=most).contains(&pages.len()), "{name}: {} pages", pages.len());
        // The head of the cut list is on each of its pages, up to its last column.
        let listed: Vec<&String> = pages.iter().filter(|page| page.contains("Mass")).collect();
        assert!(listed.len() >= 2);
        let report: serde_json::Value =
            serde_json::from_str(&fs::read_to_string(out.join("report.json")).unwrap()).unwrap();
        let made = report["fabrications"].as_array().unwrap();
        for part in made.iter().flat_map(|made| made["parts"].as_array().unwrap()) {
            let (alias, length) = (part["alias"].as_str().unwrap(), part["length_mm"].as_f64().unwrap());
            let row = |page: &&String| {
                page.lines().any(|line| {
                    let mut words = line.split_whitespace();
                    words.next() == Some(alias) && words.next() == Some(&format!("{length:.1}"))
                })
            };
            assert!(listed.iter().any(row), "{name}: {alias} with {length} is on no page under a head");
        }
    }
}

#[test]
fn chromium_s_console_is_heard() {
    let folder = scratch("html-console");
    let page = folder.join("page.html");
    fs::write(&page, "<!DOCTYPE html><html><script>console.error('heard')</script></html>").unwrap();
    let said = print(&page, &folder.join("page.pdf"));
    assert!(said.iter().any(|line| line.contains("heard")), "{said:?}");
}

#[test]
fn the_referee_refuses_other_pages() {
    let folder = scratch("html-changed");
    run(program().arg("build").arg(example_path("shell")).args(["--emit", "html,json", "-o"]).arg(&folder))
        .good();
    let path = folder.join("report.html");
    let good = fs::read_to_string(&path).unwrap();
    let refused = |from: &str, to: &str| {
        assert!(good.contains(from), "{from:?} is not there");
        fs::write(&path, good.replacen(from, to, 1)).unwrap();
        let verdict = python_referee("html.py", &[&folder]);
        assert!(!verdict.good, "{to:?} for {from:?} was taken");
        verdict.faults
    };
    assert!(refused("</body>", "<script></script></body>").contains("script"));
    assert!(refused("data-holds=\"true\"", "data-holds=\"false\"").contains("verdict"));
    assert!(refused(">07-12<", ">07-13<").contains("shell-07-12"));
    assert!(refused("data-bin=\"0\"", "data-bin=\"39\"").contains("bars"));
    let after = good.split("<data value=\"0.9998").nth(1).unwrap().split("</data>").next().unwrap();
    let shown = after.rsplit('>').next().unwrap();
    let other = after.replace(&format!(">{shown}"), ">0.99979");
    assert!(refused(after, &other).contains("shown as 0.99979"));
    fs::write(&path, &good).unwrap();
    assert!(python_referee("html.py", &[&folder]).good);
}
