//! NC programs of nested sheets: one for each, all its boards engraved and then cut, read back before it is given out.

use super::nests::{Nests, SheetNest};
use super::programs::{Block, extension, written};
use super::sheets::sheet_path;
use super::{Making, Output};
use crate::analysis::Programs;
use crate::diagnostic::{Code, Diagnostic};
use crate::export::nc::NcFile;
use crate::fabricate::cut_job::{Placed, Rotation, Sheet};
use crate::fabricate::toolpath::{PartRefusal, Refusal, sheet};
use crate::readback::Expected;
use crate::source::Span;
use glam::DVec2;

/// Quarter turns anticlockwise.
const ROTATIONS: [Rotation; 4] = [Rotation::None, Rotation::Quarter, Rotation::Half, Rotation::ThreeQuarters];

/// How many sheets that cannot be cut are named.
const NAMED: usize = 5;

/// The programs of all sheets that are wanted whole and whose machine is known, or what speaks against them; `before` is
/// how many programs there are already.
pub(super) fn programs(
    blocks: &[Block<'_>],
    nests: &Nests,
    before: usize,
    watch: &mut dyn FnMut(Making),
) -> (Vec<Output>, Vec<Diagnostic>) {
    let (mut outputs, mut diagnostics) = (Vec::new(), Vec::new());
    for nest in nests.sheets.iter().filter(|nest| nest.programs != Programs::Boards) {
        let mut failures = Vec::new();
        let wanted: Vec<(usize, &String)> =
            nest.names.iter().enumerate().filter(|(place, _)| is_wanted(blocks, nest, *place)).collect();
        for (done, &(place, name)) in wanted.iter().enumerate() {
            watch(Making::Sheets { done, of: wanted.len() });
            let number =
                u32::try_from(before + outputs.len()).map_or(u32::MAX, |last| last.saturating_add(1));
            match one(blocks, nest, place, number) {
                Ok(files) => outputs.extend(files.into_iter().map(|file| {
                    let path = sheet_path(name, &extension(&file));
                    Output::new(&path, "program", file.text)
                })),
                Err(refused) => failures.push((name.as_str(), refused)),
            }
        }
        for code in [Code::E0935, Code::E0936] {
            let group: Vec<_> = failures.iter().filter(|(_, refused)| refused.code == code).collect();
            diagnostics.extend(failed(code, &group, nest.span));
        }
    }
    (outputs, diagnostics)
}

/// Whether all boards of a sheet are wanted: its program and its drawing are of all of them.
pub(super) fn is_wanted(blocks: &[Block<'_>], nest: &SheetNest, place: usize) -> bool {
    let mut here = nest.nested.placements.iter().filter(|placement| placement.sheet == place);
    here.all(|placement| {
        let (block, board) = nest.named[placement.part].place;
        blocks.get(block).is_some_and(|block| block.wants(board))
    })
}

/// The boards of a sheet as they lie, in their order.
pub(super) fn laid_out<'a>(blocks: &'a [Block<'_>], nest: &SheetNest, place: usize) -> Sheet<'a> {
    let here = nest.nested.placements.iter().filter(|placement| placement.sheet == place);
    let parts = here.filter_map(|placement| {
        let (block, board) = nest.named[placement.part].place;
        let job = blocks.get(block)?.job(board)?;
        let rotation = ROTATIONS[usize::from(placement.quarter_turns % 4)];
        let lying = job.outline.iter().map(|&corner| rotation.turn(corner));
        let low = lying.fold(DVec2::INFINITY, DVec2::min) + placement.at;
        Some(Placed { job, rotation, low })
    });
    Sheet {
        name: nest.names[place].clone(),
        number: 1,
        stock: DVec2::new(nest.sheet.length, nest.sheet.width),
        parts: parts.collect(),
    }
}

/// The block whose machine cuts the boards of a nest: they all have the same.
pub(super) fn block_of<'a, 'b>(blocks: &'a [Block<'b>], nest: &SheetNest) -> Option<&'a Block<'b>> {
    blocks.get(nest.named.first()?.place.0)
}

/// Why a sheet gets no program, and what would mend it.
struct NoProgram {
    code: Code,
    why: String,
    remedy: Option<String>,
}

/// The files of a sheet's program that has been read back, on the first of the machines that can; none without machine.
fn one(blocks: &[Block<'_>], nest: &SheetNest, place: usize, number: u32) -> Result<Vec<NcFile>, NoProgram> {
    let machines = block_of(blocks, nest).map(Block::machines).unwrap_or_default();
    let sheet_of_many = Sheet { number, ..laid_out(blocks, nest, place) };
    let mut refused: Option<PartRefusal> = None;
    for machine in machines {
        match sheet(&sheet_of_many, machine) {
            Ok(program) => {
                let expected = Expected::of_sheet(&sheet_of_many, machine);
                let refused = |why| NoProgram { code: Code::E0936, why, remedy: None };
                return written(&program, machine, &expected).map_err(refused);
            }
            Err(error) => {
                refused.get_or_insert(error);
            }
        }
    }
    let Some(refused) = refused else { return Ok(Vec::new()) };
    let why = said(&refused, &sheet_of_many);
    Err(NoProgram { code: Code::E0935, why, remedy: remedy(&refused.refusal) })
}

/// The refusal with the names of the boards it is about.
fn said(refused: &PartRefusal, sheet: &Sheet<'_>) -> String {
    let alias = |part: usize| sheet.parts.get(part).map_or("?", |placed| placed.job.alias.as_str());
    match refused.refusal {
        Refusal::PartCount { .. } => refused.refusal.to_string(),
        Refusal::PartsTooClose { other, gap, needed } => format!(
            "{} lies {gap:.3} mm from {}, the cutter needs {needed:.3} mm",
            alias(refused.part),
            alias(other)
        ),
        Refusal::Clamped { .. } => refused.refusal.to_string(),
        ref refusal => format!("{}: {refusal}", alias(refused.part)),
    }
}

fn remedy(refusal: &Refusal) -> Option<String> {
    match refusal {
        Refusal::Envelope { axis, needed, .. } => Some(format!(
            "use a machine with at least {needed:.0} mm of travel in {axis}, a smaller `board` or a smaller `margin`"
        )),
        Refusal::PartCount { .. } => Some("use a smaller `board`".to_owned()),
        Refusal::Clamped { .. } => {
            Some("move the clamp, or keep boards clear of it with a larger `margin` of the nest".to_owned())
        }
        other => other.remedy(),
    }
}

fn failed(code: Code, failures: &[&(&str, NoProgram)], span: Span) -> Option<Diagnostic> {
    let (name, first) = failures.first()?;
    let message = format!("sheet {name} gets no program: {}", first.why);
    let mut diagnostic = Diagnostic::new(code, span, message).label("nested here");
    if failures.len() > 1 {
        let others: Vec<&str> = failures[1..].iter().take(NAMED).map(|(name, _)| *name).collect();
        let more = if failures.len() > NAMED + 1 { ", …" } else { "" };
        let note = format!("and {} more: {}{more}", failures.len() - 1, others.join(", "));
        diagnostic = diagnostic.note(note);
    }
    let boards = "or let each board have its own program alone: `nest: { programs: boards }`";
    Some(match (code, &first.remedy) {
        (Code::E0935, Some(remedy)) => diagnostic.hint(format!("{remedy}; {boards}; nothing was written")),
        (Code::E0935, None) => diagnostic.hint(format!("change its boards, {boards}; nothing was written")),
        _ => diagnostic
            .note("the program was read back and does not cut the sheet; nothing was written")
            .hint("write `nest: { programs: boards }`, and please report this"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The read-back itself is tested with programs that were tampered with; here is what is said then.
    #[test]
    fn a_sheet_that_its_read_back_refuses() {
        let refused =
            || NoProgram { code: Code::E0936, why: "line 7 cuts into the board".to_owned(), remedy: None };
        let (first, second) = (("1", refused()), ("2", refused()));
        let found = failed(Code::E0936, &[&first, &second], Span::default()).unwrap();
        assert_eq!(found.code, Code::E0936);
        assert_eq!(found.message, "sheet 1 gets no program: line 7 cuts into the board");
        assert!(found.notes[0].contains("and 1 more: 2"), "{:?}", found.notes);
        assert!(failed(Code::E0936, &[], Span::default()).is_none());
    }
}
