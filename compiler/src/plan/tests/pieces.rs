//! Separate pieces: counts, positions against exact products, order and words, memory.

use std::convert::Infallible;
use std::sync::Arc;

use proptest::prelude::*;

use super::*;
use crate::exact::Rational;
use crate::ifs::{Drawn, Germ, GermShape, Matrix, State, StateSpace, Transform, drawn};
use crate::plan::address::FigureAddresses;
use crate::plan::evaluate::{EachError, PiecesEvaluator};
use crate::plan::size::{SizeBound, SizeMeasure};
use crate::plan::{Depth, Each, PiecesPlan, budget};

/// One element as plain data: its word, whether it is kept, its vertices.
type Element = (Vec<usize>, Option<u32>, Vec<[f64; 3]>);

/// The map x ↦ a·x + b·y + e, y ↦ c·x + d·y + f in thousandths and mm, on an affine frame of the plane.
fn plane_map([a, b, c, d]: [i64; 4], [e, f]: [i64; 2]) -> Matrix {
    let image = |x: i64, y: i64| {
        let (u, v) = (e * 1000 + a * x + b * y, f * 1000 + c * x + d * y);
        weights(1000, &[1000 - u - v, u, v])
    };
    Matrix::from_rows(vec![image(0, 0), image(1, 0), image(0, 1)]).unwrap()
}

fn to_self(name: &str, matrix: Matrix) -> Transform {
    Transform { name: name.to_owned(), target: FIRST, matrix }
}

/// Barnsley's fern, metres, as LANGUAGE 4 writes it but without the turn of its frond.
fn fern() -> Automaton {
    let transforms = vec![
        to_self("stem", plane_map([0, 0, 0, 160], [0, 0])),
        to_self("frond", plane_map([850, 40, -40, 850], [0, 1600])),
        to_self("left", plane_map([200, -260, 230, 220], [0, 1600])),
        to_self("right", plane_map([-150, 280, 260, 240], [0, 440])),
    ];
    let germ = Germ::segment(weights(1, &[1, 0, 0]), weights(1, &[-9999, 0, 10000]));
    automaton(State { space: StateSpace::Plane, ..State::new("fern".to_owned(), 3, transforms, germ) })
}

/// A Sierpinski triangle on its corners, drawn as triangles.
fn sierpinski() -> Automaton {
    let corner = |rows: [&[i64]; 3]| matrix(2, &rows);
    let transforms = vec![
        to_self("a", corner([&[2, 0, 0], &[1, 1, 0], &[1, 0, 1]])),
        to_self("b", corner([&[1, 1, 0], &[0, 2, 0], &[0, 1, 1]])),
        to_self("c", corner([&[1, 0, 1], &[0, 1, 1], &[0, 0, 2]])),
    ];
    let germ = Germ { shape: GermShape::Polygon, vertices: (0..3).map(|at| unit(3, at)).collect() };
    automaton(State::new("sierpinski".to_owned(), 3, transforms, germ))
}

fn cantor() -> Automaton {
    let transforms = vec![
        to_self("left", matrix(3, &[&[3, 0], &[2, 1]])),
        to_self("right", matrix(3, &[&[1, 2], &[0, 3]])),
    ];
    automaton(State::new("cantor".to_owned(), 2, transforms, Germ::segment(unit(2, 0), unit(2, 1))))
}

/// A trunk of two points that is kept and forks in two, ending in points.
fn fork() -> Automaton {
    let transforms = vec![
        to_self("left", matrix(2, &[&[0, 2], &[-1, 3]])),
        to_self("right", matrix(3, &[&[0, 3], &[-1, 4]])),
    ];
    let germ = Germ { shape: GermShape::Point, vertices: vec![unit(2, 1)] };
    let strut = GermShape::Strut { width: r(160, 1) };
    let keep = vec![
        Germ { shape: strut, vertices: vec![unit(2, 0), unit(2, 1)] },
        Germ { shape: GermShape::Point, vertices: vec![unit(2, 0)] },
    ];
    automaton(State { keep, ..State::new("fork".to_owned(), 2, transforms, germ) })
}

