//! What most of many files say: the lines of programs, the frame of a drawing. One damaged file does not change it.

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
