//! The project of a design: its folder, and how the paths in it are shown. The folder is that of the nearest `ifs.toml`
//! upwards, else that of the design; what that file sets is used here.

use std::path::{Component, Path, PathBuf};

use ifs_compiler::analysis::project::{
    ProjectSettings, misspelt_parameters, read_project, unreadable_project,
};
use ifs_compiler::analysis::{Analysis, Unwatched, Watch, analyse, analyse_watched, read};
use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::hir::evaluate::{MachineName, Overrides};
use ifs_compiler::source::{FileId, SourceMap};

use crate::args::{NamedMachine, Setting};
use crate::commands::{Messages, tell};
use crate::environment;
use crate::exit::Exit;
use crate::output;
use crate::sources::{Disk, slashed, text_of};

/// The name of the file that marks a project's folder.
pub const PROJECT_FILE: &str = "ifs.toml";

/// A design in its project.
#[derive(Debug, Clone)]
pub struct Project {
    /// Its files.
    pub disk: Disk,
    /// The folder of the project as it is shown: from where the design was named.
    shown: PathBuf,
    /// What its `ifs.toml` sets.
    pub settings: ProjectSettings,
    /// The machine that takes the place of those the design names.
    machine: Option<MachineName>,
    /// The text of its `ifs.toml`.
    text: SourceMap,
}

impl Project {
    /// The project of the design that was named, after its `ifs.toml` was read; `-` is the standard input, whose folder
    /// is the working folder.
    ///
    /// # Errors
    /// The path is not UTF-8, or the `ifs.toml` has errors; that has been said.
    pub fn open(named: &Path, messages: impl Into<Messages>) -> Result<Project, Exit> {
        let Some((mut project, marked)) = Project::of(named) else {
            output::message("error: a path that is not UTF-8\n");
            return Err(Exit::Usage);
        };
        if marked {
            let diagnostics = project.read_settings(text_of(&project.disk.root.join(PROJECT_FILE)));
            let told = tell(&diagnostics, &project.text, messages);
            if told.exit != Exit::Good {
                return Err(told.exit);
            }
        }
        if let Some(text) = environment::machine() {
            match text.parse() {
                Ok(named) => project.cut_by(&named, "the variable `IFS_MACHINE`"),
                Err(why) => {
                    output::message(&format!("error: the variable `IFS_MACHINE`: {why}\n"));
                    return Err(Exit::Usage);
                }
            }
        }
        Ok(project)
    }

    /// The same without a word: an `ifs.toml` with errors sets what could be understood of it. Where `open` has its text, that
    /// goes before the one on disk.
    pub fn silent(named: &Path, open: &dyn Fn(&Path) -> Option<String>) -> Option<Project> {
        let (mut project, marked) = Project::of(named)?;
        if marked {
            let path = project.disk.root.join(PROJECT_FILE);
            project.read_settings(open(&path).map_or_else(|| text_of(&path), Ok));
        }
        Some(project)
    }

    /// The project, and whether an `ifs.toml` marks it; `None` where a path is not UTF-8.
    fn of(named: &Path) -> Option<(Project, bool)> {
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
        let shown = above(folder, inner.components().count());
        let design = slashed(&inner.join(name))?;
        let is_marked = marked.is_some();
        let disk = Disk { root, design, named: named.to_owned() };
        let settings = ProjectSettings::default();
        Some((Project { disk, shown, settings, machine: None, text: SourceMap::default() }, is_marked))
    }

    fn read_settings(&mut self, text: Result<String, String>) -> Vec<Diagnostic> {
        let path = self.shown.join(PROJECT_FILE).display().to_string();
        match text {
            Ok(text) => {
                let (settings, found) = read_project(FileId(0), &text);
                self.text.add(path, text);
                self.machine = settings.machine.as_ref().map(|(machine, _)| machine.clone());
                self.settings = settings;
                found
            }
            Err(why) => {
                let file = self.text.add(path, "");
                vec![unreadable_project(file, &why)]
            }
        }
    }

    /// What is set from outside: on the command line, else in the environment, else in `ifs.toml`.
    pub fn overrides(&self, settings: &[Setting]) -> Overrides {
        let given = settings.iter().map(|setting| (setting.name.clone(), setting.value.clone()));
        let project = self.settings.parameters.iter();
        let mut defaults: std::collections::BTreeMap<String, (String, String)> = project
            .map(|(name, (value, _))| (name.clone(), (value.clone(), format!("`{PROJECT_FILE}`"))))
            .collect();
        defaults.extend(environment::parameters());
        let machine = self.machine.clone();
        Overrides { parameters: given.collect(), defaults, machine, ..Overrides::default() }
    }

    /// Lets a machine take the place of those the design and the project name; `whence` says who names it.
    pub fn cut_by(&mut self, named: &NamedMachine, whence: &str) {
        // What is not there, or outside of the project, keeps its whole path: that it cannot be read is said later.
        let whole = || std::env::current_dir().unwrap_or_default().join(&named.file);
        let real = named.file.canonicalize().ok();
        let inside = real.as_deref().and_then(|real| slashed(real.strip_prefix(&self.disk.root).ok()?));
        let file = inside.unwrap_or_else(|| whole().display().to_string());
        let (name, whence) = (named.name.clone(), whence.to_owned());
        self.machine = Some(MachineName { file, name, whence });
    }

    /// Analyses the design and tells what it finds.
    pub fn analyse(&self, settings: &[Setting], messages: impl Into<Messages>) -> Analysed {
        self.analyse_watched(settings, messages, &mut Unwatched)
    }

    /// The same, telling how far it is where it takes long.
    pub fn analyse_watched(
        &self,
        settings: &[Setting],
        messages: impl Into<Messages>,
        watch: &mut dyn Watch,
    ) -> Analysed {
        let overrides = self.overrides(settings);
        self.told(analyse_watched(&self.disk, &self.disk.design, &overrides, watch), messages)
    }

    /// The same with nothing set but what is given here.
    pub fn analyse_with(&self, overrides: &Overrides, messages: impl Into<Messages>) -> Analysed {
        self.told(analyse(&self.disk, &self.disk.design, overrides), messages)
    }

    /// Reads the design as far as its typed tree and tells what it finds.
    pub fn read(&self, settings: &[Setting], messages: impl Into<Messages>) -> Analysed {
        self.told(read(&self.disk, &self.disk.design, &self.overrides(settings)), messages)
    }

    fn told(&self, analysis: Analysis, messages: impl Into<Messages>) -> Analysed {
        let (sources, messages) = (self.shown(&analysis.sources), messages.into());
        let project = tell(&misspelt_parameters(&self.settings, &analysis.hir), &self.text, messages);
        let exit = tell(&analysis.diagnostics, &sources, messages).exit;
        Analysed { exit: exit.max(project.exit), analysis, sources }
    }

    /// Where a design's outputs go if nobody says: its own folder in the one that the environment or `ifs.toml` names,
    /// else in `out`.
    pub fn out(&self, design: &str) -> PathBuf {
        let project = || self.settings.out.as_ref().map(|(out, _)| self.shown.join(out));
        environment::out().or_else(project).unwrap_or_else(|| PathBuf::from("out")).join(design)
    }

    /// The sources of an analysis with the paths a person knows them by.
    fn shown(&self, sources: &SourceMap) -> SourceMap {
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

/// A design analysed and told of.
#[derive(Debug)]
pub struct Analysed {
    /// What it means.
    pub analysis: Analysis,
    /// Its sources, with the paths a person knows them by.
    pub sources: SourceMap,
    /// How the program should end for what was found.
    pub exit: Exit,
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
