//! The annotated suite: its files, running one of them against an analysis, and which codes it covers.
//!
//! Nothing here knows the compiler: the analysis is a function from a file and its settings to what it finds.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::annotations::{Annotations, Found, update};
use crate::sources::files;

/// An analysis: the text of a test, its path, and the parameters it sets, to the diagnostics found.
pub type Analyse<'a> = dyn Fn(&str, &Path, &[(String, String)]) -> Vec<Found> + 'a;

/// The files of a suite that are tests, in order. Those in a folder `parts` are used by others.
pub fn cases(folder: &Path) -> Vec<PathBuf> {
    let is_case = |path: &PathBuf| !path.iter().any(|part| part == "parts");
    files(folder, "ifs").into_iter().filter(is_case).collect()
}

/// Runs one test. With `rewrite`, its annotations are brought up to date instead of compared.
///
/// # Errors
/// The file cannot be read or its annotations cannot, or what is found differs from what is stated.
pub fn run(path: &Path, rewrite: bool, analyse: &Analyse<'_>) -> Result<(), String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let annotations = Annotations::parse(&text)?;
    let found = analyse(&text, path, &annotations.settings);
    let difference = annotations.compare(&found);
    if difference.is_empty() {
        Ok(())
    } else if rewrite {
        fs::write(path, update(&text, &found)?).map_err(|error| format!("{}: {error}", path.display()))
    } else {
        Err(format!("{}\n{difference}(UPDATE=1 rewrites the annotations)", path.display()))
    }
}

/// Whether the annotations are to be brought up to date: `UPDATE=1`.
pub fn is_update() -> bool {
    std::env::var_os("UPDATE").is_some_and(|value| value == "1")
}

/// The codes that the tests of a suite state.
///
/// # Errors
/// A file cannot be read.
pub fn covered(folder: &Path) -> Result<BTreeSet<String>, String> {
    let mut codes = BTreeSet::new();
    for path in cases(folder) {
        let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        codes.extend(Annotations::parse(&text)?.expected.into_iter().map(|(_, expected)| expected.code));
    }
    Ok(codes)
}

/// What is wrong with the coverage of a table of codes. A code is covered by a test of the suite, or `elsewhere` names
/// the test function for it (codes of input and output, or of text that is not UTF-8), which must be in `tests`, the
/// text of the other tests.
pub fn faults_of_coverage(
    table: &[&str],
    covered: &BTreeSet<String>,
    elsewhere: &[(&str, &str)],
    tests: &str,
) -> Vec<String> {
    let mut faults = Vec::new();
    for code in table {
        if !covered.contains(*code) && !elsewhere.iter().any(|(other, _)| other == code) {
            faults.push(format!("{code} is stated by no test"));
        }
    }
    for (code, name) in elsewhere {
        if covered.contains(*code) {
            faults.push(format!("{code} is covered by the suite and need not be listed"));
        }
        if !tests.contains(&format!("fn {name}(")) {
            faults.push(format!("{code} is covered by {name}, which is not there"));
        }
    }
    let listed = covered.iter().map(String::as_str).chain(elsewhere.iter().map(|(code, _)| *code));
    for code in listed.collect::<BTreeSet<_>>() {
        if !table.contains(&code) {
            faults.push(format!("{code} is in no table"));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scratch;

    #[test]
    fn a_test_fails_until_its_annotations_are_right() {
        let folder = scratch("suite");
        fs::create_dir(folder.join("parts")).unwrap();
        fs::write(folder.join("parts/x.ifs"), "//~ E0999 1:1..1:2\n").unwrap();
        let path = folder.join("a.ifs");
        fs::write(&path, "//@ set span=4m\nlet a = b\n").unwrap();
        assert_eq!(cases(&folder), std::slice::from_ref(&path));
        let analyse = |text: &str, _: &Path, settings: &[(String, String)]| {
            assert_eq!(settings, [("span".to_owned(), "4m".to_owned())]);
            let line = text.lines().position(|line| line.starts_with("let")).unwrap() + 1;
            let message = "not known".to_owned();
            vec![Found { file: None, start: (line, 9), end: (line, 10), code: "E0301".into(), message }]
        };
        let failed = run(&path, false, &analyse).unwrap_err();
        assert!(failed.contains("found and not stated:\n    //~ E0301 2:9..2:10 not known"), "{failed}");
        run(&path, true, &analyse).unwrap();
        run(&path, false, &analyse).unwrap();
        assert_eq!(covered(&folder).unwrap(), BTreeSet::from(["E0301".to_owned()]));
    }

    #[test]
    fn coverage_has_no_holes() {
        let covered = BTreeSet::from(["E1".to_owned()]);
        let tests = "fn not_utf8() {}";
        assert!(faults_of_coverage(&["E1", "E2"], &covered, &[("E2", "not_utf8")], tests).is_empty());
        assert_eq!(faults_of_coverage(&["E1", "E2"], &covered, &[], tests).len(), 1);
        assert_eq!(faults_of_coverage(&["E1", "E2"], &covered, &[("E2", "gone")], tests).len(), 1);
        assert_eq!(faults_of_coverage(&["E1"], &covered, &[("E1", "not_utf8")], tests).len(), 1);
        assert_eq!(faults_of_coverage(&[], &covered, &[], tests).len(), 1);
        assert_eq!(faults_of_coverage(&["E1"], &covered, &[("E3", "not_utf8")], tests).len(), 1);
    }
}
