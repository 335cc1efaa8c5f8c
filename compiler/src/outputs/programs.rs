//! NC programs: one for each board and plank of a block with a machine, read back before it is given out.

use super::parts::program_path;
use super::{Output, design_hash};
use crate::analysis::{Analysis, Elements, Fabrication, field, number, text};
use crate::diagnostic::{Code, Diagnostic};
use crate::export::nc;
use crate::export::number::fixed;
use crate::fabricate::cut_job::{CutJob, Engraving};
use crate::fabricate::machine::{CutDirection, Dialect, Machine, MachineSpec, Tool, WorkOffset, ZZero};
use crate::fabricate::panel::{Edges, Panel};
use crate::fabricate::plank::Plank;
use crate::fabricate::toolpath::program;
use crate::hir::tree::Hir;
use crate::hir::value::Value;
use crate::readback::{Expected, read_back};
use crate::source::Span;
use glam::DVec3;

/// Room between the deepest bevel and the engraving, mm.
const CLEAR_OF_BEVELS: f64 = 1.0;

/// How many boards that cannot be cut are named.
const NAMED: usize = 5;

/// The programs of every block, or what speaks against them.
pub(super) fn programs(analysis: &Analysis) -> (Vec<Output>, Vec<Diagnostic>) {
    let mut outputs = Vec::new();
    let mut diagnostics = Vec::new();
    let hash = design_hash(analysis);
    for made in &analysis.fabrications {
        let Some((_, value, span)) = made.settings.iter().find(|(name, _, _)| *name == "machine") else {
            continue;
        };
        match machine(&analysis.hir, value, *span) {
            Ok(machine) => block(analysis, made, &machine, *span, &hash, &mut outputs, &mut diagnostics),
            Err(diagnostic) => diagnostics.push(diagnostic),
        }
    }
    (outputs, diagnostics)
}

/// A board that gets no program, and why.
struct Failure {
    code: Code,
    alias: String,
    address: String,
    why: String,
}

fn block(
    analysis: &Analysis,
    made: &Fabrication,
    machine: &Machine,
    span: Span,
    hash: &str,
    outputs: &mut Vec<Output>,
    diagnostics: &mut Vec<Diagnostic>,
) {
    let mut failures: Vec<Failure> = Vec::new();
    for job in jobs(analysis, made, hash) {
        match one(&job, machine) {
            Ok(text) => {
                let mut output = Output::new(&program_path(&job.address), "program", text);
                output.address = Some(job.address);
                outputs.push(output);
            }
            Err((code, why)) => failures.push(Failure { code, alias: job.alias, address: job.address, why }),
        }
    }
    for code in [Code::E0901, Code::E0902] {
        let group: Vec<&Failure> = failures.iter().filter(|failure| failure.code == code).collect();
        diagnostics.extend(failed(code, &group, span));
    }
}

fn failed(code: Code, failures: &[&Failure], span: Span) -> Option<Diagnostic> {
    let first = failures.first()?;
    let message = format!("{} ({}) gets no program: {}", first.alias, first.address, first.why);
    let mut diagnostic = Diagnostic::new(code, span, message).label("cannot be cut by this machine");
    if failures.len() > 1 {
        let others: Vec<&str> =
            failures[1..].iter().take(NAMED).map(|failure| failure.alias.as_str()).collect();
        let more = if failures.len() > NAMED + 1 { ", …" } else { "" };
        diagnostic = diagnostic.note(format!("and {} more: {}{more}", failures.len() - 1, others.join(", ")));
    }
    Some(match code {
        Code::E0901 => {
            diagnostic.hint("use another tool, a smaller address or larger boards; nothing was written")
        }
        _ => diagnostic.note("the program was read back and does not cut the board; nothing was written"),
    })
}

/// The text of a program that has been read back.
fn one(job: &CutJob, machine: &Machine) -> Result<String, (Code, String)> {
    let program = program(job, machine).map_err(|refusal| (Code::E0901, refusal.to_string()))?;
    let text = nc::write(&program, machine);
    let expected = Expected::new(job, machine);
    match read_back(&text, &expected) {
        Ok(_) => Ok(text),
        Err(faults) => {
            let why = faults.first().map_or_else(String::new, ToString::to_string);
            Err((Code::E0902, why))
        }
    }
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
fn engraving(hir: &Hir, made: &Fabrication) -> (f64, f64) {
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

/// The machine of a record of the library's type `Machine`.
fn machine(hir: &Hir, value: &Value, span: Span) -> Result<Machine, Diagnostic> {
    let incomplete =
        || Diagnostic::new(Code::E0804, span, "this machine is not complete").label("a field is missing");
    let get = |name: &str| number(hir, value, name).ok_or_else(incomplete);
    let tool = |name: &str| field(hir, value, name).and_then(|value| tool(hir, value)).ok_or_else(incomplete);
    let (cutter, engraver) = (tool("cutter")?, tool("engraver")?);
    let spec = MachineSpec {
        name: text(hir, value, "name").ok_or_else(incomplete)?,
        envelope: DVec3::new(get("length")?, get("width")?, get("height")?),
        safe_height: get("safe_height")?,
        z_zero: ZZero::TopOfStock,
        work_offset: WorkOffset::G54,
        stock_margin: get("margin")?,
        cut_through: get("cut_through")?,
        engrave_depth: get("engrave_depth")?,
        spindle_range: (get("least_spindle")?, get("most_spindle")?),
        spin_up: get("spin_up")?,
        direction: CutDirection::Climb,
        dialect: Dialect::LinuxCnc,
        cutter: cutter.number,
        engraver: engraver.number,
        tools: vec![cutter, engraver],
    };
    Machine::try_new(spec).map_err(|error| {
        let message = format!("this machine cannot work: {error}");
        Diagnostic::new(Code::E0804, span, message).label("this machine")
    })
}

fn tool(hir: &Hir, value: &Value) -> Option<Tool> {
    let get = |name: &str| number(hir, value, name);
    Some(Tool {
        number: get("number")? as u32,
        name: text(hir, value, "name")?,
        diameter: get("diameter")?,
        flute_length: get("flute")?,
        feed: get("feed")?,
        plunge: get("plunge")?,
        spindle: get("spindle")?,
        max_step_down: get("step_down")?,
    })
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
        };
        let (first, second) = (refused("rail-00"), refused("rail-01"));
        let found = failed(Code::E0902, &[&first, &second], Span::default()).unwrap();
        assert_eq!(found.code, Code::E0902);
        assert_eq!(found.message, "rail-00 (rail-00.left) gets no program: line 7 cuts into the board");
        assert!(found.notes[0].contains("rail-01"), "{:?}", found.notes);
        assert!(failed(Code::E0902, &[], Span::default()).is_none());
    }
}
