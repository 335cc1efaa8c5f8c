//! Germs worked out: their vertices as weights, bars with their section, and those an ifs finds itself.

use super::transform::Piece;
use super::{Evaluator, Frame, Outcome, Stop, words};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::map::{Triple, cross, dot, product};
use crate::hir::native::Native;
use crate::hir::scalar::{Scalar, ScalarError};
use crate::hir::tree::{Expr, Ifs};
use crate::hir::types::{PointSpace, Type};
use crate::hir::value::{Combination, Germ, GermShape, Instance, OwnGerm, Terms, Value};
use crate::source::Span;
use std::sync::Arc;

/// Work on long fractions that counts as a step.
const WORK_PER_STEP: u64 = 8;

/// How a germ is drawn, and the weights of its vertices.
pub(super) type Drawn = (GermShape, Vec<Vec<Scalar>>);

impl Evaluator<'_> {
    /// A function that makes a germ.
    pub(super) fn germ_of(&mut self, native: Native, values: &[Value], arguments: &[Expr]) -> Outcome<Value> {
        let points: &[Value] = match values {
            [Value::List(list)] => list,
            values => values,
        };
        let mut vertices: Vec<Arc<Combination>> = Vec::new();
        for point in points {
            if let Value::Combination(point) = point {
                vertices.push(point.clone());
            }
        }
        let shape = match native {
            Native::Point => GermShape::Point,
            Native::Segment => GermShape::Segment,
            Native::Polygon | Native::Quad => {
                if vertices.len() < 3 {
                    return Err(self.too_few_corners(vertices.len(), &arguments[0]));
                }
                GermShape::Polygon
            }
            Native::Strut => {
                let (Some(width), [start, end]) =
                    (values.last().and_then(Value::scalar), vertices.as_slice())
                else {
                    return Err(Stop::Reported);
                };
                let section = self.section(start, end, width, arguments)?;
                vertices.extend(section);
                GermShape::Strut { width: width.clone() }
            }
            _ => return Err(Stop::Reported),
        };
        Ok(Value::Germ(Arc::new(Germ { shape, vertices })))
    }

    fn too_few_corners(&mut self, corners: usize, list: &Expr) -> Stop {
        let message = format!("a polygon has three corners or more, not {corners}");
        let diagnostic = Diagnostic::new(Code::E0535, list.span, message).label("too few corners");
        self.report(diagnostic.hint("a line between two points is `segment(p, q)`"))
    }

    /// The start of a bar moved by half its width along each axis of its section, where the bar has coordinates. Of a
    /// bar in space the first axis is level, unless the bar is upright: then it is that of x.
    fn section(
        &mut self,
        start: &Combination,
        end: &Combination,
        width: &Scalar,
        arguments: &[Expr],
    ) -> Outcome<Vec<Arc<Combination>>> {
        let at = arguments.last().map_or(Span::default(), |width| width.span);
        if !self.order(width, &Scalar::zero(), at)?.is_gt() {
            let message = "the width of a bar is above 0";
            let is = words(width, &Type::LENGTH);
            let diagnostic = Diagnostic::new(Code::E0535, at, message).label(format!("is {is}"));
            return Err(self.report(diagnostic.hint("a line without width is `segment(p, q)`")));
        }
        if matches!((&start.terms, &end.terms), (Terms::Weights(_), _) | (_, Terms::Weights(_))) {
            return Ok(Vec::new());
        }
        let from = self.triple(start, arguments[0].span)?;
        let to = self.triple(end, arguments[1].span)?;
        if from.1 != to.1 {
            // Said where the germ is drawn.
            return Ok(Vec::new());
        }
        let error = |this: &mut Self, error: ScalarError| this.scalar_error(error, at);
        let along = difference(&to.0, &from.0).map_err(|stop| error(self, stop))?;
        if along.iter().all(Scalar::is_zero) {
            let message = "a bar needs some length: it starts where it ends";
            let diagnostic = Diagnostic::new(Code::E0535, arguments[1].span, message).label("the same point");
            return Err(self.report(diagnostic.also(arguments[0].span, "starts here")));
        }
        let whole = |values: [i64; 3]| values.map(Scalar::integer);
        let upright = along[0].is_zero() && along[1].is_zero();
        let level = if upright { Ok(whole([1, 0, 0])) } else { cross(&whole([0, 0, 1]), &along) };
        let level = level.map_err(|stop| error(self, stop))?;
        let mut axes = vec![level.clone()];
        if from.1 == PointSpace::Space {
            axes.push(cross(&along, &level).map_err(|stop| error(self, stop))?);
        }
        let mut section = Vec::new();
        for axis in axes {
            let square = dot(&axis, &axis).map_err(|stop| error(self, stop))?;
            let length = self.function(Native::Sqrt, &square, &arguments[1])?;
            let half = width
                .over(&Scalar::integer(2))
                .and_then(|half| half.over(&length))
                .map_err(|stop| error(self, stop))?;
            let moved = stepped(&from.0, &axis, &half).map_err(|stop| error(self, stop))?;
            let count = from.1.coordinates().unwrap_or(3);
            let terms = Terms::Coordinates(moved.into_iter().take(count).collect());
            section.push(Arc::new(Combination { terms, weight: Scalar::one(), made: None }));
        }
        Ok(section)
    }

    /// What an ifs draws, as weights on its control points.
    pub(super) fn germ(
        &mut self,
        frame: &mut Frame,
        ifs: &Ifs,
        (instance, pieces): (&Instance, &[Piece]),
        germ: &Expr,
    ) -> Outcome<Drawn> {
        match self.expr(frame, germ)? {
            Value::Germ(value) => {
                let vertices: Outcome<Vec<Vec<Scalar>>> = value
                    .vertices
                    .iter()
                    .map(|vertex| self.row(ifs.space, vertex, Code::E0532, germ.span))
                    .collect();
                let vertices = vertices?;
                let shape = match value.shape.clone() {
                    GermShape::Strut { width } => {
                        let width = self.taken_exactly(width);
                        GermShape::Strut {
                            width: width.map_err(|error| self.scalar_error(error, germ.span))?,
                        }
                    }
                    shape => shape,
                };
                Ok((shape, vertices))
            }
            Value::OwnGerm(OwnGerm::Control) => self.control_germ(ifs, germ.span),
            Value::OwnGerm(OwnGerm::Limit) => self.limit_germ(ifs, instance, pieces, germ.span),
            _ => Err(Stop::Reported),
        }
    }

    /// The segment between the two control points in the middle, which neighbouring windows of a net share.
    fn control_germ(&mut self, ifs: &Ifs, at: Span) -> Outcome<Drawn> {
        let count = self.points.len();
        if ifs.space != PointSpace::Control || count < 2 {
            let message = match ifs.space {
                PointSpace::Control => {
                    "the control germ joins two control points, and there is one".to_owned()
                }
                space => format!("an ifs {} has no control points to draw", space.words()),
            };
            let diagnostic = Diagnostic::new(Code::E0533, at, message).label("no control germ");
            return Err(self.report(diagnostic.hint("write what is drawn: `germ segment(p, q)`")));
        }
        let first = (count - 2) / 2;
        let unit = |place: usize| {
            (0..count).map(|other| if other == place { Scalar::one() } else { Scalar::zero() }).collect()
        };
        Ok((GermShape::Segment, vec![unit(first), unit(first + 1)]))
    }

    /// The segment from the point that the first transform keeps to the one that the last transform keeps.
    fn limit_germ(&mut self, ifs: &Ifs, instance: &Instance, pieces: &[Piece], at: Span) -> Outcome<Drawn> {
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return Err(Stop::Reported) };
        let mut ends = Vec::new();
        for (piece, which) in [(first, "first"), (last, "last")] {
            let transform = &ifs.transforms[piece.transform];
            if piece.target != *instance {
                let message = format!(
                    "there is no limit germ: the {which} transform, `{}`, continues with another ifs or with other \
                     arguments, so that it keeps no point",
                    transform.name
                );
                let diagnostic = Diagnostic::new(Code::E0533, at, message).label("ends nowhere");
                let diagnostic = diagnostic.also(transform.name_span, "continues with another");
                return Err(self.report(diagnostic.hint("write what is drawn: `germ segment(p, q)`")));
            }
            let mut rows = Vec::new();
            for row in &piece.rows {
                let row: Option<Vec<Rational>> = row.iter().map(Scalar::to_rational).collect();
                rows.push(row.ok_or(Stop::Undetermined)?);
            }
            let row = fixed_row(&rows, &mut |work| self.spend(work / WORK_PER_STEP, at))?;
            let Some(row) = row else {
                let message = format!(
                    "there is no limit germ: the {which} transform, `{}`, does not keep just one point",
                    transform.name
                );
                let diagnostic = Diagnostic::new(Code::E0533, at, message).label("no one point to end at");
                let diagnostic = diagnostic.also(transform.name_span, "keeps none, or many");
                return Err(self.report(diagnostic.hint("write what is drawn: `germ segment(p, q)`")));
            };
            ends.push(row.into_iter().map(Scalar::Exact).collect());
        }
        Ok((GermShape::Segment, ends))
    }
}