const FRAME: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
const TRIANGLE: [[f64; 3]; 3] = [[0.0, 0.0, 10.0], [8000.0, 0.0, 20.0], [0.0, 6000.0, 30.0]];

fn pieces(points: &[[f64; 3]], depth: Depth) -> PiecesPlan {
    PiecesPlan { state: FIRST, points: points.to_vec(), dimension: Dimension::Space, depth }
}

fn elements(automaton: &Automaton, plan: &PiecesPlan) -> Vec<Element> {
    let mut out = Vec::new();
    let Ok(()) = PiecesEvaluator::new(automaton, plan).stream(|tile| {
        for element in tile.elements() {
            let mut vertices = Vec::new();
            tile.copy_vertices(&element, &mut vertices);
            out.push((element.letters().collect(), element.drawn.kept, vertices));
        }
        Ok::<(), Infallible>(())
    });
    out
}

/// Plain recursion over words, as GEOMETRY 4 has it in third place.
struct Reference<'a> {
    automaton: &'a Automaton,
    out: Vec<Element>,
}

impl Reference<'_> {
    fn of(automaton: &Automaton, points: &[[f64; 3]], level: u32) -> Vec<Element> {
        let mut reference = Reference { automaton, out: Vec::new() };
        reference.below(FIRST, points, &mut Vec::new(), level);
        reference.out
    }

    fn below(&mut self, state: StateId, points: &[[f64; 3]], word: &mut Vec<usize>, level: u32) {
        let state = self.automaton.state(state);
        if level == 0 {
            self.out.push((word.clone(), None, images(&state.germ.vertices, points)));
            return;
        }
        for (place, germ) in (0..).zip(&state.keep) {
            self.out.push((word.clone(), Some(place), images(&germ.vertices, points)));
        }
        for (letter, transform) in state.transforms.iter().enumerate() {
            let rows: Vec<Vec<Rational>> =
                (0..transform.matrix.rows()).map(|row| transform.matrix.row(row).to_vec()).collect();
            word.push(letter);
            self.below(transform.target, &images(&rows, points), word, level - 1);
            word.pop();
        }
    }
}

fn images(rows: &[Vec<Rational>], points: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let image = |row: &Vec<Rational>| {
        [0, 1, 2]
            .map(|axis| row.iter().zip(points).map(|(weight, point)| weight.to_f64() * point[axis]).sum())
    };
    rows.iter().map(image).collect()
}

