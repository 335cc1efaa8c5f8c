//! Bounds of germs' sizes against the sizes themselves.

use proptest::prelude::*;

use super::fixtures::*;
use super::surfaces::{product, quad, triangle};
use crate::ifs::*;

const FIRST: StateId = StateId(0);

/// The largest distance between two vertices of one germ, over all words of a length.
fn largest(automaton: &Automaton, state: StateId, level: u32, points: &[[f64; 3]]) -> f64 {
    let combined = |row: &[f64]| {
        let mut sum = [0.0; 3];
        for (weight, point) in row.iter().zip(points) {
            (0..3).for_each(|axis| sum[axis] += weight * point[axis]);
        }
        sum
    };
    if level == 0 {
        let rows = &automaton.state(state).germ.vertices;
        let row =
            |row: &Vec<crate::exact::Rational>| row.iter().map(|weight| weight.to_f64()).collect::<Vec<_>>();
        let vertices: Vec<[f64; 3]> = rows.iter().map(|weights| combined(&row(weights))).collect();
        let distance = |a: &[f64; 3], b: &[f64; 3]| {
            (0..3).map(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis])).sum::<f64>().sqrt()
        };
        let pairs = vertices.iter().flat_map(|a| vertices.iter().map(move |b| distance(a, b)));
        return pairs.fold(0.0, f64::max);
    }
    let pieces = automaton.state(state).transforms.iter().map(|transform| {
        let matrix = transform.matrix.to_f64();
        let image: Vec<[f64; 3]> = matrix.chunks_exact(points.len()).map(combined).collect();
        largest(automaton, transform.target, level - 1, &image)
    });
    pieces.fold(0.0, f64::max)
}

fn figures() -> Vec<Automaton> {
    vec![
        bezier(3, &r(1, 2)),
        bezier(2, &r(1, 3)),
        bspline3_limit(),
        bspline3_control(),
        four_point(&r(1, 16)),
        alternating(),
        fern(),
        automaton(quad()),
        automaton(triangle(true)),
        automaton(product("patch", &bezier_matrices(1, &r(1, 2)), &unit(2, 0), &unit(2, 1))),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn no_germ_is_larger_than_its_bound(
        points in prop::collection::vec(prop::array::uniform3(-1000.0..1000.0_f64), 6),
        level in 0_u32..5,
    ) {
        for automaton in figures() {
            let bound = size_bound(&automaton, FIRST).unwrap();
            let points = &points[..automaton.state(FIRST).control_points];
            let size = largest(&automaton, FIRST, level, points);
            prop_assert!(size <= bound.size(level, points) + 1e-9, "{}", automaton.state(FIRST).name);
        }
    }
}

#[test]
fn bounds_shrink_by_the_certified_factor() {
    let bezier = size_bound(&bezier(3, &r(1, 2)), FIRST).unwrap();
    assert!((bezier.factor(0) - 3.0).abs() < 1e-9 && (bezier.factor(10) - 3.0 / 1024.0).abs() < 1e-9);
    let points = [[0.0; 3], [3.0, 4.0, 0.0], [3.0, 4.0, 1.0], [3.0, 4.0, 1.0]];
    assert!((bezier.spread(&points) - 5.0).abs() < 1e-12);
    assert!(size_bound(&four_point(&r(1, 16)), FIRST).unwrap().factor(400) < 1e-3);
    assert_eq!(size_bound(&four_point_on_five(), FIRST), None);
}
