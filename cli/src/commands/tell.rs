//! Telling diagnostics: on stderr for people, on stdout for programs.

use std::io::IsTerminal;

use ifs_compiler::diagnostic::{
    Code, Diagnostic, HumanStyle, SHOWN_AT_MOST, Severity, render_human, render_json, render_short,
};
use ifs_compiler::source::SourceMap;

use crate::args::MessageFormat;
use crate::exit::Exit;
use crate::output;

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
pub fn tell(diagnostics: &[Diagnostic], sources: &SourceMap, format: MessageFormat) -> Told {
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
            MessageFormat::Json => {
                if let Err(failed) = output::data(&format!("{}\n", render_json(diagnostic, sources))) {
                    exit = exit.max(failed);
                }
            }
        }
    }
    if diagnostics.len() > SHOWN_AT_MOST {
        // For programs too: on stderr, so that every line of stdout stays a diagnostic.
        output::message(&format!("… and {} more\n", diagnostics.len() - SHOWN_AT_MOST));
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
