//! The functions of the program itself. Transcendental functions go through libm, and through exact values at the
//! angles that have them.

use super::combination::exactly;
use super::{Evaluator, Frame, Outcome, Stop};
use crate::diagnostic::{Code, Diagnostic};
use crate::exact::Rational;
use crate::hir::native::Native;
use crate::hir::scalar::{Scalar, ScalarError};
use crate::hir::tree::Expr;
use crate::hir::types::Type;
use crate::hir::value::{Combination, IfsValue, Terms, Value};
use crate::source::Span;
use std::sync::Arc;

impl Evaluator<'_> {
    pub(super) fn native(
        &mut self,
        frame: &mut Frame,
        native: Native,
        arguments: &[Expr],
        expr: &Expr,
    ) -> Outcome<Value> {
        let values = self.all(frame, arguments)?;
        let span = expr.span;
        match native {
            Native::Translate
            | Native::Rotate
            | Native::Turn
            | Native::Scale
            | Native::Mirror
            | Native::Affine => return self.map(native, &values, arguments, span),
            Native::Point | Native::Segment | Native::Polygon | Native::Quad | Native::Strut => {
                return self.germ_of(native, &values, arguments);
            }
            Native::Mesh => return self.mesh_germ(&values, arguments),
            _ => {}
        }
        let value = match (native, values.as_slice()) {
            (Native::Lerp, [Value::Combination(a), Value::Combination(b), Value::Scalar(t)]) => {
                return self.lerp(a, b, t, span);
            }
            (Native::Tensor, [u, v]) => {
                let factors = (self.factor(u, arguments[0].span)?, self.factor(v, arguments[1].span)?);
                return match factors {
                    (Some(u), Some(v)) => Ok(Value::Ifs(Arc::new(IfsValue::Tensor(u, v)))),
                    _ => Err(Stop::Reported),
                };
            }
            (Native::Sheet, [u, v, net, closed @ ..]) => {
                let places = [arguments[0].span, arguments[1].span, arguments[2].span];
                return self.sheet([u, v, net], closed.first(), places, span);
            }
            (Native::Chain, [ifs, points, closed @ ..]) => {
                let places = [arguments[0].span, arguments[1].span];
                return self.chain([ifs, points], closed.first(), places, span);
            }
            (Native::Weighted, [Value::Combination(point), Value::Scalar(weight)]) => {
                return self.weighted(point, weight, arguments[1].span);
            }
            (
                Native::Translation
                | Native::ScaleTranslation
                | Native::ProjectiveSum
                | Native::Revolution
                | Native::Extrusion,
                values,
            ) => return self.swept(native, values, arguments, span),
            (Native::Plane, [point, normal]) => return self.plane(point, normal, arguments),
            (Native::Cut, [Value::Plane(plane)]) => return Ok(Value::Cut(plane.clone())),
            (Native::Len, [Value::List(list)]) => Scalar::integer(list.len() as i64),
            (Native::Sum, [Value::List(list)]) if matches!(list.first(), Some(Value::Combination(_))) => {
                return self.sum_of_combinations(list, span);
            }
            (Native::Sum, [Value::List(list)]) => self.sum(list, span)?,
            (Native::Concat, [Value::List(lists)]) => return self.concat(lists, span),
            (Native::Reverse, [Value::List(list)]) => {
                self.spend(list.len() as u64, span)?;
                return Ok(Value::List(Arc::new(list.iter().rev().cloned().collect())));
            }
            (Native::Transpose, [Value::List(grid)]) => return self.transpose(grid, &arguments[0]),
            (Native::Text, [value]) => return self.text(value, &arguments[0]),
            (
                Native::Norm
                | Native::Distance
                | Native::Dot
                | Native::Toward
                | Native::WithLength
                | Native::Perpendicular,
                values,
            ) => return self.vectors(native, values, arguments, span),
            (
                Native::Asin
                | Native::Acos
                | Native::Atan
                | Native::Atan2
                | Native::Exp
                | Native::Ln
                | Native::Pow
                | Native::Ceil
                | Native::Mod,
                values,
            ) => {
                let numbers: Vec<&Scalar> = values.iter().filter_map(Value::scalar).collect();
                self.maths(native, &numbers, arguments)?
            }
            (Native::Mean, [Value::List(list)]) => self.mean(list, &arguments[0])?,
            (Native::All, [Value::List(list)]) => {
                return Ok(Value::Bool(list.iter().all(|value| *value == Value::Bool(true))));
            }
            (Native::Any, [Value::List(list)]) => {
                return Ok(Value::Bool(list.contains(&Value::Bool(true))));
            }
            (Native::Close, [Value::Scalar(a), Value::Scalar(b), Value::Scalar(within)]) => {
                return self.close(a, b, within, span).map(Value::Bool);
            }
            (Native::Min | Native::Max, [Value::List(list)]) => self.extreme(native, list, &arguments[0])?,
            (Native::Min | Native::Max, [a, b]) => self.extreme(native, &[a.clone(), b.clone()], expr)?,
            (Native::Interpolate, [Value::Scalar(x), Value::List(table)]) => {
                self.interpolate(x, table, arguments)?
            }
            (native, [Value::Scalar(x)]) => self.function(native, x, &arguments[0])?,
            _ => return Err(Stop::Reported),
        };
        let inside = frame.own_ifs.is_some() && expr.ty == Type::NUMBER;
        let value = if inside {
            self.taken_exactly(value).map_err(|error| self.scalar_error(error, span))?
        } else {
            value
        };
        Ok(Value::Scalar(value))
    }

    pub(super) fn sum(&mut self, list: &[Value], span: Span) -> Outcome<Scalar> {
        let mut total = Scalar::zero();
        for value in list.iter().filter_map(Value::scalar) {
            self.step(span)?;
            total = total.plus(value).map_err(|error| self.scalar_error(error, span))?;
        }
        Ok(total)
    }

    fn extreme(&mut self, native: Native, list: &[Value], at: &Expr) -> Outcome<Scalar> {
        let mut best: Option<Scalar> = None;
        for value in list.iter().filter_map(Value::scalar) {
            self.step(at.span)?;
            let better = match &best {
                None => true,
                Some(best) => {
                    let order = self.order(value, best, at.span)?;
                    if native == Native::Min { order.is_lt() } else { order.is_gt() }
                }
            };
            if better {
                best = Some(value.clone());
            }
        }
        best.ok_or_else(|| {
            let message = format!("`{}` of an empty list", native.declaration().name);
            let diagnostic = Diagnostic::new(Code::E0604, at.span, message).label("no elements");
            self.report(diagnostic.hint("is the range or the `if` of the list right?"))
        })
    }

    fn interpolate(&mut self, x: &Scalar, table: &[Value], arguments: &[Expr]) -> Outcome<Scalar> {
        let mut rows: Vec<(Scalar, Scalar)> = Vec::new();
        for row in table {
            match row {
                Value::Combination(row) => match &row.as_ref() {
                    Combination { terms: Terms::Coordinates(row), .. } if row.len() == 2 => {
                        rows.push((row[0].clone(), row[1].clone()));
                    }
                    _ => return Err(Stop::Reported),
                },
                _ => return Err(Stop::Reported),
            }
        }
        let span = arguments[0].span;
        for pair in rows.windows(2) {
            if !self.order(&pair[0].0, &pair[1].0, span)?.is_lt() {
                let message = "the first coordinates of a table rise from row to row";
                let diagnostic =
                    Diagnostic::new(Code::E0604, arguments[1].span, message).label("do not rise");
                return Err(self.report(diagnostic));
            }
        }
        for pair in rows.windows(2) {
            let inside = self.order(&pair[0].0, x, span)?.is_le() && self.order(x, &pair[1].0, span)?.is_le();
            if inside {
                let line = || {
                    let part = x.minus(&pair[0].0)?.over(&pair[1].0.minus(&pair[0].0)?)?;
                    pair[0].1.plus(&pair[1].1.minus(&pair[0].1)?.times(&part)?)
                };
                return line().map_err(|error| self.scalar_error(error, span));
            }
        }
        let words = |scalar: &Scalar| super::words(scalar, &Type::LENGTH);
        let ends = match (rows.first(), rows.last()) {
            (Some(first), Some(last)) => format!("from {} to {}", words(&first.0), words(&last.0)),
            _ => "nowhere".to_owned(),
        };
        let message = format!("{} is beyond the table, which goes {ends}", words(x));
        let diagnostic = Diagnostic::new(Code::E0604, span, message).label(format!("is {}", words(x)));
        Err(self.report(diagnostic.hint(format!("use a value {ends}"))))
    }

    pub(super) fn function(&mut self, native: Native, x: &Scalar, argument: &Expr) -> Outcome<Scalar> {
        let span = argument.span;
        if let Scalar::Symbolic(_) = x
            && x.to_rational().is_none()
        {
            return match native {
                Native::Floor | Native::Round => Err(Stop::Undetermined),
                _ => Ok(self.opaque(native.declaration().name, x)),
            };
        }
        let outcome = match native {
            Native::Sin => sine(x),
            Native::Cos => half_turn_over_two().plus(&x.negated()).and_then(|x| sine(&x)),
            Native::Tan => tangent(x),
            Native::Abs => {
                let negative = self.order(x, &Scalar::zero(), span)?.is_lt();
                Ok(if negative { x.negated() } else { x.clone() })
            }
            Native::Floor => whole(x, 0),
            Native::Round => whole(x, 1),
            Native::Sqrt => {
                if self.order(x, &Scalar::zero(), span)?.is_lt() {
                    let message = "there is no square root of a number below 0";
                    let is = super::words(x, &argument.ty);
                    let diagnostic = Diagnostic::new(Code::E0604, span, message).label(format!("is {is}"));
                    return Err(self.report(diagnostic.hint("do the lengths fit each other?")));
                }
                square_root(x)
            }
            _ => return Err(Stop::Reported),
        };
        outcome.map_err(|error| self.scalar_error(error, span))
    }
}

