//! The paths of a join: a boundary of the ifs around, or one of what a transform of it continues with.

use ifs_compiler::hir::index::{DeclarationKind, Target};
use ifs_compiler::hir::tree::ItemId;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::TokenKind;
use ifs_compiler::syntax::ast::{Expr, ExprKind, ItemKind, Member, MemberKind};

use super::{Kind, Known, Offer};

/// Transforms, each with a boundary, and the boundaries of the ifs around.
pub(super) fn paths(known: &Known<'_>) -> Vec<Offer> {
    let Some((name, members)) = around(known) else { return Vec::new() };
    let mut offers = Vec::new();
    for member in members {
        let MemberKind::Transform(transform) = &member.kind else { continue };
        let ends = continued(&transform.value).map_or_else(usual, |target| of_target(known, name, target));
        let (name, ends) = (&transform.name.text, ends.join(","));
        let snippet = match transform.family {
            Some(_) => format!("{name}[${{1:0}}].${{2|{ends}|}}"),
            None => format!("{name}.${{1|{ends}|}}"),
        };
        let offer = Offer::new(name, Kind::Field).detail("transform").snippet(snippet);
        offers.push(offer.rank(offers.len() as u8));
    }
    let first = offers.len() as u8;
    let own = of_target(known, name, name).into_iter().zip(first..);
    offers.extend(own.map(|(end, rank)| Offer::new(&end, Kind::Field).detail("boundary").rank(rank)));
    offers
}

/// Whether the word stands in a join.
pub(super) fn is_join(known: &Known<'_>) -> bool {
    let first = known.before.statement().first().copied();
    known.before.item() == Some(TokenKind::Ifs)
        && first.is_some_and(|first| known.before.written(first) == "join")
}

/// What can stand behind the full stop of a path: the boundaries of what a transform continues with, or the transforms of
/// the ifs that a boundary is.
pub(super) fn parts(known: &Known<'_>) -> Vec<Offer> {
    let Some((name, members)) = around(known) else { return Vec::new() };
    let statement = known.before.statement();
    // Behind the last sign or the word itself; what is in the brackets of a family is not among these.
    let start = statement.iter().rposition(|at| known.before.tokens[*at].kind == TokenKind::Equals);
    let first = statement.get(start.map_or(1, |sign| sign + 1)).map_or("", |at| known.before.written(*at));
    let offer = |end: String, detail: &str| Offer::new(&end, Kind::Field).detail(detail);
    let named = members.iter().find_map(|member| match &member.kind {
        MemberKind::Transform(transform) if transform.name.text == first => Some((&transform.value, true)),
        MemberKind::Boundary(boundary, value) if boundary.text == first => Some((value, false)),
        _ => None,
    });
    match named.and_then(|(value, transform)| Some((continued(value)?, transform))) {
        Some((target, false)) => {
            let pieces = declared(known, name, target, DeclarationKind::Transform);
            pieces.into_iter().map(|piece| offer(piece, "transform")).collect()
        }
        Some((target, true)) => {
            of_target(known, name, target).into_iter().map(|end| offer(end, "boundary")).collect()
        }
        None => of_target(known, name, name).into_iter().map(|end| offer(end, "boundary")).collect(),
    }
}

/// The name and the members of the ifs around, as it is written.
fn around<'a>(known: &Known<'a>) -> Option<(Span, &'a [Member])> {
    let ifs = known.before.tokens.iter().position(|token| token.kind == TokenKind::Ifs)?;
    let name = known.before.tokens.get(ifs + 1)?.span;
    let files = known.analysis.files.iter().filter(|file| file.file == name.file);
    files.flat_map(|file| &file.parse.ast.items).find_map(|item| match &item.kind {
        ItemKind::Ifs(ifs) if ifs.name.span == name => Some((name, ifs.members.as_slice())),
        _ => None,
    })
}

/// Where the ifs is named that a transform continues with, or that a boundary is.
fn continued(value: &Expr) -> Option<Span> {
    match &value.kind {
        ExprKind::On(inner, _) | ExprKind::Group(inner) | ExprKind::If(_, inner, _) => continued(inner),
        ExprKind::Binary(_, _, _, moved) => continued(moved),
        ExprKind::Call { callee, .. } => continued(callee),
        ExprKind::Name(_) => Some(value.span),
        _ => None,
    }
}

/// The boundaries of the ifs that is named at `target`, in the ifs that is declared by `around`.
fn of_target(known: &Known<'_>, around: Span, target: Span) -> Vec<String> {
    let names = declared(known, around, target, DeclarationKind::Boundary);
    if names.is_empty() { usual() } else { names }
}

/// The boundaries that every chain of segments has.
fn usual() -> Vec<String> {
    ["start", "end"].map(str::to_owned).to_vec()
}

/// What an ifs declares of a kind.
fn declared(
    known: &Known<'_>,
    around: Span,
    target: Span,
    kind: fn(ItemId) -> DeclarationKind,
) -> Vec<String> {
    let index = &known.analysis.index;
    let named = index.name_at(target.file, target.start).map(|named| named.target);
    let Some(Target::Declared(span)) = named.or(Some(Target::Declared(around))) else { return Vec::new() };
    let Some(DeclarationKind::Item(id)) = index.declaration(span).map(|declared| declared.kind) else {
        return Vec::new();
    };
    let of_ifs = index.declarations.iter().filter(|declared| declared.kind == kind(id));
    of_ifs.map(|declared| declared.name.clone()).collect()
}
