//! Weights of a point that do not sum to 1: what is missing is given to one of the points, as an exact fraction, or the sum
//! is divided by what it comes to.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::exact::Rational;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{BinaryOperator, Expr, ExprKind, UnaryOperator, Unit};

use super::tree::expression_at;
use crate::features::words::written;

/// At most so many points are offered one by one.
const MOST_POINTS: usize = 6;

/// A part of a sum that is added or subtracted.
struct Term<'e> {
    expr: &'e Expr,
    sign: i64,
}

/// Each point of the sum with what it needs, and the sum divided.
pub(super) fn completed(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    // Where the sum is made, if that is another place than where a point is needed.
    let made = found.labels.first().map_or(found.span, |label| label.span);
    let Some(sum) = expression_at(analysis, made) else { return Vec::new() };
    let mut terms = Vec::new();
    collect(sum, 1, &mut terms);
    let weights: Option<Vec<Rational>> = terms
        .iter()
        .map(|term| weight(analysis, term.expr).map(|weight| weight * Rational::from(term.sign)))
        .collect();
    let mut fixes = Vec::new();
    if let Some(weights) = weights {
        let total = weights.iter().fold(Rational::from(0), |total, weight| &total + weight);
        let rest = &Rational::from(1) - &total;
        if rest.is_zero() {
            return Vec::new();
        }
        if terms.len() > 1 {
            let pairs = terms.iter().zip(&weights).take(MOST_POINTS);
            fixes.extend(pairs.filter_map(|(term, now)| weighed(analysis, term, now, &rest)));
        }
        fixes.extend(divided(analysis, sum, &total));
    } else if let [first, last] = terms.as_slice()
        && last.sign == 1
        && first.sign == 1
    {
        fixes.extend(complement(analysis, first.expr, last.expr));
    }
    fixes
}

fn collect<'e>(expr: &'e Expr, sign: i64, terms: &mut Vec<Term<'e>>) {
    match &expr.kind {
        ExprKind::Binary(BinaryOperator::Add, _, left, right) => {
            collect(left, sign, terms);
            collect(right, sign, terms);
        }
        ExprKind::Binary(BinaryOperator::Subtract, _, left, right) => {
            collect(left, sign, terms);
            collect(right, -sign, terms);
        }
        _ => terms.push(Term { expr, sign }),
    }
}

/// What the points in an expression weigh together; `None` where that is not told by numbers alone.
fn weight(analysis: &Analysis, expr: &Expr) -> Option<Rational> {
    match &expr.kind {
        ExprKind::Group(inner) => weight(analysis, inner),
        ExprKind::Unary(UnaryOperator::Negate, inner) => Some(-weight(analysis, inner)?),
        ExprKind::Binary(BinaryOperator::Add, _, left, right) => {
            Some(&weight(analysis, left)? + &weight(analysis, right)?)
        }
        ExprKind::Binary(BinaryOperator::Subtract, _, left, right) => {
            Some(&weight(analysis, left)? - &weight(analysis, right)?)
        }
        ExprKind::Binary(BinaryOperator::Multiply, _, left, right) => match (number(left), number(right)) {
            (Some(factor), None) => Some(&factor * &weight(analysis, right)?),
            (None, Some(factor)) => Some(&weight(analysis, left)? * &factor),
            _ => None,
        },
        ExprKind::Binary(BinaryOperator::Divide, _, left, right) => {
            let divisor = number(right).filter(|divisor| !divisor.is_zero())?;
            Some(&weight(analysis, left)? / &divisor)
        }
        _ => is_point(analysis, expr.span).then(|| Rational::from(1)),
    }
}

/// A plain number written out: `1/3`, `0.5`, `50%`.
fn number(expr: &Expr) -> Option<Rational> {
    match &expr.kind {
        ExprKind::Number { digits, unit: None } => Rational::from_decimal(digits).ok(),
        ExprKind::Number { digits, unit: Some(Unit::Percent) } => {
            Some(&Rational::from_decimal(digits).ok()? / &Rational::from(100))
        }
        ExprKind::Group(inner) => number(inner),
        ExprKind::Unary(UnaryOperator::Negate, inner) => Some(-number(inner)?),
        ExprKind::Binary(operator, _, left, right) => {
            let (left, right) = (number(left)?, number(right)?);
            match operator {
                BinaryOperator::Add => Some(&left + &right),
                BinaryOperator::Subtract => Some(&left - &right),
                BinaryOperator::Multiply => Some(&left * &right),
                BinaryOperator::Divide if !right.is_zero() => Some(&left / &right),
                _ => None,
            }
        }
        _ => None,
    }
}

