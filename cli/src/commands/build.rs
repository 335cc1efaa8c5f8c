//! `ifs build`: the outputs of a design, all or none, and a short table of what was made.

use std::collections::BTreeMap;
use std::path::Path;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Diagnostic;
use ifs_compiler::outputs::nests::Nests;
use ifs_compiler::outputs::{
    DIAGNOSTICS, Format, LeftOut, Output, Selection, board_names, diagnostics_json, machine_text,
    outputs_watched, parameter_texts, project_sources,
};

use super::{table, tell};
use crate::args::{Build, Emit, MessageFormat};
use crate::exit::Exit;
use crate::folder::{
    Committed, FolderError, LeftOutRecord, Making, OutputFolder, Provenance, SourceRecord, Staging,
};
use crate::interrupt::{self, Writing};
use crate::output;
use crate::progress::{self, Progress, Watching};
use crate::project::{Analysed, Project};

/// Builds a design, with a line of progress for whoever looks on.
pub fn build(build: &Build, format: MessageFormat) -> Exit {
    interrupt::listen();
    let _progress = if build.quiet || format == MessageFormat::Json { None } else { Progress::begin() };
    make(build, format)
}

fn make(build: &Build, format: MessageFormat) -> Exit {
    let mut project = match Project::open(&build.file, format) {
        Ok(project) => project,
        Err(exit) => return exit,
    };
    if let Some(machine) = &build.machine {
        project.cut_by(machine, "`--machine`");
    }
    let Analysed { analysis, sources, exit } =
        project.analyse_watched(&build.settings, format, &mut Watching);
    let out = build.out.clone().unwrap_or_else(|| project.out(&analysis.design_name()));
    let selection = Selection { formats: formats(&build.emit), only: build.only.clone() };
    if exit != Exit::Good {
        return failed(exit, &selection, &out, &analysis, &analysis.diagnostics);
    }
    if build.emit.contains(&Emit::Plan)
        && let Some(lowered) = &analysis.plan
        && let Err(exit) = output::data(&lowered.plan.to_string())
    {
        return exit;
    }
    if let Some(pattern) = selection.without_boards(&analysis) {
        return nothing_fits(pattern, &analysis);
    }
    if selection.formats.is_empty() {
        return Exit::Good;
    }
    let made = outputs_watched(&analysis, &selection, &mut progress::making);
    let told = tell(&made.diagnostics, &sources, format);
    if told.exit != Exit::Good {
        let all: Vec<Diagnostic> = analysis.diagnostics.iter().chain(&made.diagnostics).cloned().collect();
        return failed(told.exit, &selection, &out, &analysis, &all);
    }
    match write(&out, &analysis, &made.files, selection.left_out(&analysis)) {
        Ok(committed) => {
            told_of(&committed);
            if build.quiet || format == MessageFormat::Json {
                return Exit::Good;
            }
            finish(&analysis, &made.nests, &committed, &out)
        }
        Err(error) => not_written(&error),
    }
}

fn not_written(error: &FolderError) -> Exit {
    if matches!(error, FolderError::Stopped) {
        return interrupt::stopped();
    }
    output::message(&format!("error: {error}\n"));
    Exit::InputOutput
}

/// Leaves in the output folder what a build said that failed; the files of the build before stay as they are. Nothing is
/// written where no files were asked for, or where the design could not even be read.
fn failed(
    exit: Exit,
    selection: &Selection,
    out: &Path,
    analysis: &Analysis,
    diagnostics: &[Diagnostic],
) -> Exit {
    if selection.formats.is_empty() || !matches!(exit, Exit::Design | Exit::Limit) {
        return exit;
    }
    let said = diagnostics_json(diagnostics, &analysis.sources, true);
    match write_failure(exit, out, analysis, &said) {
        Ok(()) => exit,
        Err(error) => not_written(&error),
    }
}

