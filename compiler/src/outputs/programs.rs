//! NC programs: one for each board and plank of a block with a machine, read back before it is given out.

use super::failures::{Failure, failed};
use super::machines::machines;
use super::names::safe_file_name;
use super::nests::{Nests, SheetNest};
use super::refits::refit;
use super::sheet_programs::is_wanted;
use super::{Making, Output, Selection, design_hash};
use crate::analysis::{Analysis, Elements, Fabrication, Programs, number};
use crate::diagnostic::{Code, Diagnostic};
use crate::export::nc::{self, NcFile};
use crate::export::number::fixed;
use crate::fabricate::cut_job::{CutJob, Engraving, Sheet};
use crate::fabricate::machine::Machine;
use crate::fabricate::panel::{Edges, Panel};
use crate::fabricate::plank::Plank;
use crate::fabricate::toolpath::{Program, Refusal, sheet};
use crate::hir::tree::Hir;
use crate::readback::{Expected, NcText, read_back_set};
use crate::source::Span;
use glam::DVec3;
use std::collections::BTreeSet;

/// Room between the deepest bevel and the engraving, mm.
const CLEAR_OF_BEVELS: f64 = 1.0;

/// A fabricate block with what its machine is to cut.
pub(super) struct Block<'a> {
    /// What it makes.
    pub(super) made: &'a Fabrication,
    /// The machine, and where the design names it.
    pub(super) machine: Option<(Machine, Span)>,
    /// The same machine with each of its spare cutters.
    pub(super) spares: Vec<Machine>,
    /// All its boards, in order.
    all: Vec<CutJob>,
    /// Whether each of them is wanted.
    wanted: Vec<bool>,
}

impl Block<'_> {
    /// The boards that are wanted, each with its place among those of the block, in order.
    pub(super) fn jobs(&self) -> impl Iterator<Item = (usize, &CutJob)> {
        self.all.iter().enumerate().filter(|(place, _)| self.wanted[*place])
    }

    /// Whether a board is wanted, by its place among those of the block.
    pub(super) fn wants(&self, place: usize) -> bool {
        self.wanted.get(place).copied().unwrap_or(false)
    }

    /// A board by its place among those of the block.
    pub(super) fn job(&self, place: usize) -> Option<&CutJob> {
        self.all.get(place)
    }

    /// The machine with its own cutter, then with each of the spare ones.
    pub(super) fn machines(&self) -> Vec<&Machine> {
        self.machine.iter().map(|(machine, _)| machine).chain(&self.spares).collect()
    }
}

/// The blocks of a design with the boards that are wanted, or what speaks against their machines.
pub(super) fn blocks<'a>(analysis: &'a Analysis, selection: &Selection) -> (Vec<Block<'a>>, Vec<Diagnostic>) {
    let (mut blocks, mut diagnostics) = (Vec::new(), Vec::new());
    let hash = design_hash(analysis);
    for made in &analysis.fabrications {
        let all = jobs(analysis, made, &hash);
        let wanted = all.iter().map(|job| selection.takes(&job.address, &job.alias)).collect();
        match machines_of(analysis, made) {
            Ok(found) => {
                let (mut machines, span) = found.unwrap_or_default();
                let spares = machines.split_off(machines.len().min(1));
                let machine = machines.pop().map(|machine| (machine, span));
                blocks.push(Block { made, machine, spares, all, wanted });
            }
            Err(diagnostic) => diagnostics.push(diagnostic),
        }
    }
    (blocks, diagnostics)
}

/// The machine of a block, as [`machines`] gives it, and where the design names it; none where it names none.
///
/// # Errors
/// E0804: its figures are out of range.
pub(super) fn machines_of(
    analysis: &Analysis,
    made: &Fabrication,
) -> Result<Option<(Vec<Machine>, Span)>, Diagnostic> {
    let setting = |wanted: &str| {
        made.settings.iter().find(|(name, _, _)| *name == wanted).map(|(_, value, span)| (value, *span))
    };
    let Some((value, span)) = setting("machine") else { return Ok(None) };
    Ok(Some((machines(&analysis.hir, value, span, setting("fixing"))?, span)))
}

