//! What is known of a name beyond its type: values of parameters and of `let`, counts, levels, sizes and planarity of figures. In words,
//! as Markdown. Of an ifs and its transforms speaks `states`.

use ifs_compiler::analysis::{Analysis, Elements};
use ifs_compiler::hir::evaluate::{Evaluator, Overrides, value_words};
use ifs_compiler::hir::tree::{ItemId, ItemKind};
use ifs_compiler::ifs::Automaton;
use ifs_compiler::plan::size::SizeRange;
use ifs_compiler::plan::{FigurePlan, Shape};

use super::{sizes, states};

/// A design as it was worked out, and what it is worked out with.
#[derive(Clone, Copy)]
pub(crate) struct WorkedOut<'a> {
    /// The last time that it had no errors.
    pub(crate) made: Option<&'a Analysis>,
    /// Whether that is of the text as it is now.
    pub(crate) current: bool,
    /// What is set from outside.
    pub(crate) overrides: &'a Overrides,
}

impl WorkedOut<'_> {
    /// These words, with a line before them where they are of a text that has changed since.
    pub(super) fn dated(self, words: String) -> String {
        if self.current { words } else { format!("*before the last changes:*\n\n{words}") }
    }
}

/// The value of a parameter or of a `let`, what was made of a figure, how much an ifs contracts.
pub(super) fn of_item(analysis: &Analysis, known: WorkedOut<'_>, id: ItemId) -> Option<String> {
    let item = analysis.hir.item(id);
    if let ItemKind::Ifs(_) = item.kind {
        return states::of_ifs(analysis, known, id);
    }
    if let ItemKind::Figure(_) = item.kind {
        return Some(known.dated(of_figure(known.made?, &item.name)?));
    }
    let value = Evaluator::new(&analysis.hir, known.overrides).global(id).ok()?;
    let ty = &analysis.index.declaration(item.name_span)?.ty;
    Some(format!("value `{}`", value_words(&analysis.hir.items, &value, ty)?))
}

fn count(number: u64, one: &str, several: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { several })
}

/// Whether a figure is a curve, a surface or of separate pieces, and why.
fn kind(automaton: &Automaton, figure: &FigurePlan) -> String {
    match &figure.shape {
        Shape::Curve { state, .. } => states::kind(automaton, *state),
        Shape::Pieces(pieces) => states::kind(automaton, pieces.state),
        Shape::Patchwork(patchwork) => states::kind(automaton, patchwork.state),
        shape if shape.is_curve() => "a `Curve`".to_owned(),
        _ => "a `Surface`".to_owned(),
    }
}

