//! The types of maps: whether they are of the plane or of space, as far as that is known before evaluation.

use super::Checker;
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::native::Native;
use crate::hir::tree::Expr;
use crate::hir::types::{PointSpace, Type};
use crate::source::Span;

impl Checker<'_> {
    /// The type of a map made of these arguments; `None` after a report.
    pub(super) fn map_type(&mut self, native: Native, values: &[Expr], at: Span) -> Option<Type> {
        let numbers: Vec<&Expr> = values.iter().filter(|value| value.ty.dimension().is_some()).collect();
        let places: Vec<&Expr> = values.iter().filter(|value| value.ty.point_space().is_some()).collect();
        let mut space = match native {
            Native::Rotate => PointSpace::Plane,
            Native::Turn => PointSpace::Space,
            Native::Mirror => PointSpace::Any,
            Native::Affine => match numbers.len() {
                4 => PointSpace::Plane,
                9 => PointSpace::Space,
                count => return self.wrong_count(count, at),
            },
            // Factors or lengths; a vector, or one factor, leaves it open.
            _ => match numbers.len() {
                2 => PointSpace::Plane,
                3 => PointSpace::Space,
                _ => PointSpace::Any,
            },
        };
        for place in places {
            let other = place.ty.point_space().unwrap_or(PointSpace::Any);
            match space.join(other).filter(|joined| *joined != PointSpace::Control) {
                Some(joined) => space = joined,
                None => {
                    self.mixed(space, at, &place.ty, place.span);
                    return None;
                }
            }
        }
        Some(Type::Map(space))
    }

    fn wrong_count(&mut self, count: usize, at: Span) -> Option<Type> {
        let message = format!("`affine` takes four numbers in the plane, or nine in space, not {count}");
        let diagnostic = Diagnostic::new(Code::E0536, at, message).label(format!("{count} given"));
        self.report(diagnostic.hint("row by row: `affine(a, b, c, d)` makes x' = a x + b y, y' = c x + d y"));
        None
    }

    /// Says that a map and what it meets are not of one space.
    pub(super) fn mixed(&mut self, map: PointSpace, map_at: Span, other: &Type, at: Span) {
        let (a, b) = (self.described(&Type::Map(map)), self.described(other));
        if other.point_space() == Some(PointSpace::Control) {
            let message =
                "a map moves points with coordinates, not control points, whose place is still open";
            let diagnostic = Diagnostic::new(Code::E0530, at, message).label(b).also(map_at, a);
            self.report(
                diagnostic.hint(
                    "combine control points, `lerp(p0, p1, 1/2)`, or use an ifs `in plane` or `in space`",
                ),
            );
            return;
        }
        let message = format!("{a} and {b} do not go together");
        let diagnostic = Diagnostic::new(Code::E0530, at, message).label(b).also(map_at, a);
        self.report(diagnostic.hint(
            "of the plane are `translate(dx, dy)`, `rotate(angle)`, `affine(a, b, c, d)`; of space `translate(dx, dy, dz)` \
             and `turn(axis, angle)`; `scale(k)` serves in both",
        ));
    }

    /// Whether a map cannot move an ifs; then that has been said.
    pub(super) fn refuse_map_of_ifs(&mut self, map: &Expr, ifs: &Expr) -> bool {
        let (Type::Map(space), Type::Ifs) = (&map.ty, &ifs.ty) else { return false };
        match self.ifs_space(ifs) {
            Some(PointSpace::Control) => {
                let message = "a map moves an ifs in plane or in space; this one is on control points";
                let diagnostic = Diagnostic::new(Code::E0531, ifs.span, message).label("on control points");
                self.report(diagnostic.hint("move its control points instead: `… on (map * p, map * q, …)`"));
                true
            }
            Some(other) if space.join(other).is_none() => {
                let map_is = self.described(&map.ty);
                let message = format!("{map_is} cannot move an ifs {}", other.words());
                let diagnostic = Diagnostic::new(Code::E0530, map.span, message)
                    .label(map_is)
                    .also(ifs.span, other.words());
                self.report(diagnostic.hint(match other {
                    PointSpace::Plane => "in the plane: `translate(dx, dy)`, `rotate(angle)`, `scale(k)`",
                    _ => "in space: `translate(dx, dy, dz)`, `turn(axis, angle)`, `scale(k)`",
                }));
                true
            }
            _ => false,
        }
    }
}
