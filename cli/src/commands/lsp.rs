//! `ifs lsp`: the language server on standard input and output, with the disk as this program sees it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use ifs_compiler::hir::library_text;
use ifs_lsp::{Project as Served, Projects};

use crate::environment;
use crate::exit::Exit;
use crate::output;
use crate::project::Project;

/// How many files of a kind are looked for in a project, and how deep.
const MOST_FILES: usize = 2_000;
const MOST_FOLDERS: usize = 20;

/// Serves until the client is done.
pub fn lsp() -> Exit {
    match ifs_lsp::serve(Arc::new(Disk::default())) {
        Ok(true) => Exit::Good,
        // The protocol's way to say that the client left without a word.
        Ok(false) => Exit::Design,
        Err(error) => {
            output::message(&format!("error: the language server cannot start: {error}\n"));
            Exit::InputOutput
        }
    }
}

/// The disk.
#[derive(Default)]
struct Disk {
    /// Where modules of the library were put.
    library: Mutex<BTreeMap<String, Option<PathBuf>>>,
}

impl Projects for Disk {
    fn project(&self, path: &Path, open: &dyn Fn(&Path) -> Option<String>) -> Option<Served> {
        let project = Project::silent(path, open)?;
        let overrides = project.overrides(&[]);
        Some(Served {
            root: project.disk.root.clone(),
            design: project.disk.design.clone(),
            files: Arc::new(project.disk),
            overrides,
        })
    }

    fn files(&self, folder: &Path, ending: &str) -> Vec<PathBuf> {
        let mut found = Vec::new();
        below(folder, ending, 0, &mut found);
        found.sort();
        found
    }

    fn library(&self, module: &str) -> Option<PathBuf> {
        let mut known = self.library.lock().unwrap_or_else(PoisonError::into_inner);
        let place = || put(module);
        known.entry(module.to_owned()).or_insert_with(place).clone()
    }
}

/// Puts a module of the library where an editor can open it.
fn put(module: &str) -> Option<PathBuf> {
    let folder = environment::cache()?.join("ifs").join(env!("CARGO_PKG_VERSION")).join("std");
    let text = library_text(module)?;
    fs::create_dir_all(&folder).ok()?;
    // As an editor names it when it is opened.
    let folder = folder.canonicalize().ok()?;
    let path = folder.join(module).with_extension("ifs");
    if fs::read_to_string(&path).is_ok_and(|there| there == text) {
        return Some(path);
    }
    // Two servers may write it at once: each writes its own and puts it there whole.
    let draft = folder.join(format!("{module}.{}.part", std::process::id()));
    fs::write(&draft, text).and_then(|()| fs::rename(&draft, &path)).ok()?;
    Some(path)
}

/// The files of that ending in a folder and those in it, without what is built and what is hidden.
fn below(folder: &Path, ending: &str, depth: usize, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        if found.len() >= MOST_FILES {
            return;
        }
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        let Ok(kind) = entry.file_type() else { continue };
        if kind.is_dir() {
            let passed = name.starts_with('.') || name == "out" || name == "target" || name == "node_modules";
            if !passed && depth < MOST_FOLDERS {
                below(&path, ending, depth + 1, found);
            }
        } else if kind.is_file() && path.extension().is_some_and(|is| is == ending) {
            found.push(path);
        }
    }
}
