//! What the compiler knows and the text does not say, between its words: types, names of arguments, counts, levels, and what
//! was measured. Each kind is a function of its own.

use ifs_compiler::analysis::{Analysis, Elements, value_words};
use ifs_compiler::hir::evaluate::Overrides;
use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::schema::Measure;
use ifs_compiler::hir::type_names::type_name;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::{FileId, Span};
use ifs_compiler::syntax::ast;

use super::lens::{counted, fabricated, worst_planarity};
use super::sums;
use super::walk::expressions;
use super::words::written;

/// What kind of hint it is, as editors tell them apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Type,
    Parameter,
    Fact,
}

/// A hint behind a byte.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Hint {
    pub(crate) at: u32,
    pub(crate) text: String,
    pub(crate) kind: Kind,
    /// What is written where the hint is taken over.
    pub(crate) insert: Option<String>,
}

/// A design as it was worked out last, maybe before the text changed.
#[derive(Clone, Copy)]
pub(crate) struct Facts<'a> {
    pub(crate) made: &'a Analysis,
    /// Where what stood at a place then stands now.
    pub(crate) now: &'a dyn Fn(Span) -> Option<Span>,
}

/// The hints of a part of a file.
pub(crate) fn hints(
    analysis: &Analysis,
    overrides: &Overrides,
    facts: Option<Facts<'_>>,
    part: Span,
) -> Vec<Hint> {
    let Some(parsed) = analysis.files.iter().find(|parsed| parsed.file == part.file) else {
        return Vec::new();
    };
    let tree = &parsed.parse.ast;
    let mut hints = types(analysis, overrides, tree, part);
    hints.extend(arguments(analysis, tree));
    if let Some(facts) = facts {
        hints.extend(counts(facts.made, tree));
        hints.extend(blocks(facts.made, tree));
        hints.extend(levels(facts, part.file));
        hints.extend(measured(facts, part.file));
    }
    hints.retain(|hint| part.start <= hint.at && hint.at <= part.end);
    hints.sort_by_key(|hint| hint.at);
    hints
}

/// The types of `let` that say none, but for those that are seen at a glance. A sum of control points is a point or a vector
/// by its weights.
fn types(analysis: &Analysis, overrides: &Overrides, tree: &ast::File, part: Span) -> Vec<Hint> {
    let items = tree.items.iter().filter(|item| item.span.start <= part.end && part.start <= item.span.end);
    let hints = items.flat_map(|item| {
        let sums = match &item.kind {
            ast::ItemKind::Ifs(ifs) => sums::of_ifs(analysis, overrides, ifs),
            _ => Vec::new(),
        };
        let lets = lets(item).into_iter().filter(|value| value.ty.is_none() && !is_plain(&value.value));
        lets.filter_map(move |value| {
            let sum = sums.iter().find(|(name, _)| *name == value.name.span);
            let known = &analysis.index.declaration(value.name.span)?.ty;
            type_hint(analysis, value, sum.and_then(|(_, sum)| sum.ty.as_ref()).unwrap_or(known))
        })
    });
    hints.collect()
}

/// The `let` of an item, and those inside of it.
fn lets(item: &ast::Item) -> Vec<&ast::Let> {
    match &item.kind {
        ast::ItemKind::Let(value) => vec![value],
        ast::ItemKind::Ifs(ifs) => {
            let members = ifs.members.iter().filter_map(|member| match &member.kind {
                ast::MemberKind::Let(value) => Some(value),
                _ => None,
            });
            members.collect()
        }
        ast::ItemKind::Test(test) => {
            let steps = test.steps.iter().filter_map(|step| match step {
                ast::TestStep::Let(value) => Some(value),
                _ => None,
            });
            steps.collect()
        }
        _ => Vec::new(),
    }
}

fn type_hint(analysis: &Analysis, value: &ast::Let, ty: &Type) -> Option<Hint> {
    let name = type_name(&analysis.hir.items, ty);
    // What has no name in the language cannot be written.
    let writable = !matches!(
        ty,
        Type::WeightedSum(_)
            | Type::Weighted(_)
            | Type::IntRange
            | Type::Size
            | Type::Choice(_)
            | Type::Settings(_)
            | Type::Material
            | Type::Germ
    ) && !name.contains(['^', ' ', '/']);
    let hint = format!(": {name}");
    (*ty != Type::Error).then(|| Hint {
        at: value.name.span.end,
        insert: writable.then(|| hint.clone()),
        text: hint,
        kind: Kind::Type,
    })
}

/// Whether a value says its type itself: a number, a text, a truth, a record.
fn is_plain(value: &ast::Expr) -> bool {
    match &value.kind {
        ast::ExprKind::Number { .. } | ast::ExprKind::Text(_) | ast::ExprKind::Bool(_) => true,
        ast::ExprKind::Call { callee, .. } => {
            matches!(&callee.kind, ast::ExprKind::Name(name) if name.starts_with(char::is_uppercase))
        }
        _ => false,
    }
}

