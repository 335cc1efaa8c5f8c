//! `ifs check`: what is wrong with designs and with what their machines are to cut; nothing is written.

use ifs_compiler::analysis::Unwatched;
use ifs_compiler::outputs::workshop_faults;

use super::tell;
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
                let faults = workshop_faults(&analysed.analysis, &mut Unwatched);
                let found = analysed.exit.max(tell(&faults, &analysed.sources, format).exit);
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