fn half_turn_over_two() -> Scalar {
    Scalar::Pi(Rational::new(1, 2).unwrap_or_default())
}

/// The sine; exact where the angle is a multiple of 30 degrees whose sine is rational, else rounded after an exact
/// reduction of multiples of π, so that sin(180deg - x) is sin(x) to the bit.
fn sine(angle: &Scalar) -> Result<Scalar, ScalarError> {
    let Scalar::Pi(turns) = angle else {
        let value = angle.to_f64().ok_or(ScalarError::Undetermined)?;
        return Scalar::real(libm::sin(value));
    };
    let two = Rational::from(2);
    let over = |a: &Rational, b: i64| a.checked_div(&Rational::from(b)).unwrap_or_default();
    // r in [0, 2): the angle is r times π.
    let mut r = turns - &(&over(turns, 2).floor() * &two);
    let one = Rational::from(1);
    let negative = r >= one;
    if negative {
        r = &r - &one;
    }
    if &r + &r > one {
        r = &one - &r;
    }
    // r in [0, 1/2].
    let twelfths = &r * &Rational::from(6);
    let value = match twelfths.to_i64() {
        Some(0) => Scalar::zero(),
        Some(1) => Scalar::Exact(over(&one, 2)),
        Some(3) => Scalar::one(),
        _ if &r * &Rational::from(4) <= one => Scalar::real(libm::sin(r.to_f64() * core::f64::consts::PI))?,
        _ => {
            let rest = &over(&one, 2) - &r;
            Scalar::real(libm::cos(rest.to_f64() * core::f64::consts::PI))?
        }
    };
    Ok(if negative { value.negated() } else { value })
}

