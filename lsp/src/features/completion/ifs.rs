//! What an ifs continues with: of its own space, by a map in the plane and in space.

use ifs_compiler::hir::index::{Target, Visible};
use ifs_compiler::hir::native::Native;
use ifs_compiler::hir::native_result;
use ifs_compiler::hir::types::{PointSpace, Type};
use ifs_compiler::syntax::TokenKind;

use super::Known;
use super::fit::Fit;
use crate::features::tokens::Before;

/// Where the ifs around lives, as its head says it.
pub(super) fn space(before: &Before<'_>) -> Option<PointSpace> {
    if before.item() != Some(TokenKind::Ifs) {
        return None;
    }
    let brace = before.tokens.iter().position(|token| token.kind == TokenKind::OpenBrace)?;
    let word = |back: usize| brace.checked_sub(back);
    match word(2).map(|at| before.tokens[at].kind) {
        Some(TokenKind::In) if before.written(brace - 1) == "plane" => Some(PointSpace::Plane),
        Some(TokenKind::In) if before.written(brace - 1) == "space" => Some(PointSpace::Space),
        _ => Some(PointSpace::Control),
    }
}

/// Whether a name is of no use in the ifs around, whatever is wanted: a mesh that is read has coordinates of space.
pub(super) fn elsewhere(visible: &Visible<'_>, before: &Before<'_>) -> bool {
    visible.target == Target::Native(Native::Import)
        && space(before).is_some_and(|space| space != PointSpace::Space)
}

/// The space of the ifs around, where what is written says what that continues with or is bounded by.
pub(super) fn continued(known: &Known<'_>) -> Option<PointSpace> {
    if known.expected() != Some(&Type::Ifs) {
        return None;
    }
    let first = known.before.statement().first().copied()?;
    matches!(known.before.written(first), "transform" | "boundary").then(|| space(known.before))?
}

/// Whether a name is that of a map, or of a function that makes one.
pub(super) fn is_map(visible: &Visible<'_>) -> bool {
    match visible.target {
        Target::Native(native) => native_result(native) == Some("Map"),
        _ => matches!(visible.ty, Type::Map(_)),
    }
}

/// How well a name serves there: an ifs of the same space, or a map, where one moves it.
pub(super) fn fit(visible: &Visible<'_>, own: PointSpace) -> Fit {
    let by_map = own != PointSpace::Control;
    let yes = |fits: bool| if fits { Fit::Yes } else { Fit::No };
    if let Target::Native(native) = visible.target {
        return match (native, native_result(native)) {
            (Native::Rotate, _) => yes(own == PointSpace::Plane),
            (Native::Turn, _) => yes(own == PointSpace::Space),
            (_, Some("Map")) => yes(by_map),
            (_, Some("Ifs")) => yes(!by_map),
            _ => Fit::No,
        };
    }
    match (visible.ty, visible.space) {
        (Type::Map(space), _) => yes(by_map && space.join(own).is_some()),
        (Type::Ifs, Some(space)) => yes(space == own),
        (Type::Ifs, None) if by_map => Fit::Unknown,
        (Type::Ifs, None) => Fit::Yes,
        (Type::Error, _) => Fit::Unknown,
        _ => Fit::No,
    }
}