/// The programs of the boards of every block with a machine, or what speaks against them.
pub(super) fn programs(
    analysis: &Analysis,
    blocks: &[Block<'_>],
    nests: &Nests,
    watch: &mut dyn FnMut(Making),
) -> (Vec<Output>, Vec<Diagnostic>) {
    let (mut outputs, mut diagnostics) = (Vec::new(), Vec::new());
    let in_sheets = cut_in_sheets(blocks, nests);
    for (place, block) in blocks.iter().enumerate() {
        if let Some((_, span)) = &block.machine {
            let alone = block.jobs().filter(|(board, _)| !in_sheets.contains(&(place, *board)));
            let jobs: Vec<&CutJob> = alone.map(|(_, job)| job).collect();
            let failures = block_programs(&jobs, &block.machines(), &mut outputs, watch);
            for code in [Code::E0901, Code::E0902] {
                let group: Vec<&Failure> = failures.iter().filter(|failure| failure.code == code).collect();
                let refusals: Vec<&Refusal> = group.iter().filter_map(|one| one.refusal.as_ref()).collect();
                let fix = refit(analysis, block.made, &refusals);
                diagnostics.extend(failed(code, &group, *span, fix));
            }
        }
    }
    (outputs, diagnostics)
}

/// The boards, by block and place in it, that are cut by the programs of their sheets alone.
fn cut_in_sheets(blocks: &[Block<'_>], nests: &Nests) -> BTreeSet<(usize, usize)> {
    let nests = nests.sheets.iter().filter(|nest| nest.programs == Programs::Sheets);
    let of_nest = |nest: &SheetNest| -> Vec<(usize, usize)> {
        let cut: Vec<bool> = (0..nest.nested.sheets).map(|sheet| is_wanted(blocks, nest, sheet)).collect();
        let placed = nest.nested.placements.iter().filter(|placed| cut[placed.sheet]);
        placed.map(|placed| nest.named[placed.part].place).collect()
    };
    nests.flat_map(of_nest).collect()
}

/// Why none of the machines, which differ in their cutters, can cut a board; `None` where one can.
pub(super) fn refusal_of(job: &CutJob, machines: &[&Machine]) -> Option<Refusal> {
    let mut first = None;
    for machine in machines {
        match sheet(&Sheet::single(job, machine), machine) {
            Ok(_) => return None,
            Err(error) => first.get_or_insert(error.refusal),
        };
    }
    first
}

fn block_programs(
    jobs: &[&CutJob],
    machines: &[&Machine],
    outputs: &mut Vec<Output>,
    watch: &mut dyn FnMut(Making),
) -> Vec<Failure> {
    let mut failures: Vec<Failure> = Vec::new();
    for (done, job) in jobs.iter().enumerate() {
        watch(Making::Programs { done, of: jobs.len() });
        let number = u32::try_from(outputs.len()).map_or(u32::MAX, |before| before.saturating_add(1));
        match one(job, machines, number) {
            Ok(files) => outputs.extend(files.into_iter().map(|file| {
                let path = format!("boards/{}", safe_file_name(&job.address, &extension(&file)));
                Output::of_board(&path, "program", &job.address, file.text.into_bytes())
            })),
            Err(NoProgram { code, why, refusal }) => {
                let (alias, address) = (job.alias.clone(), job.address.clone());
                failures.push(Failure { code, alias, address, why, refusal });
            }
        }
    }
    failures
}

/// Why there is no program.
struct NoProgram {
    code: Code,
    why: String,
    refusal: Option<Refusal>,
}

/// The machine that cuts a sheet: the first that can, which differ in their cutters; if none can, the first.
pub(super) fn cutting<'m, 'j>(
    machines: &[&'m Machine],
    sheet_on: impl Fn(&Machine) -> Sheet<'j>,
) -> Option<&'m Machine> {
    let can = |machine: &&&Machine| machines.len() == 1 || sheet(&sheet_on(machine), machine).is_ok();
    machines.iter().find(can).or(machines.first()).copied()
}

/// The files of a program that has been read back: on the first of the machines that can, which differ in their cutters.
/// If none can, it is the first that says why.
fn one(job: &CutJob, machines: &[&Machine], number: u32) -> Result<Vec<NcFile>, NoProgram> {
    let mut refused: Option<Refusal> = None;
    for &machine in machines {
        let sheet_of_one = Sheet { number, ..Sheet::single(job, machine) };
        let program = match sheet(&sheet_of_one, machine) {
            Ok(program) => program,
            Err(error) => {
                refused.get_or_insert(error.refusal);
                continue;
            }
        };
        let expected = Expected { number, ..Expected::new(job, machine) };
        let refused = |why| NoProgram { code: Code::E0902, why, refusal: None };
        return written(&program, machine, &expected).map_err(refused);
    }
    let why = refused.as_ref().map_or_else(|| "there is no machine".to_owned(), ToString::to_string);
    Err(NoProgram { code: Code::E0901, why, refusal: refused })
}

/// The files of a program, or the first fault that reading them back finds.
pub(super) fn written(
    program: &Program,
    machine: &Machine,
    expected: &Expected,
) -> Result<Vec<NcFile>, String> {
    let files = nc::write(program, machine);
    let texts: Vec<NcText> = files.iter().map(|file| NcText { tool: file.tool, text: &file.text }).collect();
    match read_back_set(&texts, expected) {
        Ok(_) => Ok(files),
        Err(faults) => Err(faults.first().map_or_else(String::new, ToString::to_string)),
    }
}

/// What comes after the name in the names of a program's files: `nc`, or `t1.nc` where there is one for each tool.
pub(super) fn extension(file: &NcFile) -> String {
    file.tool.map_or_else(|| "nc".to_owned(), |tool| format!("t{tool}.nc"))
}

fn jobs(analysis: &Analysis, made: &Fabrication, hash: &str) -> Vec<CutJob> {
    let design = analysis.design_name();
    let engraving = engraving(&analysis.hir, made);
    match &made.elements {
        Elements::Panels(panels) => {
            panels.panels.iter().map(|panel| panel_job(panel, &design, hash, engraving)).collect()
        }
        Elements::Planks(planks) => {
            planks.planks.iter().map(|plank| plank_job(plank, &design, hash, engraving)).collect()
        }
    }
}

/// Height and least height asked for, else those of the library's `Engraving`, mm.
pub(super) fn engraving(hir: &Hir, made: &Fabrication) -> (f64, f64) {
    let asked = made.settings.iter().find(|(name, _, _)| *name == "address").map(|(_, value, _)| value);
    let number = |name: &str| asked.and_then(|value| number(hir, value, name));
    (number("height").unwrap_or(12.0), number("least").unwrap_or(5.0))
}

fn panel_job(panel: &Panel, design: &str, hash: &str, (height, least): (f64, f64)) -> CutJob {
    let widest = panel.bevels.iter().flatten().map(|bevel| panel.thickness * libm::tan(bevel.abs()));
    let clearance = CLEAR_OF_BEVELS + widest.fold(0.0, f64::max);
    let notes = (0..4).map(|edge| {
        let bevel = match panel.bevels[edge] {
            Some(bevel) => format!("bevel {} deg not cut by this file", degrees(bevel)),
            None => "border".to_owned(),
        };
        let neighbour = towards(panel.neighbours[edge].as_ref());
        format!("edge {edge}: {bevel}{}{neighbour}", faces_beside(panel, edge))
    });
    let engraving = Engraving { height, least_height: least, clearance, mark_edge_0: true };
    CutJob {
        address: panel.label.address.clone(),
        alias: panel.label.alias.clone(),
        design: design.to_owned(),
        design_hash: hash.to_owned(),
        outline: panel.outline.clone(),
        thickness: panel.thickness,
        engraving,
        face_up: "outer".to_owned(),
        notes: notes.collect(),
    }
}

/// How far the two faces, or the two halves of a stepped edge, lie inside the outline that is cut.
fn faces_beside(panel: &Panel, edge: usize) -> String {
    let offset = panel.offsets[edge];
    let inside = |face: f64| fixed(offset.cut() - face, 2).unwrap_or_default();
    let (top, bottom) = (inside(offset.top), inside(offset.bottom));
    match panel.edge_cut {
        _ if panel.bevels[edge].is_none() => String::new(),
        Edges::Square => String::new(),
        Edges::Bevelled => format!(", outer face {top} inner face {bottom} inside this outline"),
        Edges::Stepped => format!(", outer half {top} inner half {bottom} inside this outline"),
    }
}

fn plank_job(plank: &Plank, design: &str, hash: &str, (height, least): (f64, f64)) -> CutJob {
    let ends = ["start", "end"];
    let notes = ends.iter().enumerate().map(|(end, name)| {
        let neighbour = towards(plank.neighbours[end].as_ref());
        format!("{name}: mitre {} deg cut by this file{neighbour}", degrees(plank.mitres[end]))
    });
    let engraving = Engraving { height, least_height: least, clearance: CLEAR_OF_BEVELS, mark_edge_0: true };
    CutJob {
        address: plank.label.address.clone(),
        alias: plank.label.alias.clone(),
        design: design.to_owned(),
        design_hash: hash.to_owned(),
        outline: plank.outline.clone(),
        thickness: plank.width,
        engraving,
        face_up: format!("towards {}", direction(plank.plane_normal)),
        notes: notes.collect(),
    }
}

fn towards(neighbour: Option<&String>) -> String {
    neighbour.map_or_else(String::new, |to| format!(", to {to}"))
}

/// An angle in degrees with two decimals, never `-0.00`.
fn degrees(angle: f64) -> String {
    fixed(angle.to_degrees(), 2).unwrap_or_default()
}

/// A direction in words: an axis where it is one, else its three components.
fn direction(normal: DVec3) -> String {
    let axes = [(DVec3::X, "x"), (DVec3::Y, "y"), (DVec3::Z, "z")];
    for (axis, name) in axes {
        if normal.distance(axis) < 1e-9 {
            return format!("+{name}");
        }
        if normal.distance(-axis) < 1e-9 {
            return format!("-{name}");
        }
    }
    format!("{:.4} {:.4} {:.4}", normal.x, normal.y, normal.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The read-back itself is tested with programs that were tampered with; here is what is said then.
    #[test]
    fn a_program_that_its_read_back_refuses() {
        let refused = |alias: &str| Failure {
            code: Code::E0902,
            alias: alias.to_owned(),
            address: format!("{alias}.left"),
            why: "line 7 cuts into the board".to_owned(),
            refusal: None,
        };
        let (first, second) = (refused("rail-00"), refused("rail-01"));
        let found = failed(Code::E0902, &[&first, &second], Span::default(), None).unwrap();
        assert_eq!(found.code, Code::E0902);
        assert_eq!(found.message, "rail-00 (rail-00.left) gets no program: line 7 cuts into the board");
        assert!(found.notes[0].contains("rail-01"), "{:?}", found.notes);
        assert!(failed(Code::E0902, &[], Span::default(), None).is_none());
    }
}
