//! What a worked-out design knows of one board or plank, where its address, its alias or its place in a list stands in the
//! text: in a text, in a comment, and as `shell.boards[3]`. In words, as Markdown.

use std::fmt::Display;

use ifs_compiler::analysis::{Analysis, Elements, Fabrication, value_words};
use ifs_compiler::fabricate::label::Label;
use ifs_compiler::fabricate::panel::Panel;
use ifs_compiler::fabricate::plank::Plank;
use ifs_compiler::hir::dimension::Dimension;
use ifs_compiler::hir::evaluate::quantity_words_to;
use ifs_compiler::hir::schema::Measure;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::{Expr, ExprKind};

use super::walk::expressions;

/// The board or plank that a place names, and what is known of it.
pub(super) fn board(
    analysis: &Analysis,
    made: &Analysis,
    file: FileId,
    offset: u32,
) -> Option<(Span, String)> {
    if let Some((span, name)) = word(analysis, file, offset) {
        return Some((span, named(made, name)?));
    }
    let (span, figure, place) = element(analysis, file, offset)?;
    let fabrication = made.fabrications.iter().find(|fabrication| fabrication.figure == figure)?;
    let text = match &fabrication.elements {
        Elements::Panels(panels) => panel(made, fabrication, panels.panels.get(place)?),
        Elements::Planks(planks) => plank(made, fabrication, planks.planks.get(place)?),
    };
    Some((span, text))
}

/// What a text says, or the word of a comment.
fn word(analysis: &Analysis, file: FileId, offset: u32) -> Option<(Span, &str)> {
    let parsed = analysis.files.iter().find(|parsed| parsed.file == file)?;
    let source = analysis.sources.get(file)?;
    let token =
        parsed.parse.tokens.iter().find(|token| token.span.start <= offset && offset < token.span.end)?;
    match token.kind {
        TokenKind::Text => Some((token.span, source.slice(token.span).trim_matches('"'))),
        TokenKind::Comment | TokenKind::ItemDocs | TokenKind::FileDocs => {
            let belongs = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '_');
            let (before, after) =
                source.slice(token.span).split_at_checked((offset - token.span.start) as usize)?;
            let start = before.len() - before.chars().rev().take_while(|c| belongs(*c)).count();
            let end = before.len() + after.chars().take_while(|c| belongs(*c)).count();
            let found = source.slice(token.span)[start..end].trim_end_matches(['.', '-']);
            let start = token.span.start + start as u32;
            Some((Span::new(file, start, start + found.len() as u32), found))
        }
        _ => None,
    }
}

/// The figure and the place of `figure.boards[place]` around a place of the text, where the pointer is behind the name.
fn element(analysis: &Analysis, file: FileId, offset: u32) -> Option<(Span, &str, usize)> {
    let parsed = analysis.files.iter().find(|parsed| parsed.file == file)?;
    let mut found = None;
    expressions(&parsed.parse.ast, |expr: &Expr| {
        let ExprKind::Index(list, places) = &expr.kind else { return };
        let (ExprKind::Field(figure, field), [place]) = (&list.kind, places.as_slice()) else { return };
        let ExprKind::Name(figure) = &figure.kind else { return };
        let inside = list.span.end <= offset && offset < expr.span.end;
        if inside
            && field.text == "boards"
            && let ExprKind::Number { .. } = place.kind
        {
            let digits = analysis.sources.get(file).map_or("", |source| source.slice(place.span));
            found = digits.parse().ok().map(|place| (expr.span, figure.as_str(), place));
        }
    });
    found
}

