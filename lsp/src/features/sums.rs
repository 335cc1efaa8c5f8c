//! What the `let` of an ifs are: sums of control points, whose weights tell a point from a vector.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::evaluate::{Evaluator, Overrides, SymbolicSum};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast;

/// The sums among the `let` of an ifs of the design, each with where its name stands.
pub(super) fn of_ifs(analysis: &Analysis, overrides: &Overrides, ifs: &ast::Ifs) -> Vec<(Span, SymbolicSum)> {
    let Some((id, _)) = analysis.hir.project_items().find(|(_, item)| item.name_span == ifs.name.span) else {
        return Vec::new();
    };
    let sums = Evaluator::new(&analysis.hir, overrides).symbolic_sums(id);
    let lets = ifs.members.iter().filter_map(|member| match &member.kind {
        ast::MemberKind::Let(value) => Some(value),
        _ => None,
    });
    let named = lets.filter_map(|value| {
        let sum = sums.iter().find(|sum| sum.value == value.value.span)?;
        Some((value.name.span, sum.clone()))
    });
    named.collect()
}

/// The sum that a `let` is whose name stands there.
pub(super) fn named(analysis: &Analysis, overrides: &Overrides, name: Span) -> Option<SymbolicSum> {
    let file = analysis.files.iter().find(|file| file.file == name.file)?;
    let item = file
        .parse
        .ast
        .items
        .iter()
        .find(|item| item.span.start <= name.start && name.end <= item.span.end)?;
    let ast::ItemKind::Ifs(ifs) = &item.kind else { return None };
    of_ifs(analysis, overrides, ifs).into_iter().find(|(span, _)| *span == name).map(|(_, sum)| sum)
}

#[cfg(test)]
mod tests {
    use crate::features::fixture::fixture;
    use crate::features::hover::hover;

    #[test]
    fn a_sum_is_told_by_its_weights() {
        for (value, said) in [
            ("(a + b) / 2", "let m: Point\n```\n---\nweights `1/2 a + 1/2 b`"),
            ("b - a", "let m: Vector\n```\n---\nweights `-a + b`"),
            ("lerp(a, b, t)", "let m: Point\n```\n---\nweights `(1 - t) a + t b`"),
            ("a + b", "let m: weighted sum of points\n```\n---\nweights `a + b`"),
        ] {
            let text =
                format!("ifs s(t: Number) on (a, b) {{\n    let m$0 = {value}\n    germ segment(a, b)\n}}\n");
            let design = fixture(&text);
            let found = hover(&design.analysis, design.known(None), design.analysis.root, design.at).unwrap();
            assert!(found.markdown.contains(said), "{}", found.markdown);
        }
    }
}
