//! Rationals against integer arithmetic, against the standard library's decimal reader, and at the edge of `i128`.

use num_bigint::BigInt;
use proptest::prelude::*;

use super::super::*;

fn r(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap()
}

#[test]
fn prints_in_lowest_terms() {
    assert_eq!(r(46, 100).to_string(), "23/50");
    assert_eq!(r(2, -4).to_string(), "-1/2");
    assert_eq!(r(-9, -3).to_string(), "3");
    assert_eq!(Rational::new(1, 0), None);
}

#[test]
fn reads_decimals_exactly() {
    assert_eq!(Rational::from_decimal("0.46"), Ok(r(23, 50)));
    assert_eq!(Rational::from_decimal("1.5e-3"), Ok(r(3, 2000)));
    assert_eq!(Rational::from_decimal("12E+2"), Ok(r(1200, 1)));
    assert_eq!(Rational::from_decimal("0e300"), Ok(Rational::ZERO));
    assert_eq!(Rational::from_decimal("1e300").unwrap().to_f64(), 1e300);
    for malformed in ["", ".5", "5.", "-1", "1e", "1e+", "1.e5", "0x1", "1_0", "١", "1e5.0", "1.2.3"] {
        assert_eq!(Rational::from_decimal(malformed), Err(DecimalError::Malformed), "{malformed}");
    }
}

#[test]
fn refuses_enormous_literals() {
    assert_eq!(Rational::from_decimal("1e999"), Err(DecimalError::ExponentTooLarge));
    assert_eq!(Rational::from_decimal("1e-301"), Err(DecimalError::ExponentTooLarge));
    assert_eq!(Rational::from_decimal("1e99999999999999999999999999"), Err(DecimalError::ExponentTooLarge));
    assert_eq!(
        Rational::from_decimal(&"9".repeat(1_000_000)),
        Err(DecimalError::TooManyDigits { digits: 1_000_000 })
    );
}

#[test]
fn overflows_into_big_integers_and_back() {
    let huge = Rational::from_decimal("1e38").unwrap();
    let product = &huge * &huge;
    assert_eq!(product.to_string(), format!("1{}", "0".repeat(76)));
    assert_eq!(&product / &huge, huge);
    assert_eq!((&product + &huge) - &product, huge);
    let least = Rational::from_integers(BigInt::from(i128::MIN), BigInt::from(1)).unwrap();
    assert_eq!(-(-&least), least);
    assert_eq!(&least + &Rational::ONE, -Rational::from_integers(BigInt::from(i128::MAX), 1.into()).unwrap());
    assert_eq!(least.abs().reciprocal().unwrap() * &least, -Rational::ONE);
    assert_eq!(r(1 << 62, 1) * r(1 << 62, 1) * r(-8, 1), least);
}

#[test]
fn powers_and_division_are_checked() {
    assert_eq!(r(2, 3).checked_pow(-3), Ok(r(27, 8)));
    assert_eq!(Rational::ZERO.checked_pow(0), Ok(Rational::ONE));
    assert_eq!(Rational::ZERO.checked_pow(-1), Err(ArithmeticError::DivisionByZero));
    assert_eq!(r(-1, 1).checked_pow(i32::MAX), Ok(r(-1, 1)));
    assert_eq!(r(-1, 1).checked_pow(i32::MIN), Ok(Rational::ONE));
    assert_eq!(r(3, 1).checked_pow(i32::MIN), Err(ArithmeticError::TooLarge));
    assert_eq!(Rational::ONE.checked_div(&Rational::ZERO), Err(ArithmeticError::DivisionByZero));
}

#[test]
fn doubles_round_to_nearest() {
    assert_eq!(r(1, 3).to_f64(), 1.0 / 3.0);
    // Halfway between 1 and its successor goes to even, a hair above goes up.
    assert_eq!(
        Rational::from_decimal("1.00000000000000011102230246251565404236316680908203125").unwrap().to_f64(),
        1.0
    );
    let above = Rational::from_decimal("1.00000000000000011102230246251565404236316680908203126").unwrap();
    assert_eq!(above.to_f64(), 1.0 + f64::EPSILON);
    let least = Rational::from_f64(f64::from_bits(1)).unwrap();
    assert_eq!(least.to_f64(), f64::from_bits(1));
    assert_eq!((&least / &r(2, 1)).to_f64(), 0.0);
    assert_eq!((&least * &r(3, 2)).to_f64(), f64::from_bits(2));
    let greatest = Rational::from_f64(f64::MAX).unwrap();
    assert_eq!((&greatest * &greatest).to_f64(), f64::INFINITY);
    assert_eq!(Rational::from_f64(f64::NAN), None);
    assert_eq!(Rational::from_f64(-0.0), Some(Rational::ZERO));
}

#[test]
fn sizes_and_integers() {
    assert_eq!(Rational::ZERO.bits(), 1);
    assert_eq!(r(3, 4).bits(), 5);
    assert_eq!(r(-7, 2).floor(), r(-4, 1));
    assert_eq!(r(7, 2).to_i64(), None);
    assert_eq!(r(-8, 2).to_i64(), Some(-4));
}

proptest! {
    #[test]
    fn field_laws(a: i64, b in 1_i64.., c: i64, d in 1_i64.., e: i64, f in 1_i64..) {
        let (x, y, z) = (r(a, b), r(c, d), r(e, f));
        prop_assert_eq!((&x + &y) * &z, &x * &z + &y * &z);
        prop_assert_eq!(&(&x + &y) + &z, &x + &(&y + &z));
        prop_assert_eq!(&x - &x, Rational::ZERO);
        if !y.is_zero() {
            prop_assert_eq!((&x / &y) * &y, x.clone());
        }
        let cross = (i128::from(a) * i128::from(d)).cmp(&(i128::from(c) * i128::from(b)));
        prop_assert_eq!(x.cmp(&y), cross);
    }

    #[test]
    fn doubles_are_exact_both_ways(bits: u64) {
        let value = f64::from_bits(bits);
        prop_assume!(value.is_finite());
        prop_assert_eq!(Rational::from_f64(value).unwrap().to_f64(), value);
    }

    /// The standard library reads decimals correctly rounded, subnormals included.
    #[test]
    fn decimals_round_as_the_standard_library(text in "[0-9]{1,30}(\\.[0-9]{1,40})?", exponent in -300_i32..=300) {
        let text = format!("{text}e{exponent}");
        prop_assert_eq!(Rational::from_decimal(&text).unwrap().to_f64(), text.parse::<f64>().unwrap());
    }

    #[test]
    fn reading_never_panics(text in "[0-9.eE+-]{0,12}") {
        let read = Rational::from_decimal(&text);
        if let Ok(value) = read {
            prop_assert_eq!(value.to_f64(), text.parse::<f64>().unwrap());
        }
    }
}
