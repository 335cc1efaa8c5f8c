//! `ifs build`: the outputs of a design, all or none, and a short table of what was made.

use std::collections::BTreeMap;
use std::path::Path;

use ifs_compiler::analysis::Analysis;
use ifs_compiler::outputs::{Output, Selection, outputs, parameter_texts, project_sources};

use super::{table, tell};
use crate::args::{Build, Emit, MessageFormat};
use crate::exit::Exit;
use crate::folder::{Committed, Exchange, FolderError, OutputFolder, Provenance, SourceRecord};
use crate::output;
use crate::project::{Analysed, Project};

/// Builds a design.
pub fn build(build: &Build, format: MessageFormat) -> Exit {
    let project = match Project::open(&build.file, format) {
        Ok(project) => project,
        Err(exit) => return exit,
    };
    let Analysed { analysis, sources, exit } = project.analyse(&build.settings, format);
    if exit != Exit::Good {
        return exit;
    }
    if build.emit.contains(&Emit::Plan)
        && let Some(lowered) = &analysis.plan
        && let Err(exit) = output::data(&lowered.plan.to_string())
    {
        return exit;
    }
    let selection = selection(&build.emit);
    if selection.is_empty() {
        return Exit::Good;
    }
    let made = outputs(&analysis, selection);
    let told = tell(&made.diagnostics, &sources, format);
    if told.exit != Exit::Good {
        return told.exit;
    }
    let out = build.out.clone().unwrap_or_else(|| project.out(&analysis.design_name()));
    match write(&out, &analysis, &made.files) {
        Ok(committed) => finish(&analysis, &committed, &out, format),
        Err(error) => {
            output::message(&format!("error: {error}\n"));
            Exit::InputOutput
        }
    }
}

/// What `--emit` asks for; everything where it is not given.
fn selection(emit: &[Emit]) -> Selection {
    if emit.is_empty() {
        return Selection::ALL;
    }
    let wants = |which: Emit| emit.contains(&which);
    Selection {
        glb: wants(Emit::Glb),
        nc: wants(Emit::Nc),
        csv: wants(Emit::Csv),
        json: wants(Emit::Json),
        html: wants(Emit::Html),
    }
}

fn write(out: &Path, analysis: &Analysis, files: &[Output]) -> Result<Committed, FolderError> {
    let mut waiting = || output::message(&format!("waiting for another build of {}\n", out.display()));
    let mut staging = OutputFolder::stage_with(out, Exchange::System, &mut waiting)?;
    for file in files {
        staging.write_with(&file.path, file.kind, file.address.as_deref(), |out| file.write(out))?;
    }
    let sources = project_sources(analysis);
    let sources = sources.iter().map(|(path, bytes)| SourceRecord::of(path, bytes)).collect();
    let parameters: BTreeMap<String, String> = parameter_texts(analysis).into_iter().collect();
    staging.commit(&Provenance { sources, parameters })
}

fn finish(analysis: &Analysis, committed: &Committed, out: &Path, format: MessageFormat) -> Exit {
    for name in &committed.foreign {
        output::message(&format!("note: kept {name}, which no build wrote\n"));
    }
    if let Some(leftover) = &committed.leftover {
        output::message(&format!("warning: the build is complete, but {leftover}\n"));
    }
    if format == MessageFormat::Json {
        return Exit::Good;
    }
    let files = committed.manifest.files.len() + 1;
    output::data(&table::table(analysis, files, out)).err().unwrap_or(Exit::Good)
}