fn tangent(angle: &Scalar) -> Result<Scalar, ScalarError> {
    match angle {
        Scalar::Pi(_) => {
            let cosine = half_turn_over_two().minus(angle).and_then(|angle| sine(&angle))?;
            sine(angle)?.over(&cosine)
        }
        _ => Scalar::real(libm::tan(angle.to_f64().ok_or(ScalarError::Undetermined)?)),
    }
}

pub(super) fn whole(x: &Scalar, halves_added: i64) -> Result<Scalar, ScalarError> {
    let value = exactly(x.clone())?.to_rational().ok_or(ScalarError::Undetermined)?;
    let half = Rational::new(halves_added, 2).unwrap_or_default();
    Ok(Scalar::Exact((&value + &half).floor()))
}

pub(super) fn square_root(x: &Scalar) -> Result<Scalar, ScalarError> {
    let value = x.to_f64().ok_or(ScalarError::Undetermined)?;
    let root = value.sqrt();
    if let (Some(exact), Some(candidate)) = (x.to_rational(), Rational::from_f64(root))
        && &candidate * &candidate == exact
    {
        return Ok(Scalar::Exact(candidate));
    }
    Scalar::real(root)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn degrees(n: i64) -> Scalar {
        Scalar::Pi(Rational::new(n, 180).unwrap())
    }

    #[test]
    fn sines_are_exact_where_they_can_be_and_symmetric() {
        assert_eq!(sine(&degrees(30)), Ok(Scalar::Exact(Rational::new(1, 2).unwrap())));
        assert_eq!(sine(&degrees(150)), Ok(Scalar::Exact(Rational::new(1, 2).unwrap())));
        assert_eq!(sine(&degrees(-90)), Ok(Scalar::integer(-1)));
        assert_eq!(sine(&degrees(180)), Ok(Scalar::zero()));
        for angle in 1..360 {
            let value = sine(&degrees(angle)).unwrap().to_f64().unwrap();
            assert!((value - libm::sin(f64::from(angle as i32).to_radians())).abs() < 2e-16 * 4.0, "{angle}");
            assert_eq!(sine(&degrees(angle)), sine(&degrees(180 - angle)), "{angle}");
        }
    }

    #[test]
    fn rounding_goes_halves_up() {
        let half = Scalar::Exact(Rational::new(5, 2).unwrap());
        assert_eq!(whole(&half, 1), Ok(Scalar::integer(3)));
        assert_eq!(whole(&half.negated(), 1), Ok(Scalar::integer(-2)));
        assert_eq!(whole(&half.negated(), 0), Ok(Scalar::integer(-3)));
    }
}
