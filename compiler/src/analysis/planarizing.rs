//! The settings of `planarize: { … }` as a method with its parameters.

use super::settings::{SettingValue, choice};
use crate::diagnostic::{Code, Diagnostic};
use crate::hir::value::Value;
use crate::planarize::{Method, OptionsError, Perturbation, Pin, Projection};
use crate::source::Span;

/// The settings that the perturbation alone has.
const OF_PERTURBATION: [&str; 5] = ["worst", "average", "select", "step", "move"];

/// What the block's requirements ask planarizing for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goals {
    pub(super) planarity: Option<f64>,
    pub(super) diagonal_ratio: Option<f64>,
}

/// The method asked for.
pub(super) fn planarizing(settings: &Value, span: Span, goals: Goals) -> Result<Method, Diagnostic> {
    let given =
        Given { settings: if let Value::Settings(settings) = settings { settings } else { &[] }, span };
    match choice(given.find("method")) {
        Some(1) => given.projection(goals).map(Method::Projection),
        _ => given.perturbation(goals.planarity).map(Method::Perturbation),
    }
}

/// What stands in the braces.
struct Given<'a> {
    settings: &'a [SettingValue],
    span: Span,
}

impl Given<'_> {
    fn find(&self, name: &str) -> Option<&SettingValue> {
        self.settings.iter().find(|(known, _, _)| *known == name)
    }

    fn number(&self, name: &str, default: f64) -> f64 {
        self.find(name).and_then(|(_, value, _)| value.number()).unwrap_or(default)
    }

    fn pin(&self, default: Pin) -> Pin {
        match choice(self.find("pin")) {
            Some(1) => Pin::None,
            Some(2) => Pin::Corners,
            Some(_) => Pin::Boundary,
            None => default,
        }
    }

    fn iterations(&self, default: u32) -> Result<u32, Diagnostic> {
        let iterations = self.number("iterations", f64::from(default));
        if iterations < 0.0 {
            let why = format!("`iterations` is a number of steps, 0 or more, but is {iterations}");
            return Err(self.refused(&why));
        }
        Ok(iterations.min(f64::from(u32::MAX)) as u32)
    }

    fn perturbation(&self, goal: Option<f64>) -> Result<Perturbation, Diagnostic> {
        let default = Perturbation::default();
        let given = Perturbation {
            worst: self.number("worst", default.worst),
            average: self.number("average", default.average),
            select: self.number("select", default.select),
            threshold: self.number("threshold", goal.unwrap_or(default.threshold)),
            step: self.number("step", default.step),
            move_length: self.number("move", default.move_length),
            iterations: self.iterations(default.iterations)?,
            pin: self.pin(default.pin),
        };
        Perturbation::try_new(given).map_err(|error| self.wrong(&error))
    }

    fn projection(&self, goals: Goals) -> Result<Projection, Diagnostic> {
        if let Some((name, _, span)) = OF_PERTURBATION.iter().find_map(|name| self.find(name)) {
            let message =
                format!("`{name}` is a setting of `method: perturbation`; `projection` has no use for it");
            let diagnostic = Diagnostic::new(Code::E0820, *span, message).label("not of this method");
            return Err(diagnostic.hint(format!(
                "take `{name}` out: projection is set by `threshold`, `iterations` and `pin`"
            )));
        }
        let default = Projection::default();
        let given = Projection {
            threshold: self.number("threshold", goals.planarity.unwrap_or(default.threshold)),
            // A ratio of 0 or less cannot be aimed at; that it fails is said where it is required.
            diagonal_ratio: goals.diagonal_ratio.filter(|most| *most > 0.0),
            iterations: self.iterations(default.iterations)?,
            pin: self.pin(default.pin),
        };
        Projection::try_new(given).map_err(|error| self.wrong(&error))
    }

    fn wrong(&self, error: &OptionsError) -> Diagnostic {
        self.refused(&error.to_string())
    }

    /// An error names its parameter in backticks; it stands at that one where it was given.
    fn refused(&self, why: &str) -> Diagnostic {
        let named = why.split('`').nth(1).and_then(|name| self.find(name));
        let message = format!("planarizing cannot work with these settings: {why}");
        let span = named.map_or(self.span, |(_, _, place)| *place);
        Diagnostic::new(Code::E0804, span, message).label("cannot be used")
    }
}
