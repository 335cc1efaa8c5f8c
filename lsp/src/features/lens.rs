//! What stands above figures and fabricate blocks: what came out, and commands that an editor's extension offers.

use ifs_compiler::analysis::{Analysis, Elements, Fabrication, value_words};
use ifs_compiler::fabricate::panel::PanelRefusal;
use ifs_compiler::fabricate::plank::PlankRefusal;
use ifs_compiler::geometry::{MeshSummary, QuadMesh};
use ifs_compiler::hir::schema::Measure;
use ifs_compiler::plan::{FigurePlan, Shape};
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::ast;

/// What a lens shows or does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Shows {
    /// Words; a click does nothing.
    Said(String),
    /// Writes the outputs of the design.
    Build,
    /// Shows the report of the design.
    Report,
    /// Shows the outputs of the boards or planks of this figure.
    Preview(String),
}

/// A line above another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Lens {
    pub(crate) span: Span,
    pub(crate) shows: Shows,
}

/// The lenses of a file; `made` is the design as it was worked out last. What is done with the whole design stands above its
/// first fabricate block.
pub(crate) fn lenses(analysis: &Analysis, made: Option<&Analysis>, file: FileId) -> Vec<Lens> {
    let Some(parsed) = analysis.files.iter().find(|parsed| parsed.file == file) else { return Vec::new() };
    let mut found = Vec::new();
    let mut is_first = true;
    for item in &parsed.parse.ast.items {
        match &item.kind {
            ast::ItemKind::Figure(figure) => {
                let said = made.and_then(|made| counted(made, &figure.name.text));
                found.extend(said.map(|said| Lens { span: figure.name.span, shows: Shows::Said(said) }));
            }
            ast::ItemKind::Fabricate(block) => {
                let span = block.figure.span;
                let figure = &block.figure.text;
                let made = made
                    .and_then(|made| made.fabrications.iter().find(|made| made.figure == *figure))
                    .map(|made| Shows::Said(fabricated(made)));
                let whole = if is_first { vec![Shows::Build, Shows::Report] } else { Vec::new() };
                is_first = false;
                let own = (!figure.is_empty()).then(|| Shows::Preview(figure.clone()));
                found.extend(made.into_iter().chain(whole).chain(own).map(|shows| Lens { span, shows }));
            }
            _ => {}
        }
    }
    found
}

/// How many elements and vertices a figure has.
pub(super) fn counted(made: &Analysis, name: &str) -> Option<String> {
    let lowered = made.plan.as_ref()?;
    let counts = lowered.plan.figures().iter().zip(&lowered.counts).filter(|(figure, _)| figure.name == name);
    let (figures, elements, vertices) =
        counts.fold((0u64, 0u64, 0u64), |(figures, elements, vertices), (_, count)| {
            (figures + 1, elements.saturating_add(count.elements), vertices.saturating_add(count.vertices))
        });
    let figures = match figures {
        0 => return None,
        1 => String::new(),
        several => format!("{} figures · ", grouped(several)),
    };
    let elements = plural(elements, "element");
    // How many vertices polygons share is known only when they are drawn.
    let patchwork = |figure: &FigurePlan| figure.name == name && matches!(figure.shape, Shape::Patchwork(_));
    if lowered.plan.figures().iter().any(patchwork) {
        return Some(format!("{figures}{elements}"));
    }
    Some(format!("{figures}{elements} · {} vertices", grouped(vertices)))
}

fn plural(count: u64, one: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{} {one}s", grouped(count)) }
}

/// A count with a narrow space between its thousands.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// The planarity of the least planar quad of some surfaces.
pub(super) fn worst_planarity<'a>(surfaces: impl Iterator<Item = &'a QuadMesh>) -> Option<String> {
    let worst = surfaces.filter_map(|surface| MeshSummary::of(surface).worst);
    let worst = worst.map(|extreme| extreme.value).min_by(f64::total_cmp)?;
    Some(value_words(Measure::Planarity, worst))
}

/// What a block made: `1 024 boards · worst planarity 0.9996 · 2 too long`.
pub(super) fn fabricated(made: &Fabrication) -> String {
    let mut parts = Vec::new();
    let total = made.elements.total() as u64;
    let refused = match &made.elements {
        Elements::Panels(panels) => {
            parts.push(plural(total, "board"));
            let worst = worst_planarity(panels.figures.iter().map(|figure| &figure.built));
            parts.extend(worst.map(|worst| format!("worst planarity {worst}")));
            let large = |reason: &PanelRefusal| matches!(reason, PanelRefusal::TooLarge { .. });
            let large = panels.refused.iter().filter(|refused| large(&refused.reason)).count();
            if large > 0 {
                parts.push(format!("{large} too large"));
            }
            panels.refused.len() - large
        }
        Elements::Planks(planks) => {
            parts.push(plural(total, "plank"));
            let long = |reason: &PlankRefusal| matches!(reason, PlankRefusal::TooLong { .. });
            let long = planks.refused.iter().filter(|refused| long(&refused.reason)).count();
            if long > 0 {
                parts.push(format!("{long} too long"));
            }
            planks.refused.len() - long
        }
    };
    if refused > 0 {
        parts.push(format!("{refused} cannot be made"));
    }
    let failed = made.requirements.iter().filter(|requirement| !requirement.result.holds()).count();
    match (failed, made.requirements.len()) {
        (_, 0) => {}
        (0, 1) => parts.push("its requirement holds".to_owned()),
        (0, all) => parts.push(format!("all {all} requirements hold")),
        (1, 1) => parts.push("its requirement fails".to_owned()),
        (failed, all) => parts.push(format!("{failed} of {all} requirements fail")),
    }
    parts.join(" · ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;
    use crate::features::words::written;

    #[test]
    fn what_came_out_stands_above() {
        let text = "use std.curves (bspline2)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\nlet net = [[(i * 1m, j * 1m, 10mm * i * j) for j in 0..4] for i in 0..4]\nfigure shell = sheet(bspline2, bspline2, net) at level 1\nfabricate shell as panels {\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n    require edge <= 100mm\n}\n";
        let design = fixture(text);
        let shown = |made: Option<&Analysis>| {
            let lenses = lenses(&design.analysis, made, design.analysis.root);
            let shown = lenses.iter().map(|lens| match &lens.shows {
                Shows::Said(said) => format!("{}: {said}", written(&design.analysis, lens.span)),
                shows => format!("{}: {shows:?}", written(&design.analysis, lens.span)),
            });
            shown.collect::<Vec<_>>()
        };
        assert_eq!(shown(None), ["shell: Build", "shell: Report", "shell: Preview(\"shell\")"]);
        let made = design.made();
        let told = shown(Some(&made));
        assert_eq!(told[0], "shell: 16 elements · 25 vertices");
        assert!(told[1].starts_with("shell: 16 boards · worst planarity 0.99"), "{told:?}");
        assert!(told[1].ends_with("its requirement fails"), "{told:?}");
        assert_eq!(grouped(1024), "1\u{202f}024");
        assert_eq!(grouped(1_234_567), "1\u{202f}234\u{202f}567");
    }
}
