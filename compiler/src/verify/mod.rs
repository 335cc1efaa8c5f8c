//! Reads a set of outputs again and judges it: whether every file is the one that the manifest lists, and whether what
//! the files say agrees — with `report.json`, with each other, and with what a format allows. Shares no code with
//! `export` or `outputs`: every format has a reader of its own here; programs are read by `readback`. Opens no file:
//! bytes come through [`Folder`]. Findings are plain data; nobody is told here.

mod bars;
mod btlx;
mod csv;
mod dxf;
mod finding;
mod form;
mod glb;
mod html;
mod labels;
mod lists;
mod machine;
mod manifest;
mod nc;
mod nc_text;
mod report;
mod sheet_nc;
mod sheets;
mod vote;
mod xml;

pub use finding::Finding;
pub use manifest::{KINDS, Listed, Manifest, NotAManifest};

use std::collections::BTreeSet;

use finding::Findings;
use report::Report;

/// What is to be verified: names relative to the folder, with `/`, and their bytes.
pub trait Folder {
    /// Every file in the folder and below, `manifest.json` too, in order.
    fn names(&self) -> Vec<String>;

    /// The bytes of a file, at most `most` of them and one more.
    ///
    /// # Errors
    /// Why it cannot be read, for people: it is not there, is a link, is no file.
    fn bytes(&self, name: &str, most: u64) -> Result<Vec<u8>, String>;
}

/// What was found out about a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    /// What is wrong, in the order of the files; empty where nothing is.
    pub findings: Vec<Finding>,
    /// How many files the manifest lists.
    pub files: usize,
    /// How many of them were read as what they are, beyond their hash.
    pub read: usize,
    /// Files of kinds that are known by their hash alone.
    pub by_hash: Vec<String>,
    /// Files that the manifest does not list: not outputs.
    pub foreign: Vec<String>,
    /// Whether the last build failed: then the files are those of the build before.
    pub failed: bool,
}

/// Verifies a set.
///
/// # Errors
/// Its `manifest.json` is missing, is none of ours, or leads out of the folder: nothing was looked at then.
pub fn verify(folder: &dyn Folder) -> Result<Verdict, NotAManifest> {
    let manifest = Manifest::read(folder)?;
    let mut findings = Findings::default();
    let foreign = manifest.foreign(folder, &mut findings);
    let sound = manifest.check_hashes(folder, &mut findings);
    let set = Set { folder, manifest: &manifest };
    let mut read = 0;
    let mut by_hash = Vec::new();
    let report = set.bytes("report.json").and_then(|bytes| {
        read += 1;
        report::read(&bytes, &manifest, &mut findings)
    });
    let whole = !manifest.is_partial();
    let mut boards = Boards { report: report.as_ref(), whole, ..Boards::default() };
    for file in manifest.files.iter().filter(|file| sound.contains(&file.path) && file.path != "report.json")
    {
        let Some(bytes) = set.bytes(&file.path) else { continue };
        if judge(file, &bytes, &mut boards, &manifest, &mut findings) {
            read += 1;
        } else {
            by_hash.push(file.path.clone());
        }
    }
    let unread = boards.together(&mut findings);
    read -= unread.len();
    by_hash.extend(unread);
    if let Some(report) = &report {
        report.check_files(&manifest, &mut findings);
        labels::check(&set, report, &mut findings);
        glb::with_frames(&set, report, &mut findings);
    }
    let (files, failed) = (manifest.files.len(), manifest.failed);
    Ok(Verdict { findings: findings.sorted(), files, read, by_hash, foreign, failed })
}

/// The listed files.
struct Set<'a> {
    folder: &'a dyn Folder,
    manifest: &'a Manifest,
}

impl Set<'_> {
    /// The bytes of a listed file; none where it is not listed or cannot be read, which is found elsewhere.
    fn bytes(&self, name: &str) -> Option<Vec<u8>> {
        let listed = self.manifest.files.iter().find(|file| file.path == name)?;
        self.folder.bytes(name, listed.bytes).ok()
    }
}

