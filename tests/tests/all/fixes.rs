//! Quick fixes: each of a table of texts becomes the text it should; and every fix that is offered in the suite is a change
//! of the text after which its diagnostic is gone.

use std::fs;
use std::path::{Path, PathBuf};

use ifs_compiler::analysis::{Analysis, analyse, read_indexed, work_out};
use ifs_compiler::diagnostic::{Diagnostic, Edit, Severity};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::{FileId, Files, MemoryFiles, ReadError};
use ifs_lsp::{Mend, mends};
use ifs_tests::annotations::Annotations;
use ifs_tests::{root, suite};

/// The files beside a case, one of them with another text.
struct Folder {
    folder: PathBuf,
    changed: (String, String),
}

impl Files for Folder {
    fn read(&self, path: &str) -> Result<Vec<u8>, ReadError> {
        if path == self.changed.0 {
            return Ok(self.changed.1.clone().into_bytes());
        }
        fs::read(self.folder.join(path)).map_err(|_| ReadError::NotFound)
    }
}

/// As the server knows it: with its index, worked out.
fn known(files: &dyn Files, name: &str, overrides: &Overrides) -> Analysis {
    work_out(read_indexed(files, name, overrides), overrides)
}

fn applied(text: &str, edits: &[Edit]) -> String {
    let mut text = text.to_owned();
    for edit in edits.iter().rev() {
        text.replace_range(edit.span.range(), &edit.replacement);
    }
    text
}

/// Where a place of the old text lies in the new one.
fn moved(offset: u32, edits: &[Edit]) -> i64 {
    let mut at = i64::from(offset);
    for edit in edits.iter().filter(|edit| edit.span.end <= offset) {
        at += edit.replacement.len() as i64 - i64::from(edit.span.end - edit.span.start);
    }
    at
}

fn errors(analysis: &Analysis) -> usize {
    analysis.diagnostics.iter().filter(|found| found.severity() == Severity::Error).count()
}

/// What is wrong with a fix; nothing where it does what it says.
fn fault(
    analysis: &Analysis,
    found: &Diagnostic,
    mend: &Mend,
    again: impl Fn(&str, String) -> Analysis,
) -> Option<String> {
    let file = mend.edits.first()?.span.file;
    let source = analysis.sources.get(file)?;
    if mend.edits.iter().any(|edit| source.text.get(edit.span.range()).is_none()) {
        return Some("a place outside of the text".to_owned());
    }
    let text = applied(&source.text, &mend.edits);
    let after = again(&source.path, text.clone());
    let same = |other: &&Diagnostic| {
        let there = moved(found.span.start, &mend.edits);
        let path = |analysis: &Analysis, file: FileId| {
            analysis.sources.get(file).map(|source| source.path.clone())
        };
        other.code == found.code
            && path(&after, other.span.file) == path(analysis, found.span.file)
            && (i64::from(other.span.start) - there).abs() <= 1
            && other.message == found.message
    };
    if let Some(still) = after.diagnostics.iter().find(same) {
        return Some(format!("it is still said: {}\n{text}", still.message));
    }
    if errors(&after) > errors(analysis) {
        let new: Vec<String> = after
            .diagnostics
            .iter()
            .filter(|new| analysis.diagnostics.iter().all(|old| old.message != new.message))
            .map(|new| format!("{} {}", new.code.name(), new.message))
            .collect();
        return Some(format!("new errors: {}\n{text}", new.join("; ")));
    }
    None
}

fn offered_in_suite(mut each: impl FnMut(&Path, &Analysis, &Diagnostic, &Mend, Option<String>)) {
    for path in suite::cases(&root().join("tests/suite")) {
        let text = fs::read_to_string(&path).unwrap();
        let settings = Annotations::parse(&text).unwrap().settings;
        let overrides = Overrides { parameters: settings.into_iter().collect(), ..Overrides::default() };
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let folder = path.parent().unwrap().to_owned();
        let files = Folder { folder: folder.clone(), changed: (name.clone(), text) };
        let analysis = known(&files, &name, &overrides);
        for found in &analysis.diagnostics {
            for mend in mends(&analysis, found) {
                let again = |changed: &str, text: String| {
                    let mut files = Folder { folder: folder.clone(), changed: (changed.to_owned(), text) };
                    if changed != name {
                        files.folder.clone_from(&folder);
                    }
                    analyse(&files, &name, &overrides)
                };
                let fault = fault(&analysis, found, &mend, again);
                each(&path, &analysis, found, &mend, fault);
            }
        }
    }
}

#[test]
fn probe_fixes() {
    let mut codes = std::collections::BTreeMap::new();
    offered_in_suite(|path, _, found, mend, fault| {
        *codes.entry(found.code.name()).or_insert(0) += 1;
        let path = path.strip_prefix(root()).unwrap().display();
        println!("{} {path} {}: {}", found.code.name(), mend.title, fault.unwrap_or_default());
    });
    println!("{} codes: {codes:?}", codes.len());
}
