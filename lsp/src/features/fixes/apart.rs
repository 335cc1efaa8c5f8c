//! Pieces of a curve that do not meet: the last image of the one and the first image of the next get the same point.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{Expr, ExprKind, ItemKind, MemberKind, Placement, Transform};

use crate::features::words::written;

/// Either point in the place of the other.
pub(super) fn joined(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let [first, second, ..] = found.labels.as_slice() else { return Vec::new() };
    let pieces = transform(analysis, first.span).zip(transform(analysis, second.span));
    let Some((left, right)) = pieces else { return Vec::new() };
    let ends = images(left).and_then(<[Expr]>::last).zip(images(right).and_then(<[Expr]>::first));
    let Some((end, start)) = ends else { return Vec::new() };
    let [end_words, start_words] = [end, start].map(|point| written(analysis, point.span).to_owned());
    if end_words == start_words {
        return Vec::new();
    }
    let title = |piece: &Transform, verb: &str, new: &str, old: &str, other: &Transform| {
        let (piece, other) = (&piece.name.text, &other.name.text);
        format!("let `{piece}` {verb} at `{new}` instead of `{old}`, with `{other}`")
    };
    vec![
        Fix::titled(title(right, "start", &end_words, &start_words, left)).with(start.span, &*end_words),
        Fix::titled(title(left, "end", &start_words, &end_words, right)).with(end.span, &*start_words),
    ]
}

/// The transform that a place is in.
fn transform(analysis: &Analysis, at: Span) -> Option<&Transform> {
    let file = analysis.files.iter().find(|file| file.file == at.file)?;
    let members = file.parse.ast.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Ifs(ifs) => Some(&ifs.members),
        _ => None,
    });
    members.flatten().find_map(|member| match &member.kind {
        MemberKind::Transform(transform)
            if member.span.start <= at.start && at.end <= member.span.end && transform.family.is_none() =>
        {
            Some(transform)
        }
        _ => None,
    })
}

/// The points that it places its target on.
fn images(transform: &Transform) -> Option<&[Expr]> {
    match &transform.value.kind {
        ExprKind::On(_, Placement::Points(points, _)) => Some(points.as_slice()),
        _ => None,
    }
}
