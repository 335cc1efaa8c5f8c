//! The rules of GEOMETRY 1, built from their formulas.

use crate::exact::Rational;
use crate::ifs::{Automaton, Germ, Matrix, State, StateId, Transform};

pub(crate) fn r(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator, denominator).unwrap()
}

/// A matrix of integers over one denominator.
pub(crate) fn matrix(denominator: i64, rows: &[&[i64]]) -> Matrix {
    let row = |row: &&[i64]| row.iter().map(|entry| r(*entry, denominator)).collect();
    Matrix::from_rows(rows.iter().map(row).collect()).unwrap()
}

pub(crate) fn weights(denominator: i64, row: &[i64]) -> Vec<Rational> {
    row.iter().map(|entry| r(*entry, denominator)).collect()
}

/// A state that continues with itself, `left` then `right` (or `0`, `1`, … when there are more).
pub(crate) fn curve(name: &str, matrices: Vec<Matrix>, start: Vec<Rational>, end: Vec<Rational>) -> State {
    let named = |(place, matrix): (usize, Matrix)| Transform {
        name: ["left", "right"].get(place).map_or(format!("piece.{place}"), |name| (*name).to_owned()),
        target: StateId(0),
        matrix,
    };
    State::new(
        name.to_owned(),
        start.len(),
        matrices.into_iter().enumerate().map(named).collect(),
        Germ::segment(start, end),
    )
}

pub(crate) fn automaton(state: State) -> Automaton {
    Automaton::try_new(vec![state]).unwrap()
}

pub(crate) fn unit(size: usize, place: usize) -> Vec<Rational> {
    (0..size).map(|index| if index == place { Rational::ONE } else { Rational::ZERO }).collect()
}

fn binomial(n: usize, k: usize) -> i64 {
    (0..k).fold(1, |total, i| total * (n - i) as i64 / (i as i64 + 1))
}

/// De Casteljau's two matrices for a split at `s`.
pub(crate) fn bezier_matrices(degree: usize, s: &Rational) -> Vec<Matrix> {
    let entry = |i: usize, j: usize, s: &Rational| {
        if j > i {
            return Rational::ZERO;
        }
        let rest = Rational::ONE - s;
        let powers = s.checked_pow(j as i32).unwrap() * rest.checked_pow((i - j) as i32).unwrap();
        Rational::from(binomial(i, j)) * powers
    };
    let size = degree + 1;
    let left = Matrix::from_entries(size, size, |i, j| entry(i, j, s));
    let right = Matrix::from_entries(size, size, |i, j| entry(degree - i, degree - j, &(Rational::ONE - s)));
    vec![left, right]
}

pub(crate) fn bezier(degree: usize, s: &Rational) -> Automaton {
    let name = format!("bezier{degree}(t: {s})");
    automaton(curve(&name, bezier_matrices(degree, s), unit(degree + 1, 0), unit(degree + 1, degree)))
}

/// Lane–Riesenfeld's matrices from the mask C(d+1, k)/2^d.
pub(crate) fn bspline_matrices(degree: usize) -> Vec<Matrix> {
    let size = degree + 1;
    let piece = |shift: usize| {
        Matrix::from_entries(size, size, |i, j| {
            // Row i of the refined polygon counts from the last point that needs p_0: p'_i = Σ a[i − 2j] p_j.
            let place = (i + shift + degree) as i64 - 2 * j as i64;
            match usize::try_from(place) {
                Ok(k) if k <= degree + 1 => r(binomial(degree + 1, k), 1 << degree),
                _ => Rational::ZERO,
            }
        })
    };
    vec![piece(0), piece(1)]
}

pub(crate) fn bspline3_limit() -> Automaton {
    automaton(curve("bspline3", bspline_matrices(3), weights(6, &[1, 4, 1, 0]), weights(6, &[0, 1, 4, 1])))
}

pub(crate) fn bspline3_control() -> Automaton {
    automaton(curve("bspline3_control", bspline_matrices(3), unit(4, 1), unit(4, 2)))
}

/// Chaikin's corner cutting with the control polygon as germ.
pub(crate) fn chaikin(start: Vec<Rational>, end: Vec<Rational>) -> Automaton {
    let left = matrix(4, &[&[3, 1, 0], &[1, 3, 0], &[0, 3, 1]]);
    let right = matrix(4, &[&[1, 3, 0], &[0, 3, 1], &[0, 1, 3]]);
    automaton(curve("chaikin", vec![left, right], start, end))
}

