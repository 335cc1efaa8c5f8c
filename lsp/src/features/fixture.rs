//! Designs for the tests of features: texts in which `$0` is the cursor.

use ifs_compiler::analysis::{Analysis, analyse, read_indexed};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::MemoryFiles;

use super::facts::WorkedOut;

/// A design with its cursor.
pub(crate) struct Fixture {
    pub(crate) analysis: Analysis,
    pub(crate) at: u32,
    files: MemoryFiles,
    overrides: Overrides,
}

/// The file `design.ifs` of this text.
pub(crate) fn fixture(text: &str) -> Fixture {
    with_files(text, &[])
}

/// The same beside other files.
pub(crate) fn with_files(text: &str, others: &[(&str, &str)]) -> Fixture {
    let at = text.find("$0").unwrap_or(text.len());
    let mut files = MemoryFiles::single("design.ifs", &text.replacen("$0", "", 1));
    for (path, text) in others {
        files = files.with(path, *text);
    }
    let analysis = read_indexed(&files, "design.ifs", &Overrides::default());
    Fixture { analysis, at: at as u32, files, overrides: Overrides::default() }
}

impl Fixture {
    /// The design worked out.
    pub(crate) fn made(&self) -> Analysis {
        analyse(&self.files, "design.ifs", &self.overrides)
    }

    /// What a hover knows; `made` is of the text as it is.
    pub(crate) fn known<'a>(&'a self, made: Option<&'a Analysis>) -> WorkedOut<'a> {
        WorkedOut { made, current: made.is_some(), overrides: &self.overrides }
    }
}
