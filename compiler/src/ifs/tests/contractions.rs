//! Contraction against the facts of GEOMETRY 2, and the exact spectral tests against known spectra.

use proptest::prelude::*;

use super::fixtures::*;
use crate::exact::Rational;
use crate::ifs::difference::{forward_difference_operator, frame_operator};
use crate::ifs::spectrum::{euclidean_norm_below, spectral_radius_at_least_one};
use crate::ifs::*;

const FIRST: StateId = StateId(0);

fn verdict(automaton: &Automaton) -> Contraction {
    contraction(automaton, FIRST)
}

#[test]
fn bezier_and_bspline_halve_at_once() {
    let half = Contraction::Proved { length: 1, bound: 0.5, norm: Norm::Infinity };
    for degree in 1..6 {
        assert_eq!(verdict(&bezier(degree, &r(1, 2))), half);
        let germ = (unit(degree + 1, 0), unit(degree + 1, degree));
        assert_eq!(verdict(&automaton(curve("bspline", bspline_matrices(degree), germ.0, germ.1))), half);
    }
    assert_eq!(difference_norm(&bspline3_limit().states()[0].transforms[0]), r(1, 2));
    let uneven = Contraction::Proved { length: 1, bound: 0.54, norm: Norm::Infinity };
    assert_eq!(verdict(&bezier(3, &r(23, 50))), uneven);
}

#[test]
fn four_point_contracts_on_six_points_only() {
    for w in [r(1, 16), r(1, 4), r(1, 5)] {
        let Contraction::Proved { bound, .. } = verdict(&four_point(&w)) else { panic!("w = {w}") };
        assert!(bound < 1.0);
    }
    let Contraction::Refuted { word } = verdict(&four_point_on_five()) else { panic!("accepted") };
    assert_eq!(word.letters, [1]);
    // Beyond the range in which the scheme converges.
    assert!(matches!(verdict(&four_point(&r(1, 1))), Contraction::Refuted { .. }));
}

#[test]
fn the_fern_contracts_by_its_euclidean_factor() {
    let Contraction::Proved { length: 1, bound, .. } = verdict(&fern()) else {
        panic!("{:?}", verdict(&fern()))
    };
    assert!(bound < 1.0);
    for transform in &fern().states()[0].transforms {
        assert!(euclidean_norm_below(&frame_operator(&transform.matrix), &r(851, 1000)));
    }
    assert!(!euclidean_norm_below(&frame_operator(&fern().states()[0].transforms[1].matrix), &r(849, 1000)));
}

#[test]
fn scaled_rotations_contract_at_once_in_the_euclidean_norm() {
    // 24/25 of a turn by the angle of the triangle 3, 4, 5: its ∞-norm is above 1.
    let turn = matrix(125, &[&[125, 0, 0], &[-43, 72, 96], &[149, -96, 72]]);
    let state = automaton(curve("turn", vec![turn.clone(), turn], unit(3, 0), unit(3, 1)));
    let bound = 62_915.0 / 65_536.0;
    assert_eq!(verdict(&state), Contraction::Proved { length: 1, bound, norm: Norm::Euclidean });
}

#[test]
fn several_states_are_judged_together() {
    assert!(matches!(verdict(&alternating()), Contraction::Proved { .. }));
    // One state stretches on its way out and back: no single transform is a loop.
    let stretch = matrix(1, &[&[1, 0], &[-1, 2]]);
    let mut there = curve("there", vec![stretch], unit(2, 0), unit(2, 1));
    there.transforms[0].target = StateId(1);
    let back = curve("back", vec![matrix(2, &[&[2, 0], &[1, 1]])], unit(2, 0), unit(2, 1));
    let both = Automaton::try_new(vec![there, back]).unwrap();
    let Contraction::Refuted { word } = verdict(&both) else { panic!("accepted") };
    assert_eq!(word.letters, [0, 0]);
}

#[test]
fn a_rotation_without_contraction_is_refuted() {
    // A quarter turn about the first frame point: eigenvalues ±i.
    let turn = matrix(1, &[&[1, 0, 0], &[0, 0, 1], &[2, -1, 0]]);
    let state = automaton(curve("turn", vec![turn], unit(3, 0), unit(3, 1)));
    assert!(matches!(verdict(&state), Contraction::Refuted { .. }));
    let point = automaton(curve("point", vec![Matrix::identity(1)], unit(1, 0), unit(1, 0)));
    assert!(matches!(verdict(&point), Contraction::Proved { bound: 0.0, .. }));
}

/// A shear of spectral radius just below 1 and two transforms: more words than the budget, and no proof in sight.
#[test]
fn an_open_question_stays_open() {
    let shear = |entry: i64| matrix(1000, &[&[1000, 0, 0], &[1, 999, 0], &[1000 - 999 - entry, entry, 999]]);
    let state = automaton(curve("shear", vec![shear(5000), shear(4000)], unit(3, 0), unit(3, 1)));
    let Contraction::Open { length, bound } = verdict(&state) else { panic!("{:?}", verdict(&state)) };
    assert!(length >= 14 && bound >= 1.0);
}

