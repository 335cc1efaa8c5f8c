//! Telling diagnostics: on stderr for people; for programs on stdout, unless that carries other data.

use std::io::IsTerminal;

use ifs_compiler::diagnostic::{
    Code, Diagnostic, HumanStyle, SHOWN_AT_MOST, Severity, render_human, render_json, render_short,
};
use ifs_compiler::source::SourceMap;

use crate::args::MessageFormat;
use crate::exit::Exit;
use crate::output;

/// How diagnostics are told, and where.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Messages {
    format: MessageFormat,
    beside_data: bool,
}

impl Messages {
    /// Those of a command whose stdout carries a text, a table or the like: all go to stderr, JSON too.
    pub fn beside_data(format: MessageFormat) -> Messages {
        Messages { format, beside_data: true }
    }
}

/// Those of a command that has lines of JSON on stdout or nothing: JSON goes there too.
impl From<MessageFormat> for Messages {
    fn from(format: MessageFormat) -> Messages {
        Messages { format, beside_data: false }
    }
}

/// What was told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Told {
    /// How many errors there are.
    pub errors: usize,
    /// How many warnings there are.
    pub warnings: usize,
    /// How the program should end for them.
    pub exit: Exit,
}

/// Tells diagnostics: the first of them, errors before warnings when there are too many, then their number.
pub fn tell(diagnostics: &[Diagnostic], sources: &SourceMap, messages: impl Into<Messages>) -> Told {
    let Messages { format, beside_data } = messages.into();
    let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error).count();
    let warnings = diagnostics.len() - errors;
    let mut shown: Vec<&Diagnostic> = diagnostics.iter().collect();
    if shown.len() > SHOWN_AT_MOST {
        shown.sort_by_key(|diagnostic| diagnostic.severity());
        shown.truncate(SHOWN_AT_MOST);
    }
    let style = HumanStyle { color: colored(), unicode: true };
    let mut exit = exit_for(diagnostics);
    for diagnostic in shown {
        match format {
            MessageFormat::Human => output::message(&render_human(diagnostic, sources, style)),
            MessageFormat::Short => output::message(&render_short(diagnostic, sources)),
            MessageFormat::Json if beside_data => {
                output::message(&format!("{}\n", render_json(diagnostic, sources)));
            }
            MessageFormat::Json => {
                if let Err(failed) = output::data(&format!("{}\n", render_json(diagnostic, sources))) {
                    exit = exit.max(failed);
                }
            }
        }
    }
    if diagnostics.len() > SHOWN_AT_MOST {
        let more = diagnostics.len() - SHOWN_AT_MOST;
        match format {
            MessageFormat::Json if beside_data => output::message(&format!("{{\"more\":{more}}}\n")),
            // For programs too: on stderr, so that every line of stdout stays a diagnostic.
            _ => output::message(&format!("… and {more} more\n")),
        }
    }
    if !diagnostics.is_empty() && format != MessageFormat::Json {
        output::message(&format!("{}\n", summary(errors, warnings)));
    }
    Told { errors, warnings, exit }
}

fn summary(errors: usize, warnings: usize) -> String {
    let count = |number: usize, word: &str| match number {
        0 => None,
        1 => Some(format!("1 {word}")),
        n => Some(format!("{n} {word}s")),
    };
    let parts: Vec<String> =
        [count(errors, "error"), count(warnings, "warning")].into_iter().flatten().collect();
    parts.join(", ")
}

fn colored() -> bool {
    std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

/// The exit code that errors of these kinds call for, the gravest first: input and output, limits, the design.
fn exit_for(diagnostics: &[Diagnostic]) -> Exit {
    let mut exit = Exit::Good;
    for diagnostic in diagnostics.iter().filter(|diagnostic| diagnostic.severity() == Severity::Error) {
        let this = match diagnostic.code {
            Code::E0306 => Exit::InputOutput,
            Code::E0107
            | Code::E0108
            | Code::E0312
            | Code::E0701
            | Code::E0702
            | Code::E0703
            | Code::E0704 => Exit::Limit,
            _ => Exit::Design,
        };
        exit = match (exit, this) {
            (Exit::InputOutput, _) | (_, Exit::InputOutput) => Exit::InputOutput,
            (Exit::Limit, _) | (_, Exit::Limit) => Exit::Limit,
            _ => Exit::Design,
        };
    }
    exit
}
