//! `ifs fmt`: texts laid out in the one way of the language. What it is lives in the compiler; here files are replaced.

use std::path::Path;

use ifs_compiler::analysis::{SingleText, single};
use ifs_compiler::diagnostic::Severity;
use ifs_compiler::source::Source;
use ifs_compiler::syntax::format::format;
use similar::TextDiff;

use super::tell;
use crate::args::{Fmt, MessageFormat};
use crate::exit::Exit;
use crate::output;
use crate::replace::replace;
use crate::sources::{Disk, words};

/// Lays out each file; the gravest exit code of all.
pub fn fmt(fmt: &Fmt, messages: MessageFormat) -> Exit {
    let Some(paths) = fmt.files.iter().map(|file| file.to_str()).collect::<Option<Vec<&str>>>() else {
        output::message("error: a path that is not UTF-8\n");
        return Exit::Usage;
    };
    let mut exit = Exit::Good;
    for path in paths {
        exit = exit.max(file(fmt, path, messages));
    }
    exit
}

fn file(fmt: &Fmt, path: &str, messages: MessageFormat) -> Exit {
    let SingleText { sources, root, parse, diagnostics } = single(&Disk::alone(path), path);
    let broken = diagnostics.iter().any(|found| found.severity() == Severity::Error);
    let Some(source) = sources.get(root).filter(|_| !broken) else {
        return tell(&diagnostics, &sources, messages).exit;
    };
    let Some(text) = format(&parse, source) else {
        output::message(&format!("error: {path} was not formatted: its indents would make it too large\n"));
        return Exit::Limit;
    };
    let changed = source.text != text;
    if fmt.check || fmt.diff {
        return if changed { shown(fmt, source, &text) } else { Exit::Good };
    }
    if path == "-" {
        return output::data(&text).err().unwrap_or(Exit::Good);
    }
    if changed { written(path, &text) } else { Exit::Good }
}

/// Says that a text is not laid out, or prints what would change.
fn shown(fmt: &Fmt, source: &Source, text: &str) -> Exit {
    let path = source.path.as_str();
    if fmt.check {
        let name = if path == "-" { "the standard input" } else { path };
        output::message(&format!("{name} is not formatted\n"));
    }
    if fmt.diff {
        let difference = TextDiff::from_lines(source.text.as_str(), text);
        let shown = difference.unified_diff().header(path, path).to_string();
        if let Err(failed) = output::data(&shown) {
            return failed;
        }
    }
    Exit::Design
}

fn written(path: &str, text: &str) -> Exit {
    match replace(Path::new(path), text.as_bytes()) {
        Ok(()) => {
            output::message(&format!("formatted {path}\n"));
            Exit::Good
        }
        Err(error) => {
            output::message(&format!("error: {path} was not formatted: {}\n", words(&error)));
            Exit::InputOutput
        }
    }
}
