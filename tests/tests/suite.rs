//! The annotated suite: each `.ifs` file below `tests/suite` is one test, and what the analysis finds in it is what its
//! annotations state. `UPDATE=1` rewrites the annotations.
#![allow(clippy::disallowed_methods, reason = "the tests read the suite")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use ifs_compiler::analysis::{Unwatched, analyse, run_tests};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::outputs::workshop_faults;
use ifs_compiler::source::{Files, ReadError};
use ifs_tests::annotations::{Found, position};
use ifs_tests::{root, suite};
use libtest_mimic::{Arguments, Trial};

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let folder = root().join("tests/suite");
    let cases = suite::cases(&folder).into_iter().map(|path| {
        let name = path.strip_prefix(&folder).unwrap_or(&path).display().to_string();
        Trial::test(name, move || Ok(suite::run(&path, suite::is_update(), &analysed)?))
    });
    libtest_mimic::run(&arguments, cases.collect()).exit_code()
}

/// The files beside a test.
struct Folder(PathBuf);

impl Files for Folder {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        fs::read(self.0.join(path)).map_err(|error| match error.kind() {
            std::io::ErrorKind::NotFound => ReadError::NotFound,
            _ => ReadError::Other(error.to_string()),
        })
    }
}

fn analysed(_: &str, path: &Path, settings: &[(String, String)]) -> Vec<Found> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let overrides = Overrides { parameters: settings.iter().cloned().collect(), ..Overrides::default() };
    let analysis = analyse(&Folder(folder.to_owned()), &name, &overrides);
    // The tests in a case are run too: what they find is stated like all else.
    let results = run_tests(&analysis, &overrides);
    let tested = results.iter().flat_map(|result| &result.diagnostics);
    let in_the_workshop = workshop_faults(&analysis, &mut Unwatched);
    let found = analysis.diagnostics.iter().chain(tested).chain(&in_the_workshop).map(|diagnostic| {
        let source = analysis.sources.get(diagnostic.span.file);
        let place = |byte: u32| source.map_or((1, 1), |source| position(&source.text, byte as usize));
        Found {
            file: source.filter(|source| source.id != analysis.root).map(|source| source.path.clone()),
            start: place(diagnostic.span.start),
            end: place(diagnostic.span.end),
            code: diagnostic.code.name().to_owned(),
            message: diagnostic.message.clone(),
        }
    });
    found.collect()
}
