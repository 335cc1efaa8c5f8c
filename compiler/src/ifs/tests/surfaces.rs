//! Joins of polygon germs: quads cut in four, patches of sixteen points, triangles, and what does not join.

use super::fixtures::*;
use crate::exact::Rational;
use crate::ifs::*;

const FIRST: StateId = StateId(0);

pub(crate) fn polygon(name: &str, pieces: Vec<Matrix>, corners: Vec<Vec<Rational>>) -> State {
    let mut state = curve(name, pieces, corners[0].clone(), corners[1].clone());
    for (place, transform) in state.transforms.iter_mut().enumerate() {
        transform.name = format!("piece.{place}");
    }
    state.germ = Germ { shape: GermShape::Polygon, vertices: corners };
    state
}

/// The Kronecker product: rows and columns of pairs, the first index slow.
fn kronecker(a: &Matrix, b: &Matrix) -> Matrix {
    Matrix::from_entries(a.rows() * b.rows(), a.columns() * b.columns(), |row, column| {
        &a.row(row / b.rows())[column / b.columns()] * &b.row(row % b.rows())[column % b.columns()]
    })
}

fn outer(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    a.iter().flat_map(|x| b.iter().map(move |y| x * y)).collect()
}

/// A product of a curve's matrices with themselves, its germ the quad around (0, 0), (1, 0), (1, 1), (0, 1).
pub(crate) fn product(name: &str, halves: &[Matrix], start: &[Rational], end: &[Rational]) -> State {
    let pieces = halves.iter().flat_map(|u| halves.iter().map(move |v| kronecker(u, v))).collect();
    let corners = vec![outer(start, start), outer(end, start), outer(end, end), outer(start, end)];
    polygon(name, pieces, corners)
}

/// A quad of four corners, in order around, cut in four at its edges' middles.
pub(crate) fn quad() -> State {
    let around = [[0, 0], [2, 0], [2, 2], [0, 2]];
    let row = |x: i64, y: i64| weights(4, &[(2 - x) * (2 - y), x * (2 - y), x * y, (2 - x) * y]);
    let piece = |u: i64, v: i64| {
        Matrix::from_rows(around.iter().map(|[x, y]| row(u + x / 2, v + y / 2)).collect()).unwrap()
    };
    let corners = (0..4).map(|place| unit(4, place)).collect();
    polygon("quad", vec![piece(0, 0), piece(1, 0), piece(1, 1), piece(0, 1)], corners)
}

/// A triangle cut at its edges' middles, without the piece in the middle when `whole` is not set.
pub(crate) fn triangle(whole: bool) -> State {
    let mut pieces = vec![
        matrix(2, &[&[2, 0, 0], &[1, 1, 0], &[1, 0, 1]]),
        matrix(2, &[&[1, 1, 0], &[0, 2, 0], &[0, 1, 1]]),
        matrix(2, &[&[1, 0, 1], &[0, 1, 1], &[0, 0, 2]]),
    ];
    if whole {
        pieces.push(matrix(2, &[&[0, 1, 1], &[1, 0, 1], &[1, 1, 0]]));
    }
    polygon("triangle", pieces, (0..3).map(|place| unit(3, place)).collect())
}

