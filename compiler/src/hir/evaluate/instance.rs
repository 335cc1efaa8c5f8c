//! An ifs with its arguments worked out: the images of control points as rows of exact weights.

use super::boundary::{InstanceBoundary, InstanceJoin};
use super::control_points::point_names;
use super::germ::Drawn;
use super::transform::Piece;
use super::{Evaluator, Frame, Outcome, Stop, words};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::scalar::Scalar;
use crate::hir::tree::{Hir, Ifs, ItemKind, LocalId};
use crate::hir::types::{PointSpace, Type};
use crate::hir::value::{Combination, GermShape, Instance, Terms, Value};
use crate::source::Span;
use std::sync::Arc;

/// A row of weights, one for each control point.
type Row = Vec<Rational>;

/// An ifs with its arguments worked out.
#[derive(Clone, Debug, PartialEq)]
pub struct InstanceBody {
    /// Where it lives.
    pub space: PointSpace,
    /// Whether a number in its weights is rounded, such as the cosine of most angles: then no proof holds for what was
    /// meant, only for the rounded numbers.
    pub rounded: bool,
    /// The names of its control points, or of the points of its frame.
    pub points: Vec<String>,
    /// Its transforms in order.
    pub transforms: Vec<InstanceTransform>,
    /// What it draws at the last level.
    pub germ: InstanceGerm,
    /// What it draws at every level.
    pub keep: Vec<InstanceGerm>,
    /// Where the germ stands.
    pub germ_span: Span,
    /// Its named boundaries.
    pub boundaries: Vec<InstanceBoundary>,
    /// The joins that are stated of it.
    pub joins: Vec<InstanceJoin>,
}

/// A germ worked out.
#[derive(Clone, Debug, PartialEq)]
pub struct InstanceGerm {
    /// How its vertices are drawn.
    pub shape: GermShape,
    /// One row of weights a vertex.
    pub vertices: Vec<Row>,
}

/// A transform worked out.
#[derive(Clone, Debug, PartialEq)]
pub struct InstanceTransform {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub name_span: Span,
    /// Where the images stand.
    pub points_span: Span,
    /// The ifs it continues with.
    pub target: Instance,
    /// One row an image.
    pub rows: Vec<Row>,
}

/// The parts of an ifs while some of its weights may be functions of its parameters.
pub(super) struct Parts {
    points: Vec<String>,
    pub(super) pieces: Vec<Piece>,
    germ: Drawn,
    keep: Vec<Drawn>,
    boundaries: Vec<(Instance, Vec<Vec<Scalar>>)>,
    joins: Vec<InstanceJoin>,
}

