//! Validation, exact identities of the rules, and counts.

use super::fixtures::*;
use crate::exact::Rational;
use crate::ifs::*;

#[test]
fn bsplines_match_the_printed_rows() {
    let cubic = bspline_matrices(3);
    let rows: [&[i64]; 5] = [&[4, 4, 0, 0], &[1, 6, 1, 0], &[0, 4, 4, 0], &[0, 1, 6, 1], &[0, 0, 4, 4]];
    assert_eq!(cubic[0], matrix(8, &rows[..4]));
    assert_eq!(cubic[1], matrix(8, &rows[1..]));
    assert!((1..7).all(|degree| bspline_matrices(degree).iter().all(Matrix::is_row_stochastic)));
    let chaikin = chaikin(unit(3, 0), unit(3, 2));
    assert_eq!(chaikin.states()[0].transforms[0].matrix, bspline_matrices(2)[0]);
    assert_eq!(chaikin.states()[0].transforms[1].matrix, bspline_matrices(2)[1]);
}

#[test]
fn bspline_and_bezier_are_conjugate() {
    let change = matrix(6, &[&[1, 4, 1, 0], &[0, 4, 2, 0], &[0, 2, 4, 0], &[0, 1, 4, 1]]);
    for (bspline, bezier) in bspline_matrices(3).iter().zip(&bezier_matrices(3, &r(1, 2))) {
        assert_eq!(change.product(bspline), bezier.product(&change));
    }
}

#[test]
fn the_middle_of_de_casteljau_has_the_right_weights() {
    let halves = bezier_matrices(3, &r(1, 2));
    assert_eq!(halves[0].row(3), weights(8, &[1, 3, 3, 1]));
    assert_eq!(halves[1].row(0), weights(8, &[1, 3, 3, 1]));
}

#[test]
fn matrices_check_their_sizes() {
    assert_eq!(Matrix::from_rows(vec![]), Err(MatrixError::Empty));
    let ragged = vec![vec![Rational::ONE], vec![Rational::ONE, Rational::ZERO]];
    assert_eq!(Matrix::from_rows(ragged), Err(MatrixError::Ragged { row: 1 }));
    let wide = matrix(1, &[&[1, 0, 0]]);
    assert_eq!(wide.product(&wide), Err(MatrixError::Sizes { left_columns: 3, right_rows: 1 }));
    assert_eq!(wide.product(&Matrix::identity(3)), Ok(wide.clone()));
    assert_eq!(wide.to_f64(), [1.0, 0.0, 0.0]);
}

fn refused(change: impl Fn(&mut State)) -> AutomatonError {
    let mut state = bezier(3, &r(1, 2)).states()[0].clone();
    change(&mut state);
    Automaton::try_new(vec![state]).unwrap_err()
}

#[test]
fn wrong_automata_are_refused() {
    let state = "bezier3(t: 1/2)".to_owned();
    let error = refused(|state| state.transforms[1].target = StateId(7));
    assert_eq!(
        error,
        AutomatonError::UnknownTarget { state: state.clone(), transform: "right".into(), target: StateId(7) }
    );
    let error = refused(|state| state.transforms[0].matrix = Matrix::identity(3));
    assert!(matches!(error, AutomatonError::WrongSize { expected: (4, 4), found: (3, 3), .. }));
    let error = refused(|state| state.transforms[0].matrix = matrix(2, &[&[2, 0, 0, 0][..]; 2]));
    assert!(matches!(error, AutomatonError::WrongSize { found: (2, 4), .. }));
    let error = refused(|state| {
        state.transforms[0].matrix = bspline_matrices(3)[0].product(&matrix(2, &[&[1; 4][..]; 4])).unwrap()
    });
    assert_eq!(
        error.to_string(),
        "weights of image point 0 in transform `left` of `bezier3(t: 1/2)` sum to 2, not 1"
    );
    let error = refused(|state| state.germ = Germ::segment(unit(3, 0), unit(4, 3)));
    assert!(matches!(error, AutomatonError::GermWeights { vertex: 0, expected: 4, found: 3, .. }));
    assert!(matches!(refused(|state| state.transforms.clear()), AutomatonError::NoTransforms { .. }));
    assert!(matches!(refused(|state| state.control_points = 0), AutomatonError::NoControlPoints { .. }));
    let many = vec![bezier(1, &r(1, 2)).states()[0].clone(); MAX_STATES + 1];
    assert_eq!(Automaton::try_new(many), Err(AutomatonError::TooManyStates { states: 1001 }));
}

const FIRST: StateId = StateId(0);

#[test]
fn counts_are_powers_of_the_adjacency_matrix() {
    let cubic = bezier(3, &r(1, 2));
    assert_eq!(count(&cubic, FIRST, 0, 10), Count::Exactly(1));
    assert_eq!(count(&cubic, FIRST, 10, 1 << 20), Count::Exactly(1024));
    assert_eq!(count(&cubic, FIRST, 21, 1 << 20), Count::Exceeds);
    assert_eq!(count(&fern(), FIRST, 12, u64::MAX), Count::Exactly(16_777_216));
    assert_eq!(count(&cubic, FIRST, 1_000_000_000, u64::MAX), Count::Exceeds);
}

/// `grows` leads to itself and to `stays`, which leads to itself only: level + 1 elements.
#[test]
fn slow_growth_is_counted_at_any_level() {
    let line = bezier_matrices(1, &r(1, 2));
    let mut grows = curve("grows", line.clone(), unit(2, 0), unit(2, 1));
    grows.transforms[1].target = StateId(1);
    let mut stays = curve("stays", line[..1].to_vec(), unit(2, 0), unit(2, 1));
    stays.transforms[0].target = StateId(1);
    let both = Automaton::try_new(vec![grows, stays]).unwrap();
    assert_eq!(count(&both, FIRST, 5000, 10_000), Count::Exactly(5001));
    assert_eq!(count(&both, FIRST, 1_000_000_000, 10_000), Count::Exceeds);
    assert_eq!(count(&both, FIRST, 1_000_000_000, u64::MAX), Count::Exceeds);
    assert_eq!(count(&both, StateId(1), 1_000_000_000, 1), Count::Exactly(1));
}

#[test]
fn words_read_as_names() {
    let both = alternating();
    let word = Word { start: FIRST, letters: vec![0, 1, 0] };
    assert_eq!(word.display(&both).to_string(), "left.right.left");
    assert_eq!(Word { start: FIRST, letters: vec![0, 5] }.names(&both), ["left"]);
}
