//! An ifs put on control points, and figures at a level.

use super::{Evaluator, Frame, MustJoin, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::placed::{Chain, ControlGrid, ControlList, Net, SweptPath};
use crate::hir::tree::Expr;
use crate::hir::types::PointSpace;
use crate::hir::value::{Figure, IfsValue, Instance, Level, Shape, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn on(
        &mut self,
        frame: &mut Frame,
        ifs: &Expr,
        points: &Expr,
        at: Span,
        span: Span,
    ) -> Outcome<Value> {
        let ifs_value = self.expr(frame, ifs)?;
        let points = self.expr(frame, points)?;
        let Value::Ifs(ifs_value) = ifs_value else { return Err(Stop::Reported) };
        let shape = match ifs_value.as_ref() {
            IfsValue::Instance(instance) => self.curve((instance, ifs.span), &points, at)?,
            IfsValue::Tensor(u, v) => self.patch([u, v], ifs.span, &points, at)?,
            IfsValue::Mapped(_, instance) => return Err(self.no_points(instance, at)),
        };
        Ok(Value::Figure(Arc::new(Figure { shape, level: None, span })))
    }

    fn no_points(&mut self, instance: &Instance, at: Span) -> Stop {
        let space = self.instance_space(instance).words();
        let message = format!("an ifs {space} has no control points to be placed on");
        let diagnostic = Diagnostic::new(Code::E0531, at, message).label("no place for points");
        self.report(diagnostic.hint("it is placed by a map: `translate(…) * name at level 4`"))
    }

    fn curve(&mut self, (instance, ifs_at): (&Instance, Span), points: &Value, at: Span) -> Outcome<Shape> {
        if self.instance_space(instance) != PointSpace::Control {
            return Err(self.no_points(instance, at));
        }
        let list = points.list().ok_or(Stop::Reported)?;
        let needed = self.control_points(instance, ifs_at)?;
        if list.first().is_some_and(|first| first.list().is_some()) {
            let message = "a curve is placed on a list of control points, not on a grid";
            let diagnostic = Diagnostic::new(Code::E0510, at, message).label("a grid");
            return Err(self.report(diagnostic.hint("use `tensor(…, …) on` the grid, or one row of it")));
        }
        if list.len() != needed {
            let name = self.hir.item(instance.ifs).name.clone();
            let declared = self.hir.item(instance.ifs).name_span;
            let message =
                format!("`{name}` is placed on {needed} control points, but {} are given", list.len());
            let label =
                if list.len() == 1 { "one point".to_owned() } else { format!("{} points", list.len()) };
            let diagnostic =
                Diagnostic::new(Code::E0504, at, message).label(label).also(declared, "declared here");
            let hint = match list.len() > needed {
                true => format!("take a part of the list: `[0..{needed}]`"),
                false => "add the points that are missing".to_owned(),
            };
            return Err(self.report(diagnostic.hint(hint)));
        }
        let ControlList { points, weights, dimension } = self.placed(list, at)?;
        let ifs = instance.clone();
        if weights.is_none() {
            return Ok(Shape::Curve { ifs, points, dimension });
        }
        let chain = Chain { ifs, points, weights, dimension, windows: false, closed: false };
        Ok(Shape::Chain(Box::new(chain)))
    }

    fn patch(&mut self, [u, v]: [&Instance; 2], ifs_at: Span, points: &Value, at: Span) -> Outcome<Shape> {
        let grid = self.net(points, at)?;
        let (rows, columns) = (grid.rows, grid.columns);
        let needed = (self.control_points(u, ifs_at)?, self.control_points(v, ifs_at)?);
        if (rows, columns) != needed {
            let message = format!(
                "this product is placed on a grid of {} by {} control points, but the grid is {rows} by {columns}",
                needed.0, needed.1
            );
            let diagnostic = Diagnostic::new(Code::E0510, at, message).label(format!("{rows} by {columns}"));
            let hint =
                format!("take a part of it, such as `[0..{}, 0..{}]`, or use `sheet`", needed.0, needed.1);
            return Err(self.report(diagnostic.hint(hint)));
        }
        Ok(on_net(u.clone(), v.clone(), grid, false, (false, false)))
    }

    /// `sheet(u, v, net)`
    pub(super) fn sheet(
        &mut self,
        values: [&Value; 3],
        closed: Option<&Value>,
        places: [Span; 3],
        span: Span,
    ) -> Outcome<Value> {
        let ([u, v, net], [u_at, v_at, at]) = (values, places);
        let (Some(u), Some(v)) = (self.factor(u, u_at)?, self.factor(v, v_at)?) else {
            return Err(Stop::Reported);
        };
        let grid = self.net(net, at)?;
        let (rows, columns) = (grid.rows, grid.columns);
        let needed = (self.control_points(&u, u_at)?, self.control_points(&v, v_at)?);
        if rows < needed.0 || columns < needed.1 {
            let message = format!(
                "a sheet needs a net of at least {} by {} control points, but this one is {rows} by {columns}",
                needed.0, needed.1
            );
            let diagnostic = Diagnostic::new(Code::E0510, at, message).label(format!("{rows} by {columns}"));
            return Err(self.report(diagnostic.hint("add rows or columns of control points")));
        }
        let closed = match closed {
            Some(Value::Choice(_, place)) => (*place != 1, *place != 0),
            _ => (false, false),
        };
        let shape = on_net(u, v, grid, true, closed);
        Ok(Value::Figure(Arc::new(Figure { shape, level: None, span })))
    }

    /// `chain(ifs, points)`
    pub(super) fn chain(
        &mut self,
        [ifs, points]: [&Value; 2],
        closed: Option<&Value>,
        [ifs_at, at]: [Span; 2],
        span: Span,
    ) -> Outcome<Value> {
        let Value::Ifs(ifs) = ifs else { return Err(Stop::Reported) };
        let IfsValue::Instance(ifs) = ifs.as_ref() else {
            let message = "a chain is made of curves, not of surfaces";
            let diagnostic = Diagnostic::new(Code::E0510, ifs_at, message).label("a surface");
            return Err(self.report(diagnostic.hint("name the ifs of a curve, such as `bspline3`")));
        };
        let why = "a chain is a curve".to_owned();
        self.must_join.push(MustJoin { ifs: ifs.clone(), span: ifs_at, why });
        let list = points.list().ok_or(Stop::Reported)?;
        let needed = self.control_points(ifs, ifs_at)?;
        if list.len() < needed {
            let message =
                format!("a chain needs at least {needed} control points, but there are {}", list.len());
            let diagnostic =
                Diagnostic::new(Code::E0510, at, message).label(format!("{} points", list.len()));
            return Err(self.report(diagnostic.hint("add control points")));
        }
        let ControlList { points, weights, dimension } = self.placed(list, at)?;
        let closed = matches!(closed, Some(Value::Bool(true)));
        let chain = Chain { ifs: ifs.clone(), points, weights, dimension, windows: true, closed };
        Ok(Value::Figure(Arc::new(Figure { shape: Shape::Chain(Box::new(chain)), level: None, span })))
    }

    /// A factor of a product: one ifs whose pieces join.
    pub(super) fn factor(&mut self, value: &Value, span: Span) -> Outcome<Option<Instance>> {
        let Value::Ifs(ifs) = value else { return Ok(None) };
        match ifs.as_ref() {
            IfsValue::Mapped(_, instance) => Err(self.no_factor(instance, span)),
            IfsValue::Instance(instance) if self.instance_space(instance) != PointSpace::Control => {
                Err(self.no_factor(instance, span))
            }
            IfsValue::Instance(instance) => {
                let why = "a surface is a product of curves".to_owned();
                self.must_join.push(MustJoin { ifs: instance.clone(), span, why });
                Ok(Some(instance.clone()))
            }
            IfsValue::Tensor(..) => {
                let message = "a surface is the product of two curves, not of surfaces";
                let diagnostic = Diagnostic::new(Code::E0510, span, message).label("a surface already");
                Err(self.report(diagnostic.hint("name the ifs of a curve, such as `bezier3`")))
            }
        }
    }

    fn no_factor(&mut self, instance: &Instance, span: Span) -> Stop {
        let space = self.instance_space(instance).words();
        let message = format!("a surface is a product of curves on control points; this ifs lives {space}");
        let diagnostic = Diagnostic::new(Code::E0531, span, message).label(format!("an ifs {space}"));
        self.report(diagnostic.hint("name the ifs of a curve, such as `bezier3`"))
    }

    pub(super) fn at(
        &mut self,
        frame: &mut Frame,
        figure: &Expr,
        u: &Expr,
        v: Option<&Expr>,
    ) -> Outcome<Value> {
        let Value::Figure(value) = self.expr(frame, figure)? else { return Err(Stop::Reported) };
        let level = self.level(frame, u)?;
        let second = match v {
            Some(v) => Some(self.level(frame, v)?),
            None => None,
        };
        let span = v.map_or(u.span, |v| u.span.to(v.span));
        let of_one = match &value.shape {
            Shape::Curve { .. } | Shape::Chain(_) => Some("a curve has one level, not two"),
            Shape::Swept(swept) if !matches!(swept.path, SweptPath::Rail(..)) => {
                Some("this surface has one level, that of its profile, not two")
            }
            _ => None,
        };
        if let (Some(_), Some(message)) = (second, of_one) {
            let diagnostic = Diagnostic::new(Code::E0604, span, message).label("two levels");
            return Err(self.report(diagnostic.hint(format!("write `at level {level}`"))));
        }
        let level = Some(Level { u: level, v: second, until: None, span });
        Ok(Value::Figure(Arc::new(Figure { level, ..value.as_ref().clone() })))
    }

    fn level(&mut self, frame: &mut Frame, level: &Expr) -> Outcome<u32> {
        let value = self.integer(frame, level)?;
        if value < 0 {
            let message = format!("a level is 0 or more, but this is {value}");
            let diagnostic = Diagnostic::new(Code::E0604, level.span, message).label("below 0");
            return Err(self.report(diagnostic.hint("level 0 is the germ itself on the control points")));
        }
        Ok(u32::try_from(value).unwrap_or(u32::MAX))
    }
}

/// A product on a net: the plain form where the net is open and has no weights.
fn on_net(u: Instance, v: Instance, grid: ControlGrid, windows: bool, closed: (bool, bool)) -> Shape {
    if grid.weights.is_none() && closed == (false, false) {
        let ControlGrid { points: net, rows, columns, .. } = grid;
        return Shape::Sheet { u, v, net, rows, columns, windows };
    }
    Shape::Net(Box::new(Net { u, v, grid, windows, closed }))
}
