//! One text alone, read and parsed: all that a formatter needs to know of a file.

use super::load::{decode, problems};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::source::{FileId, Files, SourceMap};
use crate::syntax::{Parse, parse};

/// A file as a text and its tree.
#[derive(Debug)]
pub struct SingleText {
    /// The text, alone.
    pub sources: SourceMap,
    /// Its identity.
    pub root: FileId,
    /// Its tree and tokens.
    pub parse: Parse,
    /// Why it could not be read, or what is wrong with its form, by place.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads and parses one file; what it names is not looked for.
pub fn single(files: &dyn Files, path: &str) -> SingleText {
    let mut sources = SourceMap::default();
    let read = files.read(path);
    let (text, wrong) = match read.as_ref().ok() {
        Some(bytes) => decode(bytes.clone()),
        None => (String::new(), None),
    };
    let root = sources.add(path, text);
    let problem = match read {
        Err(error) => Some(problems::unreadable_design(path, &error, root)),
        Ok(_) => wrong.map(|(at, byte)| problems::no_text(root, at, byte)),
    };
    let parse = sources.get(root).map(parse).unwrap_or_default();
    let mut diagnostics = Diagnostics::default();
    match problem {
        // Of a text that could not be read to its end nothing more is said.
        Some(problem) => diagnostics.extend([problem]),
        None => diagnostics.extend(parse.diagnostics.iter().cloned()),
    }
    SingleText { sources, root, parse, diagnostics: diagnostics.finish() }
}
