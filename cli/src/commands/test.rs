//! `ifs test`: runs the tests of designs, a line each, and tells what does not hold.

use ifs_compiler::analysis::{TestResult, Verdict, run_tests};
use ifs_compiler::source::SourceMap;
use serde::Serialize;

use super::tell;
use crate::args::{MessageFormat, Test};
use crate::exit::Exit;
use crate::output;
use crate::project::{Analysed, Project};

/// Runs the tests of each file; the gravest exit code of all.
pub fn test(test: &Test, format: MessageFormat) -> Exit {
    let (mut exit, mut results) = (Exit::Good, Vec::new());
    for file in &test.files {
        let done = match Project::open(file, format) {
            Ok(project) => one(&project, test, format, &mut results),
            Err(exit) => exit,
        };
        exit = exit.max(done);
    }
    if format == MessageFormat::Json {
        return exit;
    }
    exit.max(output::data(&summary(&results)).err().unwrap_or(Exit::Good))
}

fn one(project: &Project, test: &Test, format: MessageFormat, results: &mut Vec<Verdict>) -> Exit {
    let Analysed { analysis, sources, mut exit } = project.analyse(&test.settings, format);
    let mut diagnostics = Vec::new();
    for result in run_tests(&analysis, &project.overrides(&test.settings)) {
        exit = exit.max(output::data(&line(&result, &sources, format)).err().unwrap_or(Exit::Good));
        results.push(result.verdict);
        if result.verdict == Verdict::Fails {
            exit = exit.max(Exit::Design);
        }
        diagnostics.extend(result.diagnostics);
    }
    exit.max(tell(&diagnostics, &sources, format).exit)
}

#[derive(Serialize)]
struct JsonTest<'a> {
    test: &'a str,
    file: &'a str,
    line: u32,
    verdict: &'static str,
}

fn line(result: &TestResult, sources: &SourceMap, format: MessageFormat) -> String {
    let source = sources.get(result.span.file);
    let file = source.map_or("", |source| source.path.as_str());
    let line = source.map_or(0, |source| source.lines.bytes(result.span.start).line + 1);
    let verdict = match result.verdict {
        Verdict::Holds => "ok",
        Verdict::Fails => "FAILED",
        Verdict::NotRun => "not run: the design has errors",
    };
    if format != MessageFormat::Json {
        let name: String = result.name.chars().filter(|c| !c.is_control()).collect();
        return format!("{file}:{line}: {name} … {verdict}\n");
    }
    let verdict = match result.verdict {
        Verdict::Holds => "ok",
        Verdict::Fails => "failed",
        Verdict::NotRun => "not run",
    };
    let json = JsonTest { test: &result.name, file, line, verdict };
    serde_json::to_string(&json).map(|line| line + "\n").unwrap_or_default()
}

fn summary(results: &[Verdict]) -> String {
    let count = |verdict: Verdict| results.iter().filter(|result| **result == verdict).count();
    let tests = if results.len() == 1 { "1 test".to_owned() } else { format!("{} tests", results.len()) };
    let mut parts = vec![tests];
    for (verdict, word) in [(Verdict::Holds, "ok"), (Verdict::Fails, "failed"), (Verdict::NotRun, "not run")]
    {
        match count(verdict) {
            0 => {}
            n => parts.push(format!("{n} {word}")),
        }
    }
    format!("{}\n", parts.join(", "))
}
