//! Boundaries of an ifs with its arguments worked out. What is proved of them is not said here.

use super::instance::exact;
use super::{Evaluator, Frame, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::scalar::Scalar;
use crate::hir::tree::Boundary;
use crate::hir::value::{Combination, GermShape, IfsValue, Instance, Terms, Value};
use crate::source::Span;

/// A boundary worked out.
#[derive(Clone, Debug, PartialEq)]
pub struct InstanceBoundary {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub name_span: Span,
    /// The ifs that it is.
    pub target: Instance,
    /// One row of weights a point of that ifs.
    pub rows: Vec<Vec<Rational>>,
}

impl InstanceBoundary {
    pub(super) fn exact(
        declared: &Boundary,
        target: Instance,
        rows: Vec<Vec<Scalar>>,
    ) -> Outcome<InstanceBoundary> {
        let (name, name_span) = (declared.name.clone(), declared.name_span);
        let rows: Outcome<Vec<Vec<Rational>>> = rows.into_iter().map(exact).collect();
        Ok(InstanceBoundary { name, name_span, target, rows: rows? })
    }
}

impl Evaluator<'_> {
    /// Whether an ifs with its arguments draws polygons, so that it may be a surface.
    pub(super) fn draws_polygons(&mut self, instance: &Instance) -> bool {
        self.instantiate(instance).is_ok_and(|body| body.germ.shape == GermShape::Polygon)
    }

    #[allow(clippy::type_complexity, reason = "a target and its rows")]
    pub(super) fn boundary(
        &mut self,
        frame: &mut Frame,
        boundary: &Boundary,
    ) -> Outcome<(Instance, Vec<Vec<Scalar>>)> {
        let Value::Ifs(target) = self.expr(frame, &boundary.target)? else { return Err(Stop::Reported) };
        let IfsValue::Instance(target) = target.as_ref() else {
            let message = "a boundary is one ifs, not a product of two";
            let diagnostic = Diagnostic::new(Code::E0541, boundary.target.span, message);
            return Err(self.report(diagnostic.label("a tensor product")));
        };
        let mut rows = Vec::new();
        let mut stop = None;
        for point in &boundary.points {
            match self.expr(frame, point) {
                Ok(Value::Combination(point)) => rows.push(weights(&point)?),
                Ok(_) => stop = Some(Stop::Reported),
                Err(reason) => stop = Some(reason),
            }
        }
        match stop {
            Some(stop) => Err(stop),
            None => Ok((target.clone(), rows)),
        }
    }
}

fn weights(point: &Combination) -> Outcome<Vec<Scalar>> {
    match &point.terms {
        Terms::Weights(weights) => Ok(weights.clone()),
        Terms::Coordinates(_) => Err(Stop::Reported),
    }
}
