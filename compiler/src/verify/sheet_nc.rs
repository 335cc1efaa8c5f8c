//! Programs of sheets: each is read back against all boards that `nest.csv` lays on its sheet, with the machine of
//! `report.json`. Without drawings of all its boards a program is known by its hash.

use std::collections::BTreeMap;

use glam::DVec2;
use serde_json::Value;

use super::dxf::Drawing;
use super::finding::Findings;
use super::machine::Workshop;
use super::nc::{can_be_cut, job, read_by_any};
use super::nc_text::NcFile;
use super::report::Report;
use super::sheets::{Lying, NEAR, Raw, name_of, turned};
use crate::fabricate::cut_job::{CutJob, MAX_PARTS};
use crate::readback::{Expected, ExpectedPart};

/// What programs of sheets are held against.
pub(super) struct Set<'a> {
    pub(super) drawings: &'a [Drawing],
    pub(super) report: &'a Report,
    /// By the names of sheets, in the order of the report.
    pub(super) raws: &'a [(String, Raw, Value)],
    pub(super) lying: &'a [Lying],
    /// How many programs of boards there are: those of sheets are numbered after them.
    pub(super) before: u32,
}

impl Set<'_> {
    /// Reads the programs back; the files that could not be.
    pub(super) fn check(&self, files: &[NcFile], findings: &mut Findings) -> Vec<String> {
        let mut programs: BTreeMap<&str, Vec<&NcFile>> = BTreeMap::new();
        for file in files {
            programs.entry(name_of(&file.path)).or_default().push(file);
        }
        let mut unread = Vec::new();
        let mut number = self.before;
        for (name, raw, _) in self.raws {
            let Some(files) = programs.remove(name.as_str()) else { continue };
            number += 1;
            if !self.one(&files, name, *raw, number, findings) {
                unread.extend(files.iter().map(|file| file.path.clone()));
            }
        }
        for file in programs.into_values().flatten() {
            findings.add(&file.path, "the sheet", "one of report.json", name_of(&file.path));
        }
        unread
    }

    /// Reads the program of a sheet; whether it could be.
    fn one(&self, files: &[&NcFile], name: &str, raw: Raw, number: u32, findings: &mut Findings) -> bool {
        let here: Vec<&Lying> = self.lying.iter().filter(|board| board.sheet == name).collect();
        let first = here.first().and_then(|board| self.report.part(&board.address));
        let workshop = first.and_then(|part| self.report.workshops.get(part.block)?.as_ref());
        let Some(workshop) = workshop else { return false };
        let Some(jobs) = self.jobs(files[0], workshop, &here) else { return false };
        if here.len() > MAX_PARTS || !jobs.iter().all(can_be_cut) {
            return false;
        }
        let header = workshop.dialect().map(|dialect| files[0].header(dialect.profile())).unwrap_or_default();
        let said: &[String] = header.get("at").map_or(&[], Vec::as_slice);
        let parts = here.iter().zip(&jobs).enumerate().map(|(place, (board, job))| ExpectedPart {
            job,
            outline: placed(board, job, said.get(place).map_or("", String::as_str)),
            turned: 90 * u32::from(board.quarters),
        });
        let parts: Vec<ExpectedPart<'_>> = parts.collect();
        let expected = |machine| Expected {
            parts: parts.clone(),
            machine,
            stock: raw.size,
            thickness: jobs.first().map_or(0.0, |job| job.thickness),
            sheet: name.to_owned(),
            number,
        };
        read_by_any(files, workshop, expected, findings);
        true
    }

    fn jobs(&self, file: &NcFile, workshop: &Workshop, here: &[&Lying]) -> Option<Vec<CutJob>> {
        let job = |board: &&Lying| {
            let part = self.report.part(&board.address)?;
            let drawing = self.drawings.iter().find(|drawing| drawing.address == board.address)?;
            Some(job(part, Some(drawing), file, workshop, self.report))
        };
        here.iter().map(job).collect()
    }
}

/// The outline of a board where it lies. Places in the list are rounded: where the header's is the same but for that, the
/// header's counts.
fn placed(board: &Lying, job: &CutJob, said: &str) -> Vec<DVec2> {
    let corners: Vec<DVec2> =
        job.outline.iter().map(|&corner| turned(corner, board.quarters) + board.at).collect();
    let low = corners.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let place = said.split(" turned ").next().and_then(|place| place.split_once(" x "));
    let number = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
    let off = place.map_or(DVec2::NAN, |(x, y)| DVec2::new(number(x), number(y))) - low;
    let near = off.abs().max_element() <= NEAR;
    corners.into_iter().map(|corner| if near { corner + off } else { corner }).collect()
}
