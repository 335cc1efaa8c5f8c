//! Boundaries of an ifs with its arguments worked out. What is proved of them is not said here.

use super::instance::exact;
use super::{Evaluator, Frame, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Boundary, Join, JoinPart};
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

/// A stated join with its members counted out.
#[derive(Clone, Debug, PartialEq)]
pub struct InstanceJoin {
    /// The path before the sign: one or two parts.
    pub left: Vec<InstanceJoinPart>,
    /// The path after it.
    pub right: Vec<InstanceJoinPart>,
    /// The whole member.
    pub span: Span,
}

/// A part of a path in a join.
#[derive(Clone, Debug, PartialEq)]
pub struct InstanceJoinPart {
    /// The name as it is written, without the member.
    pub name: String,
    /// Where it stands.
    pub span: Span,
    /// Which member of a family it is.
    pub member: Option<i64>,
}

impl InstanceJoinPart {
    /// The name that a transform has for it: `left`, `branch.0`.
    pub fn transform_name(&self) -> String {
        match self.member {
            Some(member) => format!("{}.{member}", self.name),
            None => self.name.clone(),
        }
    }
}

impl std::fmt::Display for InstanceJoinPart {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.member {
            Some(member) => write!(f, "{}[{member}]", self.name),
            None => f.write_str(&self.name),
        }
    }
}

impl Evaluator<'_> {
    /// A stated join of an ifs with its arguments.
    pub(super) fn join(&mut self, frame: &mut Frame, join: &Join) -> Outcome<InstanceJoin> {
        let mut path = |parts: &[JoinPart]| -> Outcome<Vec<InstanceJoinPart>> {
            let part = |part: &JoinPart| {
                let member = match &part.member {
                    Some(member) => {
                        let number = self.scalar(frame, member)?;
                        Some(number.to_integer().ok_or(Stop::Undetermined)?)
                    }
                    None => None,
                };
                Ok(InstanceJoinPart { name: part.name.clone(), span: part.span, member })
            };
            parts.iter().map(part).collect()
        };
        Ok(InstanceJoin { left: path(&join.left)?, right: path(&join.right)?, span: join.span })
    }

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
