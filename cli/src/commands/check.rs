//! `ifs check`: every diagnostic of designs; nothing is written.

use crate::args::{Check, MessageFormat};
use crate::exit::Exit;
use crate::project::Project;

/// Checks each file; the gravest exit code of all.
pub fn check(check: &Check, format: MessageFormat) -> Exit {
    let mut exit = Exit::Good;
    for file in &check.files {
        exit = exit.max(match Project::open(file, format) {
            Ok(project) => project.analyse(&check.settings, format).exit,
            Err(exit) => exit,
        });
    }
    exit
}