fn assert_near(found: &[Element], expected: &[Element]) {
    assert_eq!(found.len(), expected.len());
    let all = expected.iter().flat_map(|element| element.2.iter().flatten());
    let scale = all.fold(1.0_f64, |scale, value| scale.max(value.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!((&found.0, found.1), (&expected.0, expected.1));
        assert_eq!(found.2.len(), expected.2.len());
        for (a, b) in found.2.iter().flatten().zip(expected.2.iter().flatten()) {
            assert!((a - b).abs() <= 1e-12 * scale, "{a} {b} in {:?}", found.0);
        }
    }
}

#[test]
fn counts_are_powers_and_with_keep_their_sums() {
    let of = |automaton: &Automaton, level| drawn(automaton, FIRST, level).unwrap();
    assert_eq!(of(&sierpinski(), 7), Drawn { elements: 3_u64.pow(7), vertices: 3_u64.pow(8) });
    assert_eq!(of(&cantor(), 10), Drawn { elements: 1024, vertices: 2048 });
    assert_eq!(of(&fern(), 12).elements, 16_777_216);
    // Two things kept at each of 1 + 2 + 4 words, and 8 points at the tips.
    assert_eq!(of(&fork(), 3), Drawn { elements: 7 * 2 + 8, vertices: 7 * 3 + 8 });
    assert_eq!(of(&fork(), 0), Drawn { elements: 1, vertices: 1 });
    assert_eq!(drawn(&fork(), FIRST, 200), None);
    for (automaton, points) in [(sierpinski(), &TRIANGLE[..]), (fork(), &TRIANGLE[..2])] {
        for level in 0..7 {
            let found = elements(&automaton, &pieces(points, Depth::Level(level)));
            let vertices: usize = found.iter().map(|element| element.2.len()).sum();
            let expected = of(&automaton, level);
            assert_eq!((found.len() as u64, vertices as u64), (expected.elements, expected.vertices));
        }
    }
}

#[test]
fn a_plan_of_pieces_is_counted_refused_and_printed() {
    let fern = plan(fern(), vec![figure("fern", None, Shape::Pieces(pieces(&FRAME, Depth::Level(12))))]);
    let error = budget::check(&fern, 4_000_000).unwrap_err();
    let budget::BudgetError::TooMany { elements, fits, .. } = error else { panic!("{error}") };
    assert_eq!((elements, fits), (Some(16_777_216), Some(10)));
    let text = fern.to_string();
    let open =
        "joins open at level 1: in state 0 frond ends at [-10499 400 10100], left starts at [-1599 0 1600]";
    assert!(text.contains(open), "{text}");
    let last = "figure fern: separate pieces of state 0 in space at level 12: 16777216 elements, 33554432 vertices\n";
    assert!(text.ends_with(last), "{text}");
    let wrong = vec![figure("fern", None, Shape::Pieces(pieces(&TRIANGLE[..2], Depth::Level(1))))];
    assert!(matches!(
        Plan::try_new(sierpinski(), wrong),
        Err(crate::plan::PlanError::PointCount { expected: 3, found: 2, .. })
    ));
}

/// G · T_tk ⋯ T_t1 · P with the exact matrices.
#[test]
fn positions_are_products_of_exact_matrices() {
    for (automaton, points, level) in [(fern(), &FRAME[..], 6), (sierpinski(), &TRIANGLE[..], 8)] {
        let found = elements(&automaton, &pieces(points, Depth::Level(level)));
        for (word, _, vertices) in found.iter().step_by(97) {
            let state = automaton.state(FIRST);
            let mut product = Matrix::from_rows(state.germ.vertices.clone()).unwrap();
            for letter in word.iter().rev() {
                product = product.product(&state.transforms[*letter].matrix).unwrap();
            }
            let rows: Vec<Vec<Rational>> = (0..product.rows()).map(|row| product.row(row).to_vec()).collect();
            for (a, b) in vertices.iter().flatten().zip(images(&rows, points).iter().flatten()) {
                assert!((a - b).abs() < 1e-9, "{a} {b}");
            }
        }
    }
}

#[test]
fn what_is_kept_comes_before_what_follows_below_it() {
    let automaton = fork();
    let points = &[[0.0, 0.0, 0.0], [0.0, 0.0, 2000.0]];
    for level in 0..6 {
        let found = elements(&automaton, &pieces(points, Depth::Level(level)));
        assert_near(&found, &Reference::of(&automaton, points, level));
    }
    let shape = Shape::Pieces(pieces(points, Depth::Level(2)));
    let figure = figure("column", Some(1), shape);
    let addresses = FigureAddresses::new(&automaton, &figure);
    assert_eq!(addresses.segment(0), None);
    let mut names = Vec::new();
    let evaluator = PiecesEvaluator::new(&automaton, &pieces(points, Depth::Level(2)));
    let Ok(()) = evaluator.stream(|tile| {
        for element in tile.elements() {
            let address = addresses.piece(names.len() as u64, &element).unwrap();
            names.push((address.to_string(), address.alias));
        }
        Ok::<(), Infallible>(())
    });
    assert_eq!(names[0], ("column.1".to_owned(), "column-1-00".to_owned()));
    assert_eq!(names[1].0, "column.1.keep-2");
    assert_eq!(names[2].0, "column.1.left");
    assert_eq!(names[4], ("column.1.left.left".to_owned(), "column-1-04".to_owned()));
    let mut unique: Vec<&String> = names.iter().flat_map(|(address, alias)| [address, alias]).collect();
    unique.sort();
    unique.dedup();
    assert_eq!(unique.len(), 2 * names.len());
}

#[test]
fn a_million_leaves_go_through_the_memory_of_one_tile() {
    let evaluator = PiecesEvaluator::new(&fern(), &pieces(&FRAME, Depth::Level(10)));
    let (mut leaves, mut places, mut largest) = (0, Vec::new(), 0);
    let Ok(()) = evaluator.stream(|tile| {
        leaves += tile.elements().len();
        largest = largest.max(tile.vertices());
        for axis in [0, 1] {
            places.push(tile.axis(axis).as_ptr());
        }
        Ok::<(), Infallible>(())
    });
    places.sort();
    places.dedup();
    assert_eq!((leaves, places.len()), (1 << 20, 2));
    assert!(largest <= 4096, "{largest}");
}

fn until(most: f64) -> SizeBound {
    SizeBound { measure: SizeMeasure::Size, most, strict: false }
}

/// The plan whose branches stop at a bound.
fn each(automaton: &Automaton, points: &[[f64; 3]], bound: SizeBound) -> Result<PiecesPlan, EachError> {
    let evaluator = PiecesEvaluator::new(automaton, &pieces(points, Depth::Level(0)));
    let (drawn, deepest) = evaluator.count_each(bound, 4_000_000)?;
    Ok(pieces(points, Depth::Each(Each { bound, drawn, deepest })))
}

#[test]
fn every_branch_of_a_fern_stops_on_its_own_and_it_reaches_its_tip() {
    let automaton = fern();
    let plan = each(&automaton, &FRAME, until(20.0)).unwrap();
    let Depth::Each(Each { drawn, deepest, .. }) = plan.depth else { unreachable!() };
    let found = elements(&automaton, &plan);
    assert_eq!((drawn.elements, drawn.vertices), (found.len() as u64, 2 * found.len() as u64));
    assert_eq!(deepest as usize, found.iter().map(|element| element.0.len()).max().unwrap());
    for (word, _, vertices) in &found {
        let size = |vertices: &[[f64; 3]]| crate::plan::size::distance(vertices[0], vertices[1]);
        assert!(size(vertices) <= 20.0, "{word:?}");
    }
    // The limit lies in −2.182 ≤ x ≤ 2.6558, 0 ≤ y ≤ 9.9983 (Barnsley 1988), here in metres.
    let axis =
        |axis: usize| found.iter().flat_map(move |element| element.2.iter().map(move |vertex| vertex[axis]));
    for (place, least, most) in [(0, -2182.0, 2655.8), (1, 0.0, 9998.3)] {
        let low = axis(place).fold(f64::INFINITY, f64::min);
        let high = axis(place).fold(f64::NEG_INFINITY, f64::max);
        assert!((low - least).abs() < 20.0 && (high - most).abs() < 20.0, "{low} {high}");
    }
    // The tip is the fixed point of `frond`: (1 − T)⁻¹ · (0, 1.6 m).
    let along = 0.15 * 0.15 + 0.04 * 0.04;
    let tip = [1600.0 * 0.04 / along, 1600.0 * 0.15 / along, 0.0];
    let nearest =
        found.iter().map(|element| crate::plan::size::distance(element.2[1], tip)).fold(f64::MAX, f64::min);
    assert!(nearest < 25.0, "{nearest}");
    assert!(deepest > 35 && drawn.elements < 700_000, "{deepest} {drawn:?}");
}

#[test]
fn a_branch_that_never_gets_smaller_is_named() {
    let mut transforms = cantor().state(FIRST).transforms.clone();
    transforms.push(to_self("still", matrix(1, &[&[1, 0], &[0, 1]])));
    let still =
        automaton(State::new("still".to_owned(), 2, transforms, Germ::segment(unit(2, 0), unit(2, 1))));
    let error = each(&still, &TRIANGLE[..2], until(100.0)).unwrap_err();
    let EachError::TooDeep { word, size, halfway } = error else { panic!("{error}") };
    assert_eq!((word.letters.len(), word.letters.last()), (1000, Some(&2)));
    assert!(size > 100.0 && size == halfway);
    let error = each(&sierpinski(), &TRIANGLE, until(1e-3)).unwrap_err();
    assert!(matches!(error, EachError::TooMany { .. }), "{error}");
    let points = Germ { shape: GermShape::Point, vertices: vec![unit(2, 0)] };
    let dust = automaton(State::new("dust".to_owned(), 2, cantor().state(FIRST).transforms.clone(), points));
    let bound = SizeBound { measure: SizeMeasure::Edge, ..until(1.0) };
    assert_eq!(each(&dust, &TRIANGLE[..2], bound), Err(EachError::NoMeasure { state: FIRST }));
}

#[test]
fn branches_keep_what_they_keep_until_they_stop() {
    let automaton = fork();
    let points = &[[0.0, 0.0, 0.0], [0.0, 0.0, 2000.0]];
    let germ = Germ::segment(unit(2, 0), unit(2, 1));
    let automaton = Automaton::try_new(vec![State { germ, ..automaton.state(FIRST).clone() }]).unwrap();
    let plan = each(&automaton, points, until(300.0)).unwrap();
    let found = elements(&automaton, &plan);
    let words: Vec<&Vec<usize>> =
        found.iter().filter(|element| element.1.is_none()).map(|element| &element.0).collect();
    // Halves need three letters, thirds two.
    assert!(words.contains(&&vec![0, 0, 0]) && words.contains(&&vec![1, 1]), "{words:?}");
    for (word, kept, _) in &found {
        assert_eq!(
            kept.is_some(),
            words.iter().any(|leaf| leaf.len() > word.len() && leaf.starts_with(word))
        );
    }
}

/// States on two to four points with one to three transforms each to any of them, and germs of all kinds.
fn automata() -> impl Strategy<Value = Automaton> {
    let points = prop::collection::vec(2_usize..5, 1..4);
    points.prop_flat_map(|points| {
        let states: Vec<_> = points.iter().map(|count| state(*count, points.clone())).collect();
        states.prop_map(|states| Automaton::try_new(states).unwrap())
    })
}

fn state(points: usize, all: Vec<usize>) -> impl Strategy<Value = State> {
    let transform = (0..all.len()).prop_flat_map(move |target| {
        prop::collection::vec(row(points), all[target]).prop_map(move |rows| (target, rows))
    });
    let transforms = prop::collection::vec(transform, 1..4);
    let germs = prop::collection::vec(germ(points), 1..4);
    (transforms, germs).prop_map(move |(transforms, mut germs)| {
        let named = transforms.into_iter().enumerate().map(|(place, (target, rows))| Transform {
            name: format!("t{place}"),
            target: StateId(target as u32),
            matrix: Matrix::from_rows(rows).unwrap(),
        });
        let germ = germs.pop().unwrap();
        State { keep: germs, ..State::new("any".to_owned(), points, named.collect(), germ) }
    })
}

/// Weights of sum 1.
fn row(points: usize) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(-3_i64..8, points).prop_map(|mut row| {
        let rest = 12 - row[1..].iter().sum::<i64>();
        row[0] = rest;
        weights(12, &row)
    })
}