fn difference(a: &Triple, b: &Triple) -> Result<Triple, ScalarError> {
    Ok([a[0].minus(&b[0])?, a[1].minus(&b[1])?, a[2].minus(&b[2])?])
}

fn stepped(from: &Triple, axis: &Triple, by: &Scalar) -> Result<Triple, ScalarError> {
    let part = |place: usize| from[place].plus(&product(&axis[place], by)?);
    Ok([part(0)?, part(1)?, part(2)?])
}

/// The only row g of sum 1 with g · T = g (GEOMETRY 1, limit rows); `None` where there is none, or more than one.
///
/// By elimination on the columns of T - 1 with the sum as one more equation.
/// `spend` is told of the work before it is done.
fn fixed_row(
    matrix: &[Vec<Rational>],
    spend: &mut dyn FnMut(u64) -> Outcome<()>,
) -> Outcome<Option<Vec<Rational>>> {
    let count = matrix.len();
    let (zero, one) = (Rational::from(0), Rational::from(1));
    if matrix.iter().any(|row| row.len() != count) {
        return Ok(None);
    }
    let mut equations: Vec<Vec<Rational>> = (0..count)
        .map(|column| {
            let weight = |row: usize| match row == column {
                true => &matrix[row][column] - &one,
                false => matrix[row][column].clone(),
            };
            (0..count).map(weight).chain([zero.clone()]).collect()
        })
        .collect();
    equations.push(vec![one.clone(); count + 1]);
    for pivot in 0..count {
        let Some(found) = (pivot..equations.len()).find(|row| !equations[*row][pivot].is_zero()) else {
            return Ok(None);
        };
        equations.swap(pivot, found);
        let lead = equations[pivot][pivot].clone();
        for entry in &mut equations[pivot] {
            spend(work(entry, &lead))?;
            *entry = entry.checked_div(&lead).map_err(|_| Stop::Reported)?;
        }
        let leading = equations[pivot].clone();
        for (_, equation) in equations.iter_mut().enumerate().filter(|(row, _)| *row != pivot) {
            let factor = equation[pivot].clone();
            if factor.is_zero() {
                continue;
            }
            for (entry, lead) in equation.iter_mut().zip(&leading).filter(|(_, lead)| !lead.is_zero()) {
                spend(work(&factor, lead))?;
                *entry = &*entry - &(&factor * lead);
            }
        }
    }
    let consistent = equations[count..].iter().all(|equation| equation[count].is_zero());
    Ok(consistent.then(|| equations[..count].iter().map(|equation| equation[count].clone()).collect()))
}

