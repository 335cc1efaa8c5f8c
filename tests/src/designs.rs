//! Designs for tests: the examples, texts in memory, and what the compiler makes of them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use ifs_compiler::analysis::{Analysis, FigureGeometry, analyse, figure_geometry};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::MemoryFiles;

use crate::root;
use crate::sources::files;

/// The names of all designs in `examples/`, in order.
pub fn examples() -> Vec<String> {
    let paths = files(&root().join("examples"), "ifs");
    assert!(paths.len() >= 2, "the examples are gone");
    paths.iter().map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect()
}

/// Where an example lies.
pub fn example_path(name: &str) -> PathBuf {
    root().join("examples").join(name).with_extension("ifs")
}

/// The text of an example.
pub fn example_text(name: &str) -> String {
    fs::read_to_string(example_path(name)).unwrap()
}

/// What the compiler library makes of a text; it must have no errors.
pub fn analysis_of(text: &str) -> Analysis {
    let analysis = analyse(&MemoryFiles::single("design.ifs", text), "design.ifs", &Overrides::default());
    assert!(!analysis.has_errors(), "{:#?}\n{text}", analysis.diagnostics);
    analysis
}

/// All figures of a design evaluated in doubles, by their names as the plan prints them: `vault[2]`.
pub fn geometries(analysis: &Analysis) -> Vec<(String, FigureGeometry)> {
    let plan = &analysis.plan.as_ref().expect("a design without errors has a plan").plan;
    let geometry = |figure| figure_geometry(plan, figure).expect("coordinates are finite");
    plan.figures().iter().map(|figure| (figure.to_string(), geometry(figure))).collect()
}

/// Every file below a folder with its bytes, by its name with `/`.
pub fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(&next).unwrap_or_else(|error| panic!("{}: {error}", next.display())) {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().to_string_lossy().replace('\\', "/");
                found.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    found
}

/// Asserts that two sets of files are the same bytes; what differs is told by name.
pub fn assert_same(left: &BTreeMap<String, Vec<u8>>, right: &BTreeMap<String, Vec<u8>>, why: &str) {
    let names = |set: &BTreeMap<String, Vec<u8>>| set.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(left), names(right), "{why}: other files");
    let other: Vec<&String> =
        left.iter().filter(|(name, bytes)| right[*name] != **bytes).map(|(name, _)| name).collect();
    assert!(other.is_empty(), "{why}: other bytes in {other:?}");
}
