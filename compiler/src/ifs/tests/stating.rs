//! Joins as they are stated, on the B-spline of LANGUAGE 9 and on arcs of segments.

use proptest::prelude::*;

use super::fixtures::*;
use crate::ifs::*;

const SPLINE: StateId = StateId(0);

/// The cubic B-spline with its ends as points, weights of the right end's middle row over 24 as given.
fn spline(end_rows: [&[i64]; 3]) -> Automaton {
    let step = matrix(8, &[&[4, 4, 0], &[1, 6, 1], &[0, 4, 4]]);
    let mut end = curve("bspline3_end", vec![step], unit(3, 0), unit(3, 2));
    end.transforms[0].name = "only".to_owned();
    end.transforms[0].target = StateId(1);
    end.germ = Germ { shape: GermShape::Point, vertices: vec![weights(6, &[1, 4, 1])] };
    let mut spline =
        curve("bspline3", bspline_matrices(3), weights(6, &[1, 4, 1, 0]), weights(6, &[0, 1, 4, 1]));
    let boundary = |name: &str, matrix| Boundary { name: name.to_owned(), target: StateId(1), matrix };
    spline.boundaries = vec![
        boundary("start", matrix(1, &[&[1, 0, 0, 0], &[0, 1, 0, 0], &[0, 0, 1, 0]])),
        boundary("end", matrix(24, &end_rows)),
    ];
    let piece = |transform, boundary| Side::Piece { transform, boundary };
    let own = |boundary| Side::Own { boundary, transform: 0 };
    spline.stated_joins = vec![
        StatedJoin { left: piece(0, 1), right: piece(1, 0) },
        StatedJoin { left: own(0), right: piece(0, 0) },
        StatedJoin { left: own(1), right: piece(1, 1) },
        StatedJoin { left: Side::PieceEnd { transform: 0, end: End::Finish }, right: piece(1, 0) },
    ];
    Automaton::try_new(vec![spline, end]).unwrap()
}

fn verdicts(automaton: &Automaton, state: StateId) -> Vec<Stated> {
    let joins = &automaton.state(state).stated_joins;
    joins.iter().map(|join| stated_join(automaton, state, join)).collect()
}

#[test]
fn the_spline_of_the_language_holds() {
    let automaton = spline([&[0, 24, 0, 0], &[0, 0, 24, 0], &[0, 0, 0, 24]]);
    assert_eq!(verdicts(&automaton, SPLINE), vec![Stated::Holds; 4]);
}

#[test]
fn a_boundary_of_wrong_weights_is_apart_in_both_rows() {
    let automaton = spline([&[0, 24, 0, 0], &[0, 1, 23, 0], &[0, 0, 0, 24]]);
    let verdicts = verdicts(&automaton, SPLINE);
    let Stated::Apart(apart) = &verdicts[0] else { panic!("{verdicts:?}") };
    assert_eq!(apart.level, 1);
    assert_eq!(apart.right_weights, weights(48, &[1, 23, 23, 1]));
    assert_ne!(apart.left_weights, apart.right_weights);
    let pairs = apart.left_weights.iter().zip(&apart.right_weights);
    assert_eq!(pairs.map(|(left, right)| (left - right).abs()).max(), Some(r(1, 96)));
    assert!(matches!(verdicts[2], Stated::Apart(_)));
    assert_eq!([&verdicts[1], &verdicts[3]], [&Stated::Holds; 2]);
}

#[test]
fn ends_of_segments_need_no_boundary() {
    let end = |transform, end| Side::PieceEnd { transform, end };
    let (left_end, right_start) = (end(0, End::Finish), end(1, End::Start));
    let mut arc = curve("arc", bezier_matrices(3, &r(1, 3)), unit(4, 0), unit(4, 3));
    arc.stated_joins = vec![
        StatedJoin { left: left_end, right: right_start },
        StatedJoin { left: Side::OwnEnd(End::Start), right: end(0, End::Start) },
        StatedJoin { left: Side::OwnEnd(End::Finish), right: end(1, End::Finish) },
        StatedJoin { left: Side::OwnEnd(End::Finish), right: left_end },
    ];
    let automaton = automaton(arc);
    let verdicts = verdicts(&automaton, SPLINE);
    assert_eq!(verdicts[..3], [Stated::Holds, Stated::Holds, Stated::Holds]);
    let Stated::Apart(apart) = &verdicts[3] else { panic!("{verdicts:?}") };
    assert_eq!(apart.left_weights, unit(4, 3));
    assert_eq!(apart.right_weights, weights(27, &[8, 12, 6, 1]));
}