/// What is known of the board with this address or alias.
fn named(made: &Analysis, name: &str) -> Option<String> {
    let fits = |label: &Label| label.address == name || label.alias == name;
    made.fabrications.iter().find_map(|fabrication| match &fabrication.elements {
        Elements::Panels(panels) => {
            let found = panels.panels.iter().find(|panel| fits(&panel.label));
            let refused = panels.refused.iter().find(|refused| fits(&refused.label));
            found.map(|found| panel(made, fabrication, found)).or_else(|| {
                refused.map(|refused| cannot(fabrication, "board", &refused.label, &refused.reason))
            })
        }
        Elements::Planks(planks) => {
            let found = planks.planks.iter().find(|plank| fits(&plank.label));
            let refused = planks.refused.iter().find(|refused| fits(&refused.label));
            found.map(|found| plank(made, fabrication, found)).or_else(|| {
                refused.map(|refused| cannot(fabrication, "plank", &refused.label, &refused.reason))
            })
        }
    })
}

fn head(fabrication: &Fabrication, what: &str, label: &Label) -> String {
    format!("**{}**: {what} of `{}`, address `{}`", label.alias, fabrication.figure, label.address)
}

fn cannot(fabrication: &Fabrication, what: &str, label: &Label, reason: &impl Display) -> String {
    format!("{}\n\ncannot be made: {reason}", head(fabrication, what, label))
}

fn length(value: f64) -> String {
    quantity_words_to(value, Dimension::LENGTH, 1)
}

fn angle(value: f64) -> String {
    quantity_words_to(value, Dimension::ANGLE, 2)
}

fn mass(value: Option<f64>) -> String {
    value.map_or_else(String::new, |kilograms| format!(", {kilograms:.1}kg"))
}

fn panel(made: &Analysis, fabrication: &Fabrication, panel: &Panel) -> String {
    let size = panel.size();
    let mut lines = vec![
        head(fabrication, "board", &panel.label),
        format!(
            "{} by {}, {} thick{}",
            length(size.x),
            length(size.y),
            length(panel.thickness),
            mass(panel.mass)
        ),
        format!("planarity {}, fold {}", value_words(Measure::Planarity, panel.planarity), angle(panel.fold)),
    ];
    let sides = panel.edges.iter().zip(&panel.bevels).zip(&panel.neighbours).zip(["AB", "BC", "CD", "DA"]);
    lines.extend(sides.map(|(((edge, bevel), neighbour), side)| {
        let bevel = bevel.map_or_else(String::new, |bevel| format!(", bevel {}", angle(bevel)));
        format!(
            "- side {side}: {}{bevel}, {}",
            length(*edge),
            beside(made, neighbour.as_deref(), "on the border")
        )
    }));
    joined(&lines)
}

fn plank(made: &Analysis, fabrication: &Fabrication, plank: &Plank) -> String {
    let mut lines = vec![
        head(fabrication, "plank", &plank.label),
        format!(
            "{} long, {} by {}{}",
            length(plank.length),
            length(plank.depth),
            length(plank.width),
            mass(plank.mass)
        ),
    ];
    let ends = plank.mitres.iter().zip(&plank.neighbours).zip(["start", "end"]);
    lines.extend(ends.map(|((mitre, neighbour), end)| {
        format!("- {end}: mitre {}, {}", angle(*mitre), beside(made, neighbour.as_deref(), "free"))
    }));
    joined(&lines)
}

/// Paragraphs, but for what is a list.
fn joined(lines: &[String]) -> String {
    let mut text = String::new();
    for line in lines {
        let between = if line.starts_with("- ") && text.contains("\n- ") { "\n" } else { "\n\n" };
        text += if text.is_empty() { "" } else { between };
        text += line;
    }
    text
}

/// The neighbour at a side, by its alias.
fn beside(made: &Analysis, address: Option<&str>, none: &str) -> String {
    let Some(address) = address else { return none.to_owned() };
    let all = made.fabrications.iter().flat_map(|fabrication| -> Vec<&Label> {
        match &fabrication.elements {
            Elements::Panels(made) => made.panels.iter().map(|panel| &panel.label).collect(),
            Elements::Planks(made) => made.planks.iter().map(|plank| &plank.label).collect(),
        }
    });
    let known = all.into_iter().find(|label| label.address == address);
    format!("beside `{}`", known.map_or(address, |label| &label.alias))
}

