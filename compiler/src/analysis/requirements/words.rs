//! Limits and measured values in words: units a workshop uses, and as many decimals as tell a value from its limit.

use super::LimitValue;
use crate::fabricate::checks::Limit;
use crate::hir::evaluate::{quantity_words, quantity_words_to};
use crate::hir::schema::Measure;

/// The most decimals a value is told with where fewer would make it look like its limit.
const MOST_DECIMALS: usize = 9;

/// A measured value: `312.5mm`, `0.048m2`, `0.62%`.
pub fn value_words(measure: Measure, value: f64) -> String {
    match measure {
        Measure::DiagonalRatio => format!("{}%", quantity_words_to(value * 100.0, measure.dimension(), 4)),
        _ => quantity_words(value, measure.dimension()),
    }
}

/// A value that is beyond a limit, with enough decimals to see it.
pub(super) fn beyond_words(measure: Measure, value: f64, limit: &LimitValue) -> String {
    let LimitValue::Plain(limit) = limit else { return value_words(measure, value) };
    let bounds = limit.ends().map(|(end, _)| end);
    let looks_like = |words: &dyn Fn(f64) -> String| bounds.iter().any(|end| words(*end) == words(value));
    if limit.holds(value) || !looks_like(&|value| value_words(measure, value)) {
        return value_words(measure, value);
    }
    let (factor, unit) = if measure == Measure::DiagonalRatio { (100.0, "%") } else { (1.0, "") };
    let words = |decimals: usize| {
        move |value: f64| {
            format!("{}{unit}", quantity_words_to(value * factor, measure.dimension(), decimals))
        }
    };
    let decimals = (4..MOST_DECIMALS).find(|decimals| !looks_like(&words(*decimals)));
    words(decimals.unwrap_or(MOST_DECIMALS))(value)
}

impl LimitValue {
    /// The limit in words: `at least 80mm`.
    pub fn words(&self, measure: Measure) -> String {
        let words = |value: f64| value_words(measure, value);
        match self {
            LimitValue::Plain(limit) => match limit {
                Limit::AtLeast(value) => format!("at least {}", words(*value)),
                Limit::AtMost(value) => format!("at most {}", words(*value)),
                Limit::Within(from, to) => format!("{} .. {}", words(*from), words(*to)),
                Limit::Above(value) => format!("above {}", words(*value)),
                Limit::Below(value) => format!("below {}", words(*value)),
                Limit::Equal(value) => words(*value),
            },
            LimitValue::Grain(least) => {
                format!("at least {} across and {} along the grain", words(least.across), words(least.along))
            }
        }
    }

    /// The requirement as the language writes it, with the limit worked out: `require edge >= 80mm`.
    pub(in crate::analysis) fn line(&self, measure: Measure) -> String {
        let words = |value: f64| value_words(measure, value);
        let limit = match self {
            LimitValue::Plain(limit) => match limit {
                Limit::AtLeast(value) => format!(">= {}", words(*value)),
                Limit::AtMost(value) => format!("<= {}", words(*value)),
                Limit::Within(from, to) => format!("in {} .. {}", words(*from), words(*to)),
                Limit::Above(value) => format!("> {}", words(*value)),
                Limit::Below(value) => format!("< {}", words(*value)),
                Limit::Equal(value) => format!("== {}", words(*value)),
            },
            LimitValue::Grain(_) => return format!("`require {}`", measure.words()),
        };
        format!("`require {} {limit}`", measure.words())
    }
}

/// What a measure has many of: `edges`.
pub(super) fn plural(measure: Measure) -> &'static str {
    match measure {
        Measure::Planarity => "planarities",
        Measure::Fold => "folds",
        Measure::DiagonalRatio => "diagonal ratios",
        Measure::Edge => "edges",
        Measure::Length => "lengths",
        Measure::Width => "widths",
        Measure::Area => "areas",
        Measure::Angle => "angles",
        Measure::Mitre => "mitres",
        Measure::Bevel => "bevels",
        Measure::BendRadius => "bend radii",
        Measure::Overlap => "overlaps",
        Measure::Mass => "masses",
        Measure::Count => "counts",
    }
}

/// What measured values say of a figure under such a limit: the end that counts, or both.
pub(in crate::analysis) fn found_words(
    measure: Measure,
    limit: &LimitValue,
    (least, most): (f64, f64),
) -> String {
    let [low, high] = [least, most].map(|value| beyond_words(measure, value, limit));
    if low == high {
        return low;
    }
    match limit {
        LimitValue::Plain(Limit::Within(..) | Limit::Equal(_)) => format!("{low} .. {high}"),
        LimitValue::Plain(Limit::AtMost(_) | Limit::Below(_)) => format!("up to {high}"),
        LimitValue::Plain(Limit::AtLeast(_) | Limit::Above(_)) | LimitValue::Grain(_) => {
            format!("down to {low}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_the_workshop() {
        let said = [
            (Measure::Edge, 312.5, "312.5mm"),
            (Measure::DiagonalRatio, 0.0062, "0.62%"),
            (Measure::Area, 48_000.0, "0.048m2"),
            (Measure::Area, 900.0, "900mm2"),
            (Measure::Mass, 2.5, "2.5kg"),
            (Measure::Angle, core::f64::consts::FRAC_PI_3, "60deg"),
            (Measure::Planarity, 0.9998, "0.9998"),
            (Measure::Count, 256.0, "256"),
        ];
        for (measure, value, words) in said {
            assert_eq!(value_words(measure, value), words);
        }
    }

    #[test]
    fn a_value_just_beyond_its_limit_is_told_apart() {
        let least = LimitValue::Plain(Limit::AtLeast(80.0));
        assert_eq!(beyond_words(Measure::Edge, 79.5, &least), "79.5mm");
        assert_eq!(beyond_words(Measure::Edge, 79.999_96, &least), "79.99996mm");
        assert_eq!(beyond_words(Measure::Edge, 80.0, &least), "80mm", "it holds");
        let most = LimitValue::Plain(Limit::AtMost(0.005));
        assert_eq!(beyond_words(Measure::DiagonalRatio, 0.005_000_04, &most), "0.500004%");
    }
}
