//! Planes of space.

use super::{Evaluator, Outcome, Stop};
use crate::hir::tree::Expr;
use crate::hir::value::{Plane, Value};
use std::sync::Arc;

impl Evaluator<'_> {
    /// The plane through `point`, square to `normal`.
    pub(super) fn plane(&mut self, point: &Value, normal: &Value, arguments: &[Expr]) -> Outcome<Value> {
        let Value::Combination(point) = point else { return Err(Stop::Reported) };
        let point = self.in_space(point, arguments[0].span)?;
        let normal = self.direction(normal, arguments[1].span)?;
        Ok(Value::Plane(Arc::new(Plane { point, normal })))
    }
}
