//! Pieces of a curve that do not meet: the last image of the one and the first image of the next get the same point.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{Expr, ExprKind, Ifs, ItemKind, MemberKind, Placement, Space, Transform};

use crate::features::words::written;

/// A transform, where it stands and in which ifs.
pub(super) struct Piece<'a> {
    pub(super) ifs: &'a Ifs,
    span: Span,
    pub(super) name: &'a str,
    pub(super) images: &'a [Expr],
}

/// Either point in the place of the other.
pub(super) fn joined(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let [first, second, ..] = found.labels.as_slice() else { return Vec::new() };
    let pieces = piece(analysis, first.span).zip(piece(analysis, second.span));
    let Some((left, right)) = pieces else { return Vec::new() };
    let words = |point: &Expr| written(analysis, point.span);
    let ([left_start, .., end], [start, .., right_end]) = (left.images, right.images) else {
        return Vec::new();
    };
    if words(end) == words(start) {
        return Vec::new();
    }
    if words(left_start) == words(right_end) {
        let title = format!(
            "write `{}` before `{}`: transforms stand in the order of the pieces",
            right.name, left.name
        );
        let [one, two] = [left.span, right.span].map(|span| written(analysis, span).to_owned());
        return vec![Fix::titled(title).with(left.span, two).with(right.span, one)];
    }
    // Where pieces meet is no end of the whole, and a piece has two ends.
    let inner = |point: &str| match &left.ifs.space {
        Space::On(points, _) => {
            [points.first(), points.last()].into_iter().flatten().all(|end| end.name.text != point)
        }
        Space::Plane(_) | Space::Space(_) => true,
    };
    let title = |piece: &str, verb: &str, new: &str, old: &str, other: &str| {
        format!("let `{piece}` {verb} at `{new}` instead of `{old}`, with `{other}`")
    };
    let mut fixes = Vec::new();
    let (at, from) = (words(end), words(start));
    if inner(at) && at != words(right_end) {
        fixes.push(Fix::titled(title(right.name, "start", at, from, left.name)).with(start.span, at));
    }
    if inner(from) && from != words(left_start) {
        fixes.push(Fix::titled(title(left.name, "end", from, at, right.name)).with(end.span, from));
    }
    fixes
}

/// The transform that a place is in, where it puts something on points written out.
pub(super) fn piece(analysis: &Analysis, at: Span) -> Option<Piece<'_>> {
    let file = analysis.files.iter().find(|file| file.file == at.file)?;
    let around = |span: Span| span.start <= at.start && at.end <= span.end;
    let mut members = file.parse.ast.items.iter().flat_map(|item| match &item.kind {
        ItemKind::Ifs(ifs) => ifs.members.iter().map(|member| (ifs, member)).collect(),
        _ => Vec::new(),
    });
    let (ifs, member) = members.find(|(_, member)| around(member.span))?;
    match &member.kind {
        MemberKind::Transform(transform) if transform.family.is_none() => {
            Some(Piece { ifs, span: member.span, name: &transform.name.text, images: images(transform)? })
        }
        _ => None,
    }
}

/// The points that it places its target on.
pub(super) fn images(transform: &Transform) -> Option<&[Expr]> {
    match &transform.value.kind {
        ExprKind::On(_, Placement::Points(points, _)) => Some(points.as_slice()),
        _ => None,
    }
}