/// The names of arguments that are given by their place and do not say what they are.
fn arguments(analysis: &Analysis, tree: &ast::File) -> Vec<Hint> {
    let mut hints = Vec::new();
    let named: std::collections::BTreeMap<Span, Target> =
        analysis.index.references.iter().map(|used| (used.span, used.target)).collect();
    expressions(tree, |expr| {
        let ast::ExprKind::Call { callee, arguments } = &expr.kind else { return };
        let Some(target) = named.get(&callee.span) else { return };
        let parameters: Vec<&str> = match target {
            Target::Native(native) => {
                native.declaration().parameters.iter().map(|parameter| parameter.name).collect()
            }
            target => {
                let known = analysis.index.parameters(*target).unwrap_or_default();
                known.iter().map(|parameter| parameter.name.as_str()).collect()
            }
        };
        // One argument says what it is by what is called.
        if parameters.len() < 2 {
            return;
        }
        let by_place = arguments.iter().filter(|argument| argument.name.is_none()).zip(&parameters);
        for (argument, name) in by_place.filter(|(argument, name)| !says(analysis, &argument.value, name)) {
            let text = format!("{name}:");
            let insert = Some(format!("{name}: "));
            hints.push(Hint { at: argument.value.span.start, text, kind: Kind::Parameter, insert });
        }
    });
    hints
}

/// Whether an argument bears the name of its parameter, or the parameter has but a letter.
fn says(analysis: &Analysis, argument: &ast::Expr, name: &str) -> bool {
    let text = written(analysis, argument.span);
    name.len() == 1
        || text == name
        || text.ends_with(&format!(".{name}"))
        || text.ends_with(&format!("_{name}"))
}

/// How many elements each figure has, and the worst planarity it is designed with where boards are made of it.
fn counts(made: &Analysis, tree: &ast::File) -> Vec<Hint> {
    let figures = tree.items.iter().filter_map(|item| match &item.kind {
        ast::ItemKind::Figure(figure) => Some((item, figure)),
        _ => None,
    });
    let hints = figures.filter_map(|(item, figure)| {
        let text = counted(made, &figure.name.text)?;
        let elements = text.split(" · ").find(|part| part.contains("element"))?;
        let text = match designed_planarity(made, &figure.name.text) {
            Some(worst) => format!("{elements} · worst planarity {worst} as designed"),
            None => elements.to_owned(),
        };
        Some(Hint { at: item.span.end, text, kind: Kind::Fact, insert: None })
    });
    hints.collect()
}

/// The worst planarity before anything was planarized; none where it is planar by construction.
fn designed_planarity(made: &Analysis, figure: &str) -> Option<String> {
    let fabrication = made.fabrications.iter().find(|fabrication| fabrication.figure == figure)?;
    let Elements::Panels(panels) = &fabrication.elements else { return None };
    let curved = panels.figures.iter().filter(|figure| !figure.planar);
    worst_planarity(curved.map(|figure| &figure.designed))
}

/// What each fabricate block made, behind the word that says of what kind it is.
fn blocks(made: &Analysis, tree: &ast::File) -> Vec<Hint> {
    let blocks = tree.items.iter().filter_map(|item| match &item.kind {
        ast::ItemKind::Fabricate(block) => Some(block),
        _ => None,
    });
    let hints = blocks.filter_map(|block| {
        let made = made.fabrications.iter().find(|made| made.figure == block.figure.text)?;
        Some(Hint { at: block.kind.span.end, text: fabricated(made), kind: Kind::Fact, insert: None })
    });
    hints.collect()
}

/// The levels that were found by size.
fn levels(facts: Facts<'_>, file: FileId) -> Vec<Hint> {
    let Some(lowered) = &facts.made.plan else { return Vec::new() };
    let found =
        lowered.plan.figures().iter().zip(&lowered.sources).filter(|(_, source)| source.until.is_some());
    let mut hints: Vec<Hint> = Vec::new();
    for (figure, source) in found.filter(|(_, source)| source.level_span.file == file) {
        let words = figure.shape.level_words();
        let Some(now) = (facts.now)(source.level_span).filter(|_| !words.is_empty()) else { continue };
        let (at, text) = (now.end, format!("level {words}"));
        match hints.iter_mut().find(|hint| hint.at == at) {
            // Figures of a list may have found several.
            Some(hint) if hint.text != text => hint.text = "several levels".to_owned(),
            Some(_) => {}
            None => hints.push(Hint { at, text, kind: Kind::Fact, insert: None }),
        }
    }
    hints
}