#[test]
fn large_numbers_end_in_an_answer() {
    let huge = Rational::from_decimal("1e300").unwrap();
    let stretch = Matrix::from_rows(vec![unit(2, 0), vec![Rational::ONE - &huge, huge]]).unwrap();
    let state = automaton(curve("huge", vec![stretch], unit(2, 0), unit(2, 1)));
    assert!(matches!(verdict(&state), Contraction::Refuted { .. }));
}

#[test]
fn spectral_radii_are_decided_exactly() {
    let at_least_one =
        |denominator, rows: &[&[i64]]| spectral_radius_at_least_one(&matrix(denominator, rows));
    assert_eq!(at_least_one(1, &[&[0, 1], &[1, 0]]), Some(true));
    assert_eq!(at_least_one(1, &[&[0, 1], &[-1, 0]]), Some(true));
    assert_eq!(at_least_one(1, &[&[0, 1000], &[0, 0]]), Some(false));
    assert_eq!(at_least_one(10_000, &[&[0, 9_999], &[-9_999, 0]]), Some(false));
    assert_eq!(at_least_one(2, &[&[1, 5, 0], &[0, 1, 7], &[0, 0, 1]]), Some(false));
    assert_eq!(at_least_one(2, &[&[1, 5, 0], &[0, 1, 7], &[0, 0, -2]]), Some(true));
    assert!(euclidean_norm_below(&matrix(5, &[&[3, -4], &[4, 3]]), &r(1001, 1000)));
    assert!(!euclidean_norm_below(&matrix(5, &[&[3, -4], &[4, 3]]), &r(1, 1)));
}

fn affine_matrix(rows: usize, columns: usize) -> impl Strategy<Value = Matrix> {
    prop::collection::vec(prop::collection::vec(-8_i64..9, columns - 1), rows).prop_map(move |rows| {
        let complete = |row: Vec<i64>| {
            let mut weights: Vec<Rational> = row.into_iter().map(|entry| r(entry, 8)).collect();
            weights.push(Rational::ONE - weights.iter().sum::<Rational>());
            weights
        };
        Matrix::from_rows(rows.into_iter().map(complete).collect()).unwrap()
    })
}

fn differences(size: usize) -> Matrix {
    Matrix::from_entries(size - 1, size, |row, column| {
        Rational::from(i32::from(column == row + 1) - i32::from(column == row))
    })
}

proptest! {
    #[test]
    fn difference_operators_satisfy_their_equation(transform in affine_matrix(4, 5)) {
        let operator = forward_difference_operator(&transform);
        let left = differences(4).product(&transform);
        prop_assert_eq!(left, operator.product(&differences(5)));
    }

    /// A refuted word stretches some difference: its powers do not vanish. A proof bounds every word.
    #[test]
    fn verdicts_hold(a in affine_matrix(3, 3), b in affine_matrix(3, 3)) {
        let state = automaton(curve("random", vec![a.clone(), b.clone()], unit(3, 0), unit(3, 2)));
        let operators = [forward_difference_operator(&a), forward_difference_operator(&b)];
        match contraction(&state, FIRST) {
            Contraction::Refuted { word } => {
                let step = |product: Matrix, letter: &usize| operators[*letter].product(&product).unwrap();
                let once = word.letters.iter().fold(Matrix::identity(2), step);
                let many = (0..20).fold(Matrix::identity(2), |power, _| once.product(&power).unwrap());
                prop_assert!(many.infinity_norm() >= r(1, 2));
            }
            Contraction::Proved { length, bound, norm: Norm::Infinity } if length < 8 => {
                for word in 0..1_usize << length {
                    let step = |product: Matrix, place: u32| operators[word >> place & 1].product(&product).unwrap();
                    let product = (0..length).fold(Matrix::identity(2), step);
                    prop_assert!(product.infinity_norm() <= Rational::from_f64(bound).unwrap());
                }
            }
            _ => {}
        }
    }
}

/// GEOMETRY 2: the tenth-level figures of the schemes it names.
#[test]
fn known_factors_are_found() {
    let Contraction::Proved { length, bound, .. } = verdict(&four_point(&r(1, 16))) else { panic!("open") };
    // Words of any length do: the first below 1 proves; at length 9 the root is 0.516.
    assert!(length <= 9 && bound < 1.0);
    let state = four_point(&r(1, 16));
    let operators: Vec<Matrix> = state.states()[0]
        .transforms
        .iter()
        .map(|transform| forward_difference_operator(&transform.matrix))
        .collect();
    let mut words = vec![Matrix::identity(5)];
    for _ in 0..9 {
        words = words
            .iter()
            .flat_map(|word| operators.iter().map(move |step| step.product(word).unwrap()))
            .collect();
    }
    let largest = words.iter().map(|word| word.infinity_norm().to_f64()).fold(0.0, f64::max);
    let root = libm::pow(largest, 1.0 / 9.0);
    assert!((root - 0.516).abs() < 5e-4, "{root}");
    let mut states = fern().states().to_vec();
    states[0].space = StateSpace::Plane;
    let fern = verdict(&Automaton::try_new(states).unwrap());
    let Contraction::Proved { length: 1, bound, norm: Norm::Euclidean } = fern else { panic!("{fern:?}") };
    assert!((bound - 0.85).abs() < 1.0 / 256.0);
}
