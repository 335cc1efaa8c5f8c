//! Polynomials and rational functions: printing, sums of weights, limits, and agreement with their values.

use proptest::prelude::*;

use super::super::*;

const T: AtomId = AtomId(0);
const U: AtomId = AtomId(1);

fn r(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap()
}

fn name(atom: AtomId) -> String {
    ["t", "u", "v"][atom.0 as usize].to_owned()
}

fn constant(value: i64) -> RationalFunction {
    RationalFunction::from_rational(value.into())
}

fn atom(atom: AtomId) -> RationalFunction {
    RationalFunction::from_atom(atom)
}

fn text(function: &RationalFunction) -> String {
    function.display(&name).to_string()
}

#[test]
fn prints_as_one_writes() {
    let t = atom(T);
    let one_minus_t = constant(1).checked_sub(&t).unwrap();
    assert_eq!(text(&one_minus_t), "1 - t");
    let square = t.checked_mul(&t).unwrap().checked_mul(&constant(2)).unwrap();
    assert_eq!(text(&square), "2*t^2");
    let half = RationalFunction::from_rational(r(-1, 2)).checked_mul(&t).unwrap();
    assert_eq!(text(&half), "-1/2*t");
    assert_eq!(text(&half.checked_mul(&atom(U)).unwrap().checked_add(&atom(U)).unwrap()), "u - 1/2*t*u");
    assert_eq!(text(&constant(0)), "0");
    assert_eq!(text(&t.checked_div(&constant(1).checked_add(&t).unwrap()).unwrap()), "t/(1 + t)");
    assert_eq!(text(&one_minus_t.checked_div(&t).unwrap()), "(1 - t)/t");
    assert_eq!(text(&constant(3).checked_div(&square).unwrap()), "3/2/t^2");
}

#[test]
fn weights_of_de_casteljau_sum_to_one() {
    // The middle point: (1-t)^3, 3 t (1-t)^2, 3 t^2 (1-t), t^3.
    let t = atom(T);
    let s = constant(1).checked_sub(&t).unwrap();
    let product = |factors: &[&RationalFunction]| {
        factors.iter().fold(constant(1), |total, factor| total.checked_mul(factor).unwrap())
    };
    let weights = [
        product(&[&s, &s, &s]),
        product(&[&constant(3), &t, &s, &s]),
        product(&[&constant(3), &t, &t, &s]),
        product(&[&t, &t, &t]),
    ];
    let sum = weights.iter().fold(constant(0), |total, weight| total.checked_add(weight).unwrap());
    assert_eq!(sum.constant(), Some(Rational::ONE));
    assert_eq!(weights[1].constant(), None);
    assert_eq!(weights[1].evaluate(&|_| Some(r(1, 2))), Some(r(3, 8)));
}

#[test]
fn quotients_cancel_and_compare() {
    let (t, u) = (atom(T), atom(U));
    let difference = t.checked_mul(&t).unwrap().checked_sub(&u.checked_mul(&u).unwrap()).unwrap();
    let quotient = difference.checked_div(&t.checked_sub(&u).unwrap()).unwrap();
    assert_eq!(text(&quotient), "t + u");
    // t/(t+u) + u/(t+u) = 1, also when built over another denominator.
    let sum = t.checked_add(&u).unwrap();
    let (a, b) = (t.checked_div(&sum).unwrap(), u.checked_div(&sum).unwrap());
    assert_eq!(a.checked_add(&b).unwrap().constant(), Some(Rational::ONE));
    let detour =
        t.checked_mul(&difference).unwrap().checked_div(&sum.checked_mul(&difference).unwrap()).unwrap();
    assert_eq!(a.equals(&detour), Ok(true));
    assert_eq!(a.equals(&b), Ok(false));
    assert_eq!(a.checked_div(&constant(0)).err(), Some(PolynomialError::DivisionByZero));
}

#[test]
fn growth_is_refused() {
    let mut power = atom(T).checked_add(&atom(U)).unwrap();
    let mut refused = None;
    for _ in 0..12 {
        match power.checked_mul(&power) {
            Ok(next) => power = next,
            Err(error) => {
                refused = Some(error);
                break;
            }
        }
    }
    assert_eq!(refused, Some(PolynomialError::TooComplex));
}

fn small_polynomial() -> impl Strategy<Value = Polynomial> {
    prop::collection::vec((-6_i64..7, 0_usize..4, 0_usize..4), 0..6).prop_map(|terms| {
        terms.into_iter().fold(Polynomial::zero(), |total, (coefficient, t, u)| {
            let factors = std::iter::repeat_n(T, t).chain(std::iter::repeat_n(U, u));
            let term = factors.fold(Polynomial::from_rational(coefficient.into()), |product, atom| {
                product.checked_mul(&Polynomial::from_atom(atom)).unwrap()
            });
            total.checked_add(&term).unwrap()
        })
    })
}

proptest! {
    #[test]
    fn arithmetic_agrees_with_values(
        a in small_polynomial(), b in small_polynomial(), c in small_polynomial(), t in -9_i64..10, u in -9_i64..10,
    ) {
        prop_assume!(!b.is_zero() && !c.is_zero());
        let at = |atom: AtomId| Some(if atom == T { r(t, 7) } else { r(u, 5) });
        let (f, g) = (RationalFunction::new(a.clone(), b.clone()).unwrap(), RationalFunction::new(c.clone(), b).unwrap());
        if let (Some(x), Some(y)) = (f.evaluate(&at), g.evaluate(&at)) {
            prop_assert_eq!(f.checked_add(&g).unwrap().evaluate(&at), Some(&x + &y));
            prop_assert_eq!(f.checked_sub(&g).unwrap().evaluate(&at), Some(&x - &y));
            prop_assert_eq!(f.checked_mul(&g).unwrap().evaluate(&at), Some(&x * &y));
            if !y.is_zero() {
                prop_assert_eq!(f.checked_div(&g).unwrap().evaluate(&at), Some(&x / &y));
            }
        }
        prop_assert_eq!(a.checked_mul(&c).unwrap().divided_exactly(&c), Some(a));
    }
}