/// What of single boards is compared with each other once all are read.
#[derive(Default)]
struct Boards<'a> {
    report: Option<&'a Report>,
    /// Whether nothing was left out.
    whole: bool,
    dxf: Vec<dxf::Drawing>,
    nc: Vec<nc_text::NcFile>,
    sheet_nc: Vec<nc_text::NcFile>,
    /// Pictures and drawings of sheets.
    shown: Vec<sheets::Shown>,
    /// Where boards lie; none without a list that could be read.
    lying: Option<Vec<sheets::Lying>>,
}

impl Boards<'_> {
    /// The files that could not be read after all.
    fn together(&self, findings: &mut Findings) -> Vec<String> {
        dxf::check_together(&self.dxf, findings);
        let mut unread = nc::check_together(&self.nc, &self.dxf, self.report, findings);
        let (Some(report), Some(lying)) = (self.report, &self.lying) else {
            unread.extend(self.shown.iter().map(|shown| shown.path.clone()));
            unread.extend(self.sheet_nc.iter().map(|program| program.path.clone()));
            return unread;
        };
        let raws = sheets::raws(report);
        for shown in &self.shown {
            let name = sheets::name_of(&shown.path);
            match raws.iter().find(|(sheet, ..)| sheet == name) {
                Some((_, raw, _)) => sheets::compare(shown, name, *raw, lying, findings),
                None => findings.add(&shown.path, "the sheet", "one of report.json", name),
            }
        }
        let boards: BTreeSet<&str> = self.nc.iter().map(|file| file.address.as_str()).collect();
        let before = boards.len() as u32;
        let set = sheet_nc::Set { drawings: &self.dxf, report, raws: &raws, lying, before };
        unread.extend(set.check(&self.sheet_nc, findings));
        unread
    }
}

/// Reads one file as what it is; whether it is of a kind that can be.
fn judge(
    file: &Listed,
    bytes: &[u8],
    boards: &mut Boards<'_>,
    manifest: &Manifest,
    findings: &mut Findings,
) -> bool {
    let path = file.path.as_str();
    let known = |text: &mut Findings| form::text(path, bytes, text);
    match (path, path.rsplit_once('.').map_or("", |(_, end)| end)) {
        ("diagnostics.json", _) => report::diagnostics(path, bytes, manifest, findings),
        ("cutlist.csv" | "assembly.csv" | "planarity.csv", _) => {
            if let Some(text) = known(findings) {
                lists::check(path, text, boards.report, manifest, findings);
            }
        }
        ("report.html", _) => {
            if let Some(text) = known(findings) {
                html::check(path, text, boards.report, findings);
            }
        }
        ("model.glb", _) => glb::check(path, bytes, boards.report, findings),
        ("model.btlx", _) => {
            if let Some(text) = known(findings) {
                btlx::check(path, text, boards.report, manifest, findings);
            }
        }
        (_, "svg") if path.starts_with("labels") => {
            if let Some(text) = known(findings) {
                labels::form(path, text, findings);
            }
        }
        ("nest.csv", _) => {
            let Some(report) = boards.report else { return false };
            if let Some(text) = known(findings) {
                boards.lying = Some(sheets::read(text, report, boards.whole, findings));
            }
        }
        ("stock.csv", _) => {
            let Some(report) = boards.report else { return false };
            if let Some(text) = known(findings) {
                bars::check(text, report, boards.whole, findings);
            }
        }
        (_, "svg") if path.starts_with("sheets/") => {
            if let Some(text) = known(findings) {
                boards.shown.push(sheets::picture(path, text, findings));
            }
        }
        (_, "dxf") if path.starts_with("sheets/") => {
            if let Some(text) = known(findings) {
                boards.shown.extend(dxf::read_sheet(path, text, findings));
            }
        }
        (_, "nc") if path.starts_with("sheets/") => {
            if let Some(text) = known(findings) {
                boards.sheet_nc.push(nc_text::NcFile::read(file, text));
            }
        }
        (_, "dxf") if path.starts_with("boards/") => {
            if let Some(text) = known(findings) {
                boards.dxf.extend(dxf::read(file, text, boards.report, findings));
            }
        }
        (_, "nc") if path.starts_with("boards/") => {
            if let Some(text) = known(findings) {
                boards.nc.push(nc_text::NcFile::read(file, text));
            }
        }
        _ => return false,
    }
    true
}
