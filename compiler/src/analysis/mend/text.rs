//! The places of the text where a remedy is written: numbers that stand there as they are. What is worked out from
//! something else has no such place.

use super::Remedies;
use crate::analysis::fabrication::Fabrication;
use crate::diagnostic::Fix;
use crate::hir::tree::{Expr, ExprKind, Fabricate, ItemKind, SettingValue, is_literal};
use crate::source::Span;

impl Remedies<'_> {
    /// The block of a figure.
    pub(super) fn block(&self, figure: &str) -> Option<&Fabricate> {
        self.hir.fabricates.iter().find(|block| self.hir.item(block.figure).name == figure)
    }

    /// The levels of a figure moved by `shift`, where they stand as numbers at the figure itself.
    pub(super) fn level_put(&self, figure: &str, shift: i32, found: Option<&str>) -> Option<Fix> {
        let block = self.block(figure)?;
        let ItemKind::Figure(body) = &self.hir.item(block.figure).kind else { return None };
        let (u, v) = levels(&body.value)?;
        let mut fix: Option<Fix> = None;
        for level in [Some(u), v].into_iter().flatten() {
            let ExprKind::Scalar(now) = &level.kind else { return None };
            let now = now.to_integer()?;
            let then = now.checked_add(i64::from(shift)).filter(|level| *level >= 0)?;
            let gives = found.map_or_else(String::new, |found| format!(" ({found})"));
            let first = || Fix::titled(format!("take level {then} instead of {now}{gives}"));
            fix = Some(fix.unwrap_or_else(first).with(level.span, then.to_string()));
        }
        fix
    }

    /// A parameter of the design with another default, where that stands as a number.
    pub(super) fn default_put(&self, name: &str, now: &str, then: &str) -> Option<Fix> {
        // What is set from outside is not the default's.
        let set = self.overrides.parameters.contains_key(name) || self.overrides.defaults.contains_key(name);
        let (_, item) = self.hir.own_items().find(|(_, item)| item.name == name)?;
        let ItemKind::Param(param) = &item.kind else { return None };
        let place = &param.default.value;
        let title = format!("set `{name}` to {then} instead of {now}");
        (!set && is_literal(place)).then(|| Fix::titled(title).with(place.span, then))
    }

    /// A setting of a block with another value, or added.
    pub(super) fn setting_put(&self, fabrication: &Fabrication, name: &str, value: &str) -> Option<Fix> {
        let block = self.block(&fabrication.figure)?;
        match block.settings.iter().find(|setting| setting.name == name) {
            Some(setting) if is_written_out(&setting.value) => {
                let title = format!("set `{name}` to {value}");
                Some(Fix::titled(title).with(setting.value.span, value))
            }
            Some(_) => None,
            None => put_before(block.settings.first()?, name, value, "\n    "),
        }
    }

    /// A setting of `planarize` with another value, or added to those there are.
    pub(super) fn planarize_put(&self, fabrication: &Fabrication, name: &str, value: &str) -> Option<Fix> {
        let block = self.block(&fabrication.figure)?;
        let planarize = block.settings.iter().find(|setting| setting.name == "planarize")?;
        let ExprKind::Settings(_, given) = &planarize.value.kind else { return None };
        let title = format!("planarize with `{name}: {value}`");
        match (given.iter().find(|setting| setting.name == name), given.first()) {
            (Some(setting), _) => Some(Fix::titled(title).with(setting.value.span, value)),
            (None, Some(first)) => put_before(first, name, value, ", "),
            (None, None) => {
                Some(Fix::titled(title).with(planarize.value.span, format!("{{ {name}: {value} }}")))
            }
        }
    }
}

fn put_before(first: &SettingValue, name: &str, value: &str, between: &str) -> Option<Fix> {
    let at = Span::new(first.name_span.file, first.name_span.start, first.name_span.start);
    Some(Fix::titled(format!("add `{name}: {value}`")).with(at, format!("{name}: {value}{between}")))
}

/// Whether a value stands there as it is: a number, a word, a size of two numbers.
fn is_written_out(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Size(first, second) => is_literal(first) && is_literal(second),
        ExprKind::Choice(..) => true,
        _ => is_literal(value),
    }
}

/// The levels at the end of a figure, also of each of a list of figures.
fn levels(figure: &Expr) -> Option<(&Expr, Option<&Expr>)> {
    match &figure.kind {
        ExprKind::At(_, u, v) => Some((plain(u), v.as_deref().map(plain))),
        ExprKind::Convert(inner) | ExprKind::Comprehension(inner, _) => levels(inner),
        _ => None,
    }
}

fn plain(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Convert(inner) => plain(inner),
        _ => expr,
    }
}
