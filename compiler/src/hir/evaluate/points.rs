//! Control points as doubles: lists and nets of them, and their weights.

use super::{Evaluator, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::placed::{ControlGrid, ControlList};
use crate::hir::scalar::Scalar;
use crate::hir::value::{Combination, Terms, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    /// `weighted(point, w)`
    pub(super) fn weighted(&mut self, point: &Arc<Combination>, w: &Scalar, at: Span) -> Outcome<Value> {
        let weight = w.to_f64().ok_or(Stop::Undetermined)?;
        if weight > 0.0 && weight.is_finite() {
            return Ok(Value::Weighted(point.clone(), weight));
        }
        let message = format!("the weight of a control point is above 0, but this is {weight}");
        let diagnostic = Diagnostic::new(Code::E0520, at, message).label(format!("is {weight}"));
        let hint = "a point without a weight has the weight 1; a smaller one draws the figure less towards its point";
        Err(self.report(diagnostic.hint(hint)))
    }

    /// The points of a net: rows of one length, in space.
    pub(super) fn net(&mut self, points: &Value, at: Span) -> Outcome<ControlGrid> {
        let rows = points.list().ok_or(Stop::Reported)?;
        let columns = rows.first().and_then(Value::list).map_or(0, <[Value]>::len);
        if rows.is_empty()
            || (columns == 0 && rows.iter().all(|row| row.list().is_some_and(<[Value]>::is_empty)))
        {
            let diagnostic = Diagnostic::new(Code::E0510, at, "the net has no points").label("empty");
            return Err(self.report(diagnostic.hint("a net is a list of rows: `[[(0m, 0m, 0m), …], …]`")));
        }
        let mut net = Vec::new();
        let mut weights: Option<Vec<f64>> = None;
        for (index, row) in rows.iter().enumerate() {
            let Some(row) = row.list() else {
                let message = "a surface is placed on a grid: a list of rows of control points";
                let diagnostic = Diagnostic::new(Code::E0510, at, message).label("a plain list");
                return Err(self.report(
                    diagnostic.hint("a grid is a list of lists: `[[… for j in 0..4] for i in 0..4]`"),
                ));
            };
            if row.len() != columns {
                let message = format!("row {index} of the net has {} points, row 0 has {columns}", row.len());
                let diagnostic = Diagnostic::new(Code::E0510, at, message).label("rows of different lengths");
                return Err(self.report(diagnostic.hint("every row of a net has the same number of points")));
            }
            let ControlList { points, weights: heavy, dimension } = self.placed(row, at)?;
            if dimension != 3 {
                let message = "the control points of a surface have three coordinates";
                let diagnostic = Diagnostic::new(Code::E0510, at, message).label("two coordinates");
                return Err(self.report(diagnostic.hint("give every point a height: `(x, y, z)`")));
            }
            join_weights(&mut weights, net.len(), heavy, points.len());
            net.extend(points);
        }
        Ok(ControlGrid { points: net, weights, rows: rows.len(), columns })
    }

    /// Coordinates as doubles, with how many of them there are, and weights where a point has one.
    pub(super) fn placed(&mut self, points: &[Value], at: Span) -> Outcome<ControlList> {
        let mut placed = Vec::with_capacity(points.len());
        let mut weights: Option<Vec<f64>> = None;
        let mut dimension = 0;
        for point in points {
            let (point, weight) = match point {
                Value::Combination(point) => (point, None),
                Value::Weighted(point, weight) => (point, Some(vec![*weight])),
                _ => return Err(Stop::Reported),
            };
            let (point, count) = self.coordinates_of(point)?;
            if dimension != 0 && dimension != count {
                let message = "points of the plane and points in space do not mix";
                let diagnostic = Diagnostic::new(Code::E0402, at, message).label("two and three coordinates");
                return Err(self.report(diagnostic.hint("give every point the same number of coordinates")));
            }
            dimension = count;
            join_weights(&mut weights, placed.len(), weight, 1);
            placed.push(point);
        }
        Ok(ControlList { points: placed, weights, dimension })
    }

    /// Two or three coordinates as doubles, and how many they are.
    pub(super) fn coordinates_of(&mut self, point: &Combination) -> Outcome<([f64; 3], u8)> {
        let Terms::Coordinates(coordinates) = &point.terms else { return Err(Stop::Reported) };
        let mut out = [0.0; 3];
        for (place, coordinate) in out.iter_mut().zip(coordinates) {
            *place = coordinate.to_f64().ok_or(Stop::Undetermined)?;
        }
        Ok((out, coordinates.len() as u8))
    }
}

/// Puts `more` weights behind the `known` ones of `before` points; a point without a weight has the weight 1.
fn join_weights(known: &mut Option<Vec<f64>>, before: usize, more: Option<Vec<f64>>, count: usize) {
    match (known.as_mut(), more) {
        (None, None) => {}
        (Some(known), None) => known.resize(before + count, 1.0),
        (Some(known), Some(more)) => known.extend(more),
        (None, Some(more)) => {
            let mut weights = vec![1.0; before];
            weights.extend(more);
            *known = Some(weights);
        }
    }
}
