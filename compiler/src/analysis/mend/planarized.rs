//! Ways to planarize a figure otherwise than its block asks.

use crate::hir::scalar::Scalar;
use crate::hir::schema::ChoiceKind;
use crate::hir::value::Value;

/// How a figure is planarized otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Planarized {
    /// As its block asks, or by default where it does not.
    AtAll,
    /// By projection.
    ByProjection,
    /// For so many iterations.
    Iterations(u32),
    /// With these vertices in place, by the word's place among its choices.
    Pinned(usize),
}

impl Planarized {
    /// The setting that says so.
    pub(super) fn setting(self) -> Option<(&'static str, Value)> {
        Some(match self {
            Planarized::AtAll => return None,
            Planarized::ByProjection => ("method", Value::Choice(ChoiceKind::PlanarizeMethod, 1)),
            Planarized::Iterations(most) => ("iterations", Value::Scalar(Scalar::integer(i64::from(most)))),
            Planarized::Pinned(place) => ("pin", Value::Choice(ChoiceKind::Pin, place)),
        })
    }

    /// How it is written: `pin: none`.
    pub(super) fn words(self) -> String {
        match self.setting() {
            None => "planarize: {}".to_owned(),
            Some((name, Value::Choice(kind, place))) => {
                format!("{name}: {}", kind.words().get(place).map_or("", |word| word.name))
            }
            Some((name, value)) => format!("{name}: {}", value.number().unwrap_or_default()),
        }
    }
}
