//! `ifs verify DIR --source DESIGN`: the design built again in memory as the folder was built, and both sets compared.

use std::collections::BTreeSet;
use std::path::Path;

use ifs_compiler::hir::evaluate::{MachineName, Overrides};
use ifs_compiler::outputs::{DIAGNOSTICS, Format, Selection, outputs, project_sources};
use ifs_compiler::verify::{Finding, Folder, Manifest};
use serde::Deserialize;

use super::tell;
use crate::args::MessageFormat;
use crate::exit::Exit;
use crate::folder::SourceRecord;
use crate::output;
use crate::project::{Analysed, Project};

/// What a build was asked to leave out, as its manifest says it.
#[derive(Default, Deserialize)]
struct LeftOut {
    outputs: Vec<String>,
    only: Vec<String>,
}

/// Where the set differs from what the design gives now, in the order of files.
///
/// # Errors
/// The design has errors or cannot be built, which has been said.
pub(super) fn differences(
    folder: &dyn Folder,
    source: &Path,
    format: MessageFormat,
) -> Result<Vec<Finding>, Exit> {
    let manifest = Manifest::read(folder).map_err(|refused| {
        output::message(&format!("error: {refused}\n"));
        Exit::InputOutput
    })?;
    let project = Project::open(source, format)?;
    let Analysed { analysis, sources, exit } = project.analyse_with(&overrides(&manifest), format);
    if exit != Exit::Good {
        return Err(exit);
    }
    let made = outputs(&analysis, &selection(&manifest));
    let told = tell(&made.diagnostics, &sources, format);
    if told.exit != Exit::Good {
        return Err(told.exit);
    }
    let mut found = of_sources(&manifest, &project_sources(&analysis));
    let mut met = BTreeSet::new();
    for file in &made.files {
        met.insert(file.path.as_str());
        // A build that failed left only what it said.
        if manifest.failed && file.path == DIAGNOSTICS {
            continue;
        }
        let mut bytes = Vec::new();
        if let Err(error) = file.write(&mut bytes) {
            output::message(&format!("error: {}: {error}\n", file.path));
            return Err(Exit::InputOutput);
        }
        let listed = manifest.files.iter().any(|listed| listed.path == file.path);
        found.extend(compared(folder, &file.path, &bytes, listed));
    }
    let extra = manifest.files.iter().filter(|file| !met.contains(file.path.as_str()));
    found.extend(extra.map(|file| finding(&file.path, "the file", "that a build makes none", "one")));
    Ok(found)
}

/// What the folder was built with.
fn overrides(manifest: &Manifest) -> Overrides {
    let set = manifest.parameters.iter().filter(|(name, _)| manifest.set.contains(*name));
    let named = manifest.machine.as_deref().and_then(MachineName::split);
    let machine = named.map(|(file, name)| MachineName {
        file: file.to_owned(),
        name: name.to_owned(),
        whence: "`manifest.json`".to_owned(),
    });
    let parameters = set.map(|(name, value)| (name.clone(), value.clone())).collect();
    Overrides { parameters, machine, ..Overrides::default() }
}

/// The outputs that the folder was built with.
fn selection(manifest: &Manifest) -> Selection {
    let left_out = manifest.left_out.clone().unwrap_or_default();
    let LeftOut { outputs, only } = serde_json::from_value(left_out).unwrap_or_default();
    let wanted = |format: &Format| !outputs.iter().any(|name| name == format.name());
    Selection { formats: Format::ALL.into_iter().filter(wanted).collect(), only }
}

/// Sources that are no longer those of the manifest.
fn of_sources(manifest: &Manifest, now: &[(String, &[u8])]) -> Vec<Finding> {
    let mut found = Vec::new();
    let now: Vec<SourceRecord> = now.iter().map(|(path, bytes)| SourceRecord::of(path, bytes)).collect();
    for source in &now {
        match manifest.sources.iter().find(|listed| listed.path == source.path) {
            Some(listed) if listed.sha256 == source.sha256 => {}
            Some(listed) => found.push(finding(&source.path, "the source", &listed.sha256, &source.sha256)),
            None => found.push(finding(&source.path, "the source", "none of this name", "one")),
        }
    }
    let gone = manifest.sources.iter().filter(|listed| !now.iter().any(|source| source.path == listed.path));
    found.extend(gone.map(|listed| finding(&listed.path, "the source", &listed.sha256, "none of this name")));
    found
}

fn compared(folder: &dyn Folder, path: &str, made: &[u8], listed: bool) -> Option<Finding> {
    if !listed {
        return Some(finding(path, "the file", "one, as a build makes it", "none"));
    }
    // What cannot be read has been found by its hash.
    let there = folder.bytes(path, made.len() as u64).ok()?;
    let same = there.iter().zip(made).take_while(|(a, b)| a == b).count();
    if same == made.len() && there.len() == made.len() {
        return None;
    }
    let line = 1 + made[..same].iter().filter(|byte| **byte == b'\n').count();
    let found = format!("others from byte {same}, line {line}");
    Some(finding(path, "the bytes", "those of a build", &found))
}

fn finding(path: &str, what: &str, expected: &str, found: &str) -> Finding {
    Finding {
        path: path.to_owned(),
        what: what.to_owned(),
        expected: expected.to_owned(),
        found: found.to_owned(),
    }
}
