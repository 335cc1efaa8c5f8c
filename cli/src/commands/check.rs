//! `ifs check`: every diagnostic of designs; nothing is written.

use ifs_compiler::analysis::analyse;

use super::{overrides, tell};
use crate::args::{Check, MessageFormat};
use crate::exit::Exit;
use crate::output;
use crate::sources::Disk;

/// Checks each file; the gravest exit code of all.
pub fn check(check: &Check, format: MessageFormat) -> Exit {
    let overrides = overrides(&check.settings);
    let mut exit = Exit::Good;
    for file in &check.files {
        let Some(path) = file.to_str() else {
            output::message("error: a path that is not UTF-8\n");
            return Exit::Usage;
        };
        let analysis = analyse(&Disk, path, &overrides);
        exit = exit.max(tell(&analysis.diagnostics, &analysis.sources, format).exit);
    }
    exit
}
