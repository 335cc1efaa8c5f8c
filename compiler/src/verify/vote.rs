//! What most of many files say: the figures of a machine, the frame of a drawing. One damaged file does not change it.

use std::collections::BTreeMap;

/// The value that occurs most often; of equally frequent ones the least. None of nothing.
pub(super) fn most<T: Ord>(values: impl IntoIterator<Item = T>) -> Option<T> {
    let mut counts: BTreeMap<T, usize> = BTreeMap::new();
    for value in values {
        *counts.entry(value).or_default() += 1;
    }
    let greatest = counts.values().copied().max()?;
    counts.into_iter().find(|(_, count)| *count == greatest).map(|(value, _)| value)
}

/// As [`most`] for numbers, told apart to the thousandth.
pub(super) fn most_number(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let thousandths = |value: f64| (value * 1000.0).round() as i64;
    most(values.into_iter().filter(|value| value.is_finite()).map(thousandths))
        .map(|value| value as f64 / 1000.0)
}