/// What was measured for each requirement: the value that is nearest to its limit, or beyond it.
fn measured(facts: Facts<'_>, file: FileId) -> Vec<Hint> {
    let all = facts.made.fabrications.iter().flat_map(|fabrication| &fabrication.requirements);
    let own = all.filter(|requirement| requirement.span.file == file);
    let hints = own.filter_map(|requirement| {
        let (least, most) = requirement.result.extremes?;
        let words = |value| value_words(requirement.measure, value);
        let text = match requirement.measure {
            Measure::Planarity => format!("worst {}", words(least)),
            _ if words(least) == words(most) => words(least),
            _ => format!("{} .. {}", words(least), words(most)),
        };
        let now = (facts.now)(requirement.span)?;
        Some(Hint { at: now.end, text, kind: Kind::Fact, insert: None })
    });
    hints.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::{Fixture, fixture};

    /// The text with its hints in `‹…›`.
    fn shown(design: &Fixture, made: bool) -> String {
        let analysis = &design.analysis;
        let text = &analysis.sources.get(analysis.root).unwrap().text;
        let made = made.then(|| design.made());
        let all = hints(
            analysis,
            &Overrides::default(),
            made.as_ref().map(|made| Facts { made, now: &Some }),
            Span::new(analysis.root, 0, text.len() as u32),
        );
        let mut shown = text.clone();
        for hint in all.iter().rev() {
            shown.insert_str(hint.at as usize, &format!("‹{}›", hint.text));
        }
        shown
    }

    #[test]
    fn types_and_arguments() {
        let text = "fn f(width: Length, n: Int, tall: Bool = true) -> Length = width * n\nlet a = 2m\nlet b = a * a\nlet c: Length = f(a, 3, true)\nlet width = f(width: a, n: 2)\nlet d = f(width, 2, tall: false)\nlet e = [sqrt(b)]\nlet broken = ";
        let expected = "fn f(width: Length, n: Int, tall: Bool = true) -> Length = width * n\nlet a = 2m\nlet b‹: Area› = a * a\nlet c: Length = f(‹width:›a, 3, ‹tall:›true)\nlet width‹: Length› = f(width: a, n: 2)\nlet d‹: Length› = f(width, 2, tall: false)\nlet e‹: [Length]› = [sqrt(b)]\nlet broken = ";
        assert_eq!(shown(&fixture(text), false), expected);
    }

    #[test]
    fn sums_of_control_points() {
        let text = "ifs s(t: Number) on (a, b, c) {\n    let m = (a + b) / 2\n    let n = (1 - t) * a + t * b\n    let v = c - a\n    let w = a + c\n    transform l = self on (a, m, n)\n    germ segment(a, c)\n}\n";
        let shown = shown(&fixture(text), false);
        for part in ["let m‹: Point›", "let n‹: Point›", "let v‹: Vector›", "let w‹: weighted sum of points›"]
        {
            assert!(shown.contains(part), "{part} in\n{shown}");
        }
    }

    #[test]
    fn what_was_worked_out() {
        let text = "use std.curves (bezier2)\nfigure arch = bezier2 on ((0m, 0m), (1m, 2m), (2m, 0m)) until edge <= 600mm\nuse std.materials (sawn_spruce)\nfabricate arch as planks {\n    material: sawn_spruce\n    section: 100mm by 40mm\n    require count <= 9\n}\n";
        let shown = shown(&fixture(text), true);
        assert!(
            shown.contains("until edge <= 600mm‹level 3›")
                || shown.contains("until edge <= 600mm‹8 elements›‹level 3›"),
            "{shown}"
        );
        assert!(shown.contains("‹8 elements›"), "{shown}");
        assert!(shown.contains("require count <= 9‹8›"), "{shown}");
        assert!(shown.contains("as planks‹8 planks · its requirement holds› {"), "{shown}");
    }

    #[test]
    fn boards_and_how_flat_they_are() {
        let text = "use std.curves (bspline2)\nuse std.surfaces (sheet)\nuse std.materials (birch_plywood)\nlet net = [[(i * 1m, j * 1m, 100mm * i * j) for j in 0..4] for i in 0..4]\nfigure shell = sheet(bspline2, bspline2, net) at level 1\nfabricate shell as panels {\n    material: birch_plywood(12mm)\n    board: 2500mm by 1250mm\n    planarize: { worst: 1, average: 2, select: 0.9999, step: 0.1mm, move: 50mm, iterations: 400 }\n    require planarity >= 0.999\n}\n";
        let shown = shown(&fixture(text), true);
        let behind = |words: &str| {
            let at =
                shown.find(&format!("{words}‹")).unwrap_or_else(|| panic!("no hint behind {words}: {shown}"));
            shown[at + words.len() + "‹".len()..].split('›').next().unwrap()
        };
        assert!(behind("at level 1").starts_with("16 elements · worst planarity 0.9"), "{shown}");
        assert!(behind("at level 1").ends_with(" as designed"), "{shown}");
        assert!(behind("as panels").starts_with("16 boards · worst planarity 0.99"), "{shown}");
        let worst =
            |hint: &str| hint.split("planarity ").nth(1).unwrap().split(' ').next().unwrap().to_owned();
        assert_ne!(worst(behind("at level 1")), worst(behind("as panels")), "as designed, and as built");
    }
}