fn write_failure(exit: Exit, out: &Path, analysis: &Analysis, said: &str) -> Result<(), FolderError> {
    let writing = Writing::begin();
    let mut staging = stage(out)?;
    let before = staging.keep_set(DIAGNOSTICS)?;
    staging.write(DIAGNOSTICS, "diagnostics", None, said.as_bytes())?;
    staging.commit(&before.unwrap_or_else(|| Provenance { failed: true, ..provenance(analysis) }))?;
    writing.done(exit);
    Ok(())
}

fn stage(out: &Path) -> Result<Staging, FolderError> {
    let mut waiting = || output::message(&format!("waiting for another build of {}\n", out.display()));
    OutputFolder::stage_with(out, Making { stop: interrupt::asked, ..Making::default() }, &mut waiting)
}

/// The sources and parameters of a design, with nothing left out.
fn provenance(analysis: &Analysis) -> Provenance {
    let sources = project_sources(analysis);
    let sources = sources.iter().map(|(path, bytes)| SourceRecord::of(path, bytes)).collect();
    let parameters: BTreeMap<String, String> = parameter_texts(analysis).into_iter().collect();
    // Those of an `ifs.toml` may be of other designs.
    let set = analysis.set_parameters.iter().filter(|name| parameters.contains_key(*name)).cloned().collect();
    Provenance { sources, parameters, set, machine: machine_text(analysis), ..Provenance::default() }
}

/// What `--emit` asks for; everything where it is not given.
fn formats(emit: &[Emit]) -> Vec<Format> {
    if emit.is_empty() {
        return Format::ALL.to_vec();
    }
    let asked = |format: Format| match format {
        Format::Glb => emit.contains(&Emit::Glb),
        Format::Nc => emit.contains(&Emit::Nc),
        Format::Dxf => emit.contains(&Emit::Dxf),
        Format::Btlx => emit.contains(&Emit::Btlx),
        Format::Svg => emit.contains(&Emit::Svg),
        Format::Csv => emit.contains(&Emit::Csv),
        Format::Html => emit.contains(&Emit::Html),
        Format::Json => emit.contains(&Emit::Json),
    };
    Format::ALL.into_iter().filter(|format| asked(*format)).collect()
}

/// Says that a pattern of `--only` fits no board, and what the boards are called.
fn nothing_fits(pattern: &str, analysis: &Analysis) -> Exit {
    let names = board_names(analysis);
    let known = match names.first() {
        Some((address, alias)) => {
            format!("it has {} boards, the first is {address}, {alias} for short", names.len())
        }
        None => "it makes no boards".to_owned(),
    };
    output::message(&format!("error: no board of the design fits `--only {pattern}`: {known}\n"));
    Exit::Usage
}

fn write(
    out: &Path,
    analysis: &Analysis,
    files: &[Output],
    left_out: LeftOut,
) -> Result<Committed, FolderError> {
    let writing = Writing::begin();
    let mut staging = stage(out)?;
    for (done, file) in files.iter().enumerate() {
        progress::say(|| "files written".to_owned(), Some((done, files.len())));
        staging.write_with(&file.path, file.kind, file.address.as_deref(), |out| file.write(out))?;
    }
    progress::say(|| "putting the files in place".to_owned(), None);
    let committed =
        staging.commit(&Provenance { left_out: LeftOutRecord::of(left_out), ..provenance(analysis) })?;
    writing.done(Exit::Good);
    Ok(committed)
}

fn told_of(committed: &Committed) {
    for name in &committed.foreign {
        output::message(&format!("note: kept {name}, which no build wrote\n"));
    }
    if let Some(leftover) = &committed.leftover {
        output::message(&format!("warning: the build is complete, but {leftover}\n"));
    }
}

fn finish(analysis: &Analysis, nests: &Nests, committed: &Committed, out: &Path) -> Exit {
    let files: Vec<&str> = committed.manifest.files.iter().map(|file| file.path.as_str()).collect();
    output::data(&table::table(analysis, nests, &files, out)).err().unwrap_or(Exit::Good)
}
