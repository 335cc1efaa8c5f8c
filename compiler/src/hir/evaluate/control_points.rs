//! How many control points an ifs has with its arguments, and their names.

use super::{Call, Evaluator, Outcome, Stop, instance_name};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::tree::{Ifs, ItemKind};
use crate::hir::value::Instance;
use crate::source::Span;

/// The most control points an ifs may have.
const MOST_POINTS: usize = 256;

impl Evaluator<'_> {
    /// The control points of an ifs with its arguments, which is used at a place.
    pub(super) fn control_points(&mut self, instance: &Instance, used_at: Span) -> Outcome<usize> {
        let hir = self.hir;
        let ItemKind::Ifs(ifs) = &hir.item(instance.ifs).kind else { return Err(Stop::Reported) };
        match ifs.fixed_points() {
            Some(count) => Ok(count),
            None => {
                // What cannot be counted is the matter of whoever gave the arguments.
                self.calls.push(Call { span: used_at, of: instance.ifs });
                let counts = self.point_counts(instance, ifs);
                self.calls.pop();
                Ok(counts?.iter().map(|count| count.unwrap_or(1)).sum())
            }
        }
    }

    /// For each entry of the control points how many there are, where it is a list.
    pub(super) fn point_counts(&mut self, instance: &Instance, ifs: &Ifs) -> Outcome<Vec<Option<usize>>> {
        if ifs.fixed_points().is_some() {
            return Ok(vec![None; ifs.control_points.len()]);
        }
        let mut frame = self.argument_frame(instance, ifs)?;
        let mut counts = Vec::new();
        let mut all = 0;
        for point in &ifs.control_points {
            let Some(count) = &point.count else {
                all += 1;
                counts.push(None);
                continue;
            };
            let given = self.integer(&mut frame, count)?;
            let found = usize::try_from(given).ok().filter(|given| (1..=MOST_POINTS).contains(given));
            all += found.unwrap_or(0);
            let Some(found) = found.filter(|_| all <= MOST_POINTS) else {
                let name = instance_name(self.hir, instance);
                let message = format!("`{name}` would have {given} control points `{}`", point.name);
                let diagnostic = Diagnostic::new(Code::E0538, count.span, message);
                let diagnostic = diagnostic.label(format!("is {given}"));
                return Err(
                    self.report(diagnostic.hint(format!("an ifs has 1 to {MOST_POINTS} control points")))
                );
            };
            counts.push(Some(found));
        }
        Ok(counts)
    }
}

/// The names of all control points: `p[2]` for one of a list.
pub(super) fn point_names(ifs: &Ifs, counts: &[Option<usize>]) -> Vec<String> {
    let mut names = Vec::new();
    for (point, count) in ifs.control_points.iter().zip(counts) {
        match count {
            Some(count) => names.extend((0..*count).map(|place| format!("{}[{place}]", point.name))),
            None => names.push(point.name.clone()),
        }
    }
    names
}