/// Dubuc–Deslauriers with tension w on a window of six points.
pub(crate) fn four_point(w: &Rational) -> Automaton {
    let edge = |at: usize| {
        let mut row = vec![Rational::ZERO; 6];
        let half = r(1, 2) + w;
        for (place, weight) in [-w, half.clone(), half, -w].into_iter().enumerate() {
            row[at + place] = weight;
        }
        row
    };
    let left = vec![unit(6, 1), edge(0), unit(6, 2), edge(1), unit(6, 3), edge(2)];
    let right = vec![edge(0), unit(6, 2), edge(1), unit(6, 3), edge(2), unit(6, 4)];
    let matrices = vec![Matrix::from_rows(left).unwrap(), Matrix::from_rows(right).unwrap()];
    automaton(curve("four_point", matrices, unit(6, 2), unit(6, 3)))
}

/// The window of five, which does not contract.
pub(crate) fn four_point_on_five() -> Automaton {
    let edge = |at: usize| {
        let mut row = [0; 5];
        row[at..at + 4].copy_from_slice(&[-1, 9, 9, -1]);
        row
    };
    let (m0, m1) = (edge(0), edge(1));
    let e = |place: usize| {
        let mut row = [0; 5];
        row[place] = 16;
        row
    };
    let left = matrix(16, &[&e(1), &m0, &e(2), &m1, &e(3)]);
    let right = matrix(16, &[&m0, &e(2), &m1, &e(3), &[0, 0, 0, 0, 16]]);
    automaton(curve("four_point_on_five", vec![left, right], unit(5, 2), unit(5, 3)))
}

/// Two ifs that continue with each other, the second on fewer points: a quadratic Bézier arc raised to a cubic.
pub(crate) fn alternating() -> Automaton {
    let halves = bezier_matrices(3, &r(1, 2));
    let raise = matrix(3, &[&[3, 0, 0], &[1, 2, 0], &[0, 2, 1], &[0, 0, 3]]);
    let quadratic = bezier_matrices(2, &r(1, 2));
    // Its left half as a quadratic: the cubic of a raised quadratic knows it by p0, (3 p1 − p0)/2, p3.
    let lower = matrix(2, &[&[2, 0, 0, 0], &[-1, 3, 0, 0], &[0, 0, 0, 2]]);
    let transform =
        |name: &str, target, matrix| Transform { name: name.to_owned(), target: StateId(target), matrix };
    let cubic = State::new(
        "smooth".to_owned(),
        4,
        vec![
            transform("left", 1, lower.product(&halves[0]).unwrap()),
            transform("right", 0, halves[1].clone()),
        ],
        Germ::segment(unit(4, 0), unit(4, 3)),
    );
    let square = State::new(
        "rough".to_owned(),
        3,
        vec![
            transform("left", 0, raise.product(&quadratic[0]).unwrap()),
            transform("right", 1, quadratic[1].clone()),
        ],
        Germ::segment(unit(3, 0), unit(3, 2)),
    );
    Automaton::try_new(vec![cubic, square]).unwrap()
}

/// Barnsley's fern on the frame (0,0), (1,0), (0,1); `frond` turns by 2.66 degrees.
pub(crate) fn fern() -> Automaton {
    let (sine, cosine) = (0.046_408_f64 * 0.85, 0.998_922_f64 * 0.85);
    let map = |a: f64, b: f64, c: f64, d: f64, y: f64| {
        let exact = |value: f64| Rational::from_f64(value).unwrap();
        let image = |x: f64, z: f64| vec![Rational::ONE - exact(x) - exact(z), exact(x), exact(z)];
        Matrix::from_rows(vec![image(0.0, y), image(a, y + c), image(b, y + d)]).unwrap()
    };
    let matrices = vec![
        map(0.0, 0.0, 0.0, 0.16, 0.0),
        map(cosine, sine, -sine, cosine, 1.6),
        map(0.20, -0.26, 0.23, 0.22, 1.6),
        map(-0.15, 0.28, 0.26, 0.24, 0.44),
    ];
    automaton(curve("fern", matrices, unit(3, 0), weights(1, &[-9, 0, 10])))
}
