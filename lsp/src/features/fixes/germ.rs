//! The germ of an ifs: one where it has none, one where it has two.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{ItemKind, MemberKind, Space};

use crate::features::words::written;

/// The segment between the first and the last control point, where the ifs draws nothing.
pub(super) fn added(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let file = analysis.files.iter().find(|file| file.file == found.span.file);
    let mut items = file.into_iter().flat_map(|file| &file.parse.ast.items);
    let ifs = items.find_map(|item| match &item.kind {
        ItemKind::Ifs(ifs) if ifs.name.span == found.span => Some(ifs),
        _ => None,
    });
    let Some(ifs) = ifs else { return Vec::new() };
    let draws = |kind: &MemberKind| matches!(kind, MemberKind::Germ(_) | MemberKind::Error);
    let last = ifs.members.last().filter(|_| !ifs.members.iter().any(|member| draws(&member.kind)));
    let (Some(last), Space::On(points, _)) = (last, &ifs.space) else { return Vec::new() };
    let ([first, .., end], true) = (points.as_slice(), points.iter().all(|point| point.count.is_none()))
    else {
        return Vec::new();
    };
    let germ = format!("germ segment({}, {})", first.name.text, end.name.text);
    let at = Span::new(last.span.file, last.span.end, last.span.end);
    vec![Fix::titled(format!("add `{germ}`")).with(at, format!("\n    {germ}"))]
}

/// The second germ out.
pub(super) fn second(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let file = analysis.files.iter().find(|file| file.file == found.span.file);
    let ifs = file.into_iter().flat_map(|file| &file.parse.ast.items).filter_map(|item| match &item.kind {
        ItemKind::Ifs(ifs) => Some(ifs),
        _ => None,
    });
    let mut members = ifs.flat_map(|ifs| &ifs.members);
    let germ =
        members.find(|member| matches!(&member.kind, MemberKind::Germ(germ) if germ.span == found.span));
    let Some(germ) = germ else { return Vec::new() };
    vec![Fix::titled(format!("remove the second, `{}`", written(analysis, germ.span))).with(germ.span, "")]
}
