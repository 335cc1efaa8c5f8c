//! `ifs verify`: reads a set of outputs again and says what is wrong with it. The truth about it is in the compiler's
//! room `verify`; here are the files and the words.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use ifs_compiler::verify::{Finding, Folder, Verdict, verify as judge};
use serde::Serialize;

use super::rebuilt::differences;
use crate::args::{MessageFormat, Verify};
use crate::exit::Exit;
use crate::folder::OutputFolder;
use crate::output;

/// How many findings people are shown.
const SHOWN: usize = 50;

/// How deep folders are looked into: a set has two levels.
const DEEPEST: usize = 8;

/// Verifies an output folder.
pub fn verify(verify: &Verify, format: MessageFormat) -> Exit {
    let folder = &verify.folder;
    if !folder.is_dir() {
        let why = if folder.exists() { "is not a folder" } else { "does not exist" };
        output::message(&format!("error: {} {why}\n", folder.display()));
        return Exit::InputOutput;
    }
    if let Err(error) = OutputFolder::recover(folder) {
        output::message(&format!("error: {error}\n"));
        return Exit::InputOutput;
    }
    match judge(&OnDisk { root: folder }) {
        Ok(mut verdict) => {
            if let Some(source) = &verify.source {
                match differences(&OnDisk { root: folder }, source, format) {
                    Ok(found) => verdict.findings.extend(found),
                    Err(exit) => return exit,
                }
            }
            tell(&verdict, folder, format)
        }
        Err(refused) if refused.unreadable => {
            output::message(&format!("error: {}: {refused}\n", folder.display()));
            Exit::InputOutput
        }
        Err(refused) => {
            let finding = Finding {
                path: "manifest.json".to_owned(),
                what: "the list of the set".to_owned(),
                expected: "one that a build of ifs wrote".to_owned(),
                found: refused.reason,
            };
            let (files, read, by_hash, foreign, failed) = (0, 0, Vec::new(), Vec::new(), false);
            tell(&Verdict { findings: vec![finding], files, read, by_hash, foreign, failed }, folder, format)
        }
    }
}

/// A folder of the file system. Links are not followed.
struct OnDisk<'a> {
    root: &'a Path,
}

impl Folder for OnDisk<'_> {
    fn names(&self) -> Vec<String> {
        let mut names = Vec::new();
        walk(self.root, "", 0, &mut names);
        names
    }

    fn bytes(&self, name: &str, most: u64) -> Result<Vec<u8>, String> {
        let mut path = PathBuf::from(self.root);
        for segment in name.split('/') {
            path.push(segment);
            let kind = fs::symlink_metadata(&path).map_err(|error| error.to_string())?;
            if kind.is_symlink() {
                return Err("a link, which is not followed".to_owned());
            }
        }
        // Opening a pipe would wait for its other end.
        if !fs::symlink_metadata(&path).map_err(|error| error.to_string())?.is_file() {
            return Err("no plain file".to_owned());
        }
        let mut bytes = Vec::new();
        let file = File::open(&path).map_err(|error| error.to_string())?;
        let read = file.take(most.saturating_add(1)).read_to_end(&mut bytes);
        read.map_err(|error| error.to_string())?;
        Ok(bytes)
    }
}

/// The names below a folder in order; a folder that cannot be read, or lies too deep, holds none.
fn walk(folder: &Path, before: &str, depth: usize, names: &mut Vec<String>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut entries: Vec<_> = entries.flatten().collect();
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_folder && depth < DEEPEST {
            walk(&entry.path(), &format!("{name}/"), depth + 1, names);
        } else if !is_folder {
            names.push(name);
        }
    }
}

#[derive(Serialize)]
struct JsonFinding<'a> {
    path: &'a str,
    what: &'a str,
    expected: &'a str,
    found: &'a str,
}

#[derive(Serialize)]
struct JsonVerdict<'a> {
    files: usize,
    read: usize,
    by_hash: &'a [String],
    foreign: &'a [String],
    findings: usize,
    failed: bool,
}

fn tell(verdict: &Verdict, folder: &Path, format: MessageFormat) -> Exit {
    let text = match format {
        MessageFormat::Json => json(verdict),
        MessageFormat::Short => verdict.findings.iter().map(|finding| format!("{finding}\n")).collect(),
        MessageFormat::Human => human(verdict, folder),
    };
    let found = if verdict.findings.is_empty() { Exit::Good } else { Exit::Design };
    found.max(output::data(&text).err().unwrap_or(Exit::Good))
}

/// A line for each finding, then one with the numbers.
fn json(verdict: &Verdict) -> String {
    let line = |finding: &Finding| {
        let Finding { path, what, expected, found } = finding;
        serde_json::to_string(&JsonFinding { path, what, expected, found })
    };
    let summary = JsonVerdict {
        files: verdict.files,
        read: verdict.read,
        by_hash: &verdict.by_hash,
        foreign: &verdict.foreign,
        findings: verdict.findings.len(),
        failed: verdict.failed,
    };
    let lines = verdict.findings.iter().map(line).chain([serde_json::to_string(&summary)]);
    lines.flatten().map(|line| line + "\n").collect()
}

fn human(verdict: &Verdict, folder: &Path) -> String {
    let mut text = String::new();
    let mut path = "";
    for finding in verdict.findings.iter().take(SHOWN) {
        if finding.path != path {
            path = &finding.path;
            text += &format!("{path}\n");
        }
        text += &format!(
            "  {}\n    expected  {}\n    found     {}\n",
            finding.what, finding.expected, finding.found
        );
    }
    if verdict.findings.len() > SHOWN {
        text += &format!("… and {} more\n", verdict.findings.len() - SHOWN);
    }
    let counted = |count: usize, noun: &str| format!("{count} {noun}{}", if count == 1 { "" } else { "s" });
    text += &format!(
        "{}: {}, {} read again, {} known by their hashes alone\n",
        folder.display(),
        counted(verdict.files, "file"),
        verdict.read,
        verdict.by_hash.len()
    );
    for name in &verdict.by_hash {
        text += &format!("by hash   {}\n", plain(name));
    }
    for name in &verdict.foreign {
        text += &format!("foreign   {}\n", plain(name));
    }
    text += &match verdict.findings.len() {
        0 if verdict.failed => "all of it is as it was built, but not by the last build: that failed, and `diagnostics.json` says \
                               why\n"
            .to_owned(),
        0 => "all of it is as it was built\n".to_owned(),
        count => format!("{}: do not use these files\n", counted(count, "finding")),
    };
    text
}

/// A name without what steers a terminal.
fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}
