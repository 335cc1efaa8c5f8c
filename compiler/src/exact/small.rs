//! Sums and products of fractions of 64-bit numbers: most that a design is made of. They give what those of longer
//! numbers give, without divisions of 128 bits.

use num_integer::Integer;
use num_rational::Ratio;

/// Numerator and denominator of a reduced fraction where both have 64 bits.
fn short(ratio: &Ratio<i128>) -> Option<(i64, i64)> {
    Some((i64::try_from(*ratio.numer()).ok()?, i64::try_from(*ratio.denom()).ok()?))
}

/// The greatest common divisor of a number and a denominator; it divides a denominator, so it has 63 bits.
fn common(number: u64, denominator: i64) -> i64 {
    i64::try_from(number.gcd(&denominator.unsigned_abs())).unwrap_or(1)
}

/// `a · b`, reduced; `None` where a part is too long.
pub(super) fn product(a: &Ratio<i128>, b: &Ratio<i128>) -> Option<Ratio<i128>> {
    let ((a, below_a), (b, below_b)) = (short(a)?, short(b)?);
    let left = if below_b == 1 { 1 } else { common(a.unsigned_abs(), below_b) };
    let right = if below_a == 1 { 1 } else { common(b.unsigned_abs(), below_a) };
    let above = i128::from(a / left) * i128::from(b / right);
    let below = i128::from(below_a / right) * i128::from(below_b / left);
    Some(Ratio::new_raw(above, below))
}

/// `a + b`, reduced; `None` where a part is too long (D. E. Knuth, The Art of Computer Programming 2, 4.5.1).
pub(super) fn sum(a: &Ratio<i128>, b: &Ratio<i128>) -> Option<Ratio<i128>> {
    let ((a, below_a), (b, below_b)) = (short(a)?, short(b)?);
    if below_a == 1 && below_b == 1 {
        return Some(Ratio::new_raw(i128::from(a) + i128::from(b), 1));
    }
    let shared = common(below_a.unsigned_abs(), below_b);
    let (rest_a, rest_b) = (below_a / shared, below_b / shared);
    let above = i128::from(a) * i128::from(rest_b) + i128::from(b) * i128::from(rest_a);
    if shared == 1 {
        return Some(Ratio::new_raw(above, i128::from(below_a) * i128::from(below_b)));
    }
    let above = i64::try_from(above).ok()?;
    let left = common(above.unsigned_abs(), shared);
    Some(Ratio::new_raw(i128::from(above / left), i128::from(rest_a) * i128::from(below_b / left)))
}

/// `a - b`, reduced; `None` where a part is too long.
pub(super) fn difference(a: &Ratio<i128>, b: &Ratio<i128>) -> Option<Ratio<i128>> {
    let negated = Ratio::new_raw(b.numer().checked_neg()?, *b.denom());
    sum(a, &negated)
}

#[cfg(test)]
mod tests {
    use super::{difference, product, sum};
    use num_bigint::BigInt;
    use num_rational::Ratio;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = i64> {
        prop_oneof![
            Just(0),
            Just(i64::MIN),
            Just(i64::MAX),
            -20..=20_i64,
            any::<i64>(),
            any::<i32>().prop_map(|short| i64::from(short) * 3600),
        ]
    }

    fn fraction() -> impl Strategy<Value = Ratio<i128>> {
        (number(), number())
            .prop_map(|(above, below)| Ratio::new(i128::from(above), i128::from(below.max(1))))
    }

    fn big(ratio: &Ratio<i128>) -> Ratio<BigInt> {
        Ratio::new_raw((*ratio.numer()).into(), (*ratio.denom()).into())
    }

    fn same(found: Option<Ratio<i128>>, expected: &Ratio<BigInt>) {
        if let Some(found) = found {
            // Both parts, so that it is reduced too.
            assert_eq!(big(&found).into_raw(), expected.clone().into_raw());
        }
    }

    proptest! {
        #[test]
        fn as_with_long_numbers(a in fraction(), b in fraction()) {
            let (long_a, long_b) = (big(&a), big(&b));
            same(product(&a, &b), &(&long_a * &long_b));
            same(sum(&a, &b), &(&long_a + &long_b));
            same(difference(&a, &b), &(&long_a - &long_b));
        }
    }

    #[test]
    fn short_parts_are_enough() {
        let half = Ratio::new(1, 2);
        let third = Ratio::new(-1, 3);
        assert_eq!(product(&half, &third), Some(Ratio::new(-1, 6)));
        assert_eq!(sum(&half, &third), Some(Ratio::new(1, 6)));
        assert_eq!(difference(&half, &half), Some(Ratio::new(0, 1)));
        let long = Ratio::from_integer(i128::from(i64::MAX) + 1);
        assert_eq!(product(&half, &long), None);
        assert_eq!(sum(&long, &half), None);
    }
}
