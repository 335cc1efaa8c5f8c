//! Joins as they are stated, on the B-spline of LANGUAGE 9 and on arcs of segments.

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
    assert_eq!(apart.largest_difference(), r(1, 96));
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
