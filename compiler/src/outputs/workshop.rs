//! What the machines of a design cannot cut, found without writing a program: what is said of a design before it is built.
//! Nests, and programs read back, come with the build.

use super::Selection;
use super::failures::{Failure, failed};
use super::programs::{Block, blocks, refusal_of};
use super::refits::refit;
use crate::analysis::{Analysis, Elements, Nest, Programs, Watch};
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::panel::{Grain, Panel};
use crate::fabricate::toolpath::Refusal;
use crate::hir::dimension::Dimension;
use crate::hir::evaluate::quantity_words_to;
use glam::DVec2;

/// E0804 for machines whose figures are out of range, and E0901 for the boards that cannot be cut, of a design without
/// errors; nothing where whoever watches says stop.
pub fn workshop_faults(analysis: &Analysis, watch: &mut dyn Watch) -> Vec<Diagnostic> {
    if analysis.has_errors() {
        return Vec::new();
    }
    let (blocks, mut diagnostics) = blocks(analysis, &Selection::all());
    diagnostics.extend(blocks.iter().filter_map(small_boards_of));
    for block in &blocks {
        let Some((_, span)) = &block.machine else { continue };
        let machines = block.machines();
        let mut failures: Vec<Failure> = Vec::new();
        for (_, job) in block.jobs() {
            if watch.step().is_break() {
                return Vec::new();
            }
            failures.extend(refusal_of(job, &machines).map(|refusal| Failure::refused(job, refusal)));
        }
        let group: Vec<&Failure> = failures.iter().collect();
        let refusals: Vec<&Refusal> = group.iter().filter_map(|one| one.refusal.as_ref()).collect();
        let fix = refit(analysis, block.made, &refusals);
        diagnostics.extend(failed(Code::E0901, &group, *span, fix));
    }
    diagnostics
}

/// What the blocks of a design warn of.
pub(super) fn small_boards(analysis: &Analysis) -> Vec<Diagnostic> {
    let (blocks, _) = blocks(analysis, &Selection::all());
    blocks.iter().filter_map(small_boards_of).collect()
}

/// W0903: boards whose own programs ask for a larger piece than the raw board: a margin for the cutter goes around each.
fn small_boards_of(block: &Block<'_>) -> Option<Diagnostic> {
    let ((machine, span), Elements::Panels(made)) = (block.machine.as_ref()?, &block.made.elements) else {
        return None;
    };
    if matches!(block.made.nest, Some(Nest::Sheets(_, Programs::Sheets))) {
        return None;
    }
    let (length, width) = made.settings.board;
    let margin = machine.border();
    let needed = |panel: &&Panel| panel.size() + 2.0 * margin;
    let fits = |size: DVec2| {
        let turned = made.settings.grain == Grain::Free && size.y <= length && size.x <= width;
        turned || (size.x <= length && size.y <= width)
    };
    let large: Vec<&Panel> = made.panels.iter().filter(|panel| !fits(needed(panel))).collect();
    let first = *large.first()?;
    let mm = |value: f64| quantity_words_to(value, Dimension::LENGTH, 1);
    let piece = needed(&first);
    let message = format!(
        "the program of {} asks for a piece of {} by {}, and the raw board has {} by {}",
        first.label.alias,
        mm(piece.x),
        mm(piece.y),
        mm(length),
        mm(width)
    );
    let of = large.len();
    let sizes = large.iter().map(needed).fold(DVec2::ZERO, DVec2::max);
    let hint = format!(
        "the cutter needs {} around a board: raw boards of {} by {} would do, or smaller elements",
        mm(margin),
        mm(sizes.x.ceil()),
        mm(sizes.y.ceil())
    );
    let label = if of == 1 { "for one board".to_owned() } else { format!("for {of} boards") };
    Some(Diagnostic::new(Code::W0903, *span, message).label(label).hint(hint))
}
