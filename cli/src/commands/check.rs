//! `ifs check`: every diagnostic of designs; nothing is written.

use super::{overrides, tell};
use crate::args::{Check, MessageFormat};
use crate::exit::Exit;
use crate::output;
use crate::project::Project;

/// Checks each file; the gravest exit code of all.
pub fn check(check: &Check, format: MessageFormat) -> Exit {
    let overrides = overrides(&check.settings);
    let mut exit = Exit::Good;
    for file in &check.files {
        let Some(project) = Project::of(file) else {
            output::message("error: a path that is not UTF-8\n");
            return Exit::Usage;
        };
        let analysis = project.analyse(&overrides);
        let sources = project.shown(&analysis.sources);
        exit = exit.max(tell(&analysis.diagnostics, &sources, format).exit);
    }
    exit
}