fn germ(points: usize) -> impl Strategy<Value = Germ> {
    let mesh = GermShape::Mesh { faces: Arc::new(vec![vec![0, 1, 2], vec![2, 1, 0]]) };
    let strut = GermShape::Strut { width: r(3, 2) };
    let shapes =
        [(GermShape::Point, 1), (GermShape::Segment, 2), (GermShape::Polygon, 5), (strut, 3), (mesh, 3)];
    prop::sample::select(shapes.to_vec()).prop_flat_map(move |(shape, count)| {
        let vertices = prop::collection::vec(row(points), count);
        vertices.prop_map(move |vertices| Germ { shape: shape.clone(), vertices })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn blocks_agree_with_plain_recursion(automaton in automata(), level in 0_u32..6) {
        let count = automaton.state(FIRST).control_points;
        let points: Vec<[f64; 3]> = [[10.0, 2.0, 3.0], [4000.0, 50.0, 6.0], [7.0, 3000.0, 9.0], [1.0, 2.0, 5000.0]]
            [..count].to_vec();
        let found = elements(&automaton, &pieces(&points, Depth::Level(level)));
        assert_near(&found, &Reference::of(&automaton, &points, level));
        let expected = drawn(&automaton, FIRST, level).unwrap();
        prop_assert_eq!(found.len() as u64, expected.elements);
        let again = elements(&automaton, &pieces(&points, Depth::Level(level)));
        prop_assert_eq!(found, again);
    }
}
