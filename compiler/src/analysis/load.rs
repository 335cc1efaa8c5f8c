//! Reading and parsing: the design's file, the files it uses, theirs, and the library. What the names in them mean is
//! not looked at.

mod circles;
mod meshes;
mod paths;
pub(super) mod problems;

pub use meshes::MeshFile;

use super::earlier::Earlier;
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::evaluate::MachineName;
use crate::hir::{ImportedMesh, LIBRARY};
use crate::source::{FileId, Files, ReadError, Source, SourceMap, Span};
use crate::syntax::{Parse, ast, parse, parse_again};
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// The most files a design may be made of.
pub const MOST_FILES: usize = 1000;

/// The most bytes the files of a design may have together.
pub const MOST_BYTES: usize = 32 << 20;

/// The parsed library.
#[derive(Debug, Default)]
pub struct Library {
    modules: Vec<(&'static str, FileId, ast::File)>,
    sources: Vec<Arc<Source>>,
}

impl Library {
    /// Each module: its name after `std.`, its file, its tree.
    pub fn modules(&self) -> impl Iterator<Item = (&'static str, FileId, &ast::File)> {
        self.modules.iter().map(|(name, file, ast)| (*name, *file, ast))
    }
}

/// A parsed file of the project.
#[derive(Debug)]
pub struct ProjectFile {
    /// Its identity.
    pub file: FileId,
    /// Its path from the root of the project.
    pub path: String,
    /// Its tree and tokens.
    pub parse: Parse,
    /// Where it names files it uses, and which: those that could be read.
    pub uses: Vec<(Span, FileId)>,
    /// Where it names meshes that there are, and their paths from the root of the project.
    pub meshes: Vec<(Span, String)>,
    /// Where it names meshes, and what they are.
    pub imports: Vec<(Span, ImportedMesh)>,
    /// Whether all of it could be read.
    pub readable: bool,
}

/// The files of a design and the library's, parsed.
pub(super) struct Loaded {
    pub(super) sources: SourceMap,
    /// The design's own file first, then the files it uses in the order they are met.
    pub(super) files: Vec<ProjectFile>,
    /// The meshes that any of them names and that could be read, in the order they are met.
    pub(super) meshes: Vec<MeshFile>,
    /// The file in which a machine is named from outside.
    pub(super) machine: Option<FileId>,
    pub(super) library: &'static Library,
    pub(super) diagnostics: Vec<Diagnostic>,
}

/// Reads a design, and the file of a machine that is named from outside; `before` is what it was some edits ago.
pub(super) fn load(
    files: &dyn Files,
    root: &str,
    machine: Option<&MachineName>,
    before: Option<Earlier>,
) -> Loaded {
    let mut loader = Loader {
        files,
        before,
        sources: SourceMap::default(),
        found: Vec::new(),
        known: BTreeMap::new(),
        meshes: meshes::Meshes::default(),
        bytes: 0,
        full: false,
        diagnostics: Vec::new(),
    };
    match files.read(root) {
        Ok(bytes) => {
            loader.add(root, bytes);
        }
        Err(error) => {
            let file = loader.sources.add(root, "");
            loader.diagnostics.push(problems::unreadable_design(root, &error, file));
            loader.known.insert(root.to_owned(), Ok(0));
            loader.found.push(ProjectFile {
                file,
                path: root.to_owned(),
                parse: Parse::default(),
                uses: Vec::new(),
                meshes: Vec::new(),
                imports: Vec::new(),
                readable: false,
            });
        }
    }
    let library = library();
    for source in &library.sources {
        loader.sources.share(source);
    }
    let machine = machine.and_then(|machine| loader.machine(machine));
    let mut next = 0;
    while next < loader.found.len() {
        loader.follow(next);
        loader.import(next);
        next += 1;
    }
    loader.diagnostics.extend(circles::circles(&loader.found));
    Loaded {
        sources: loader.sources,
        files: loader.found,
        meshes: loader.meshes.files,
        machine,
        library,
        diagnostics: loader.diagnostics,
    }
}

/// The library, parsed once: its files stand behind the design's own in every analysis, so they go by the same identities.
pub(super) fn library() -> &'static Library {
    static PARSED: OnceLock<Library> = OnceLock::new();
    PARSED.get_or_init(|| {
        let mut library = Library::default();
        for (place, (name, text)) in (1..).zip(LIBRARY) {
            let source = Arc::new(Source::new(FileId(place), format!("std.{name}"), *text));
            library.modules.push((*name, source.id, parse(&source).ast));
            library.sources.push(source);
        }
        library
    })
}

/// Why a path leads to no file.
#[derive(Clone, Debug)]
enum Failure {
    Unreadable(ReadError),
    TooManyFiles,
    TooManyBytes,
}

struct Loader<'f> {
    files: &'f dyn Files,
    before: Option<Earlier>,
    sources: SourceMap,
    found: Vec<ProjectFile>,
    /// Every path met, with the place of the file it leads to.
    known: BTreeMap<String, Result<usize, Failure>>,
    meshes: meshes::Meshes,
    bytes: usize,
    /// Whether a limit was hit: no more files are read, which has been said.
    full: bool,
    diagnostics: Vec<Diagnostic>,
}