#[cfg(test)]
mod tests {
    use crate::features::fixture::fixture;
    use crate::features::hover::hover;

    fn shown(text: &str) -> Option<String> {
        let design = fixture(text);
        let made = design.made();
        hover(&design.analysis, design.known(Some(&made)), design.analysis.root, design.at)
            .map(|found| found.markdown)
    }

    const SHELL: &str = "use std.curves (bspline2)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\nlet net = [[(i * 1m, j * 1m, 10mm * i * j) for j in 0..4] for i in 0..4]\nfigure shell = sheet(bspline2, bspline2, net) at level 1\nfabricate shell as panels {\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n}\n";

    const ARCH: &str = "use std.curves (bezier2)\nuse std.materials (sawn_spruce)\nfigure arch = bezier2 on ((0m, 0m), (1m, 2m), (2m, 0m)) at level 2\nfabricate arch as planks {\n    material: sawn_spruce\n    section: 100mm by 40mm\n}\n";

    #[test]
    fn an_address_shows_its_board() {
        let by_place =
            shown(&format!("{SHELL}test \"a\" {{ assert shell.boards[0$0].planarity > 0.9 }}\n")).unwrap();
        for part in [
            "board of `shell`, address `shell.",
            "12mm thick, ",
            "planarity 0.99",
            "side AB: ",
            "on the border",
            "beside `shell-",
        ] {
            assert!(by_place.contains(part), "no {part:?} in\n{by_place}");
        }
        // The same by its alias and its address, in a text and in a comment.
        let alias = by_place.split("**").nth(1).unwrap();
        let address = by_place.split("address `").nth(1).unwrap().split('`').next().unwrap();
        for name in [alias, address] {
            let (head, tail) = name.split_at(3);
            let text = shown(&format!("{SHELL}let seam = \"{head}$0{tail}\"\n"));
            assert_eq!(text.as_deref(), Some(by_place.as_str()), "{name}");
            let text = shown(&format!("// 😀 See {head}$0{tail}.\n{SHELL}"));
            assert_eq!(text.as_deref(), Some(by_place.as_str()), "{name}");
        }
        assert_eq!(shown(&format!("// shell-99$0-99 is gone\n{SHELL}")), None);
        assert!(
            shown(&format!("{SHELL}let n = \"shell-$0x\"\n")).is_none_or(|text| !text.contains("board of"))
        );
    }

    #[test]
    fn planks_too() {
        let text = shown(&format!("{ARCH}test \"a\" {{ assert arch.boards[1$0].length > 1mm }}\n")).unwrap();
        for part in ["plank of `arch`", "mm long, 100mm by 40mm", "- start: mitre ", "beside `arch-"] {
            assert!(text.contains(part), "no {part:?} in\n{text}");
        }
        let text = shown(&format!("{ARCH}test \"a\" {{ assert arch.boards[0$0].length > 1mm }}\n")).unwrap();
        assert!(text.contains("- start: mitre 0deg, free") || text.contains(", free\n- end"), "{text}");
        assert!(
            shown(&format!("{ARCH}test \"a\" {{ assert arch.boards[77$0].length > 1mm }}\n"))
                .is_none_or(|text| !text.contains("plank of"))
        );
    }

    #[test]
    fn one_that_cannot_be_made_says_why() {
        let text = ARCH.replace("section: 100mm by 40mm", "section: 100mm by 40mm\n    stock: 300mm");
        let text = shown(&format!("// arch-$0PLACE\n{text}").replace("PLACE", "1"))
            .or_else(|| shown(&format!("// arch-0$01\n{text}")));
        assert!(text.as_ref().is_some_and(|text| text.contains("cannot be made: ")), "{text:?}");
    }
}
