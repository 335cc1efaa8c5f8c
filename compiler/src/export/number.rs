//! Numbers as text: fixed decimals, a point, no exponent, no `-0`. CSV cells take the text, JSON the same text bare.

use serde::ser::{Error, Serialize, Serializer};
use serde_json::value::RawValue;

/// Decimals of a length in mm.
pub const MM: usize = 3;
/// Decimals of an angle in degrees.
pub const DEGREES: usize = 4;
/// Decimals of an area in m².
pub const SQUARE_METRES: usize = 6;
/// Decimals of a mass in kg.
pub const KILOGRAMS: usize = 3;
/// Decimals of a planarity: 1e-9 below 1 is a fold of 0.0026 degrees.
pub const PLANARITY: usize = 9;
/// Decimals of a diagonal ratio.
pub const RATIO: usize = 6;

/// The number with that many decimals; none for what is not finite.
///
/// ```
/// use ifs_compiler::export::number::fixed;
/// assert_eq!(fixed(-0.0004, 3).as_deref(), Some("0.000"));
/// assert_eq!(fixed(1e-7, 2).as_deref(), Some("0.00"));
/// assert_eq!(fixed(f64::NAN, 2), None);
/// ```
#[must_use]
pub fn fixed(value: f64, decimals: usize) -> Option<String> {
    if !value.is_finite() {
        return None;
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(size) if size.bytes().all(|byte| matches!(byte, b'0' | b'.')) => Some(size.to_owned()),
        _ => Some(text),
    }
}

/// A number that serde writes with fixed decimals; null for what is not finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fixed {
    /// The number.
    pub value: f64,
    /// How many decimals.
    pub decimals: usize,
}

impl Fixed {
    /// A length, mm.
    #[must_use]
    pub const fn mm(value: f64) -> Self {
        Self { value, decimals: MM }
    }

    /// An angle given in rad, written in degrees.
    #[must_use]
    pub fn degrees(radians: f64) -> Self {
        Self { value: radians.to_degrees(), decimals: DEGREES }
    }

    /// An area given in mm², written in m².
    #[must_use]
    pub fn square_metres(square_millimetres: f64) -> Self {
        Self { value: square_millimetres * 1e-6, decimals: SQUARE_METRES }
    }

    /// A mass, kg.
    #[must_use]
    pub const fn kilograms(value: f64) -> Self {
        Self { value, decimals: KILOGRAMS }
    }

    /// A planarity.
    #[must_use]
    pub const fn planarity(value: f64) -> Self {
        Self { value, decimals: PLANARITY }
    }

    /// A diagonal ratio, or a ratio of another kind.
    #[must_use]
    pub const fn ratio(value: f64) -> Self {
        Self { value, decimals: RATIO }
    }

    /// As text; none for what is not finite.
    #[must_use]
    pub fn text(self) -> Option<String> {
        fixed(self.value, self.decimals)
    }
}

impl Serialize for Fixed {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.text() {
            Some(text) => RawValue::from_string(text).map_err(S::Error::custom)?.serialize(serializer),
            None => serializer.serialize_none(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn in_json_as_in_text() {
        let numbers = [Fixed::mm(-0.0), Fixed::planarity(1e-9), Fixed::mm(1e20), Fixed::mm(f64::INFINITY)];
        assert_eq!(
            serde_json::to_string(&numbers).unwrap(),
            "[0.000,0.000000001,100000000000000000000.000,null]"
        );
        assert_eq!(Fixed::degrees(std::f64::consts::FRAC_PI_6).text().unwrap(), "30.0000");
        assert_eq!(Fixed::square_metres(1_500_000.0).text().unwrap(), "1.500000");
    }

    proptest! {
        #[test]
        fn plain_digits_near_the_value(value in prop_oneof![-1e6f64..1e6, -1e-3f64..1e-3, any::<f64>()]) {
            let Some(text) = fixed(value, 3) else {
                prop_assert!(!value.is_finite());
                return Ok(());
            };
            prop_assert!(text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'-')));
            let back: f64 = text.parse().unwrap();
            prop_assert!((back - value).abs() <= 0.500_001e-3 || back == value);
            prop_assert!(back != 0.0 || !text.starts_with('-'));
        }
    }
}
