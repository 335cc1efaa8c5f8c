//! Exact reading of decimal literals into [`Rational`], with limits that keep every literal small.

use std::fmt;

use num_bigint::BigInt;

use super::rational::Rational;

/// Most digits a literal may have, before and after its point together, leading and trailing zeros included.
pub const MAX_DECIMAL_DIGITS: usize = 100;

/// Largest absolute value of a literal's written exponent: within the range of doubles, which reach 1.8e308.
pub const MAX_DECIMAL_EXPONENT: u32 = 300;

/// Digits of significand and power of ten together with which both fit in 64 bits.
const FEW_DIGITS: usize = 18;

/// Why a text is no decimal literal of this language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DecimalError {
    /// Not of the form `\d+(\.\d+)?([eE][+-]?\d+)?`.
    Malformed,
    /// More than [`MAX_DECIMAL_DIGITS`] digits.
    TooManyDigits {
        /// How many it has.
        digits: usize,
    },
    /// An exponent beyond ±[`MAX_DECIMAL_EXPONENT`].
    ExponentTooLarge,
}

impl fmt::Display for DecimalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DecimalError::Malformed => f.write_str("not a decimal number"),
            DecimalError::TooManyDigits { digits } => {
                write!(f, "a number of {digits} digits; at most {MAX_DECIMAL_DIGITS} are read")
            }
            DecimalError::ExponentTooLarge => {
                write!(f, "an exponent beyond {MAX_DECIMAL_EXPONENT}")
            }
        }
    }
}

impl std::error::Error for DecimalError {}

impl Rational {
    /// The exact value of a literal `\d+(\.\d+)?([eE][+-]?\d+)?`: `0.46` is 23/50. A sign is an operator, not part of
    /// the literal.
    ///
    /// # Errors
    /// [`DecimalError`], found before any large number is made.
    pub fn from_decimal(text: &str) -> Result<Rational, DecimalError> {
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, read_exponent(exponent)?),
            None => (text, 0),
        };
        let (whole, fraction) = match mantissa.split_once('.') {
            Some((whole, fraction)) => (whole, Some(fraction)),
            None => (mantissa, None),
        };
        if !is_digits(whole) || fraction.is_some_and(|digits| !is_digits(digits)) {
            return Err(DecimalError::Malformed);
        }
        let fraction = fraction.unwrap_or("");
        let digits = whole.len() + fraction.len();
        if digits > MAX_DECIMAL_DIGITS {
            return Err(DecimalError::TooManyDigits { digits });
        }
        let scale = exponent - fraction.len() as i32;
        if digits + scale.unsigned_abs() as usize <= FEW_DIGITS {
            return few_digits(whole, fraction, scale).ok_or(DecimalError::Malformed);
        }
        let significand =
            format!("{whole}{fraction}").parse::<BigInt>().map_err(|_| DecimalError::Malformed)?;
        // At most 100 digits and an exponent of 300: the power of ten has at most 400 digits.
        let power = BigInt::from(10).pow(scale.unsigned_abs());
        let (numerator, denominator) =
            if scale < 0 { (significand, power) } else { (significand * power, BigInt::from(1)) };
        Rational::from_integers(numerator, denominator).ok_or(DecimalError::Malformed)
    }
}

/// The same where significand and power of ten fit in 64 bits.
fn few_digits(whole: &str, fraction: &str, scale: i32) -> Option<Rational> {
    let digits = whole.bytes().chain(fraction.bytes()).map(|byte| i64::from(byte - b'0'));
    let significand = digits.fold(0, |number, digit| 10 * number + digit);
    let power = 10_i64.pow(scale.unsigned_abs());
    if scale < 0 { Rational::new(significand, power) } else { Rational::new(significand * power, 1) }
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

fn read_exponent(text: &str) -> Result<i32, DecimalError> {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    if !is_digits(digits) {
        return Err(DecimalError::Malformed);
    }
    let significant = digits.trim_start_matches('0');
    let size = match significant.len() {
        0 => 0,
        // Three digits at most: fits every integer type.
        1..=3 => significant.parse::<u32>().map_err(|_| DecimalError::Malformed)?,
        _ => return Err(DecimalError::ExponentTooLarge),
    };
    if size > MAX_DECIMAL_EXPONENT {
        return Err(DecimalError::ExponentTooLarge);
    }
    Ok(if negative { -(size as i32) } else { size as i32 })
}
