//! An ifs of the library that is placed on another number of points than it takes: its sibling of another degree,
//! `bezier2` for `bezier3`. Which of them takes that many is the caller's to find, by reading the changed text.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Code, Diagnostic, Edit};
use ifs_compiler::hir::index::Origin;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{Expr, ExprKind, Placement};

use super::Mend;
use crate::features::completion::to_import;
use crate::features::walk::expressions;

/// Each ifs of the same module and name but for the digits, in the place of the one that is placed there.
pub(crate) fn siblings(analysis: &Analysis, found: &Diagnostic) -> Vec<Mend> {
    let placed = (found.code == Code::E0504).then(|| placed(analysis, found.span)).flatten();
    let Some((name, span)) = placed else { return Vec::new() };
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let library = analysis.index.modules.iter().filter(|module| module.library);
    let Some(module) = library
        .filter(|_| stem.len() < name.len())
        .find(|module| module.public.iter().any(|public| public.name == name))
    else {
        return Vec::new();
    };
    let digits = |other: &str| other.strip_prefix(stem).is_some_and(|end| end.parse::<u8>().is_ok());
    let others = module.public.iter().filter(|public| public.name != name && public.ty == Type::Ifs);
    let visible = analysis.index.names(span.file, span.start);
    let mend = |other: &str| {
        let mut edits = vec![Edit { span, replacement: other.to_owned() }];
        let known = |origin: Origin<'_>| !matches!(origin, Origin::Library(_));
        if !visible.iter().any(|visible| visible.name == other && known(visible.origin)) {
            let (at, replacement) = to_import(analysis, span.file, &module.title, other)?;
            edits.insert(0, Edit { span: at, replacement });
        }
        edits.sort_by_key(|edit| edit.span.start);
        let title = format!("place `{other}` there instead of `{name}`");
        Some(Mend { title, edits, preferred: false, safe: false })
    };
    others.filter(|other| digits(&other.name)).filter_map(|other| mend(&other.name)).collect()
}

/// The name of the ifs that is placed on the points that stand there, and where the name stands.
fn placed(analysis: &Analysis, points: Span) -> Option<(String, Span)> {
    let file = analysis.files.iter().find(|file| file.file == points.file)?;
    let mut found = None;
    expressions(&file.parse.ast, |expr| {
        let ExprKind::On(ifs, placement) = &expr.kind else { return };
        let at = match placement {
            Placement::Points(_, span) => *span,
            Placement::Value(value) => value.span,
        };
        let called = match &ifs.kind {
            ExprKind::Call { callee, .. } => callee,
            _ => ifs,
        };
        if let (true, Expr { kind: ExprKind::Name(name), span }) = (at == points, &**called) {
            found = Some((name.clone(), *span));
        }
    });
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    #[test]
    fn the_names_of_other_degrees_with_their_imports() {
        let offered = |text: &str| {
            let design = fixture(text);
            let found =
                design.analysis.diagnostics.iter().flat_map(|found| siblings(&design.analysis, found));
            found.map(|mend| (mend.title, mend.edits.len())).collect::<Vec<_>>()
        };
        let three = "on ((0m, 0m), (3m, 4m), (6m, 0m)) at level 3\n";
        let found = offered(&format!("use std.curves (bezier3, bezier2)\nfigure a = bezier3 {three}"));
        assert!(found.contains(&("place `bezier2` there instead of `bezier3`".to_owned(), 1)), "{found:?}");
        let found = offered(&format!("use std.curves (bspline3)\nfigure a = bspline3 {three}"));
        assert!(found.iter().any(|(title, edits)| title.contains("`bspline2`") && *edits == 2), "{found:?}");
        let own =
            "ifs own3 on (a, b) {\n    transform l = self on (a, (a + b) / 2)\n    germ segment(a, b)\n}\n";
        assert_eq!(offered(&format!("{own}figure a = own3 {three}")), []);
    }
}
