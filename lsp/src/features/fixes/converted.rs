//! A value of another type than is needed: a unit of the dimension that is, a field that has the type, a whole number
//! near to it.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::{Diagnostic, Fix};
use ifs_compiler::hir::dimension::{Dimension, unit_worth};
use ifs_compiler::hir::index::Target;
use ifs_compiler::hir::types::Type;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::{Expr, ExprKind, Unit};

use super::tree::expression_at;
use crate::features::words::written;

/// What makes the value one of the type that its place needs.
pub(super) fn fitting(analysis: &Analysis, found: &Diagnostic) -> Vec<Fix> {
    let index = &analysis.index;
    let Some(needed) = index.expected_at(found.span) else { return Vec::new() };
    let Some(expr) = expression_at(analysis, found.span) else { return Vec::new() };
    let is = index.types.iter().find(|(span, _)| *span == found.span).map(|(_, ty)| ty);
    match (&expr.kind, is) {
        (ExprKind::Number { digits, .. }, _) if *needed == Type::Int => whole_numbers(expr, digits),
        (ExprKind::Number { digits, unit: Some(unit) }, _) => other_units(expr, digits, *unit, needed),
        (_, Some(Type::Record(id))) => {
            let name = analysis.hir.item(*id).name_span;
            let fields = index.parameters(Target::Declared(name)).unwrap_or_default().iter();
            let fitting = fields.filter(|field| field.ty == *needed);
            let end = after(expr);
            fitting.map(|field| Fix::replacing(end, format!(".{}", field.name))).collect()
        }
        (_, Some(Type::Quantity(dimension))) if *dimension == Dimension::NUMBER && *needed == Type::Int => {
            let words = written(analysis, expr.span);
            let whole = ["round", "floor", "ceil"]
                .map(|function| Fix::replacing(expr.span, format!("{function}({words})")));
            whole.to_vec()
        }
        _ => Vec::new(),
    }
}

/// The whole numbers next to what is written, without its unit.
fn whole_numbers(expr: &Expr, digits: &str) -> Vec<Fix> {
    let Some(number) = digits.parse::<f64>().ok().filter(|number| number.abs() < 1e9) else {
        return Vec::new();
    };
    let mut whole = vec![number.floor(), number.ceil()];
    whole.dedup();
    whole.into_iter().map(|number| Fix::replacing(expr.span, format!("{number:.0}"))).collect()
}

/// The same digits with each unit of another dimension.
fn other_units(expr: &Expr, digits: &str, unit: Unit, needed: &Type) -> Vec<Fix> {
    let Some(dimension) = needed.dimension().filter(|needed| *needed != unit_worth(unit).0) else {
        return Vec::new();
    };
    let units = Unit::ALL.iter().filter(|unit| unit_worth(**unit).0 == dimension);
    let units =
        units.filter(|unit| matches!(unit.suffix(), "mm" | "cm" | "m") || dimension != Dimension::LENGTH);
    let mut fixes: Vec<Fix> =
        units.map(|unit| Fix::replacing(expr.span, format!("{digits}{}", unit.suffix()))).collect();
    if dimension == Dimension::NUMBER {
        fixes.push(Fix::replacing(expr.span, digits));
    }
    fixes
}

fn after(expr: &Expr) -> Span {
    Span::new(expr.span.file, expr.span.end, expr.span.end)
}
