//! The axis of a plot: where a value lies on paper, and round numbers to write beside it.

use crate::export::html::number::{shown, stepped};

/// An axis between two values and two places on paper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::export::html) struct Axis {
    values: [f64; 2],
    paper: [f64; 2],
    logarithmic: bool,
}

impl Axis {
    /// Equal differences have equal lengths. Two equal values are moved apart.
    pub(in crate::export::html) fn linear(values: [f64; 2], paper: [f64; 2]) -> Self {
        let [low, high] = values;
        let spread = if low < high { 0.0 } else { low.abs().max(1.0) * 0.05 };
        Self { values: [low - spread, high + spread], paper, logarithmic: false }
    }

    /// Equal ratios have equal lengths; both values are above 0.
    pub(in crate::export::html) fn logarithmic(values: [f64; 2], paper: [f64; 2]) -> Self {
        let [low, high] = values;
        let spread = if low < high { 1.0 } else { 2.0 };
        Self { values: [low / spread, high * spread], paper, logarithmic: true }
    }

    /// Where a value lies, those beyond an end at that end.
    pub(in crate::export::html) fn place(&self, value: f64) -> f64 {
        let [low, high] = self.values;
        let part = match self.logarithmic {
            true => libm::log(value.max(low) / low) / libm::log(high / low),
            false => (value - low) / (high - low),
        };
        self.paper[0] + (self.paper[1] - self.paper[0]) * part.clamp(0.0, 1.0)
    }

    /// Whether a value lies between the ends.
    pub(in crate::export::html) fn holds(&self, value: f64) -> bool {
        (self.values[0]..=self.values[1]).contains(&value)
    }

    /// Round values with their texts, at most about `most` of them.
    pub(in crate::export::html) fn ticks(&self, most: usize) -> Vec<(f64, String)> {
        let [low, high] = self.values;
        if self.logarithmic && high / low >= 8.0 {
            return decades(low, high, most);
        }
        let step = round_step((high - low) / most.max(1) as f64);
        let first = (low / step - 1e-9).ceil();
        let count = ((high / step + 1e-9).floor() - first).clamp(0.0, 100.0) as usize;
        (0..=count).map(|n| (first + n as f64) * step).map(|value| (value, stepped(value, step))).collect()
    }
}

/// Powers of ten, with 2 and 5 times them where there is room.
fn decades(low: f64, high: f64, most: usize) -> Vec<(f64, String)> {
    let from = libm::floor(libm::log10(low)) as i32;
    let to = libm::ceil(libm::log10(high)) as i32;
    let tens = |every: i32, digits: &[f64]| -> Vec<f64> {
        (from..=to)
            .filter(|power| power % every == 0)
            .flat_map(|power| digits.iter().map(move |digit| digit * libm::pow(10.0, f64::from(power))))
            .filter(|value| (low * (1.0 - 1e-9)..=high * (1.0 + 1e-9)).contains(value))
            .collect()
    };
    let kinds: [(i32, &[f64]); 5] =
        [(1, &[1.0, 2.0, 5.0]), (1, &[1.0, 3.0]), (1, &[1.0]), (2, &[1.0]), (4, &[1.0])];
    let found = kinds.into_iter().map(|(every, digits)| tens(every, digits));
    let values = found.into_iter().find(|values| values.len() <= most).unwrap_or_default();
    values.into_iter().map(|value| (value, small(value))).collect()
}

/// `0.001`, or `1e-9` where zeros are no longer counted at a glance.
fn small(value: f64) -> String {
    if value >= 0.001 {
        return stepped(value, value);
    }
    let power = libm::floor(libm::log10(value) + 1e-9);
    format!("{}e\u{2212}{}", shown(value / libm::pow(10.0, power), 0), shown(-power, 0))
}

/// The least of 1, 2, 5 times a power of ten that is no less.
pub(in crate::export::html) fn round_step(least: f64) -> f64 {
    if !(least.is_finite() && least > 0.0) {
        return 1.0;
    }
    let power = libm::pow(10.0, libm::floor(libm::log10(least)));
    [1.0, 2.0, 5.0]
        .map(|digit| digit * power)
        .into_iter()
        .find(|step| *step >= least * (1.0 - 1e-9))
        .unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_numbers() {
        assert_eq!([0.7, 1.0, 1.1, 3.0, 51.0].map(round_step), [1.0, 1.0, 2.0, 5.0, 100.0]);
        let texts = |axis: Axis, most| axis.ticks(most).into_iter().map(|(_, text)| text).collect::<Vec<_>>();
        assert_eq!(texts(Axis::linear([231.0, 262.0], [0.0, 1.0]), 4), ["240", "250", "260"]);
        assert_eq!(
            texts(Axis::linear([0.9998, 1.0], [0.0, 1.0]), 4),
            ["0.99980", "0.99985", "0.99990", "0.99995", "1.00000"]
        );
        assert_eq!(texts(Axis::logarithmic([0.5, 200.0], [0.0, 1.0]), 4), ["1", "10", "100"]);
        assert_eq!(
            texts(Axis::logarithmic([1e-7, 1e-5], [0.0, 1.0]), 4),
            ["1e\u{2212}7", "1e\u{2212}6", "1e\u{2212}5"]
        );
        assert_eq!(
            texts(Axis::logarithmic([100.0, 300.0], [0.0, 1.0]), 4),
            ["100", "150", "200", "250", "300"]
        );
    }

    #[test]
    fn places() {
        let axis = Axis::linear([100.0, 200.0], [10.0, 110.0]);
        assert_eq!([150.0, 50.0, 900.0].map(|value| axis.place(value)), [60.0, 10.0, 110.0]);
        let axis = Axis::logarithmic([1.0, 100.0], [0.0, 40.0]);
        assert!((axis.place(10.0) - 20.0).abs() < 1e-9 && axis.place(0.0) == 0.0);
        assert!(Axis::linear([5.0, 5.0], [0.0, 1.0]).place(5.0) == 0.5);
    }
}
