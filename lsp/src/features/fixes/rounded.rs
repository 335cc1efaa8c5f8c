//! Pieces that meet only to within rounding: the one gets the very points of the other, written the same way.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{Expr, ExprKind, Ifs, ItemKind, MemberKind, Placement, Space};

use super::apart::{images, piece};
use crate::features::words::written;

/// The points of the first piece at the places of the second where they join; of an ifs whose pieces are one curve, at
/// each place where two pieces meet.
pub(super) fn same_points(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let fix = if found.labels.is_empty() { along(analysis, found) } else { stated(analysis, found) };
    fix.into_iter().collect()
}

/// `join left.far = right.near`: the images of `right` that `near` lies on become those of `left` that `far` lies on.
fn stated(analysis: &Analysis, found: &Diagnostic) -> Option<Fix> {
    let [first, second, ..] = found.labels.as_slice() else { return None };
    let (left, right) = piece(analysis, first.span).zip(piece(analysis, second.span))?;
    let (from, to) = left.ifs.members.iter().find_map(|member| match &member.kind {
        MemberKind::Join(from, to) if member.span == found.span => Some((from, to)),
        _ => None,
    })?;
    let ([_, from], [_, to]) = (from.as_slice(), to.as_slice()) else { return None };
    let from = side(left.ifs, left.images, &from.name.text)?;
    let to = side(right.ifs, right.images, &to.name.text)?;
    if from.len() != to.len() {
        return None;
    }
    let title = format!("put `{}` on the very points of `{}` where they join", right.name, left.name);
    replaced(analysis, title, &from, &to)
}

/// The images that a boundary, or an end of a segment, lies on.
fn side<'a>(ifs: &Ifs, images: &'a [Expr], name: &str) -> Option<Vec<&'a Expr>> {
    let Space::On(points, _) = &ifs.space else { return None };
    if points.len() != images.len() || points.iter().any(|point| point.count.is_some()) {
        return None;
    }
    let on = ifs.members.iter().find_map(|member| match &member.kind {
        MemberKind::Boundary(boundary, on) if boundary.text == name => Some(on),
        _ => None,
    });
    let Some(on) = on else {
        return match name {
            "start" => Some(vec![images.first()?]),
            "end" => Some(vec![images.last()?]),
            _ => None,
        };
    };
    let ExprKind::On(_, Placement::Points(named, _)) = &on.kind else { return None };
    let place = |point: &Expr| match &point.kind {
        ExprKind::Name(name) => points.iter().position(|known| known.name.text == *name),
        _ => None,
    };
    named.iter().map(|point| images.get(place(point)?)).collect()
}

/// In an ifs on control points: each piece starts at the very point where the one before it ends.
fn along(analysis: &Analysis, found: &Diagnostic) -> Option<Fix> {
    let file = analysis.files.iter().find(|file| file.file == found.span.file)?;
    let ifs = file.parse.ast.items.iter().find_map(|item| match &item.kind {
        ItemKind::Ifs(ifs) if ifs.name.span == found.span => Some(ifs),
        _ => None,
    })?;
    let transforms = ifs.members.iter().filter_map(|member| match &member.kind {
        MemberKind::Transform(transform) => Some(transform),
        _ => None,
    });
    let pieces: Vec<&[Expr]> =
        transforms.map(|piece| images(piece).filter(|_| piece.family.is_none())).collect::<Option<_>>()?;
    let ends: Vec<&Expr> = pieces.iter().filter_map(|images| images.last()).collect();
    let starts: Vec<&Expr> = pieces.iter().skip(1).filter_map(|images| images.first()).collect();
    let name = &ifs.name.text;
    let title = format!("let each piece of `{name}` start at the very point where the one before it ends");
    replaced(analysis, title, &ends[..starts.len().min(ends.len())], &starts)
}

/// The words of the ones at the places of the others, where they are not the same yet.
fn replaced(analysis: &Analysis, title: String, from: &[&Expr], to: &[&Expr]) -> Option<Fix> {
    let words = |span: Span| written(analysis, span);
    let differ = from.iter().zip(to).filter(|(from, to)| words(from.span) != words(to.span));
    let fix = differ.fold(Fix::titled(title), |fix, (from, to)| fix.with(to.span, words(from.span)));
    (!fix.edits.is_empty()).then_some(fix)
}
