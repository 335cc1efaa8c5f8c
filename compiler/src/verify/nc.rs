//! Programs: each is read back against its board in `report.json` (its drawing where there is one, for the decimals)
//! and the machine that is named there. The files as text are in `nc_text`, programs of sheets in `sheet_nc`.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;

use super::dxf::Drawing;
use super::finding::Findings;
use super::machine::Workshop;
use super::nc_text::{NcFile, steady};
use super::report::{Part, Report};
use crate::fabricate::cut_job::{CutJob, Engraving, MAX_CORNERS};
use crate::fabricate::machine::{Fixing, Machine};
use crate::readback::{Expected, Fault, Motion, NcText, Readback, read_back_set};

/// How far places in a program may be from those in a drawing, mm.
const NEAR: f64 = 0.0016;

/// Room between the deepest bevel and the engraving, mm.
const CLEAR_OF_BEVELS: f64 = 1.0;

/// How many faults of a program are told.
const TOLD: usize = 3;

/// Reads every program of boards back, and compares it with its drawing. Those that are known by their hash alone.
pub(super) fn check_together(
    files: &[NcFile],
    drawings: &[Drawing],
    report: Option<&Report>,
    findings: &mut Findings,
) -> Vec<String> {
    let Some(report) = report else { return files.iter().map(|file| file.path.clone()).collect() };
    let drawings: BTreeMap<&str, &Drawing> =
        drawings.iter().map(|drawing| (drawing.address.as_str(), drawing)).collect();
    let mut programs: BTreeMap<&str, Vec<&NcFile>> = BTreeMap::new();
    for file in files {
        programs.entry(&file.address).or_default().push(file);
    }
    // Boards of one fabrication and thickness are cut alike.
    let mut alike: BTreeMap<(usize, i64, Option<u32>), Vec<&NcFile>> = BTreeMap::new();
    let mut number = 0;
    for part in &report.parts {
        let Some(files) = programs.remove(part.address.as_str()) else { continue };
        number += 1;
        let Some(workshop) = report.workshops.get(part.block).and_then(Option::as_ref) else {
            for file in files {
                findings.add(&file.path, "the machine", "one in report.json", "none");
            }
            continue;
        };
        let thickness = (thickness_of(part) * 1000.0).round() as i64;
        for file in &files {
            alike.entry((part.block, thickness, file.tool)).or_default().push(file);
        }
        one(&files, part, drawings.get(part.address.as_str()).copied(), (workshop, number), report, findings);
    }
    for file in programs.into_values().flatten() {
        findings.add(&file.path, "the board", "one of report.json", &file.address);
    }
    for files in alike.values() {
        steady(files, findings);
    }
    Vec::new()
}

/// How thick a part is where it is cut.
fn thickness_of(part: &Part) -> f64 {
    part.number("thickness_mm").unwrap_or(f64::NAN)
}

/// A program that must be the `number`-th.
fn one(
    files: &[&NcFile],
    part: &Part,
    drawing: Option<&Drawing>,
    (workshop, number): (&Workshop, u32),
    report: &Report,
    findings: &mut Findings,
) {
    let path = files[0].path.as_str();
    let job = job(part, drawing, files[0], workshop, report);
    if !can_be_cut(&job) {
        findings.add(path, "the outline", "one that can be cut, in report.json", "another");
        return;
    }
    let expected = |machine| Expected { number, ..Expected::new(&job, machine) };
    if let Some((readback, expected)) = read_by_any(files, workshop, expected, findings) {
        if let Some(drawing) = drawing {
            same_strokes(path, drawing, &readback, &expected, findings);
        }
        passes(path, &readback, &expected, findings);
    }
}

/// A program as a machine reads it, with the first of the cutters that makes of it what is expected; else what the
/// nearest of them finds wrong is told.
pub(super) fn read_by_any<'a>(
    files: &[&NcFile],
    workshop: &'a Workshop,
    expected: impl Fn(&'a Machine) -> Expected<'a>,
    findings: &mut Findings,
) -> Option<(Readback, Expected<'a>)> {
    let mut nearest: Option<Vec<Fault>> = None;
    for machine in &workshop.machines {
        let order = [machine.engraver().number, machine.cutter().number];
        let mut files = files.to_vec();
        files.sort_by_key(|file| order.iter().position(|tool| Some(*tool) == file.tool));
        let texts: Vec<NcText<'_>> =
            files.iter().map(|file| NcText { tool: file.tool, text: &file.text }).collect();
        let expected = expected(machine);
        match read_back_set(&texts, &expected) {
            Ok(readback) => return Some((readback, expected)),
            Err(faults) if nearest.as_ref().is_none_or(|least| faults.len() < least.len()) => {
                nearest = Some(faults);
            }
            Err(_) => {}
        }
    }
    for fault in nearest.iter().flatten().take(TOLD) {
        let file = files.iter().find(|file| file.tool == fault.tool).unwrap_or(&files[0]);
        findings.add(&file.path, format!("line {}", fault.line), fault.kind.property(), &fault.message);
    }
    None
}