/// Two ifs of different names draw the same: the proof looks at what is drawn, not at names.
#[test]
fn equal_drawings_of_different_states_are_equal() {
    let mut whole = curve("whole", bezier_matrices(3, &r(1, 2)), unit(4, 0), unit(4, 3));
    whole.transforms.iter_mut().for_each(|transform| transform.target = StateId(1));
    let twin = |name: &str, target: u32| {
        let mut line = curve(name, bezier_matrices(1, &r(1, 2)), unit(2, 0), unit(2, 1));
        line.transforms.iter_mut().for_each(|transform| transform.target = StateId(target));
        line
    };
    let mut carrier = curve("carrier", bezier_matrices(3, &r(1, 2)), unit(4, 0), unit(4, 3));
    let boundary = |name: &str, target| Boundary {
        name: name.to_owned(),
        target: StateId(target),
        matrix: matrix(1, &[&[1, 0, 0, 0], &[0, 0, 0, 1]]),
    };
    carrier.boundaries = vec![boundary("one", 1), boundary("other", 2), boundary("third", 3)];
    let own = |boundary| Side::Own { boundary, transform: 0 };
    carrier.stated_joins =
        vec![StatedJoin { left: own(0), right: own(1) }, StatedJoin { left: own(0), right: own(2) }];
    let mut thirds = twin("thirds", 3);
    thirds.transforms[0].matrix = matrix(3, &[&[3, 0], &[2, 1]]);
    thirds.transforms[1].matrix = matrix(3, &[&[2, 1], &[0, 3]]);
    let automaton = Automaton::try_new(vec![carrier, twin("one", 2), twin("other", 1), thirds]).unwrap();
    let verdicts = verdicts(&automaton, SPLINE);
    assert_eq!(verdicts[0], Stated::Holds);
    assert!(matches!(verdicts[1], Stated::Apart(Apart { level: 1, .. })), "{verdicts:?}");
}

#[test]
fn different_kinds_are_unlike() {
    let mut automaton = spline([&[0, 24, 0, 0], &[0, 0, 24, 0], &[0, 0, 0, 24]]).states().to_vec();
    automaton[0].boundaries.push(Boundary {
        name: "all".to_owned(),
        target: StateId(0),
        matrix: Matrix::identity(4),
    });
    automaton[0].stated_joins = vec![StatedJoin {
        left: Side::Own { boundary: 2, transform: 0 },
        right: Side::Piece { transform: 0, boundary: 0 },
    }];
    let automaton = Automaton::try_new(automaton).unwrap();
    assert_eq!(verdicts(&automaton, SPLINE), [Stated::Unlike { level: 1 }]);
}

/// A carrier on three points with two boundaries of one ifs on two points, and the join of the one in its first piece
/// with the other in its second.
fn random_join(entries: &[i64]) -> Automaton {
    let affine = |rows: &[i64], columns: usize| {
        let complete = |row: &[i64]| {
            let rest = 2 - row.iter().sum::<i64>();
            weights(2, &row.iter().copied().chain([rest]).collect::<Vec<_>>())
        };
        Matrix::from_rows(rows.chunks_exact(columns - 1).map(complete).collect()).unwrap()
    };
    let mut edge = curve(
        "edge",
        vec![affine(&entries[..2], 2), affine(&entries[2..4], 2)],
        vec![r(entries[4], 1), r(1 - entries[4], 1)],
        unit(2, 0),
    );
    edge.transforms.iter_mut().for_each(|transform| transform.target = StateId(1));
    edge.germ = Germ { shape: GermShape::Point, vertices: vec![edge.germ.vertices[0].clone()] };
    let pieces = vec![affine(&entries[5..11], 3), affine(&entries[11..17], 3)];
    let mut carrier = curve("carrier", pieces, unit(3, 0), unit(3, 2));
    let boundary = |name: &str, rows: &[i64]| {
        let (name, target) = (name.to_owned(), StateId(1));
        Boundary { name, target, matrix: affine(rows, 3) }
    };
    carrier.boundaries = vec![boundary("one", &entries[17..21]), boundary("other", &entries[21..25])];
    let piece = |transform, boundary| Side::Piece { transform, boundary };
    carrier.stated_joins = vec![StatedJoin { left: piece(0, 0), right: piece(1, 1) }];
    Automaton::try_new(vec![carrier, edge]).unwrap()
}

/// Rows of all points that a state draws at a level, on points given by `matrix`.
fn drawn(
    automaton: &Automaton,
    state: StateId,
    matrix: &Matrix,
    level: u32,
) -> Vec<Vec<crate::exact::Rational>> {
    let found = automaton.state(state);
    if level == 0 {
        let germ = Matrix::from_rows(found.germ.vertices.clone()).unwrap().product(matrix).unwrap();
        return (0..germ.rows()).map(|row| germ.row(row).to_vec()).collect();
    }
    let pieces = found.transforms.iter();
    pieces
        .flat_map(|piece| drawn(automaton, piece.target, &piece.matrix.product(matrix).unwrap(), level - 1))
        .collect()
}

proptest! {
    /// Against plain enumeration: what holds is equal at every level looked at, what parts does so where it is said.
    #[test]
    fn verdicts_are_those_of_enumeration(
        mut entries in prop::collection::vec(0_i64..2, 25),
        same in any::<bool>(),
    ) {
        if same {
            // The same up to one weight that need not matter.
            entries.copy_within(5..11, 11);
            entries.copy_within(17..20, 21);
        }
        let automaton = random_join(&entries);
        let carrier = automaton.state(SPLINE);
        let side = |place: usize, level| {
            let (piece, boundary) = (&carrier.transforms[place], &carrier.boundaries[place]);
            drawn(&automaton, StateId(1), &boundary.matrix.product(&piece.matrix).unwrap(), level)
        };
        let first = (0..6).find(|level| side(0, *level) != side(1, *level));
        match stated_join(&automaton, SPLINE, &carrier.stated_joins[0]) {
            Stated::Holds => prop_assert_eq!(first, None),
            Stated::Apart(apart) => {
                prop_assert_eq!(first, Some(apart.level - 1));
                prop_assert!(side(0, apart.level - 1).contains(&apart.left_weights));
                prop_assert!(side(1, apart.level - 1).contains(&apart.right_weights));
            }
            other => prop_assert!(false, "{:?}", other),
        }
    }
}