/// What a product costs: the square of its words, since it is brought to lowest terms.
fn work(a: &Rational, b: &Rational) -> u64 {
    let words = (a.bits() + b.bits()) / 64 + 1;
    words.saturating_mul(words)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[&[i64]], over: i64) -> Vec<Vec<Rational>> {
        let number = |n: &i64| Rational::new(*n, over).unwrap();
        rows.iter().map(|row| row.iter().map(number).collect()).collect()
    }

    fn fixed(matrix: &[Vec<Rational>]) -> Option<Vec<Rational>> {
        fixed_row(matrix, &mut |_| Ok(())).unwrap()
    }

    #[test]
    fn the_cubic_b_spline_ends_at_its_limit_rows() {
        let left = matrix(&[&[4, 4, 0, 0], &[1, 6, 1, 0], &[0, 4, 4, 0], &[0, 1, 6, 1]], 8);
        assert_eq!(fixed(&left), Some(matrix(&[&[1, 4, 1, 0]], 6).remove(0)));
        let right = matrix(&[&[1, 6, 1, 0], &[0, 4, 4, 0], &[0, 1, 6, 1], &[0, 0, 4, 4]], 8);
        assert_eq!(fixed(&right), Some(matrix(&[&[0, 1, 4, 1]], 6).remove(0)));
    }

    #[test]
    fn a_matrix_that_keeps_many_points_or_none_has_no_limit_row() {
        assert_eq!(fixed(&matrix(&[&[1, 0], &[0, 1]], 1)), None);
        // A translation: (0, 0) goes to (1, 0), (1, 0) to (2, 0).
        assert_eq!(fixed(&matrix(&[&[0, 1], &[-1, 2]], 1)), None);
    }

    #[test]
    fn the_work_on_long_fractions_is_counted_before_it_is_done() {
        let count = 100_i64;
        let weight =
            |row: i64, column: i64| Rational::new((row * 37 + column * 61) % 97 + 1, 997 + row).unwrap();
        let dense: Vec<Vec<Rational>> =
            (0..count).map(|row| (0..count).map(|column| weight(row, column)).collect()).collect();
        let mut left = 1_000_000_u64;
        let outcome = fixed_row(&dense, &mut |work| {
            left = left.checked_sub(work).ok_or(Stop::Reported)?;
            Ok(())
        });
        assert_eq!(outcome, Err(Stop::Reported));
    }
}
