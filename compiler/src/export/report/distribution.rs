//! How measured figures are spread: counts in bins of one width.

use serde::Serialize;

use crate::export::number::Fixed;

/// How many bins a distribution has, but for figures that are all the same.
pub const BINS: usize = 40;

/// From this ratio of the largest to the least on, bins are of one ratio and not of one width.
const LOGARITHMIC_FROM: f64 = 20.0;

/// Counts of figures between two ends. A figure on the border of two bins is in the upper one, the largest in the last.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Distribution {
    /// Whether the borders of the bins are steps of one ratio; else they are steps of one width.
    pub logarithmic: bool,
    /// Where the first bin starts.
    pub low: Fixed,
    /// Where the last bin ends.
    pub high: Fixed,
    /// How many figures are in each bin.
    pub counts: Vec<usize>,
}

impl Distribution {
    /// The distribution between the least and the largest; `number` gives the unit. None without a finite value.
    #[must_use]
    pub fn of(values: impl IntoIterator<Item = f64>, number: fn(f64) -> Fixed) -> Option<Self> {
        let values: Vec<f64> = values.into_iter().filter(|value| value.is_finite()).collect();
        let least = values.iter().copied().reduce(f64::min)?;
        let most = values.iter().copied().reduce(f64::max)?;
        Self::over(values, (least, most), number)
    }

    /// The distribution of `values` in bins between two given ends, which hold all of them. None without a finite value.
    #[must_use]
    pub fn over(values: Vec<f64>, (least, most): (f64, f64), number: fn(f64) -> Fixed) -> Option<Self> {
        if !values.iter().any(|value| value.is_finite()) {
            return None;
        }
        let (low, high) = (number(least), number(most));
        // What is written as 0 has no ratio to anything.
        let has_size = low.text() != number(0.0).text();
        let logarithmic = least > 0.0 && has_size && most / least >= LOGARITHMIC_FROM;
        // What differs by less than is written is noise of rounding.
        let bins = if low.text() == high.text() { 1 } else { BINS };
        let part = |value: f64| match logarithmic {
            true => libm::log(value / least) / libm::log(most / least),
            false => (value - least) / (most - least),
        };
        let mut counts = vec![0; bins];
        for value in values.into_iter().filter(|value| value.is_finite()) {
            let bin = if bins == 1 { 0.0 } else { (part(value) * bins as f64).clamp(0.0, (bins - 1) as f64) };
            counts[bin as usize] += 1;
        }
        Some(Self { logarithmic, low, high, counts })
    }

    /// The borders of bin `bin`.
    #[must_use]
    pub fn borders(&self, bin: usize) -> [f64; 2] {
        let (low, high) = (self.low.value, self.high.value);
        [bin, bin + 1].map(|border| {
            let part = border as f64 / self.counts.len() as f64;
            if self.logarithmic { low * libm::pow(high / low, part) } else { low + (high - low) * part }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn bins_of_one_width_and_of_one_ratio() {
        let tenths = Distribution::of((0..=80).map(|n| f64::from(n) / 10.0), Fixed::mm).unwrap();
        assert!(!tenths.logarithmic);
        assert_eq!((tenths.counts[0], tenths.counts[BINS - 1]), (2, 3));
        let decades = Distribution::of([1.0, 10.0, 100.0, 10_000.0], Fixed::mm).unwrap();
        assert!(decades.logarithmic);
        assert_eq!([0, 10, 20, 39].map(|bin| decades.counts[bin]), [1; 4]);
        assert!((decades.borders(20)[0] - 100.0).abs() < 1e-9);
        let same = Distribution::of([2.0, 2.0, f64::INFINITY], Fixed::mm).unwrap();
        assert_eq!(same.counts, [2]);
        assert_eq!(Distribution::of([f64::NAN], Fixed::mm), None);
    }

    #[test]
    fn noise_of_rounding_is_no_spread() {
        let flat = Distribution::of([1e-9, 3e-9, 1e-7], Fixed::mm).unwrap();
        assert_eq!((flat.counts, flat.logarithmic), (vec![3], false));
        let bent = Distribution::of([1e-9, 0.5, 4.0], Fixed::mm).unwrap();
        assert!(!bent.logarithmic && bent.counts.len() == BINS);
    }

    proptest! {
        #[test]
        fn every_value_is_counted_once_in_its_bin(
            values in proptest::collection::vec(prop_oneof![-1e3f64..1e3, 1e-3f64..1e6], 1..60),
        ) {
            let found = Distribution::of(values.iter().copied(), Fixed::mm).unwrap();
            prop_assert_eq!(found.counts.iter().sum::<usize>(), values.len());
            let slack = 1e-9 * (found.high.value.abs() + found.low.value.abs());
            for bin in 0..found.counts.len() {
                let [from, to] = found.borders(bin);
                let surely = values.iter().filter(|&&value| value > from + slack && value < to - slack).count();
                let perhaps = values.iter().filter(|&&value| value >= from - slack && value <= to + slack).count();
                prop_assert!(surely <= found.counts[bin] && found.counts[bin] <= perhaps);
            }
        }
    }
}
