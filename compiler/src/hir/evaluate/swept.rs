//! Surfaces made of curves: `translation` and its relatives, `revolution`, `extrusion`.

use super::{Evaluator, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::native::Native;
use crate::hir::placed::{Arm, Chain, Swept, SweptPath, SweptRule};
use crate::hir::scalar::Scalar;
use crate::hir::tree::Expr;
use crate::hir::types::Type;
use crate::hir::value::{Combination, Figure, Shape, Value};
use crate::source::Span;
use std::sync::Arc;

/// Sizes below this, in mm, are no direction.
const LEAST_LENGTH: f64 = 1e-9;

impl Evaluator<'_> {
    pub(super) fn swept(
        &mut self,
        native: Native,
        values: &[Value],
        arguments: &[Expr],
        span: Span,
    ) -> Outcome<Value> {
        let (profile, path) = match (native, values) {
            (Native::Revolution, [profile, point, direction, segments, angle @ ..]) => {
                let profile = self.arm("profile", profile, arguments[0].span)?;
                (profile, self.swept_turn([point, direction, segments], angle.first(), arguments)?)
            }
            (Native::Extrusion, [profile, vector, pieces @ ..]) => {
                let profile = self.arm("profile", profile, arguments[0].span)?;
                let vector = self.direction(vector, arguments[1].span)?;
                let pieces = match pieces.first() {
                    Some(pieces) => self.steps(pieces, 1, "piece", arguments[2].span)?,
                    None => 1,
                };
                (profile, SweptPath::Straight { vector, pieces })
            }
            (_, [rail, profile, scale @ ..]) => {
                let rail = self.arm("rail", rail, arguments[0].span)?;
                let profile = self.arm("profile", profile, arguments[1].span)?;
                let rule = match (native, scale.first()) {
                    (Native::ScaleTranslation, Some(scale)) => {
                        SweptRule::Scaled(self.scales(scale, &rail, arguments[2].span)?)
                    }
                    (Native::ProjectiveSum, _) => SweptRule::Projective,
                    _ => SweptRule::Sum,
                };
                (profile, SweptPath::Rail(rail, rule))
            }
            _ => return Err(Stop::Reported),
        };
        let shape = Shape::Swept(Box::new(Swept { profile, path }));
        Ok(Value::Figure(Arc::new(Figure { shape, level: None, span })))
    }

    /// A curve in space, with its own level where it has one.
    fn arm(&mut self, role: &'static str, value: &Value, span: Span) -> Outcome<Arm> {
        let Value::Figure(figure) = value else { return Err(Stop::Reported) };
        let chain = match &figure.shape {
            Shape::Curve { ifs, points, dimension } => Chain {
                ifs: ifs.clone(),
                points: points.clone(),
                weights: None,
                dimension: *dimension,
                windows: false,
                closed: false,
            },
            Shape::Chain(chain) => chain.as_ref().clone(),
            _ => return Err(Stop::Reported),
        };
        if chain.dimension != 3 {
            let message = format!("the {role} of a surface has points with three coordinates");
            let diagnostic = Diagnostic::new(Code::E0510, span, message).label("a curve of the plane");
            return Err(self.report(diagnostic.hint("give every point a height: `(x, y, z)`")));
        }
        Ok(Arm { role, chain, level: figure.level, span })
    }

    /// One number above 0 for each control point of the rail.
    fn scales(&mut self, scale: &Value, rail: &Arm, span: Span) -> Outcome<Vec<f64>> {
        let list = scale.list().ok_or(Stop::Reported)?;
        let needed = rail.chain.points.len();
        if list.len() != needed {
            let message = format!(
                "`scale` has one number for each control point of the rail: {needed}, but {} are given",
                list.len()
            );
            let diagnostic =
                Diagnostic::new(Code::E0521, span, message).label(format!("{} numbers", list.len()));
            return Err(self.report(diagnostic.also(rail.span, format!("{needed} control points"))));
        }
        let mut scales = Vec::with_capacity(needed);
        for (place, value) in list.iter().enumerate() {
            let value = value.number().ok_or(Stop::Undetermined)?;
            if value <= 0.0 {
                let message = format!("a scale is above 0, but number {place} is {value}");
                let diagnostic = Diagnostic::new(Code::E0521, span, message).label("not above 0");
                let hint = "at 0 the profile would shrink to a point, and its quads to triangles";
                return Err(self.report(diagnostic.hint(hint)));
            }
            scales.push(value);
        }
        Ok(scales)
    }

    fn swept_turn(
        &mut self,
        [point, direction, segments]: [&Value; 3],
        angle: Option<&Value>,
        arguments: &[Expr],
    ) -> Outcome<SweptPath> {
        let Value::Combination(point) = point else { return Err(Stop::Reported) };
        let point = self.in_space(point, arguments[1].span)?;
        let direction = self.direction(direction, arguments[2].span)?;
        let length = length(direction);
        let whole = Scalar::Pi(Rational::from(2));
        let (angle, at) = match angle {
            Some(Value::Scalar(angle)) => (angle.clone(), arguments[4].span),
            _ => (whole.clone(), arguments[3].span),
        };
        let degrees = super::words(&angle, &Type::ANGLE);
        let size = angle.to_f64().ok_or(Stop::Undetermined)?;
        let turns = size.abs() / core::f64::consts::TAU;
        if size == 0.0 || turns > 1.0 + 1e-12 {
            let message = format!("a revolution turns by up to 360deg, but this is {degrees}");
            let diagnostic = Diagnostic::new(Code::E0604, at, message).label(format!("is {degrees}"));
            return Err(self.report(diagnostic.hint("leave `angle` out for a full turn")));
        }
        let full = turns > 1.0 - 1e-12;
        // A step of half a turn or more would lead quads through the axis.
        let least = libm::floor(turns * 2.0) as i64 + 1;
        let segments = self.steps(segments, least, "segment", arguments[3].span)?;
        let direction = direction.map(|part| part / length);
        Ok(SweptPath::Turn { point, direction, angle: size, full, segments })
    }

    /// A whole number of steps of a path.
    fn steps(&mut self, value: &Value, least: i64, what: &str, span: Span) -> Outcome<u32> {
        let count = value.scalar().and_then(Scalar::to_rational).and_then(|count| count.to_i64());
        match count {
            Some(count) if count >= least && u32::try_from(count).is_ok() => Ok(count as u32),
            _ => {
                let is = value.number().ok_or(Stop::Undetermined)?;
                let (message, hint) = if is < least as f64 {
                    let (plural, are) = if least == 1 { ("", "is") } else { ("s", "are") };
                    let message = format!("at least {least} {what}{plural} {are} needed, but this is {is}");
                    (message, format!("write {least} or more"))
                } else {
                    (format!("{is} {what}s are more than can be made"), "write a smaller number".to_owned())
                };
                let diagnostic = Diagnostic::new(Code::E0604, span, message).label(format!("is {is}"));
                Err(self.report(diagnostic.hint(hint)))
            }
        }
    }

    pub(super) fn direction(&mut self, value: &Value, span: Span) -> Outcome<[f64; 3]> {
        let Value::Combination(vector) = value else { return Err(Stop::Reported) };
        let vector = self.in_space(vector, span)?;
        let length = length(vector);
        if length < LEAST_LENGTH || !length.is_finite() {
            let message = "a direction needs a vector of some length";
            let diagnostic = Diagnostic::new(Code::E0604, span, message).label("no direction");
            return Err(self.report(diagnostic.hint("upwards is `(0m, 0m, 1m)`")));
        }
        Ok(vector)
    }

    pub(super) fn in_space(&mut self, point: &Combination, span: Span) -> Outcome<[f64; 3]> {
        let (point, dimension) = self.coordinates_of(point)?;
        if dimension != 3 {
            let message = "three coordinates are needed here, but this has two";
            let diagnostic = Diagnostic::new(Code::E0402, span, message).label("two coordinates");
            return Err(self.report(diagnostic.hint("add a height: `(x, y, z)`")));
        }
        Ok(point)
    }
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(x, y), z)
}
