//! Transforms worked out: what each continues with, and the images of its control points as weights on the own ones.

use super::map::frame_images;
use super::{Evaluator, Frame, Outcome, Stop, instance_name};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::map::Map;
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Expr, Ifs, Image};
use crate::hir::types::PointSpace;
use crate::hir::value::{Combination, IfsValue, Instance, Terms, Value};
use crate::source::Span;

/// The most members a family of transforms may have.
const MOST_MEMBERS: usize = 1000;

/// What a member of a family costs beside its images, in steps.
const STEPS_PER_MEMBER: u64 = 50;

/// A transform, or a member of a family of them, worked out.
pub(super) struct Piece {
    /// The place of the transform in its ifs.
    pub(super) transform: usize,
    /// Its index, in a family.
    pub(super) member: Option<i64>,
    /// The ifs it continues with.
    pub(super) target: Instance,
    /// One row an image.
    pub(super) rows: Vec<Vec<Scalar>>,
}

impl Piece {
    /// The name of the transform, with the index of a member.
    pub(super) fn name(&self, ifs: &Ifs) -> String {
        let name = &ifs.transforms[self.transform].name;
        match self.member {
            Some(member) => format!("{name}.{member}"),
            None => name.clone(),
        }
    }
}

impl Evaluator<'_> {
    /// All transforms with the members of families, and why some are missing.
    pub(super) fn pieces(&mut self, frame: &mut Frame, ifs: &Ifs) -> (Vec<Piece>, Option<Stop>) {
        let (mut pieces, mut stop) = (Vec::new(), None);
        for (index, transform) in ifs.transforms.iter().enumerate() {
            let members = match &transform.family {
                None => Ok(vec![None]),
                Some((slot, over)) => self.members(frame, over).map(|members| {
                    members.into_iter().map(|(member, value)| Some((*slot, member, value))).collect()
                }),
            };
            let members = match members {
                Ok(members) => members,
                Err(reason) => {
                    stop = Some(reason);
                    continue;
                }
            };
            for member in members {
                let number = member.as_ref().map(|(_, number, _)| *number);
                if let Some((slot, _, value)) = member {
                    frame.set(slot, value);
                }
                match self.image(frame, ifs.space, &transform.image) {
                    Ok((target, rows)) => {
                        pieces.push(Piece { transform: index, member: number, target, rows })
                    }
                    Err(reason) => {
                        stop = Some(reason);
                        break;
                    }
                }
            }
        }
        (pieces, stop)
    }

    fn members(&mut self, frame: &mut Frame, over: &Expr) -> Outcome<Vec<(i64, Value)>> {
        let span = over.span;
        let value = self.expr(frame, over)?;
        let count = match &value {
            Value::Range(from, to) => {
                if *from < 0 {
                    let message = "the members of a family are numbered from 0 or above";
                    let label = format!("starts at {from}");
                    let diagnostic = Diagnostic::new(Code::E0534, span, message).label(label);
                    let hint = "start at 0 and subtract in the transform, or go through a list";
                    return Err(self.report(diagnostic.hint(hint)));
                }
                usize::try_from(to.saturating_sub(*from)).unwrap_or(0)
            }
            Value::List(list) => list.len(),
            _ => return Err(Stop::Reported),
        };
        if count > MOST_MEMBERS {
            let message = format!("a family of {count} transforms; the limit is {MOST_MEMBERS}");
            let diagnostic = Diagnostic::new(Code::E0534, span, message).label("too many");
            return Err(self.report(diagnostic.hint("use more levels of fewer transforms")));
        }
        self.spend(count as u64 * STEPS_PER_MEMBER, span)?;
        Ok(match value {
            Value::Range(from, to) => {
                (from..to).map(|index| (index, Value::Scalar(Scalar::integer(index)))).collect()
            }
            Value::List(list) => (0..).zip(list.iter().cloned()).collect(),
            _ => Vec::new(),
        })
    }

    fn image(
        &mut self,
        frame: &mut Frame,
        own: PointSpace,
        image: &Image,
    ) -> Outcome<(Instance, Vec<Vec<Scalar>>)> {
        match image {
            Image::Points { target, points, .. } => self.on_points(frame, own, target, points),
            Image::Mapped(value) => self.on_map(frame, own, value),
            Image::If(condition, yes, no) => {
                let branch = if self.truth(frame, condition)? { yes } else { no };
                stacker::maybe_grow(128 * 1024, 1024 * 1024, || self.image(frame, own, branch))
            }
        }
    }

    fn on_points(
        &mut self,
        frame: &mut Frame,
        own: PointSpace,
        target: &Expr,
        points: &[Expr],
    ) -> Outcome<(Instance, Vec<Vec<Scalar>>)> {
        let Value::Ifs(ifs) = self.expr(frame, target)? else { return Err(Stop::Reported) };
        let instance = match ifs.as_ref() {
            IfsValue::Instance(instance) => instance.clone(),
            IfsValue::Tensor(..) => {
                let message = "a transform continues with one ifs, not with a product of two";
                let diagnostic = Diagnostic::new(Code::E0503, target.span, message);
                return Err(self.report(diagnostic.label("a tensor product")));
            }
            IfsValue::Mapped(_, instance) => instance.clone(),
        };
        let space = self.instance_space(&instance);
        if space != PointSpace::Control {
            let message = format!("an ifs {} has no control points to be placed on", space.words());
            let diagnostic = Diagnostic::new(Code::E0531, target.span, message).label("no place for points");
            return Err(self.report(diagnostic.hint("continue with an ifs on control points")));
        }
        let mut rows = Vec::new();
        let mut stop = None;
        for point in points {
            let outcome =
                self.expr(frame, point).and_then(|value| self.rows(own, &value, point.span, &mut rows));
            stop = outcome.err().or(stop);
        }
        if let Some(stop) = stop {
            return Err(stop);
        }
        let needed = self.control_points(&instance, target.span)?;
        if rows.len() != needed {
            let name = instance_name(self.hir, &instance);
            let message =
                format!("`{name}` has {needed} control points, but the transform lists {}", rows.len());
            let at = points
                .first()
                .map_or(target.span, |first| points.iter().fold(first.span, |at, point| at.to(point.span)));
            let diagnostic =
                Diagnostic::new(Code::E0503, at, message).label(format!("{} points", rows.len()));
            return Err(self.report(diagnostic.hint("give one image for each control point")));
        }
        Ok((instance, rows))
    }

    /// The rows of a point, or of a list of points.
    fn rows(&mut self, own: PointSpace, value: &Value, at: Span, rows: &mut Vec<Vec<Scalar>>) -> Outcome<()> {
        match value {
            Value::Combination(point) => {
                let row = self.row(own, point, Code::E0402, at)?;
                rows.push(row);
                Ok(())
            }
            Value::List(list) => list.iter().try_for_each(|point| match point {
                Value::Combination(_) => self.rows(own, point, at, rows),
                _ => Err(Stop::Reported),
            }),
            _ => Err(Stop::Reported),
        }
    }

    fn on_map(
        &mut self,
        frame: &mut Frame,
        own: PointSpace,
        value: &Expr,
    ) -> Outcome<(Instance, Vec<Vec<Scalar>>)> {
        let Value::Ifs(ifs) = self.expr(frame, value)? else { return Err(Stop::Reported) };
        let identity = Map::identity();
        let (map, instance) = match ifs.as_ref() {
            IfsValue::Instance(instance) => (&identity, instance),
            IfsValue::Mapped(map, instance) => (map.as_ref(), instance),
            IfsValue::Tensor(..) => {
                let message = "a transform continues with one ifs, not with a product of two";
                let diagnostic = Diagnostic::new(Code::E0531, value.span, message);
                return Err(self.report(diagnostic.label("a tensor product")));
            }
        };
        let space = self.instance_space(instance);
        let Some(axes) = own.coordinates().filter(|_| space == own) else {
            let (own, is) = (own.words(), space.words());
            let message = format!("an ifs {own} cannot continue with one {is} in this way");
            let diagnostic = Diagnostic::new(Code::E0531, value.span, message).label(format!("an ifs {is}"));
            return Err(self.report(diagnostic.hint("let both live in the plane, or both in space")));
        };
        let images = frame_images(map, axes).map_err(|error| self.scalar_error(error, value.span))?;
        let rows: Outcome<Vec<Vec<Scalar>>> =
            images.iter().map(|image| self.frame_row(image, value.span)).collect();
        Ok((instance.clone(), rows?))
    }

    /// A point as weights on the points of the ifs that it is a point of; `code` is for one of another space.
    pub(super) fn row(
        &mut self,
        own: PointSpace,
        point: &Combination,
        code: Code,
        at: Span,
    ) -> Outcome<Vec<Scalar>> {
        match (&point.terms, own.coordinates()) {
            (Terms::Weights(weights), None) => Ok(weights.clone()),
            (Terms::Coordinates(numbers), Some(count)) if numbers.len() == count => {
                self.frame_row(numbers, at)
            }
            (Terms::Coordinates(numbers), _) => {
                let is = if numbers.len() == 2 { "a point of the plane" } else { "a point in space" };
                let message = format!("this is {is}, but the ifs lives {}", own.words());
                let diagnostic = Diagnostic::new(code, at, message).label(is);
                Err(self.report(match own {
                    PointSpace::Control => diagnostic.hint("combine its control points: `lerp(p0, p1, 1/2)`"),
                    _ => diagnostic.hint("give every point as many coordinates as its ifs has axes"),
                }))
            }
            (Terms::Weights(_), Some(_)) => Err(Stop::Reported),
        }
    }

    /// Coordinates in mm as weights on the points of an affine frame: `(1 - x - y, x, y)`. They sum to 1 exactly.
    pub(super) fn frame_row(&mut self, numbers: &[Scalar], at: Span) -> Outcome<Vec<Scalar>> {
        let mut row = vec![Scalar::one()];
        for number in numbers {
            let number = self.taken_exactly(number.clone()).map_err(|error| self.scalar_error(error, at))?;
            row.push(number);
        }
        // Rationals of any length, so that nothing is rounded here.
        let exact: Option<Rational> = row[1..]
            .iter()
            .map(|number| match number {
                Scalar::Exact(value) => Some(value),
                _ => None,
            })
            .sum();
        row[0] = match exact {
            Some(sum) => Scalar::Exact(&Rational::from(1) - &sum),
            None => {
                let mut rest = Scalar::one();
                for number in &row[1..] {
                    rest = rest.minus(number).map_err(|error| self.scalar_error(error, at))?;
                }
                rest
            }
        };
        Ok(row)
    }
}
