//! `manifest.json`: whether it is one, whether its names stay in the folder, and whether the files are those it lists.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde::Deserialize;
use sha2::{Digest, Sha256};

use super::Folder;
use super::finding::Findings;

/// The name of the list.
const MANIFEST: &str = "manifest.json";

/// The latest version of the list that is known here.
const SCHEMA: u32 = 1;

/// The most bytes of a list: of a million boards in three files each.
const MOST_BYTES: u64 = 1 << 30;

/// The kinds of files that builds write.
pub const KINDS: [&str; 8] =
    ["program", "drawing", "model", "list", "labels", "report", "diagnostics", "sheet"];

/// Why a folder's list cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotAManifest {
    /// The reason, for people.
    pub reason: String,
    /// Whether the file could not even be read.
    pub unreadable: bool,
}

impl fmt::Display for NotAManifest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.reason)
    }
}

/// A listed file.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Listed {
    /// Its name in the folder.
    pub path: String,
    /// Its length.
    pub bytes: u64,
    /// SHA-256 of its bytes, lower-case hexadecimal.
    pub sha256: String,
    /// What it is.
    pub kind: String,
    /// The board it is for.
    #[serde(default)]
    pub address: Option<String>,
}

/// A source of the design.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct Source {
    /// Its name in the project.
    pub path: String,
    /// SHA-256 of its bytes.
    pub sha256: String,
}

/// The list.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct Manifest {
    schema: u32,
    program: String,
    /// The version of the program that wrote the set.
    pub version: String,
    /// What the design is made of.
    pub sources: Vec<Source>,
    /// The values of its parameters.
    pub parameters: BTreeMap<String, String>,
    /// The names of those that were set from outside.
    #[serde(default)]
    pub set: BTreeSet<String>,
    /// The machine that was named from outside.
    #[serde(default)]
    pub machine: Option<String>,
    /// What was asked to be left out.
    #[serde(default)]
    pub left_out: Option<serde_json::Value>,
    /// Whether the last build failed.
    #[serde(default)]
    pub failed: bool,
    /// Every other file.
    pub files: Vec<Listed>,
}

impl Manifest {
    /// Reads the list of a folder.
    ///
    /// # Errors
    /// It is missing, is none of ours, or leads out of the folder.
    pub fn read(folder: &dyn Folder) -> Result<Manifest, NotAManifest> {
        let refuse = |reason: String| NotAManifest { reason, unreadable: false };
        let bytes = folder
            .bytes(MANIFEST, MOST_BYTES)
            .map_err(|reason| NotAManifest { reason: format!("{MANIFEST}: {reason}"), unreadable: true })?;
        let manifest: Manifest = serde_json::from_slice(&bytes)
            .map_err(|error| refuse(format!("{MANIFEST} is not the list of a build: {error}")))?;
        if manifest.program != "ifs" {
            return Err(refuse(format!("{MANIFEST} is of the program {:?}, not of ifs", manifest.program)));
        }
        if manifest.schema != SCHEMA {
            let found = manifest.schema;
            return Err(refuse(format!("{MANIFEST} has the schema {found}, and {SCHEMA} is known")));
        }
        let mut met = BTreeSet::new();
        for file in &manifest.files {
            if let Err(why) = check_name(&file.path) {
                return Err(refuse(format!("{MANIFEST} lists {:?}: {why}", file.path)));
            }
            if !met.insert(&file.path) {
                return Err(refuse(format!("{MANIFEST} lists {:?} twice", file.path)));
            }
        }
        Ok(manifest)
    }

    /// The files that are not listed; those where outputs lie are told of, the others are somebody's own.
    pub(super) fn foreign(&self, folder: &dyn Folder, findings: &mut Findings) -> Vec<String> {
        let listed: BTreeSet<&str> = self.files.iter().map(|file| file.path.as_str()).collect();
        let mut foreign = Vec::new();
        for name in folder.names() {
            if name == MANIFEST || listed.contains(name.as_str()) {
                continue;
            }
            if name.starts_with("boards/") || name.starts_with("sheets/") {
                findings.add(&name, "a file among the outputs", "that the manifest lists it", "not listed");
            }
            foreign.push(name);
        }
        foreign
    }

    /// Compares files with the list; the names of those that are as listed.
    pub(super) fn check_hashes(&self, folder: &dyn Folder, findings: &mut Findings) -> BTreeSet<String> {
        let mut sound = BTreeSet::new();
        let mut before: Option<&str> = None;
        for file in &self.files {
            let path = file.path.as_str();
            if before.is_some_and(|before| before >= path) {
                findings.add(MANIFEST, "order of the files", "by name", path);
            }
            before = Some(path);
            if !KINDS.contains(&file.kind.as_str()) {
                findings.add(MANIFEST, format!("kind of {path}"), "one that is known", &file.kind);
            }
            match folder.bytes(path, file.bytes) {
                Err(why) => findings.add(path, "the file", "that it can be read", why),
                Ok(bytes) if bytes.len() as u64 != file.bytes => {
                    let longer = if bytes.len() as u64 > file.bytes { "more" } else { "fewer" };
                    findings.add(path, "length", format!("{} bytes", file.bytes), longer);
                }
                Ok(bytes) => {
                    let found = hash(&bytes);
                    if found == file.sha256 {
                        sound.insert(file.path.clone());
                    } else {
                        findings.add(path, "sha256", &file.sha256, found);
                    }
                }
            }
        }
        sound
    }

    /// Whether the list says that something was left out on request.
    pub(super) fn is_partial(&self) -> bool {
        self.left_out.is_some()
    }
}

/// Names that stay in the folder on every system.
fn check_name(name: &str) -> Result<(), &'static str> {
    if name == MANIFEST {
        return Err("it lists itself");
    }
    for segment in name.split('/') {
        let plain = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b"._-".contains(&b);
        if segment.is_empty() || segment.starts_with('.') || segment.ends_with('.') || segment.len() > 255 {
            return Err("the name leads out of the folder or is none");
        }
        if !segment.bytes().all(plain) {
            return Err("names are of a to z, 0 to 9, `.`, `_` and `-`");
        }
    }
    Ok(())
}

/// SHA-256 as lower-case hexadecimal.
fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
