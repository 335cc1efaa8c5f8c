//! How many bars no cutting can do without.

use super::{Plank, Stock};

/// A proven least number of bars for `planks` that are each short enough for one.
///
/// Between two planks the axis loses a kerf at least, so planks on one bar, each a kerf longer, are together at most as
/// long as the bar between its trims and a kerf. That is bin packing; the bound is L2 of Martello and Toth (1990), over
/// all thresholds.
#[must_use]
pub fn least_bars(planks: &[Plank], stock: &Stock) -> usize {
    let room = stock.length - 2.0 * stock.trim + stock.kerf;
    if !(room > 0.0 && room.is_finite()) {
        return 0;
    }
    let mut lengths: Vec<f64> = planks.iter().map(|plank| plank.length + stock.kerf).collect();
    lengths.sort_by(|a, b| b.total_cmp(a));
    let mut sums = vec![0.0];
    for length in &lengths {
        sums.push(sums[sums.len() - 1] + length);
    }
    let longer = |than: f64| lengths.partition_point(|length| *length > than);
    let halves = longer(room / 2.0);
    let thresholds = lengths[halves..].iter().copied().chain([0.0]);
    let bound = |threshold: f64| {
        // Those that go with nothing as long as the threshold; those over half a bar; the rest down to the threshold.
        let alone = longer(room - threshold);
        let rest = lengths.partition_point(|length| *length >= threshold).max(halves);
        let free = (halves - alone.min(halves)) as f64 * room - (sums[halves] - sums[alone.min(halves)]);
        let over = (sums[rest] - sums[halves] - free) / room;
        halves + if over > 1e-9 { libm::ceil(over - 1e-9) as usize } else { 0 }
    };
    thresholds.map(bound).max().unwrap_or(0)
}
