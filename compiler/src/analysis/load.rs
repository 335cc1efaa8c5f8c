//! Reading and parsing: the design's file and the library.

use crate::diagnostic::{Code, Diagnostic};
use crate::hir::LIBRARY;
use crate::source::{FileId, Files, ReadError, SourceMap, Span};
use crate::syntax::{Parse, ast, parse};

/// The parsed library.
#[derive(Debug, Default)]
pub struct Library {
    modules: Vec<(&'static str, FileId, ast::File)>,
}

impl Library {
    /// Each module: its name after `std.`, its file, its tree.
    pub fn modules(&self) -> impl Iterator<Item = (&'static str, FileId, &ast::File)> {
        self.modules.iter().map(|(name, file, ast)| (*name, *file, ast))
    }
}

/// A design's text and the library's, parsed.
pub(super) struct Loaded {
    pub(super) sources: SourceMap,
    pub(super) root: FileId,
    pub(super) parse: Parse,
    pub(super) library: Library,
    pub(super) diagnostics: Vec<Diagnostic>,
}

pub(super) fn load(files: &dyn Files, root: &str) -> Loaded {
    let mut sources = SourceMap::default();
    let (text, problem) = match files.read(root) {
        Ok(bytes) => decode(bytes),
        Err(error) => (String::new(), Some(unreadable(root, &error))),
    };
    let id = sources.add(root, text);
    let parse_of = |sources: &SourceMap, id: FileId| sources.get(id).map(parse).unwrap_or_default();
    let parsed = parse_of(&sources, id);
    let mut library = Library::default();
    for (name, text) in LIBRARY {
        let file = sources.add(format!("std.{name}"), *text);
        library.modules.push((name, file, parse_of(&sources, file).ast));
    }
    let diagnostics = problem.into_iter().collect();
    Loaded { sources, root: id, parse: parsed, library, diagnostics }
}

/// The text of a file; where it is not UTF-8, what stands before the first wrong byte.
pub(super) fn decode(bytes: Vec<u8>) -> (String, Option<Diagnostic>) {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return (text, None),
        Err(error) => error,
    };
    let valid = error.utf8_error().valid_up_to();
    let bytes = error.into_bytes();
    let byte = bytes.get(valid).copied().unwrap_or(0);
    let text = String::from_utf8_lossy(&bytes[..valid]).into_owned();
    let at = u32::try_from(valid).unwrap_or(u32::MAX);
    let message = format!("the file is not UTF-8 text: byte {valid} is 0x{byte:02x}");
    let diagnostic = Diagnostic::new(Code::E0101, Span::new(FileId(0), at, at), message)
        .label("up to here it is text")
        .hint("save it as UTF-8; is it really a design?");
    (text, Some(diagnostic))
}

pub(super) fn unreadable(path: &str, error: &ReadError) -> Diagnostic {
    let why = match error {
        ReadError::NotFound => "there is no such file".to_owned(),
        ReadError::OutsideRoot => "it lies outside of the project".to_owned(),
        ReadError::Other(why) => why.clone(),
    };
    let message = format!("`{path}` cannot be read: {why}");
    Diagnostic::new(Code::E0306, Span::new(FileId(0), 0, 0), message).hint("is the path right?")
}
