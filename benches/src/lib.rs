//! Shared pieces of the benchmarks: the designs that are measured, and how processes are timed.

// A benchmark that cannot build its design has nothing to measure.
#![allow(clippy::expect_used)]
#![allow(clippy::disallowed_methods, reason = "races read clocks")]

pub mod boards;
pub mod large;
pub mod pieces;
pub mod processes;

use ifs_compiler::exact::Rational;
use ifs_compiler::ifs::{Automaton, Germ, Matrix, State, StateId, Transform};

/// A cubic Bézier arc, halved.
pub fn bezier3() -> Automaton {
    let left = [[8, 0, 0, 0], [4, 4, 0, 0], [2, 4, 2, 0], [1, 3, 3, 1]];
    let right = [[1, 3, 3, 1], [0, 2, 4, 2], [0, 0, 4, 4], [0, 0, 0, 8]];
    cubic("bezier3", [left, right], 1, [[1, 0, 0, 0], [0, 0, 0, 1]])
}

/// A uniform cubic B-spline whose germ joins points of the limit curve.
pub fn bspline3() -> Automaton {
    let left = [[4, 4, 0, 0], [1, 6, 1, 0], [0, 4, 4, 0], [0, 1, 6, 1]];
    let right = [[1, 6, 1, 0], [0, 4, 4, 0], [0, 1, 6, 1], [0, 0, 4, 4]];
    cubic("bspline3", [left, right], 6, [[1, 4, 1, 0], [0, 1, 4, 1]])
}

/// A net of `rows` by `columns` points on a wave, in millimetres.
pub fn net(rows: usize, columns: usize) -> Vec<[f64; 3]> {
    let height = |i: usize, j: usize| ((3 * i + 5 * j) % 7) as f64 * 100.0;
    let point = |i: usize, j: usize| [i as f64 * 1000.0, j as f64 * 1000.0, height(i, j)];
    (0..rows).flat_map(|i| (0..columns).map(move |j| point(i, j))).collect()
}

fn cubic(name: &str, matrices: [[[i64; 4]; 4]; 2], denominator: i64, germ: [[i64; 4]; 2]) -> Automaton {
    let row = |row: [i64; 4], denominator: i64| {
        row.map(|entry| Rational::new(entry, denominator).expect("a denominator above 0")).to_vec()
    };
    let transform = |name: &str, matrix: [[i64; 4]; 4]| Transform {
        name: name.to_owned(),
        target: StateId(0),
        matrix: Matrix::from_rows(matrix.map(|entries| row(entries, 8)).to_vec())
            .expect("rows of one length"),
    };
    let [start, end] = germ.map(|vertex| row(vertex, denominator));
    let transforms = vec![transform("left", matrices[0]), transform("right", matrices[1])];
    let state = State::new(name.to_owned(), 4, transforms, Germ::segment(start, end));
    Automaton::try_new(vec![state]).expect("rows that sum to 1")
}
