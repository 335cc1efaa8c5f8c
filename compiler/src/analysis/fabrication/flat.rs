//! Surfaces planarized: what is asked for, and warnings about what it came to.

use super::super::planarizing::{Goals, planarizing};
use super::super::requirements::{LimitValue, value_words};
use super::Work;
use crate::diagnostic::{Code, Diagnostic};
use crate::geometry::QuadMesh;
use crate::hir::evaluate::Planarizing;
use crate::hir::schema::Measure;
use crate::hir::value::Value;
use crate::plan::FigurePlan;
use crate::planarize::{Method, Outcome, StopReason};
use crate::source::Span;
use std::sync::Arc;

impl Work<'_> {
    /// How to planarize, where that is asked for and of use; `None` after a report of an error.
    pub(super) fn planarize(&mut self, limits: &[LimitValue]) -> Option<Option<Method>> {
        let Some((value, span)) = self.planarize_asked() else { return Some(None) };
        match planarizing(&value, span, self.goals(limits)) {
            Ok(_) if self.figures().iter().all(|(_, figure)| figure.shape.planar_by_construction()) => {
                let message =
                    "the quads of this surface are planar by construction: there is nothing to planarize";
                let diagnostic = Diagnostic::new(Code::W0525, span, message).label("left aside");
                self.diagnostics.push(diagnostic.hint("take `planarize` out"));
                Some(None)
            }
            Ok(options) => Some(Some(options)),
            Err(diagnostic) => {
                self.diagnostics.push(diagnostic);
                None
            }
        }
    }

    /// The settings of `planarize` and where they stand, where the surface is planarized.
    fn planarize_asked(&self) -> Option<(Value, Span)> {
        let asked = self.setting("planarize").map(|(_, value, span)| (value.clone(), *span));
        match &self.planarizing {
            Planarizing::Never => None,
            Planarizing::With { figure, setting } if *figure == self.hir.item(self.block.figure).name => {
                let (asked, span) =
                    asked.unwrap_or((Value::Settings(Arc::default()), self.block.figure_span));
                let mut settings = match asked {
                    Value::Settings(settings) => settings.to_vec(),
                    _ => Vec::new(),
                };
                if let Some((name, value)) = setting {
                    settings.retain(|(known, _, _)| known != name);
                    settings.push((name, value.clone(), span));
                }
                Some((Value::Settings(Arc::new(settings)), span))
            }
            Planarizing::AsAsked | Planarizing::With { .. } => asked,
        }
    }

    /// What `require planarity >= …` and `require diagonal ratio <= …` ask for.
    fn goals(&self, limits: &[LimitValue]) -> Goals {
        let of = |measure: Measure| {
            let required = self.block.requirements.iter().zip(limits);
            required.filter(move |(requirement, _)| requirement.measure == measure).map(|(_, limit)| limit)
        };
        Goals {
            planarity: of(Measure::Planarity).find_map(LimitValue::least),
            diagonal_ratio: of(Measure::DiagonalRatio).find_map(LimitValue::most),
        }
    }

    /// Planarizes a surface; `None` where whoever watches says stop.
    pub(super) fn planarized(
        &mut self,
        figure: &FigurePlan,
        designed: &QuadMesh,
        method: &Method,
    ) -> Option<Outcome> {
        let (name, watch) = (figure.to_string(), &mut *self.watch);
        let outcome = method.run(designed, &mut |progress| watch.planarizing(&name, &progress));
        watch.planarized(&name);
        if outcome.stop == StopReason::Cancelled {
            return None;
        }
        self.moved_far(&name, designed, &outcome);
        self.not_flat_enough(&name, method, &outcome);
        Some(outcome)
    }

    /// Where `planarize` stands.
    fn planarize_span(&self) -> Span {
        self.setting("planarize").map_or(self.block.figure_span, |(_, _, span)| *span)
    }

    /// Warns where the surface that is built is no longer the one that was designed.
    fn moved_far(&mut self, name: &str, designed: &QuadMesh, outcome: &Outcome) {
        let size = extent(designed);
        if outcome.moved.max <= FAR * size {
            return;
        }
        let (most, mean) = (outcome.moved.max, outcome.moved.mean);
        let percent = 100.0 * most / size;
        let message = format!(
            "planarizing moved vertices of `{name}` by up to {most:.0}mm ({mean:.0}mm on average): {percent:.1}% of its size"
        );
        let diagnostic =
            Diagnostic::new(Code::W0826, self.planarize_span(), message).label("far from the design");
        self.diagnostics.push(diagnostic.hint(
            "look at both in model.glb; a lower `require planarity`, a higher level or flatter control points need less",
        ));
    }

    /// Warns where the quads did not become as flat as they were to be, and no requirement says so.
    fn not_flat_enough(&mut self, name: &str, method: &Method, outcome: &Outcome) {
        let required = self.block.requirements.iter().any(|required| required.measure == Measure::Planarity);
        let reached = matches!(outcome.stop, StopReason::Reached | StopReason::NothingSelected);
        let Some(worst) = outcome.after.worst.filter(|worst| worst.value < method.threshold()) else {
            return;
        };
        if required || reached {
            return;
        }
        let words = |value| value_words(Measure::Planarity, value);
        let threshold = words(method.threshold());
        let message = format!(
            "planarizing makes the worst quad of `{name}` {}, and aims at {threshold}",
            words(worst.value)
        );
        let why = match outcome.stop {
            StopReason::IterationsUsed => format!("all {} iterations were used", method.iterations()),
            StopReason::OnlyPinnedLeft => "what falls short has no vertex that may move".to_owned(),
            StopReason::OnlyFoldedLeft => "what falls short is folded over in the design".to_owned(),
            StopReason::TooLarge => "the surface is too large for projection".to_owned(),
            _ => "no step made it flatter any more".to_owned(),
        };
        let diagnostic = Diagnostic::new(Code::W0827, self.planarize_span(), message);
        let diagnostic = diagnostic.label("not flat enough").note(why);
        self.diagnostics.push(diagnostic.hint(format!(
            "write `require planarity >= {threshold}` to be told which boards fall short and what would mend it"
        )));
    }
}

/// The part of a surface's size beyond which its vertices moved far.
const FAR: f64 = 0.025;

/// The diagonal of the box around a surface, mm.
fn extent(mesh: &QuadMesh) -> f64 {
    let mut vertices = mesh.vertices.iter().copied();
    let Some(first) = vertices.next() else { return 0.0 };
    let (least, most) = vertices.fold((first, first), |(least, most), at| (least.min(at), most.max(at)));
    least.distance(most)
}
