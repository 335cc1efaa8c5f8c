//! Joins of transforms and of windows.

use super::fixtures::*;
use crate::exact::Rational;
use crate::ifs::*;

const FIRST: StateId = StateId(0);

#[test]
fn bezier_arcs_join_at_every_split() {
    for degree in 1..6 {
        for split in [r(1, 2), r(23, 50), r(1, 3), r(-2, 1)] {
            assert_eq!(joins(&bezier(degree, &split), FIRST), Joins::Joined);
        }
    }
    assert_eq!(joins(&alternating(), FIRST), Joins::Joined);
}

#[test]
fn halves_cut_apart_are_open() {
    let halves = bezier_matrices(3, &r(1, 2));
    let later = bezier_matrices(3, &r(3, 5))[1].clone();
    let state = automaton(curve("cut", vec![halves[0].clone(), later], unit(4, 0), unit(4, 3)));
    let expected = OpenJoin {
        state: FIRST,
        left: 0,
        right: 1,
        level: 1,
        left_weights: weights(8, &[1, 3, 3, 1]),
        right_weights: weights(125, &[8, 36, 54, 27]),
    };
    assert_eq!(joins(&state, FIRST), Joins::Open(expected));
}

#[test]
fn bsplines_join_with_limit_and_control_germs() {
    for bspline in [bspline3_limit(), bspline3_control(), four_point(&r(1, 16))] {
        assert_eq!(joins(&bspline, FIRST), Joins::Joined);
        assert_eq!(windows_join(&bspline, FIRST), Joins::Joined);
    }
    let whole = automaton(curve("whole", bspline_matrices(3), unit(4, 0), unit(4, 3)));
    assert!(matches!(joins(&whole, FIRST), Joins::Open(OpenJoin { level: 1, .. })));
}

#[test]
fn chaikin_joins_on_its_polygon_and_on_its_limit() {
    for (start, end) in
        [(weights(2, &[1, 1, 0]), weights(2, &[0, 1, 1])), (unit(3, 0), unit(3, 1)), (unit(3, 1), unit(3, 2))]
    {
        let chaikin = chaikin(start, end);
        assert_eq!(joins(&chaikin, FIRST), Joins::Joined);
        assert_eq!(windows_join(&chaikin, FIRST), Joins::Joined);
    }
    let whole = chaikin(unit(3, 0), unit(3, 2));
    assert!(matches!(joins(&whole, FIRST), Joins::Open(_)));
    assert!(matches!(windows_join(&whole, FIRST), Joins::Open(OpenJoin { level: 0, .. })));
}

#[test]
fn bezier_windows_do_not_join() {
    let Joins::Open(open) = windows_join(&bezier(3, &r(1, 2)), FIRST) else { panic!("joined") };
    assert_eq!(open.left_weights, unit(5, 3));
    assert_eq!(open.right_weights, unit(5, 1));
}

/// The pieces meet at levels 1 to 3 and part at level 4: the shift register hands the difference on step by step.
#[test]
fn a_join_that_opens_late_is_found() {
    // The first transform takes the germ's start p0 through p1, p2, p3 before it reaches p4.
    let shift = |first: usize| {
        let places = [1, 2, 3, first, 4];
        Matrix::from_entries(5, 5, |row, column| Rational::from(i32::from(places[row] == column)))
    };
    // Left pieces end at p3 always; right pieces start where the shift has come to.
    let left = Matrix::from_entries(5, 5, |_, column| Rational::from(i32::from(column == 3)));
    let right = |last: usize| {
        let places = [3, 3, 3, last, 3];
        Matrix::from_entries(5, 5, |row, column| Rational::from(i32::from(places[row] == column)))
    };
    let state = |last: usize| {
        let mut top = curve("top", vec![left.clone(), right(last)], unit(5, 0), unit(5, 0));
        top.transforms[0].target = StateId(2);
        top.transforms[1].target = StateId(1);
        let mut slow = curve("slow", vec![shift(3)], unit(5, 0), unit(5, 0));
        slow.transforms[0].target = StateId(1);
        let mut still = curve("still", vec![Matrix::identity(5)], unit(5, 0), unit(5, 0));
        still.transforms[0].target = StateId(2);
        Automaton::try_new(vec![top, slow, still]).unwrap()
    };
    assert_eq!(joins(&state(3), FIRST), Joins::Joined);
    let Joins::Open(open) = joins(&state(2), FIRST) else { panic!("joined") };
    assert_eq!((open.level, open.left, open.right), (4, 0, 1));
    assert_eq!((open.left_weights, open.right_weights), (unit(5, 3), unit(5, 2)));
}

/// Sixty points and weights of long fractions: the recurrence is too long to follow exactly.
#[test]
fn a_proof_beyond_the_budget_is_not_claimed() {
    let size = 60;
    let dense = Matrix::from_entries(size, size, |row, column| {
        if column + 1 == size {
            // What is missing from 1.
            Rational::ONE - (0..size - 1).map(|c| r((row * c % 7) as i64, 1_000_003)).sum::<Rational>()
        } else {
            r((row * column % 7) as i64, 1_000_003)
        }
    });
    let state = automaton(curve("dense", vec![dense.clone()], unit(size, 1), unit(size, 2)));
    let Joins::Open(_) = windows_join(&state, FIRST) else { panic!("windows of different ends joined") };
    let twice = automaton(curve("twice", vec![dense.clone(), dense], unit(size, 1), unit(size, 1)));
    let Joins::Unproved { levels } = joins(&twice, FIRST) else { panic!("{:?}", joins(&twice, FIRST)) };
    assert!(levels > 3);
}
