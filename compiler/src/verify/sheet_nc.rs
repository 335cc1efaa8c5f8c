//! Programs of sheets: each is read back against all boards that `nest.csv` lays on its sheet, with the machine that the
//! programs of single boards tell of. Without those, without drawings of all its boards, in other dialects than the base
//! one, and for boards that are not held by the table alone, a program is known by its hash.

use std::collections::BTreeMap;

use glam::DVec2;
use serde_json::Value;

use super::dxf::Drawing;
use super::finding::Findings;
use super::nc::{Program, can_be_cut, job, tell};
use super::report::Report;
use super::sheets::{Lying, NEAR, Raw, name_of, turned};
use crate::fabricate::cut_job::{CutJob, MAX_PARTS};
use crate::fabricate::machine::Machine;
use crate::readback::{Expected, ExpectedPart, read_back};

/// What programs of sheets are held against.
pub(super) struct Set<'a> {
    pub(super) drawings: &'a [Drawing],
    pub(super) report: &'a Report,
    /// By the number of the fabrication.
    pub(super) machines: &'a BTreeMap<usize, Machine>,
    pub(super) raws: &'a BTreeMap<String, (Raw, Value)>,
    pub(super) lying: &'a [Lying],
}

impl Set<'_> {
    /// Reads a program back; whether it could be.
    pub(super) fn check(&self, program: &Program, findings: &mut Findings) -> bool {
        let path = program.path.as_str();
        let name = name_of(path);
        let here: Vec<&Lying> = self.lying.iter().filter(|board| board.sheet == name).collect();
        let first = here.first().and_then(|board| self.report.part(&board.address));
        let machine = first.and_then(|part| self.machines.get(&part.block));
        let (Some((raw, _)), Some(machine)) = (self.raws.get(name), machine) else { return false };
        // A spare cutter may have taken the place of the one that cuts the boards alone.
        if program.cutter() != Some(machine.spec().cutter) {
            return false;
        }
        let Some(jobs) = self.jobs(program, &here) else { return false };
        if here.len() > MAX_PARTS || !jobs.iter().all(can_be_cut) {
            return false;
        }
        if !program.is_read() {
            findings.add(path, "the program", "the dialect and fixing of the boards", "another");
            return true;
        }
        let said: &[String] = program.header.get("at").map_or(&[], Vec::as_slice);
        let parts = here.iter().zip(&jobs).enumerate().map(|(place, (board, job))| ExpectedPart {
            job,
            outline: placed(board, job, said.get(place).map_or("", String::as_str)),
            turned: 90 * u32::from(board.quarters),
        });
        let expected = Expected {
            parts: parts.collect(),
            machine,
            stock: raw.size,
            thickness: jobs.first().map_or(0.0, |job| job.thickness),
            sheet: name.to_owned(),
            number: 1,
        };
        if let Err(faults) = read_back(&program.text, &expected) {
            tell(path, &faults, findings);
        }
        true
    }

    fn jobs(&self, program: &Program, here: &[&Lying]) -> Option<Vec<CutJob>> {
        let job = |board: &&Lying| {
            let part = self.report.part(&board.address)?;
            let drawing = self.drawings.iter().find(|drawing| drawing.address == board.address)?;
            Some(job(part, Some(drawing), program, self.report))
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
