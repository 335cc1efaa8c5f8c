//! `ifs check`: every diagnostic of designs; nothing is written.

use crate::args::{Check, MessageFormat};
use crate::exit::Exit;
use crate::project::Project;

/// Checks each file; the gravest exit code of all.
pub fn check(check: &Check, format: MessageFormat) -> Exit {
    let mut exit = Exit::Good;
    for (place, file) in check.files.iter().enumerate() {
        let found = match Project::open(file, format) {
            Ok(project) => {
                let analysed = project.analyse(&check.settings, format);
                let found = analysed.exit;
                if place + 1 == check.files.len() {
                    // The process ends: the system takes all of it back at once, sooner than piece by piece.
                    std::mem::forget(analysed);
                }
                found
            }
            Err(found) => found,
        };
        exit = exit.max(found);
    }
    exit
}