fn is_point(analysis: &Analysis, span: Span) -> bool {
    use ifs_compiler::hir::types::Type;
    let found = analysis.index.types.iter().find(|(other, _)| *other == span);
    found.is_some_and(|(_, ty)| matches!(ty, Type::Point(_)))
}

/// The point of a term that is one point with or without a number.
fn point_of(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Name(_) => Some(expr),
        ExprKind::Group(inner) => point_of(inner),
        ExprKind::Binary(BinaryOperator::Multiply, _, left, right) => match (number(left), number(right)) {
            (Some(_), None) => point_of(right),
            (None, Some(_)) => point_of(left),
            _ => None,
        },
        ExprKind::Binary(BinaryOperator::Divide, _, left, _) => point_of(left),
        _ => None,
    }
}

fn weighed(analysis: &Analysis, term: &Term<'_>, now: &Rational, rest: &Rational) -> Option<Fix> {
    let point = written(analysis, point_of(term.expr)?.span);
    let then = now + rest;
    let title = format!("weigh `{point}` by {then} instead of {now}, so that the weights sum to 1");
    // What stands there is subtracted where its sign says so.
    let written_weight = if term.sign < 0 { -then } else { then };
    if written_weight.is_zero() {
        return None;
    }
    let text = if written_weight.is_one() {
        point.to_owned()
    } else if written_weight.is_negative() {
        format!("({written_weight}) * {point}")
    } else {
        format!("{written_weight} * {point}")
    };
    Some(Fix::titled(title).with(term.expr.span, text))
}

/// The sum divided by its total: by another number where it is divided already.
fn divided(analysis: &Analysis, sum: &Expr, total: &Rational) -> Option<Fix> {
    if total.is_zero() {
        return None;
    }
    if let ExprKind::Binary(BinaryOperator::Divide, _, _, right) = &sum.kind
        && let Some(now) = number(right)
    {
        let then = &now * total;
        let title = format!("divide by {then} instead of {now}, so that the weights sum to 1");
        let text =
            if then.is_integer() && !then.is_negative() { then.to_string() } else { format!("({then})") };
        return Some(Fix::titled(title).with(right.span, text));
    }
    let divisor =
        if total.is_integer() && !total.is_negative() { total.to_string() } else { format!("({total})") };
    let title = format!("divide the sum by {total}, so that the weights sum to 1");
    let old = written(analysis, sum.span);
    let inner = if matches!(sum.kind, ExprKind::Group(_)) { old.to_owned() } else { format!("({old})") };
    Some(Fix::titled(title).with(sum.span, format!("{inner} / {divisor}")))
}

/// `t * p + t * q`: what the first leaves to the last, `(1 - t) * q`, for weights that are no numbers.
fn complement(analysis: &Analysis, first: &Expr, last: &Expr) -> Option<Fix> {
    let (weight, _) = factors(analysis, first)?;
    let (now, point) = factors(analysis, last)?;
    let [weight, now, point] = [weight, now, point].map(|part| written(analysis, part).to_owned());
    let simple = weight.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '.');
    let bracketed = weight.starts_with('(') && weight.find(')') == Some(weight.len() - 1);
    let weight = if simple || bracketed { weight } else { format!("({weight})") };
    let title = format!("weigh `{point}` by 1 - {weight} instead of {now}, so that the weights sum to 1");
    Some(Fix::titled(title).with(last.span, format!("(1 - {weight}) * {point}")))
}

/// The weight and the point of a product of the two.
fn factors(analysis: &Analysis, expr: &Expr) -> Option<(Span, Span)> {
    let ExprKind::Binary(BinaryOperator::Multiply, _, left, right) = &expr.kind else { return None };
    match (is_point(analysis, left.span), is_point(analysis, right.span)) {
        (false, true) => Some((left.span, right.span)),
        (true, false) => Some((right.span, left.span)),
        _ => None,
    }
}
