//! What a measured value is held against.

use std::cmp::Ordering;

/// A limit on a measured value, in the unit of the measurement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// `>= x`
    AtLeast(f64),
    /// `<= x`
    AtMost(f64),
    /// `in x .. y`, both ends included.
    Within(f64, f64),
    /// `> x`
    Above(f64),
    /// `< x`
    Below(f64),
    /// `== x`
    Equal(f64),
}

/// Values this near to a limit (relative to it, and at least this much) count as on it, so that rounding in the last
/// digits fails no board that was drawn exactly to the limit.
pub const LIMIT_SLACK: f64 = 1e-9;

impl Limit {
    /// Whether the value is within the limit (equal), below it or above it. What is not a number counts as above.
    #[must_use]
    pub fn verdict(self, value: f64) -> Ordering {
        let is_below = match self {
            Self::AtLeast(bound) | Self::Above(bound) | Self::Within(bound, _) | Self::Equal(bound) => {
                value < bound || (value <= bound && matches!(self, Self::Above(_)))
            }
            Self::AtMost(_) | Self::Below(_) => false,
        };
        match self.holds(value) {
            true => Ordering::Equal,
            false if is_below => Ordering::Less,
            false => Ordering::Greater,
        }
    }

    /// The least and the largest value within the limit, and whether these themselves are within it.
    #[must_use]
    pub fn ends(self) -> [(f64, bool); 2] {
        let open = [(f64::NEG_INFINITY, true), (f64::INFINITY, true)];
        match self {
            Self::AtLeast(least) => [(least, true), open[1]],
            Self::AtMost(most) => [open[0], (most, true)],
            Self::Within(least, most) => [(least, true), (most, true)],
            Self::Above(bound) => [(bound, false), open[1]],
            Self::Below(bound) => [open[0], (bound, false)],
            Self::Equal(target) => [(target, true), (target, true)],
        }
    }

    /// Whether the value is within the limit. What is not a number never is.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::AtLeast(least) => value >= least - slack(least),
            Self::AtMost(most) => value <= most + slack(most),
            Self::Within(least, most) => value >= least - slack(least) && value <= most + slack(most),
            Self::Above(bound) => value > bound,
            Self::Below(bound) => value < bound,
            Self::Equal(target) => (value - target).abs() <= slack(target),
        }
    }

    /// How far the value is beyond the limit; 0 on it, below 0 within it.
    #[must_use]
    pub fn shortfall(self, value: f64) -> f64 {
        match self {
            Self::AtLeast(bound) | Self::Above(bound) => bound - value,
            Self::AtMost(bound) | Self::Below(bound) => value - bound,
            Self::Within(least, most) => (least - value).max(value - most),
            Self::Equal(target) => (value - target).abs(),
        }
    }
}

fn slack(limit: f64) -> f64 {
    LIMIT_SLACK * limit.abs().max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cmp::Ordering::{Equal, Greater, Less};

    #[test]
    fn on_within_and_beyond() {
        let cases = [
            (Limit::AtLeast(80.0), [79.9, 80.0, 80.1], [false, true, true]),
            (Limit::AtMost(80.0), [79.9, 80.0, 80.1], [true, true, false]),
            (Limit::Above(80.0), [79.9, 80.0, 80.1], [false, false, true]),
            (Limit::Below(80.0), [79.9, 80.0, 80.1], [true, false, false]),
            (Limit::Equal(80.0), [79.9, 80.0, 80.1], [false, true, false]),
            (Limit::Within(80.0, 90.0), [79.9, 80.0, 90.1], [false, true, false]),
        ];
        for (limit, values, expected) in cases {
            assert_eq!(values.map(|value| limit.holds(value)), expected, "{limit:?}");
            for value in values {
                assert!(limit.holds(value) || limit.shortfall(value) >= 0.0);
                let side = if value < 80.0 || limit == Limit::Above(80.0) { Less } else { Greater };
                assert_eq!(
                    limit.verdict(value),
                    if limit.holds(value) { Equal } else { side },
                    "{limit:?} {value}"
                );
                let [(least, at_least), (most, at_most)] = limit.ends();
                let above = value > least || (at_least && value == least);
                let below = value < most || (at_most && value == most);
                assert_eq!(limit.holds(value), above && below, "{limit:?} {value}");
            }
            assert!(!limit.holds(f64::NAN));
        }
        assert!((Limit::Within(80.0, 90.0).shortfall(93.0) - 3.0).abs() < 1e-12);
        assert!((Limit::Within(80.0, 90.0).shortfall(84.0) + 4.0).abs() < 1e-12);
    }

    #[test]
    fn rounding_fails_nothing() {
        assert!(Limit::AtMost(1200.0).holds(1200.0 + 1e-10));
        assert!(Limit::AtLeast(1.0).holds(1.0 - 1e-12));
        assert!(!Limit::AtLeast(0.9999).holds(0.9999 - 1e-8));
    }
}
