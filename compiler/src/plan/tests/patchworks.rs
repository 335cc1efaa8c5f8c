//! Patchworks against tensor products, formulas and Euler's count.

use super::*;
use crate::ifs::tests::fixtures::automaton as single_state;
use crate::ifs::tests::surfaces::{polygon, product, quad, triangle};
use crate::plan::address::FigureAddresses;
use crate::plan::evaluate::{Patchwork, SheetEvaluator, patchwork};
use crate::plan::{PatchworkPlan, PlanError};
use std::collections::BTreeSet;

fn made(automaton: Automaton, points: Vec<[f64; 3]>, level: u32) -> (Plan, Patchwork) {
    let shape = Shape::Patchwork(PatchworkPlan { state: FIRST, points, level, dimension: Dimension::Space });
    let plan = plan(automaton, vec![figure("patch", None, shape)]);
    let Shape::Patchwork(one) = &plan.figures()[0].shape else { panic!("another shape") };
    let mesh = patchwork(plan.automaton(), plan.adjacency(FIRST).unwrap(), one).unwrap();
    (plan, mesh)
}

/// Vertices, edges and faces of a mesh.
fn counts(mesh: &Patchwork) -> (usize, usize, usize) {
    let around = |polygon: &[u32]| -> Vec<(u32, u32)> {
        let ends = polygon.iter().zip(polygon.iter().cycle().skip(1));
        ends.map(|(a, b)| (*a.min(b), *a.max(b))).collect()
    };
    let edges: BTreeSet<(u32, u32)> = mesh.polygons().flat_map(around).collect();
    (mesh.vertices.len(), edges.len(), mesh.polygons().count())
}

/// Row and column of a quad in the product's grid, from its word: the letters are u and v by halves.
fn place(letters: &[usize]) -> (usize, usize) {
    letters.iter().fold((0, 0), |(u, v), letter| (2 * u + letter / 2, 2 * v + letter % 2))
}

#[test]
fn a_patch_of_sixteen_points_is_the_tensor_product() {
    let level = 4;
    for (halves, start, end) in [
        (bezier_matrices(3, &r(1, 2)), unit(4, 0), unit(4, 3)),
        (bezier_matrices(3, &r(23, 50)), unit(4, 0), unit(4, 3)),
        (bspline_matrices(3), weights(6, &[1, 4, 1, 0]), weights(6, &[0, 1, 4, 1])),
    ] {
        let one = curve("one", halves.clone(), start.clone(), end.clone());
        let one = single_state(one);
        let flat = sheet(4, 4, (level, level), false);
        let evaluator = SheetEvaluator::new(&one, &flat);
        let mut grid = Vec::new();
        evaluator.fill(&mut grid);
        let both = single_state(product("patch", &halves, &start, &end));
        let (plan, mesh) = made(both, net(4, 4), level);
        assert_eq!((mesh.vertices.len(), evaluator.rows()), (17 * 17, 17));
        let words = crate::plan::address::ChainWords::new(plan.automaton(), FIRST, level);
        for (element, corners) in mesh.polygons().enumerate() {
            let (u, v) = place(&words.word(element as u64).unwrap().letters);
            let expected = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)];
            for (corner, (row, column)) in corners.iter().zip(expected) {
                let (a, b) = (mesh.vertices[*corner as usize], grid[row * 17 + column]);
                assert!((0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-9), "{a:?} {b:?}");
            }
        }
    }
}

#[test]
fn quads_and_triangles_weld_into_one_disc() {
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]];
    let (_, quads) = made(single_state(quad()), corners.clone(), 3);
    assert_eq!(counts(&quads), (81, 144, 64));
    let whole = single_state(triangle(true));
    let (plan, triangles) = made(whole, corners[..3].to_vec(), 3);
    assert_eq!(counts(&triangles), (45, 108, 64));
    assert!(triangles.polygons().all(|polygon| polygon.len() == 3));
    let addresses = FigureAddresses::new(plan.automaton(), &plan.figures()[0]);
    let last = addresses.segment(63).unwrap();
    assert_eq!(
        (last.to_string().as_str(), last.alias.as_str()),
        ("patch.piece.3.piece.3.piece.3", "patch-63")
    );
    let (_, one) = made(single_state(quad()), corners, 0);
    assert_eq!(counts(&one), (4, 4, 1));
}

#[test]
fn polygons_that_do_not_join_are_no_patchwork() {
    let open = single_state(triangle(false));
    let points = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let shape =
        Shape::Patchwork(PatchworkPlan { state: FIRST, points, level: 2, dimension: Dimension::Plane });
    let refused = Plan::try_new(open, vec![figure("gasket", None, shape)]);
    assert_eq!(refused.err(), Some(PlanError::NotSurface { figure: "gasket".to_owned(), state: FIRST }));
}

#[test]
fn a_carpet_keeps_its_holes() {
    let around = [[0, 0], [1, 0], [1, 1], [0, 1]];
    let row = |x: i64, y: i64| weights(9, &[(3 - x) * (3 - y), x * (3 - y), x * y, (3 - x) * y]);
    let piece = |u: i64, v: i64| {
        crate::ifs::Matrix::from_rows(around.iter().map(|[x, y]| row(u + x, v + y)).collect()).unwrap()
    };
    let places = (0..9).filter(|place| *place != 4).map(|place| piece(place % 3, place / 3));
    let carpet = polygon("carpet", places.collect(), (0..4).map(|place| unit(4, place)).collect());
    let corners = vec![[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [9.0, 9.0, 0.0], [0.0, 9.0, 0.0]];
    let (_, mesh) = made(single_state(carpet), corners, 2);
    // One disc with nine holes: V − E + F = 1 − 9.
    let (vertices, edges, faces) = counts(&mesh);
    assert_eq!(faces, 64);
    assert_eq!(vertices as i64 - edges as i64 + faces as i64, 1 - 9);
}

#[test]
fn the_printed_plan_says_what_is_shared() {
    let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]];
    let (plan, _) = made(single_state(quad()), corners, 2);
    let text = plan.to_string();
    let line =
        "figure patch: patchwork of state 0 at level 2, 4 pairs of edges proved to be shared: 16 elements\n";
    assert!(text.ends_with(line), "{text}");
    assert_eq!(crate::plan::budget::check(&plan, 16).unwrap()[0].elements, 16);
    assert!(crate::plan::budget::check(&plan, 15).is_err());
}
