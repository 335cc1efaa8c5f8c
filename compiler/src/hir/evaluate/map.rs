//! Maps: how the functions of the program make them, and what they do to whatever stands to their right.

use super::{Evaluator, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::map::{Map, Triple, cross, diagonal, dot, product};
use crate::hir::native::Native;
use crate::hir::placed::SweptPath;
use crate::hir::scalar::{Scalar, ScalarError};
use crate::hir::tree::{Expr, ItemKind};
use crate::hir::types::{PointSpace, Type};
use crate::hir::value::{Combination, Figure, IfsValue, Instance, Shape, Terms, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    /// A function that makes a map; the checker has seen to the number of arguments.
    pub(super) fn map(
        &mut self,
        native: Native,
        values: &[Value],
        arguments: &[Expr],
        span: Span,
    ) -> Outcome<Value> {
        let numbers: Vec<Scalar> = values.iter().filter_map(Value::scalar).cloned().collect();
        let mut places = Vec::new();
        for (value, argument) in values.iter().zip(arguments) {
            if let Value::Combination(place) = value {
                places.push((self.triple(place, argument.span)?, argument));
            }
        }
        let mut places = places.into_iter();
        let map = match (native, numbers.as_slice()) {
            (Native::Translate, []) => {
                let ((by, space), _) = places.next().ok_or(Stop::Reported)?;
                Map::translation(space, by)
            }
            (Native::Translate, [dx, dy]) => {
                Map::translation(PointSpace::Plane, [dx.clone(), dy.clone(), Scalar::zero()])
            }
            (Native::Translate, [dx, dy, dz]) => {
                Map::translation(PointSpace::Space, [dx.clone(), dy.clone(), dz.clone()])
            }
            (Native::Rotate, [angle]) => {
                let sine = self.function(Native::Sin, angle, &arguments[0])?;
                let cosine = self.function(Native::Cos, angle, &arguments[0])?;
                Map::plane(cosine.clone(), sine.negated(), sine, cosine)
            }
            (Native::Turn, [angle]) => {
                let ((axis, space), at) = places.next().ok_or(Stop::Reported)?;
                if space != PointSpace::Space {
                    return Err(self.mixed("a turn about an axis", "a vector of the plane", at.span));
                }
                self.turn(&axis, angle, arguments)?
            }
            (Native::Mirror, []) => {
                let ((along, space), at) = places.next().ok_or(Stop::Reported)?;
                self.mirror(&along, space, at)?
            }
            (Native::Scale, [k]) => Map::linear(PointSpace::Any, diagonal([k.clone(), k.clone(), k.clone()])),
            (Native::Scale, [kx, ky]) => Map::plane(kx.clone(), Scalar::zero(), Scalar::zero(), ky.clone()),
            (Native::Scale, [kx, ky, kz]) => {
                Map::linear(PointSpace::Space, diagonal([kx.clone(), ky.clone(), kz.clone()]))
            }
            (Native::Affine, [a, b, c, d]) => Map::plane(a.clone(), b.clone(), c.clone(), d.clone()),
            (Native::Affine, [a, b, c, d, e, f, g, h, i]) => {
                let rows = [[a, b, c], [d, e, f], [g, h, i]];
                Map::linear(PointSpace::Space, rows.map(|row| row.map(Scalar::clone)))
            }
            _ => return Err(Stop::Reported),
        };
        let map = match places.next() {
            Some(((point, space), at)) => {
                let joined = self.joined(map.space, space, at.span)?;
                self.work(&map.scalars(), 3, span)?;
                map.of(joined).about(&point).map_err(|error| self.scalar_error(error, span))?
            }
            None => map,
        };
        Ok(Value::Map(Arc::new(map)))
    }

    /// Rodrigues' rotation about an axis through the origin.
    fn turn(&mut self, axis: &Triple, angle: &Scalar, arguments: &[Expr]) -> Outcome<Map> {
        let at = &arguments[0];
        let square = self.square(axis, at)?;
        let length = self.function(Native::Sqrt, &square, at)?;
        let sine = self.function(Native::Sin, angle, &arguments[1])?;
        let cosine = self.function(Native::Cos, angle, &arguments[1])?;
        let linear = || -> Result<[Triple; 3], ScalarError> {
            let along = Scalar::one().minus(&cosine)?.over(&square)?;
            let around = sine.over(&length)?;
            let basis = diagonal([Scalar::one(), Scalar::one(), Scalar::one()]);
            let mut columns = Vec::new();
            for (unit, part) in basis.iter().zip(axis) {
                let side = cross(axis, unit)?;
                let mut column = Vec::new();
                for ((unit, side), axis) in unit.iter().zip(&side).zip(axis) {
                    let still = product(&along, &product(part, axis)?)?;
                    let turned = product(&cosine, unit)?.plus(&product(&around, side)?)?;
                    column.push(turned.plus(&still)?);
                }
                columns.push(column);
            }
            let row = |row: usize| [0, 1, 2].map(|place: usize| columns[place][row].clone());
            Ok([row(0), row(1), row(2)])
        };
        let linear = linear().map_err(|error| self.scalar_error(error, at.span))?;
        Ok(Map::linear(PointSpace::Space, linear))
    }

    /// `p - 2 (p·u) u / (u·u)`
    fn mirror(&mut self, along: &Triple, space: PointSpace, at: &Expr) -> Outcome<Map> {
        let square = self.square(along, at)?;
        let linear = || -> Result<[Triple; 3], ScalarError> {
            let mut rows = diagonal([Scalar::one(), Scalar::one(), Scalar::one()]);
            for (row, a) in rows.iter_mut().zip(along) {
                for (entry, b) in row.iter_mut().zip(along) {
                    let part = product(&Scalar::integer(2), &product(a, b)?)?.over(&square)?;
                    *entry = entry.minus(&part)?;
                }
            }
            Ok(rows)
        };
        let linear = linear().map_err(|error| self.scalar_error(error, at.span))?;
        // Along `x` and `y` a mirror is at home in the plane too.
        let flat = space == PointSpace::Space && along[2] == Scalar::zero();
        Ok(Map::linear(if flat { PointSpace::Any } else { space }, linear))
    }

    /// The square of a direction's length, which is not zero.
    fn square(&mut self, direction: &Triple, at: &Expr) -> Outcome<Scalar> {
        self.work(direction, 3, at.span)?;
        let square = dot(direction, direction).map_err(|error| self.scalar_error(error, at.span))?;
        if square.is_zero() {
            let message = "a vector without length has no direction";
            let diagnostic = Diagnostic::new(Code::E0536, at.span, message).label("points nowhere");
            return Err(self.report(diagnostic.hint("use `x`, `y`, `z`, or a vector such as `(1m, 1m, 0m)`")));
        }
        Ok(square)
    }

    /// Coordinates, the third one 0 in the plane.
    pub(super) fn triple(&mut self, place: &Combination, at: Span) -> Outcome<(Triple, PointSpace)> {
        match &place.terms {
            Terms::Coordinates(numbers) => match numbers.as_slice() {
                [x, y] => Ok(([x.clone(), y.clone(), Scalar::zero()], PointSpace::Plane)),
                [x, y, z] => Ok(([x.clone(), y.clone(), z.clone()], PointSpace::Space)),
                _ => Err(Stop::Reported),
            },
            Terms::Weights(_) => Err(self.mixed("a map", "a combination of control points", at)),
        }
    }

    fn joined(&mut self, a: PointSpace, b: PointSpace, at: Span) -> Outcome<PointSpace> {
        a.join(b).ok_or_else(|| self.mixed(&a.thing("map"), &b.thing("point"), at))
    }

    fn mixed(&mut self, a: &str, b: &str, at: Span) -> Stop {
        let message = format!("{a} and {b} do not go together");
        let diagnostic = Diagnostic::new(Code::E0530, at, message).label(b.to_owned());
        self.report(diagnostic.hint("keep to the plane (two coordinates), or to space (three)"))
    }

    /// `map * …`
    pub(super) fn mapped(
        &mut self,
        map: &Arc<Map>,
        (right, thing): (&Expr, &Value),
        span: Span,
    ) -> Outcome<Value> {
        match thing {
            Value::Map(first) => Ok(Value::Map(Arc::new(self.composed(map, first, right.span)?))),
            Value::Combination(place) => {
                let (triple, space) = self.triple(place, right.span)?;
                self.joined(map.space, space, right.span)?;
                self.work(&map.scalars(), 1, span)?;
                let vector = matches!(right.ty, Type::Vector(_));
                let moved = if vector { map.turned(&triple) } else { map.moved(&triple) };
                let moved = moved.map_err(|error| self.scalar_error(error, span))?;
                let count = space.coordinates().unwrap_or(3);
                let terms = Terms::Coordinates(moved.into_iter().take(count).collect());
                let weight = if vector { Scalar::zero() } else { Scalar::one() };
                Ok(Value::Combination(Arc::new(Combination { terms, weight, made: None })))
            }
            Value::Ifs(ifs) => self.mapped_ifs(map, ifs, right.span),
            Value::Figure(figure) => self.mapped_figure(map, figure, right.span),
            _ => Err(Stop::Reported),
        }
    }

    fn composed(&mut self, map: &Map, first: &Map, at: Span) -> Outcome<Map> {
        let Some(space) = map.space.join(first.space) else {
            return Err(self.mixed(&map.space.thing("map"), &first.space.thing("map"), at));
        };
        self.work(&map.scalars(), first.scalars().iter().map(Scalar::cost).max().unwrap_or(1) * 3, at)?;
        map.after(first, space).map_err(|error| self.scalar_error(error, at))
    }

    fn mapped_ifs(&mut self, map: &Arc<Map>, ifs: &IfsValue, at: Span) -> Outcome<Value> {
        let (map, instance) = match ifs {
            IfsValue::Instance(instance) => (map.clone(), instance),
            IfsValue::Mapped(first, instance) => (Arc::new(self.composed(map, first, at)?), instance),
            _ => {
                let message = "a map moves an ifs in plane or in space; this is a product of two";
                let diagnostic =
                    Diagnostic::new(Code::E0531, at, message).label("on a grid of control points");
                return Err(self.report(diagnostic.hint("move the points it is placed on")));
            }
        };
        let space = self.instance_space(instance);
        if space == PointSpace::Control {
            let message = "a map moves an ifs in plane or in space; this one is on control points";
            let diagnostic = Diagnostic::new(Code::E0531, at, message).label("on control points");
            return Err(self.report(diagnostic.hint("move the points it is placed on")));
        }
        if map.space.join(space).is_none() {
            return Err(self.mixed(&map.space.thing("map"), &format!("an ifs {}", space.words()), at));
        }
        Ok(Value::Ifs(Arc::new(IfsValue::Mapped(map, instance.clone()))))
    }

    /// Where the ifs of an instance lives.
    pub(super) fn instance_space(&self, instance: &Instance) -> PointSpace {
        match &self.hir.item(instance.ifs).kind {
            ItemKind::Ifs(ifs) => ifs.space,
            _ => PointSpace::Control,
        }
    }

    fn mapped_figure(&mut self, map: &Map, figure: &Figure, at: Span) -> Outcome<Value> {
        let mut shape = figure.shape.clone();
        let space = match &shape {
            Shape::Curve { dimension: 2, .. } => PointSpace::Plane,
            Shape::Chain(chain) if chain.dimension == 2 => PointSpace::Plane,
            _ => PointSpace::Space,
        };
        if map.space.join(space).is_none() {
            return Err(self.mixed(&map.space.thing("map"), &space.thing("figure"), at));
        }
        match &mut shape {
            Shape::Curve { points, .. } | Shape::Sheet { net: points, .. } => {
                self.move_all(map, points, at)?
            }
            Shape::Chain(chain) => self.move_all(map, &mut chain.points, at)?,
            Shape::Net(net) => self.move_all(map, &mut net.grid.points, at)?,
            Shape::Swept(swept) => {
                match &mut swept.path {
                    SweptPath::Rail(rail, _) => self.move_all(map, &mut rail.chain.points, at)?,
                    SweptPath::Straight { vector, .. } => *vector = moved(map, *vector, 0.0)?,
                    SweptPath::Turn { .. } => {
                        let message = "a surface of revolution is not moved by a map";
                        let diagnostic =
                            Diagnostic::new(Code::E0531, at, message).label("turned round its axis");
                        return Err(
                            self.report(diagnostic.hint("move the points of its profile and its axis"))
                        );
                    }
                }
                self.move_all(map, &mut swept.profile.chain.points, at)?;
            }
        }
        Ok(Value::Figure(Arc::new(Figure { shape, ..figure.clone() })))
    }

    fn move_all(&mut self, map: &Map, points: &mut [[f64; 3]], at: Span) -> Outcome<()> {
        self.spend(points.len() as u64, at)?;
        for point in points {
            *point = moved(map, *point, 1.0)?;
        }
        Ok(())
    }

    /// An ifs of the plane or of space as a figure on its own frame, or on the frame that a map makes of it.
    pub(super) fn on_frame(&mut self, ifs: &IfsValue, at: Span) -> Outcome<Value> {
        let identity = Map::identity();
        let (map, instance) = match ifs {
            IfsValue::Instance(instance) => (&identity, instance),
            IfsValue::Mapped(map, instance) => (map.as_ref(), instance),
            _ => return Err(self.needs_points(at)),
        };
        let Some(axes) = self.instance_space(instance).coordinates() else {
            return Err(self.needs_points(at));
        };
        let mut points = Vec::new();
        for image in frame_images(map, axes).map_err(|error| self.scalar_error(error, at))? {
            let mut point = [0.0; 3];
            for (place, coordinate) in point.iter_mut().zip(&image) {
                *place = coordinate.to_f64().ok_or(Stop::Undetermined)?;
            }
            points.push(point);
        }
        let shape = Shape::Curve { ifs: instance.clone(), points, dimension: axes as u8 };
        Ok(Value::Figure(Arc::new(Figure { shape, level: None, span: at })))
    }

    fn needs_points(&mut self, at: Span) -> Stop {
        let message = "this ifs stands on control points, and they are not given";
        let diagnostic = Diagnostic::new(Code::E0531, at, message).label("where is it?");
        self.report(diagnostic.hint("put it on control points: `… on (p, q, …) at level 3`"))
    }
}

/// The images of the frame's points: the origin, and 1 mm from it along each of so many axes.
pub(super) fn frame_images(map: &Map, axes: usize) -> Result<Vec<Vec<Scalar>>, ScalarError> {
    let origin = [Scalar::zero(), Scalar::zero(), Scalar::zero()];
    let mut images = vec![map.moved(&origin)?.into_iter().take(axes).collect()];
    for axis in 0..axes {
        let mut point = origin.clone();
        point[axis] = Scalar::one();
        images.push(map.moved(&point)?.into_iter().take(axes).collect());
    }
    Ok(images)
}

/// The image of a point (weight 1) or of a vector (weight 0), mm.
fn moved(map: &Map, point: [f64; 3], weight: f64) -> Outcome<[f64; 3]> {
    let number = |scalar: &Scalar| scalar.to_f64().ok_or(Stop::Undetermined);
    let mut image = [0.0; 3];
    for ((place, row), offset) in image.iter_mut().zip(&map.linear).zip(&map.offset) {
        let [a, b, c] = [number(&row[0])?, number(&row[1])?, number(&row[2])?];
        *place = a * point[0] + b * point[1] + c * point[2] + weight * number(offset)?;
    }
    Ok(image)
}