fn of_figure(made: &Analysis, name: &str) -> Option<String> {
    let lowered = made.plan.as_ref()?;
    let counted = lowered.plan.figures().iter().zip(&lowered.counts);
    let figures: Vec<_> = counted.filter(|(figure, _)| figure.name == name).collect();
    let (first, _) = figures.first()?;
    let elements: u64 = figures.iter().map(|(_, count)| count.elements).sum();
    let vertices: u64 = figures.iter().map(|(_, count)| count.vertices).sum();
    let mut counted = count(elements, "element", "elements");
    // How many vertices polygons share is known only when they are drawn.
    if !figures.iter().any(|(figure, _)| matches!(figure.shape, Shape::Patchwork(_))) {
        counted += &format!(", {}", count(vertices, "vertex", "vertices"));
    }
    let mut text = match figures.len() {
        1 => format!("{counted} at level {}", first.shape.level_words()),
        several => format!("{several} figures, {counted}"),
    };
    if figures.iter().all(|(figure, _)| figure.shape.planar_by_construction()) {
        text += ", planar by construction";
    }
    text += &format!("\n\n{}", kind(lowered.plan.automaton(), first));
    if let Some(sizes) = sizes::of_figures(lowered, name) {
        text += &format!("\n\n{sizes}");
    }
    for fabrication in made.fabrications.iter().filter(|fabrication| fabrication.figure == name) {
        text += "\n\n";
        text += &match &fabrication.elements {
            Elements::Panels(made) => {
                let built = made.figures.iter().map(|figure| &figure.built);
                let boards = count(made.panels.len() as u64, "board", "boards");
                format!("{boards}{}", sizes::of_surfaces(built))
            }
            Elements::Planks(made) => {
                let lengths = made.planks.iter().map(|plank| SizeRange::one(plank.length));
                let lengths = lengths.reduce(SizeRange::with);
                let words = lengths.map_or_else(String::new, |SizeRange { least, most }| {
                    format!(", {} long", sizes::range(least, most))
                });
                format!("{}{words}", count(made.planks.len() as u64, "plank", "planks"))
            }
        };
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use crate::features::fixture::fixture;
    use crate::features::hover::hover;

    fn shown(text: &str) -> String {
        let design = fixture(text);
        let made = design.made();
        hover(&design.analysis, design.known(Some(&made)), design.analysis.root, design.at)
            .map_or(String::new(), |found| found.markdown)
    }

    #[test]
    fn what_was_made_of_a_name() {
        let curve = "ifs halves on (a, b) {\n    let m = lerp(a, b, 1/4)\n    transform left = self on (a, m)\n    transform right = self on (m, b)\n    germ segment(a, b)\n}\nfigure li$0ne = halves on ((0m, 0m), (4m, 2m)) at level 3\n";
        let text = shown(curve);
        let parts = "8 elements, 9 vertices at level 3\n\na `Curve`: its pieces meet\n\n4000mm by 2000mm by 0mm, segments 69.9mm .. 1886.7mm, 4472.1mm in all";
        assert!(text.contains(parts), "{text}");
        let text = shown("param w$0idth: Length = 2m in 1m .. 3m\n");
        assert!(text.contains("value `2000mm`"), "{text}");
    }

    #[test]
    fn a_figure_that_is_no_curve_says_which_joint_is_open() {
        let dust = "ifs dust on (a, b) {\n    transform left = self on (a, lerp(a, b, 1/3))\n    transform right = self on (lerp(a, b, 2/3), b)\n    germ segment(a, b)\n}\nfigure li$0ne = dust on ((0m, 0m), (3m, 0m)) at level 2\n";
        let text = shown(dust);
        let parts = "a `Figure` of separate pieces: the pieces of `dust` do not meet: `left` does not end where `right` starts; at level 1 these lie at 2/3 a + 1/3 b and at 1/3 a + 2/3 b, 1/3 a - 1/3 b apart";
        assert!(text.contains(parts), "{text}");
    }

    #[test]
    fn quads_that_share_edges_are_a_surface() {
        let tile = "ifs tile on (a, b, c, d) {\n    let m = lerp(a, b, 1/2)\n    let n = lerp(d, c, 1/2)\n    transform left = self on (a, m, n, d)\n    transform right = self on (m, b, c, n)\n    germ quad(a, b, c, d)\n}\nfigure ro$0of = tile on ((0m, 0m), (1m, 0m), (1m, 1m), (0m, 1m)) at level 2\n";
        let text = shown(tile);
        assert!(
            text.contains("4 elements at level 2\n\na `Surface`: its pieces share their edges\n\n1000mm"),
            "{text}"
        );
        let text = shown(&tile.replace("germ", "keep segment(a, b)\n    germ"));
        assert!(
            text.contains("a `Figure` of separate pieces: `tile` is no surface: `tile` keeps what it draws"),
            "{text}"
        );
    }

    #[test]
    fn values_of_names() {
        for (text, value) in [
            ("let a = 27mm\nlet ha$0lf = a / 2\n", "13.5mm"),
            ("let li$0st = [i * 2 for i in 0..3]\nlet wrong = 2m +", "[0, 2, 4]"),
            ("let pla$0ce = (1m, 0m, -2mm)\n", "(1000mm, 0mm, -2mm)"),
            ("let in$0v = 1 / 2m\n", "0.0005"),
            ("let tw$0elfth = 1 / 12m\n", "0.0000833"),
            ("let th$0in = 0.0004mm\n", "0.0004mm"),
            ("let tur$0n = -0.00025deg\n", "-0.00025deg"),
            ("let tex$0t = \"a\"\n", "\"a\""),
            (
                "record Foot {\n    width: Length\n    holes: Int = 4\n}\nlet fo$0ot = Foot(width: 90mm)\n",
                "Foot(width: 90mm, holes: 4)",
            ),
            (
                "use std.materials (sawn_spruce)\nlet spru$0ce = sawn_spruce\n",
                "Timber(name: \"sawn spruce\", density: 450kg/m3)",
            ),
        ] {
            let found = shown(text);
            assert!(found.contains(&format!("value `{value}`")), "{found}");
        }
        let found = shown("use std.curves (bezier3)\nlet cur$0ve = bezier3\n");
        assert!(!found.contains("value"), "{found}");
    }

    #[test]
    fn fields_of_the_library_tell_what_they_mean() {
        let roof = "use std.curves (line)\nuse std.surfaces (tensor)\nuse std.materials (birch_plywood)\nfigure roof = tensor(line, line) on [[(0m, 0m, 0m), (0m, 1m, 0m)], [(1m, 0m, 0m), (1m, 1m, 0m)]] at level 0\nfabricate roof as panels {\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n}\ntest \"ring\" {\n    assert max(roof.boards.ri$0ng) == 0\n}\n";
        let text = shown(roof);
        assert!(text.contains("field of `Board`\n\n---\nThe ring it is put up in"), "{text}");
    }

    #[test]
    fn what_was_made_before_a_change_is_told_as_that() {
        let design =
            fixture("use std.curves (line)\nfigure ro$0d = line on ((0m, 0m), (4m, 2m)) at level 3\n");
        let made = design.made();
        let mut known = design.known(Some(&made));
        known.current = false;
        let text = hover(&design.analysis, known, design.analysis.root, design.at).unwrap().markdown;
        assert!(text.contains("*before the last changes:*\n\n8 elements"), "{text}");
    }
}
