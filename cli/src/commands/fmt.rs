//! `ifs fmt`: texts laid out in the one way of the language. What it is lives in the compiler; here files are replaced.

use std::path::Path;

use ifs_compiler::analysis::{SingleText, single};
use ifs_compiler::diagnostic::Severity;
use ifs_compiler::source::Source;
use ifs_compiler::syntax::format::format;
use serde::Serialize;
use similar::TextDiff;

use super::{Messages, tell};
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
        return tell(&diagnostics, &sources, Messages::beside_data(messages)).exit;
    };
    let Some(text) = format(&parse, source) else {
        notice(path, Verdict::Failed("its indents would make it too large"), messages);
        return Exit::Limit;
    };
    let changed = source.text != text;
    if fmt.check || fmt.diff {
        return if changed { shown(fmt, source, &text, messages) } else { Exit::Good };
    }
    if path == "-" {
        return output::data(&text).err().unwrap_or(Exit::Good);
    }
    if changed { written(path, &text, messages) } else { Exit::Good }
}

/// Says that a text is not laid out, or prints what would change.
fn shown(fmt: &Fmt, source: &Source, text: &str, messages: MessageFormat) -> Exit {
    let path = source.path.as_str();
    if fmt.check {
        notice(path, Verdict::NotFormatted, messages);
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

fn written(path: &str, text: &str, messages: MessageFormat) -> Exit {
    match replace(Path::new(path), text.as_bytes()) {
        Ok(()) => {
            notice(path, Verdict::Formatted, messages);
            Exit::Good
        }
        Err(error) => {
            notice(path, Verdict::Failed(&words(&error)), messages);
            Exit::InputOutput
        }
    }
}

/// What became of a file.
enum Verdict<'a> {
    Formatted,
    NotFormatted,
    Failed(&'a str),
}

#[derive(Serialize)]
struct JsonNotice<'a> {
    file: &'a str,
    verdict: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<&'a str>,
}

/// Says it on stderr: stdout is for texts.
fn notice(path: &str, verdict: Verdict<'_>, messages: MessageFormat) {
    let name = if path == "-" { "the standard input" } else { path };
    let (line, word, why) = match verdict {
        Verdict::Formatted => (format!("formatted {name}"), "formatted", None),
        Verdict::NotFormatted => (format!("{name} is not formatted"), "not formatted", None),
        Verdict::Failed(why) => (format!("error: {name} was not formatted: {why}"), "failed", Some(why)),
    };
    let line = match messages {
        MessageFormat::Json => {
            serde_json::to_string(&JsonNotice { file: path, verdict: word, why }).unwrap_or_default()
        }
        MessageFormat::Human | MessageFormat::Short => line,
    };
    output::message(&format!("{line}\n"));
}
