//! Result types of the functions on plain values: maths, lists, vectors, texts.

use super::Checker;
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::dimension::Dimension;
use crate::hir::native::Native;
use crate::hir::tree::Expr;
use crate::hir::types::{PointSpace, Type};

impl Checker<'_> {
    /// The type of a call of a function on plain values; `None` after a report.
    pub(super) fn value_type(&mut self, native: Native, values: &[Expr]) -> Option<Type> {
        let first = &values.first()?.ty;
        Some(match native {
            Native::Asin | Native::Acos | Native::Atan => Type::ANGLE,
            Native::Atan2 => {
                self.same_dimension(native, values)?;
                Type::ANGLE
            }
            Native::Mod => self.same_dimension(native, values)?,
            Native::Exp | Native::Ln | Native::Pow => Type::NUMBER,
            Native::Ceil => Type::Int,
            Native::Concat => match first {
                Type::List(inner) => (**inner).clone(),
                _ => return None,
            },
            Native::Reverse | Native::Transpose => first.clone(),
            Native::Norm | Native::Distance => {
                self.placed_space(native, values)?;
                Type::LENGTH
            }
            Native::Dot => {
                self.placed_space(native, values)?;
                Type::Quantity(Dimension::LENGTH.times(Dimension::LENGTH)?)
            }
            Native::Toward => Type::Point(self.placed_space(native, &values[..2])?),
            Native::WithLength => Type::Vector(self.placed_space(native, &values[..1])?),
            Native::Perpendicular => {
                self.placed_space(native, &values[..2])?;
                Type::Vector(PointSpace::Space)
            }
            Native::Text => Type::Text,
            _ => return None,
        })
    }

    fn same_dimension(&mut self, native: Native, values: &[Expr]) -> Option<Type> {
        let [a, b] = values else { return None };
        let ty = a.ty.join(&b.ty).filter(|ty| ty.dimension().is_some());
        if ty.is_none() {
            let (first, second) = (self.described(&a.ty), self.described(&b.ty));
            let message = format!(
                "`{}` needs two numbers of one dimension, not {first} and {second}",
                native.declaration().name
            );
            let diagnostic = Diagnostic::new(Code::E0402, b.span, message).label(second);
            self.report(diagnostic.also(a.span, first));
        }
        ty
    }

    /// The one space of points and vectors whose coordinates are known.
    fn placed_space(&mut self, native: Native, values: &[Expr]) -> Option<PointSpace> {
        let name = native.declaration().name;
        let mut space = PointSpace::Any;
        for value in values {
            let own = value.ty.point_space()?;
            if own == PointSpace::Control {
                let message = format!("`{name}` needs coordinates, and control points have none yet");
                let diagnostic =
                    Diagnostic::new(Code::E0402, value.span, message).label("made of control points");
                self.report(
                    diagnostic.hint("an ifs is made of weights alone: it can be placed on any points"),
                );
                return None;
            }
            let Some(joined) = space.join(own) else {
                let message = format!("`{name}` needs points or vectors of one space");
                let diagnostic = Diagnostic::new(Code::E0402, value.span, message).label("of another space");
                self.report(diagnostic.also(values[0].span, "this one"));
                return None;
            };
            space = joined;
        }
        Some(space)
    }
}
