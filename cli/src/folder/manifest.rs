//! `manifest.json`: what a build wrote and from what. No time stamps, absolute paths or user names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::FolderError;
use super::names::{MANIFEST, check_relative};
use ifs_compiler::outputs::LeftOut;
use ifs_compiler::outputs::names::hex;

/// The version of the manifest's shape; it grows when a reader of the older shape would misread the newer.
const SCHEMA: u32 = 1;

/// The name of the program in the manifest, by which its own manifests are known from others.
const PROGRAM: &str = "ifs";

/// What a set of outputs was made from.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Provenance {
    /// The sources by their names relative to the project, with their bytes' hashes.
    pub sources: Vec<SourceRecord>,
    /// The values of all parameters, as text in the language.
    pub parameters: BTreeMap<String, String>,
    /// The names of the parameters that were set from outside.
    pub set: BTreeSet<String>,
    /// The machine that was named from outside of the design: a file of the project and a name in it.
    pub machine: Option<String>,
    /// What was not made though it could be; none where everything was.
    pub left_out: Option<LeftOutRecord>,
    /// Whether the last build failed: then only what it said is new, and the rest is of the build before.
    pub failed: bool,
}

/// What a build was asked to leave out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct LeftOutRecord {
    /// The outputs that `--emit` did not name.
    pub outputs: Vec<String>,
    /// The patterns of `--only`, one of which a board had to fit.
    pub only: Vec<String>,
    /// How many boards fitted none of them.
    pub boards: u64,
}

impl LeftOutRecord {
    /// The record of what was left out, if anything was.
    pub fn of(left_out: LeftOut) -> Option<LeftOutRecord> {
        if left_out == LeftOut::default() {
            return None;
        }
        let outputs = left_out.formats.into_iter().map(str::to_owned).collect();
        Some(LeftOutRecord { outputs, only: left_out.only, boards: left_out.boards as u64 })
    }
}

/// One source.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct SourceRecord {
    /// Its name relative to the project, with `/`.
    pub path: String,
    /// SHA-256 of its bytes, lower-case hexadecimal.
    pub sha256: String,
}

impl SourceRecord {
    /// The record of a source's bytes.
    pub fn of(path: &str, bytes: &[u8]) -> SourceRecord {
        SourceRecord { path: path.to_owned(), sha256: hex(&Sha256::digest(bytes)) }
    }
}

/// One file of the set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileRecord {
    /// Its name in the folder, with `/`.
    pub path: String,
    /// Its length in bytes.
    pub bytes: u64,
    /// SHA-256 of its bytes, lower-case hexadecimal.
    pub sha256: String,
    /// What it is: `nc`, `glb`, `csv`, …
    pub kind: String,
    /// The address of the board or plank it is for, where it is for one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub address: Option<String>,
}

/// The whole list. Fields are written in this order, files and sources in the order of their names.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    /// Version of this shape.
    pub schema: u32,
    /// Always `ifs`.
    pub program: String,
    /// Version of the program that wrote the set.
    pub version: String,
    /// What it was made from.
    pub sources: Vec<SourceRecord>,
    /// The values of all parameters.
    pub parameters: BTreeMap<String, String>,
    /// The names of those that were set from outside; absent where none was.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    pub set: BTreeSet<String>,
    /// The machine that was named from outside, `machines.ifs:router`; absent where the design's own are used.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<String>,
    /// What was not made though it could be; absent where everything was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_out: Option<LeftOutRecord>,
    /// Whether the last build failed: then `diagnostics.json` says why, and all else is of the build before it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub failed: bool,
    /// Every file but the manifest itself.
    pub files: Vec<FileRecord>,
}

impl Manifest {
    /// The manifest of a set, in its fixed order.
    pub(super) fn new(provenance: &Provenance, files: BTreeMap<String, FileRecord>) -> Manifest {
        let mut sources = provenance.sources.clone();
        sources.sort();
        Manifest {
            schema: SCHEMA,
            program: PROGRAM.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            sources,
            parameters: provenance.parameters.clone(),
            set: provenance.set.clone(),
            machine: provenance.machine.clone(),
            left_out: provenance.left_out.clone(),
            failed: provenance.failed,
            files: files.into_values().collect(),
        }
    }

    /// The bytes of the file: indented JSON, LF, a final newline.
    pub(super) fn to_bytes(&self) -> io::Result<Vec<u8>> {
        let mut bytes = serde_json::to_vec_pretty(self)?;
        bytes.push(b'\n');
        Ok(bytes)
    }

    /// Reads the manifest of a folder; `None` where there is none.
    ///
    /// # Errors
    /// It cannot be read, or it is not one of ours.
    pub fn read(folder: &Path) -> Result<Option<Manifest>, FolderError> {
        let path = folder.join(MANIFEST);
        let bytes = match fs::read(&path) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(FolderError::io("read", &path)(error)),
        };
        let refuse = |reason: String| FolderError::NotOurManifest { path: path.clone(), reason };
        let manifest: Manifest = serde_json::from_slice(&bytes).map_err(|error| refuse(error.to_string()))?;
        if manifest.program != PROGRAM {
            return Err(refuse(format!("its program is {:?}", manifest.program)));
        }
        if manifest.schema > SCHEMA {
            return Err(refuse(format!("its schema {} is of a later program", manifest.schema)));
        }
        for file in &manifest.files {
            check_relative(&file.path).map_err(|error| refuse(error.to_string()))?;
        }
        Ok(Some(manifest))
    }

    /// The names of the set, the manifest among them.
    pub(super) fn names(&self) -> BTreeSet<PathBuf> {
        self.files.iter().map(|file| PathBuf::from(&file.path)).chain([PathBuf::from(MANIFEST)]).collect()
    }
}

/// Compares every file of the set in `folder` with its manifest and returns what differs, in words; an empty list
/// means the set is whole. Files which the manifest does not list are not looked at.
///
/// # Errors
/// There is no manifest that can be read.
pub fn verify(folder: &Path) -> Result<Vec<String>, FolderError> {
    let Some(manifest) = Manifest::read(folder)? else {
        let missing = io::Error::from(io::ErrorKind::NotFound);
        return Err(FolderError::io("read", &folder.join(MANIFEST))(missing));
    };
    let mut differences = Vec::new();
    for file in &manifest.files {
        match measure(&folder.join(&file.path)) {
            Err(error) => differences.push(format!("{}: {error}", file.path)),
            Ok((bytes, _)) if bytes != file.bytes => {
                differences.push(format!("{}: {bytes} bytes, not {}", file.path, file.bytes));
            }
            Ok((_, sha256)) if sha256 != file.sha256 => {
                differences.push(format!("{}: other bytes than listed", file.path));
            }
            Ok(_) => {}
        }
    }
    Ok(differences)
}

/// The length and hash of a file.
fn measure(path: &Path) -> io::Result<(u64, String)> {
    let mut file = File::open(path)?;
    let mut hasher = Sha256::new();
    let mut buffer = vec![0; 1 << 16];
    let mut bytes = 0;
    loop {
        let count = file.read(&mut buffer)?;
        if count == 0 {
            return Ok((bytes, hex(&hasher.finalize())));
        }
        hasher.update(&buffer[..count]);
        bytes += count as u64;
    }
}