fn joined(state: State) -> Adjacency {
    match surface_joins(&automaton(state), FIRST) {
        SurfaceJoins::Joined(adjacency) => adjacency,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_quad_in_four_is_joined() {
    let adjacency = joined(quad());
    let patch = &adjacency.patches[&FIRST];
    assert_eq!(patch.glued.len(), 4);
    assert_eq!(patch.edges.iter().map(Vec::len).collect::<Vec<_>>(), [2, 2, 2, 2]);
    let along = |transform, edge| PieceEdge { transform, edge };
    assert_eq!(patch.edges[0], [along(0, 0), along(1, 0)]);
    assert_eq!(patch.edges[2], [along(2, 2), along(3, 2)]);
}

#[test]
fn patches_of_sixteen_points_are_joined() {
    for (halves, start, end) in [
        (bezier_matrices(3, &r(1, 2)), unit(4, 0), unit(4, 3)),
        (bezier_matrices(3, &r(1, 3)), unit(4, 0), unit(4, 3)),
        (bspline_matrices(3), weights(6, &[1, 4, 1, 0]), weights(6, &[0, 1, 4, 1])),
        (bspline_matrices(3), unit(4, 1), unit(4, 2)),
    ] {
        let patch = joined(product("patch", &halves, &start, &end)).patches[&FIRST].clone();
        assert_eq!((patch.glued.len(), patch.edges.len()), (4, 4));
    }
}

#[test]
fn a_triangle_in_four_is_joined_and_without_its_middle_open() {
    assert_eq!(joined(triangle(true)).patches[&FIRST].glued.len(), 3);
    let SurfaceJoins::Open(open) = surface_joins(&automaton(triangle(false)), FIRST) else {
        panic!("joined")
    };
    assert_eq!((open.state, open.level), (FIRST, 1));
    assert_ne!(open.left_weights, open.right_weights);
}

#[test]
fn a_carpet_has_holes_and_is_joined() {
    let around = [[0, 0], [1, 0], [1, 1], [0, 1]];
    let row = |x: i64, y: i64| weights(9, &[(3 - x) * (3 - y), x * (3 - y), x * y, (3 - x) * y]);
    let piece =
        |u: i64, v: i64| Matrix::from_rows(around.iter().map(|[x, y]| row(u + x, v + y)).collect()).unwrap();
    let places = (0..9).filter(|place| *place != 4).map(|place| piece(place % 3, place / 3));
    let carpet = polygon("carpet", places.collect(), (0..4).map(|place| unit(4, place)).collect());
    let patch = joined(carpet).patches[&FIRST].clone();
    assert_eq!((patch.glued.len(), patch.edges.iter().map(Vec::len).sum::<usize>()), (8, 12));
}

/// One weight is wrong: the two rows that differ are those of the moved vertex.
#[test]
fn a_wrong_weight_is_open_with_both_rows() {
    let mut state = quad();
    let moved = |at: usize, place: usize, state: &mut State| {
        let old = state.transforms[at].matrix.clone();
        let rows = (0..4).map(|row| match row == place {
            true => weights(8, &[3, 2, 1, 2]),
            false => old.row(row).to_vec(),
        });
        state.transforms[at].matrix = Matrix::from_rows(rows.collect()).unwrap();
    };
    moved(2, 0, &mut state);
    let SurfaceJoins::Open(open) = surface_joins(&automaton(state), FIRST) else { panic!("joined") };
    let (wrong, right) = (weights(8, &[3, 2, 1, 2]), weights(4, &[1, 1, 1, 1]));
    let rows = [open.left_weights, open.right_weights];
    assert!(rows.contains(&wrong) && rows.contains(&right), "{rows:?}");
    // Another vertex of the middle of an edge: the pieces still hang together, but a gap is open.
    let mut slit = quad();
    moved(1, 0, &mut slit);
    let SurfaceJoins::Open(open) = surface_joins(&automaton(slit), FIRST) else { panic!("joined") };
    let (wrong, right) = (weights(8, &[3, 2, 1, 2]), weights(2, &[1, 1, 0, 0]));
    let rows = [open.left_weights, open.right_weights];
    assert!(rows.contains(&wrong) && rows.contains(&right), "{rows:?}");
}

/// The pieces coincide at level 1 and part at level 2: the cut along one edge is not the cut along the other.
#[test]
fn edges_cut_at_different_places_part_later() {
    let around = [[0, 0], [1, 0], [1, 1], [0, 1]];
    // Columns of a third and two thirds, rows of halves; the piece in the upper right corner is turned a quarter.
    let row = |x: i64, y: i64| {
        let (x, y) = (r([0, 1, 3][x as usize], 3), r(y, 2));
        let (left, below) = (Rational::ONE - &x, Rational::ONE - &y);
        vec![&left * &below, &x * &below, &x * &y, &left * &y]
    };
    let piece = |u: i64, v: i64, turn: usize| {
        let corner = |place: usize| around[(place + turn) % 4];
        Matrix::from_rows((0..4).map(|place| row(u + corner(place)[0], v + corner(place)[1])).collect())
            .unwrap()
    };
    let corners: Vec<Vec<Rational>> = (0..4).map(|place| unit(4, place)).collect();
    let straight = vec![piece(0, 0, 0), piece(1, 0, 0), piece(1, 1, 0), piece(0, 1, 0)];
    joined(polygon("straight", straight.clone(), corners.clone()));
    let mut turned = straight;
    turned[2] = piece(1, 1, 1);
    let SurfaceJoins::Open(open) = surface_joins(&automaton(polygon("turned", turned, corners)), FIRST)
    else {
        panic!("joined")
    };
    assert_eq!(open.level, 2);
    assert_ne!(open.left_weights, open.right_weights);
}

#[test]
fn a_curve_is_no_surface() {
    let verdict = surface_joins(&bezier(3, &r(1, 2)), FIRST);
    assert_eq!(verdict, SurfaceJoins::NotPolygons { state: FIRST });
}