impl Loader<'_> {
    /// Adds a file and gives its place.
    fn add(&mut self, path: &str, bytes: Vec<u8>) -> usize {
        self.bytes = self.bytes.saturating_add(bytes.len());
        let place = self.found.len();
        let (text, wrong) = decode(bytes);
        let file = self.sources.add(path, text);
        self.diagnostics.extend(wrong.map(|(at, byte)| problems::no_text(file, at, byte)));
        let parse = self.parse(file);
        let readable = wrong.is_none();
        self.known.insert(path.to_owned(), Ok(place));
        self.found.push(ProjectFile {
            file,
            path: path.to_owned(),
            parse,
            uses: Vec::new(),
            meshes: Vec::new(),
            imports: Vec::new(),
            readable,
        });
        place
    }

    fn parse(&mut self, file: FileId) -> Parse {
        let Some(source) = self.sources.get(file) else { return Parse::default() };
        match self.before.as_mut().and_then(|before| before.take(&source.path)) {
            Some((before, known)) => parse_again(source, &before, known),
            None => parse(source),
        }
    }

    /// The file of a machine that is named from outside; `None` after a report.
    fn machine(&mut self, machine: &MachineName) -> Option<FileId> {
        let read = match self.known.get(&machine.file) {
            Some(known) => known.clone(),
            None => self.read(&machine.file),
        };
        let error = match read {
            Ok(place) => return Some(self.found[place].file),
            Err(Failure::Unreadable(error)) => error,
            Err(Failure::TooManyFiles | Failure::TooManyBytes) => {
                ReadError::Other("the design has too many files, or too large ones".to_owned())
            }
        };
        let root = self.found.first().map_or(FileId(0), |file| file.file);
        self.diagnostics.push(super::machine::unreadable(machine, &error, root));
        None
    }

    /// Reads the files that a file uses.
    fn follow(&mut self, place: usize) {
        let parse = &self.found[place].parse;
        let uses = parse.ast.items.iter().filter_map(|item| match &item.kind {
            ast::ItemKind::Use(ast::Use { module: ast::ModulePath::File(path), .. }) => Some(path),
            _ => None,
        });
        let named: Vec<ast::TextLiteral> = uses.filter(|path| is_whole(path, parse)).cloned().collect();
        let from = self.found[place].path.clone();
        for path in named {
            if let Some(used) = self.used(&from, &path) {
                let file = self.found[used].file;
                self.found[place].uses.push((path.span, file));
            }
        }
    }

    /// The place of the file that a path leads to; `None` after a report.
    fn used(&mut self, from: &str, written: &ast::TextLiteral) -> Option<usize> {
        let path = match paths::path(from, &written.value) {
            Ok(path) => path,
            Err(fault) => {
                self.diagnostics.push(problems::no_path(written, &fault, "./ribs.ifs"));
                return None;
            }
        };
        let outcome = match self.known.get(&path) {
            Some(known) => known.clone(),
            None => {
                let outcome = self.read(&path);
                self.known.insert(path.clone(), outcome.clone());
                outcome
            }
        };
        let diagnostic = match outcome {
            Ok(place) => return Some(place),
            Err(Failure::Unreadable(error)) => problems::unreadable(written, &path, &error, "ifs"),
            Err(_) if self.full => return None,
            Err(Failure::TooManyFiles) => problems::too_many_files(written),
            Err(Failure::TooManyBytes) => problems::too_many_bytes(written),
        };
        self.full |= diagnostic.code == Code::E0312;
        self.diagnostics.push(diagnostic);
        None
    }

    /// Reads a file that no path has led to yet.
    fn read(&mut self, path: &str) -> Result<usize, Failure> {
        let resolved = self.files.resolve(path).map_err(Failure::Unreadable)?;
        if let Some(known) = self.known.get(&resolved) {
            return known.clone();
        }
        let bytes = self.bytes_of(&resolved)?;
        Ok(self.add(&resolved, bytes))
    }

    /// The bytes of one more file, within the limits of a design.
    fn bytes_of(&self, path: &str) -> Result<Vec<u8>, Failure> {
        if self.full || self.found.len() + self.meshes.files.len() >= MOST_FILES {
            return Err(Failure::TooManyFiles);
        }
        let bytes = self.files.read(path).map_err(Failure::Unreadable)?;
        if self.bytes.saturating_add(bytes.len()) > MOST_BYTES {
            return Err(Failure::TooManyBytes);
        }
        Ok(bytes)
    }
}

/// Whether a text is without a mistake: else it is not the path that was meant.
fn is_whole(path: &ast::TextLiteral, parse: &Parse) -> bool {
    !parse.diagnostics.iter().any(|wrong| path.span.touches(wrong.span.start))
}

/// The text of a file; where it is not UTF-8, what stands before the first wrong byte, and that byte with its place.
pub(super) fn decode(bytes: Vec<u8>) -> (String, Option<(usize, u8)>) {
    let error = match String::from_utf8(bytes) {
        Ok(text) => return (text, None),
        Err(error) => error,
    };
    let valid = error.utf8_error().valid_up_to();
    let bytes = error.into_bytes();
    let byte = bytes.get(valid).copied().unwrap_or(0);
    (String::from_utf8_lossy(&bytes[..valid]).into_owned(), Some((valid, byte)))
}

#[cfg(test)]
mod tests;