impl Evaluator<'_> {
    /// An ifs with its arguments worked out.
    ///
    /// # Errors
    /// After a report.
    pub fn instantiate(&mut self, instance: &Instance) -> Outcome<InstanceBody> {
        let hir = self.hir;
        let ItemKind::Ifs(ifs) = &hir.item(instance.ifs).kind else { return Err(Stop::Reported) };
        let within = (!ifs.parameters.is_empty()).then(|| format!("`{}`", instance_name(hir, instance)));
        let outer = std::mem::replace(&mut self.within, within);
        self.rounded = false;
        let parts = self.parts(instance, ifs);
        self.within = outer;
        let parts = parts?;
        let mut transforms = Vec::new();
        for piece in parts.pieces {
            let transform = &ifs.transforms[piece.transform];
            let name = piece.name(ifs);
            let rows: Outcome<Vec<Row>> = piece.rows.into_iter().map(exact).collect();
            transforms.push(InstanceTransform {
                name,
                name_span: transform.name_span,
                points_span: transform.image.span(),
                target: piece.target,
                rows: rows?,
            });
        }
        let germ = |(shape, vertices): Drawn| -> Outcome<InstanceGerm> {
            let vertices: Outcome<Vec<Row>> = vertices.into_iter().map(exact).collect();
            Ok(InstanceGerm { shape, vertices: vertices? })
        };
        let boundaries = parts.boundaries.into_iter().zip(&ifs.boundaries);
        let boundaries =
            boundaries.map(|((target, rows), declared)| InstanceBoundary::exact(declared, target, rows));
        Ok(InstanceBody {
            space: ifs.space,
            rounded: self.rounded,
            points: parts.points,
            transforms,
            germ: germ(parts.germ)?,
            keep: parts.keep.into_iter().map(germ).collect::<Outcome<Vec<InstanceGerm>>>()?,
            germ_span: ifs.germ.as_ref().map_or(hir.item(instance.ifs).name_span, |germ| germ.span),
            boundaries: boundaries.collect::<Outcome<Vec<InstanceBoundary>>>()?,
            joins: parts.joins,
        })
    }

    pub(super) fn parts(&mut self, instance: &Instance, ifs: &Ifs) -> Outcome<Parts> {
        if self.broken.contains(&instance.ifs) {
            return Err(Stop::Reported);
        }
        let counts = self.point_counts(instance, ifs)?;
        let outer = std::mem::replace(&mut self.points, point_names(ifs, &counts));
        let outcome = self.parts_inside(instance, ifs, &counts);
        self.points = outer;
        if outcome.as_ref().is_err_and(|stop| *stop == Stop::Reported) {
            self.broken.insert(instance.ifs);
        }
        outcome
    }

    /// The frame of an ifs with its `let`, and why one has no value.
    fn frame_with_lets(
        &mut self,
        instance: &Instance,
        ifs: &Ifs,
        counts: &[Option<usize>],
    ) -> Outcome<(Frame, Option<Stop>)> {
        let mut frame = self.instance_frame(instance, ifs, counts)?;
        let mut stop = None;
        for (slot, value) in &ifs.lets {
            match self.expr(&mut frame, value) {
                Ok(value) => frame.set(*slot, value),
                Err(reason) => {
                    frame.stopped(*slot, reason);
                    stop = Some(reason);
                }
            }
        }
        Ok((frame, stop))
    }

    /// The values of the `let` of an ifs, in their order.
    pub(super) fn lets(&mut self, instance: &Instance, ifs: &Ifs) -> Outcome<Vec<Outcome<Value>>> {
        let counts = self.point_counts(instance, ifs)?;
        self.points = point_names(ifs, &counts);
        let (frame, _) = self.frame_with_lets(instance, ifs, &counts)?;
        let value = |slot: LocalId| frame.slots.get(slot.0 as usize).cloned().unwrap_or(Err(Stop::Reported));
        Ok(ifs.lets.iter().map(|(slot, _)| value(*slot)).collect())
    }

    fn parts_inside(&mut self, instance: &Instance, ifs: &Ifs, counts: &[Option<usize>]) -> Outcome<Parts> {
        let (mut frame, mut stop) = self.frame_with_lets(instance, ifs, counts)?;
        let (pieces, stopped) = self.pieces(&mut frame, ifs);
        if let Some(stop) = stopped.or(stop.take()) {
            return Err(stop);
        }
        if pieces.is_empty() {
            return Err(self.no_pieces(instance, ifs));
        }
        let mut boundaries = Vec::new();
        for boundary in &ifs.boundaries {
            match self.boundary(&mut frame, boundary) {
                Ok(done) => boundaries.push(done),
                Err(reason) => stop = Some(reason),
            }
        }
        if let Some(stop) = stop {
            return Err(stop);
        }
        let germ = ifs.germ.as_ref().ok_or(Stop::Reported)?;
        let germ = self.germ(&mut frame, ifs, (instance, &pieces), germ)?;
        let mut keep = Vec::new();
        for kept in &ifs.keep {
            keep.push(self.germ(&mut frame, ifs, (instance, &pieces), kept)?);
        }
        let joins: Outcome<Vec<InstanceJoin>> =
            ifs.joins.iter().map(|join| self.join(&mut frame, join)).collect();
        Ok(Parts { points: self.points.clone(), pieces, germ, keep, boundaries, joins: joins? })
    }

    /// All families of an ifs are empty. An ifs without any transform has been reported by the checker.
    fn no_pieces(&mut self, instance: &Instance, ifs: &Ifs) -> Stop {
        let Some(family) = ifs.transforms.first() else { return Stop::Reported };
        let message = format!("`{}` has no transforms", instance_name(self.hir, instance));
        let diagnostic =
            Diagnostic::new(Code::E0507, family.name_span, message).label("a family without members");
        self.report(diagnostic.hint("let the range of the family have at least one number"))
    }

    fn instance_frame(&mut self, instance: &Instance, ifs: &Ifs, counts: &[Option<usize>]) -> Outcome<Frame> {
        let mut frame = self.argument_frame(instance, ifs)?;
        if ifs.space != PointSpace::Control {
            return Ok(frame);
        }
        let all: usize = counts.iter().map(|count| count.unwrap_or(1)).sum();
        let unit = |place: usize| {
            let weights = (0..all).map(|other| if other == place { Scalar::one() } else { Scalar::zero() });
            let terms = Terms::Weights(weights.collect());
            Value::Combination(Arc::new(Combination { terms, weight: Scalar::one(), made: None }))
        };
        let mut next = 0;
        for (entry, count) in counts.iter().enumerate() {
            let places = next..next + count.unwrap_or(1);
            next = places.end;
            let value = match count {
                Some(_) => Value::List(Arc::new(places.map(unit).collect())),
                None => unit(places.start),
            };
            frame.set(LocalId((ifs.parameters.len() + entry) as u32), value);
        }
        Ok(frame)
    }

    /// A frame with the arguments in it.
    pub(super) fn argument_frame(&mut self, instance: &Instance, ifs: &Ifs) -> Outcome<Frame> {
        let mut frame = Frame::new(ifs.slots);
        frame.own_ifs = Some(instance.clone());
        for (index, (argument, parameter)) in instance.arguments.iter().zip(&ifs.parameters).enumerate() {
            let plain = parameter.ty == Type::NUMBER;
            let value = match argument {
                Value::Scalar(scalar) if plain => {
                    let span = self.hir.item(instance.ifs).name_span;
                    let exact = self.taken_exactly(scalar.clone());
                    Value::Scalar(exact.map_err(|error| self.scalar_error(error, span))?)
                }
                other => other.clone(),
            };
            frame.set(LocalId(index as u32), value);
        }
        Ok(frame)
    }
}

/// An ifs with its arguments as an architect would write it: `bezier3(t: 23/50)`.
pub fn instance_name(hir: &Hir, instance: &Instance) -> String {
    let item = hir.item(instance.ifs);
    let ItemKind::Ifs(ifs) = &item.kind else { return item.name.clone() };
    if ifs.parameters.is_empty() {
        return item.name.clone();
    }
    let arguments = ifs.parameters.iter().zip(&instance.arguments).map(|(parameter, value)| {
        let value = match value {
            Value::Scalar(scalar) => match scalar.to_rational() {
                Some(exact) if parameter.ty == Type::NUMBER || parameter.ty == Type::Int => exact.to_string(),
                _ => words(scalar, &parameter.ty),
            },
            Value::Bool(truth) => truth.to_string(),
            Value::Text(text) => format!("{text:?}"),
            _ => "…".to_owned(),
        };
        format!("{}: {value}", parameter.name)
    });
    format!("{}({})", item.name, arguments.collect::<Vec<_>>().join(", "))
}

/// Exact weights of a row that depends on nothing any more.
pub(super) fn exact(row: Vec<Scalar>) -> Outcome<Row> {
    row.iter().map(|weight| weight.to_rational().ok_or(Stop::Undetermined)).collect()
}