/// Whether the figures of a job are such that a program can be held against it.
pub(super) fn can_be_cut(job: &CutJob) -> bool {
    let bounded = |at: &DVec2| at.is_finite() && at.abs().max_element() < 1e6;
    (3..=MAX_CORNERS).contains(&job.outline.len()) && job.outline.iter().all(bounded)
}

/// What is to be cut of a part: its drawing has more decimals than the report, and the words of the header. Without a
/// drawing, the words are those of the program itself.
pub(super) fn job(
    part: &Part,
    drawing: Option<&Drawing>,
    file: &NcFile,
    workshop: &Workshop,
    report: &Report,
) -> CutJob {
    let bevels = (0..4).filter_map(|edge| part.item("bevels_deg", edge));
    let thickness = thickness_of(part);
    let widest = bevels.map(|bevel| thickness * libm::tan(bevel.abs().to_radians())).fold(0.0, f64::max);
    let exact =
        drawing.map(|drawing| drawing.outline.clone()).filter(|outline| outline.len() == part.outline.len());
    let said = || workshop.dialect().map(|dialect| file.header(dialect.profile())).unwrap_or_default();
    let (face_up, notes) = match drawing.and_then(|drawing| Some((drawing.face_up.clone()?, &drawing.notes)))
    {
        Some((face_up, notes)) => (face_up, notes.clone()),
        None => {
            let mut said = said();
            let face_up = said.get("face up").and_then(|all| all.first()).cloned().unwrap_or_default();
            (face_up, said.remove("note").unwrap_or_default())
        }
    };
    CutJob {
        address: part.address.clone(),
        alias: part.alias.clone(),
        design: report.design.clone(),
        design_hash: report.design_hash.clone(),
        outline: exact.unwrap_or_else(|| part.outline.clone()),
        thickness,
        engraving: Engraving {
            height: workshop.height,
            least_height: workshop.least_height,
            // The bevels of the report are rounded.
            clearance: CLEAR_OF_BEVELS + widest - 0.001,
            mark_edge_0: true,
        },
        face_up,
        notes,
    }
}

/// The engraving is that of the drawing, stroke by stroke.
fn same_strokes(
    path: &str,
    drawing: &Drawing,
    readback: &Readback,
    expected: &Expected<'_>,
    findings: &mut Findings,
) {
    let (Some(there), Some(here)) =
        (drawing.outline.first(), expected.parts.first().and_then(|part| part.outline.first()))
    else {
        return;
    };
    let moved = *here - *there;
    let wanted: Vec<(DVec2, DVec2)> = drawing
        .strokes
        .iter()
        .flat_map(|stroke| {
            stroke.windows(2).map(|pair| (pair[0] + moved, pair[1] + moved)).collect::<Vec<_>>()
        })
        .collect();
    let (cutter, engraver) = (expected.machine.cutter().number, expected.machine.engraver().number);
    if cutter == engraver {
        // Its strokes cannot be told from its passes; what they spell was read.
        return;
    }
    let mut made = Vec::new();
    for m in readback.moves.iter().filter(|m| m.tool == Some(engraver) && m.motion == Motion::Straight) {
        if let ([Some(x0), Some(y0), Some(z0)], [Some(x1), Some(y1), Some(z1)]) = (m.from, m.to)
            && z0 < expected.machine.top(expected.thickness)
            && (z0 - z1).abs() < 1e-9
        {
            made.push((DVec2::new(x0, y0), DVec2::new(x1, y1)));
        }
    }
    if made.len() != wanted.len() {
        findings.add(path, "strokes of the engraving", format!("{} as drawn", wanted.len()), made.len());
    }
    for ((a, b), (c, d)) in wanted.iter().zip(&made) {
        findings.near(path, "a stroke off the drawing, mm", 0.0, a.distance(*c).max(b.distance(*d)), NEAR);
    }
}

/// Above full depth the cutter runs where it runs at full depth, unless passes stay away from the part or rise over tabs.
fn passes(path: &str, readback: &Readback, expected: &Expected<'_>, findings: &mut Findings) {
    let spec = expected.machine.spec();
    if spec.allowance > 0.0 || matches!(spec.fixing, Fixing::Tabs { .. }) {
        return;
    }
    let cutter = spec.cutter;
    let mut ends: BTreeSet<(i64, i64)> = BTreeSet::new();
    let thousandths = |value: f64| (value * 1000.0).round() as i64;
    let cuts: Vec<_> =
        readback.moves.iter().filter(|m| m.tool == Some(cutter) && m.motion != Motion::Rapid).collect();
    let bottom = expected.machine.bottom(expected.thickness);
    for m in &cuts {
        if let [Some(x), Some(y), Some(z)] = m.to
            && (z - bottom).abs() < 0.002
        {
            ends.insert((thousandths(x), thousandths(y)));
        }
    }
    for m in cuts {
        if let [Some(x), Some(y), Some(z)] = m.to
            && z < expected.machine.top(expected.thickness) + 1e-9
            && !ends.contains(&(thousandths(x), thousandths(y)))
        {
            let found = format!("X{x:.3} Y{y:.3}");
            findings.add(path, format!("line {}", m.line), "a place of the path at full depth", found);
        }
    }
}
