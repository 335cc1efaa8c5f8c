//! The project of a design: its folder, and how the paths in it are shown. The folder is that of the nearest `ifs.toml`
//! upwards, else that of the design.

use std::path::{Component, Path, PathBuf};

use ifs_compiler::analysis::{Analysis, analyse};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::source::SourceMap;

use crate::sources::{Disk, slashed};

/// The name of the file that marks a project's folder.
pub const PROJECT_FILE: &str = "ifs.toml";

/// A design in its project.
#[derive(Debug, Clone)]
pub struct Project {
    /// Its files.
    pub disk: Disk,
    /// The folder of the project as it is shown: from where the design was named.
    shown: PathBuf,
    /// Whether an `ifs.toml` marks it.
    pub marked: bool,
}

impl Project {
    /// The project of the design that was named; `-` is the standard input, whose folder is the working folder. `None`
    /// where a path is not UTF-8.
    pub fn of(named: &Path) -> Option<Project> {
        let stdin = named == Path::new("-");
        let folder = if stdin { Path::new("") } else { named.parent().unwrap_or(Path::new("")) };
        let name = if stdin { "-" } else { named.file_name().unwrap_or(named.as_os_str()).to_str()? };
        named.to_str()?;
        let looked = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        // A folder that is not there has no project; the design in it cannot be read, which is said then.
        let real = looked.canonicalize().unwrap_or_else(|_| looked.to_owned());
        let marked = real.ancestors().find(|above| above.join(PROJECT_FILE).is_file());
        let root = marked.unwrap_or(&real).to_owned();
        let inner = real.strip_prefix(&root).ok()?;
        let depth = inner.components().count();
        let design = slashed(&inner.join(name))?;
        let is_marked = marked.is_some();
        let disk = Disk { root, design, named: named.to_owned() };
        Some(Project { disk, shown: above(folder, depth), marked: is_marked })
    }

    /// Analyses the design.
    pub fn analyse(&self, overrides: &Overrides) -> Analysis {
        analyse(&self.disk, &self.disk.design, overrides)
    }

    /// The sources of an analysis with the paths a person knows them by.
    pub fn shown(&self, sources: &SourceMap) -> SourceMap {
        sources.shown_as(|source| {
            if source.path == self.disk.design {
                self.disk.named.display().to_string()
            } else if source.path.starts_with("std.") {
                source.path.clone()
            } else {
                self.shown.join(&source.path).display().to_string()
            }
        })
    }
}

/// The folder so many levels above another, by the letters of its path.
fn above(folder: &Path, levels: usize) -> PathBuf {
    let mut path = folder.to_owned();
    for _ in 0..levels {
        match path.components().next_back() {
            Some(Component::Normal(_)) => {
                path.pop();
            }
            _ => path.push(".."),
        }
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_above() {
        for (folder, levels, found) in [
            ("", 0, ""),
            ("", 2, "../.."),
            ("a/b", 1, "a"),
            ("a", 2, ".."),
            ("..", 1, "../.."),
            ("/a/b", 2, "/"),
        ] {
            assert_eq!(above(Path::new(folder), levels), Path::new(found), "{folder} {levels}");
        }
    }
}
