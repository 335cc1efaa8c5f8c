//! Chains of windows, closed nets and weights, against plain curves and sheets.

use proptest::prelude::*;

use super::*;
use crate::plan::address::FigureAddresses;
use crate::plan::evaluate::{
    SheetEvaluator, basis, chain_points, curve_points, net_points, vertex_at_infinity,
};
use crate::plan::{ChainPlan, NetPlan, PlanError, budget};

fn chain(points: Vec<[f64; 3]>, level: u32, closed: bool) -> ChainPlan {
    let dimension = Dimension::Space;
    ChainPlan { state: FIRST, points, weights: None, level, dimension, windows: true, closed }
}

fn ring(count: usize) -> Vec<[f64; 3]> {
    (0..count).map(|i| [libm::cos(i as f64), libm::sin(i as f64 * 2.0), i as f64 * 0.1]).collect()
}

fn plain(sheet: &SheetPlan) -> Vec<[f64; 3]> {
    let automaton = bspline3_limit();
    let mut points = Vec::new();
    SheetEvaluator::new(&automaton, sheet).fill(&mut points);
    points
}

#[test]
fn a_chain_is_its_windows_one_after_the_other() {
    let (automaton, points) = (bspline3_limit(), ring(7));
    let vertices = chain_points(&automaton, &chain(points.clone(), 3, false));
    assert_eq!(vertices.len(), 4 * 8 + 1);
    let table = basis(&automaton, FIRST, 3);
    for window in 0..4 {
        let own = curve_points(&table, &points[window..window + 4]);
        assert_eq!(vertices[window * 8 + 1..=window * 8 + 8], own[1..], "window {window}");
    }
}

#[test]
fn a_closed_chain_goes_on_where_it_began() {
    let (automaton, points) = (bspline3_limit(), ring(7));
    let closed = chain_points(&automaton, &chain(points.clone(), 3, true));
    assert_eq!(closed.len(), 7 * 8);
    let mut round = points.clone();
    round.extend_from_slice(&points[..3]);
    let open = chain_points(&automaton, &chain(round, 3, false));
    assert_eq!(open.len(), closed.len() + 1);
    assert_eq!(open[..closed.len()], closed);
    let apart = (0..3).map(|place| (open[56][place] - closed[0][place]).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-15, "the seam is one vertex: {apart}");
}

#[test]
fn segments_of_chains_are_named_by_their_windows() {
    let closed = Shape::Chain(chain(ring(5), 2, true));
    let hoop = plan(bspline3_limit(), vec![figure("hoop", Some(2), closed)]);
    let counts = budget::check(&hoop, 100).unwrap()[0];
    assert_eq!((counts.elements, counts.vertices), (20, 20));
    let addresses = FigureAddresses::new(hoop.automaton(), &hoop.figures()[0]);
    let last = addresses.segment(19).unwrap();
    assert_eq!((last.to_string().as_str(), last.alias.as_str()), ("hoop.2.4.right.right", "hoop-2-19"));
    assert_eq!((addresses.segment(20), addresses.quad(0, 0)), (None, None));
    let printed = hoop.to_string();
    assert!(
        printed.ends_with(
            "figure hoop[2]: curve of state 0 in space at level 2 on 5 points, closed: 20 elements, 20 vertices\n"
        ),
        "{printed}"
    );
}

/// A closed net has the vertices of the plain one that its own first rows and columns continue.
#[test]
fn closed_nets_are_the_continued_ones_without_their_last_lines() {
    let automaton = bspline3_limit();
    let open = sheet(6, 5, (2, 1), true);
    for closed in [(true, false), (false, true), (true, true)] {
        let (rows, columns) = (6 + 3 * usize::from(closed.0), 5 + 3 * usize::from(closed.1));
        let continued = (0..rows)
            .flat_map(|i| (0..columns).map(move |j| (i, j)))
            .map(|(i, j)| open.net[i % 6 * 5 + j % 5]);
        let continued =
            SheetPlan { net: continued.collect(), net_rows: rows, net_columns: columns, ..open.clone() };
        let across = (columns - 3) * 2 + 1;
        let expected = plain(&continued);
        let grid = net_points(&automaton, &NetPlan { sheet: open.clone(), closed, weights: None });
        assert_eq!(grid.points.len(), grid.rows * grid.columns);
        assert_eq!(grid.rows, (rows - 3) * 4 + usize::from(!closed.0));
        assert_eq!(grid.columns, (columns - 3) * 2 + usize::from(!closed.1));
        for (place, point) in grid.points.iter().enumerate() {
            assert_eq!(*point, expected[place / grid.columns * across + place % grid.columns]);
        }
        let shape = Shape::Net(NetPlan { sheet: open.clone(), closed, weights: None });
        let counted = plan(bspline3_limit(), vec![figure("net", None, shape)]);
        let counts = budget::check(&counted, 10_000).unwrap()[0];
        assert_eq!(counts.vertices, grid.points.len() as u64);
        let addresses = FigureAddresses::new(counted.automaton(), &counted.figures()[0]);
        assert!(addresses.quad(counts.grid.0 - 1, counts.grid.1 - 1).is_some());
        assert_eq!(addresses.quad(counts.grid.0, 0), None);
    }
}

/// (1, √2/2, 1) on a right angle is a quarter of a circle.
#[test]
fn a_rational_parabola_is_a_circle() {
    let weights = Some(vec![1.0, 0.5_f64.sqrt(), 1.0]);
    let points = vec![[1000.0, 0.0, 0.0], [1000.0, 1000.0, 0.0], [0.0, 1000.0, 0.0]];
    let arc = ChainPlan { weights, windows: false, ..chain(points, 9, false) };
    for point in chain_points(&bezier(2, &r(1, 2)), &arc) {
        let radius = libm::hypot(point[0], point[1]);
        assert!((radius - 1000.0).abs() <= 1000.0 * 1e-12, "{radius}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// One weight for all is no weight.
    #[test]
    fn equal_weights_change_nothing(weight in 0.01..100.0, closed in any::<bool>()) {
        let automaton = bspline3_limit();
        let open = sheet(6, 5, (2, 1), true);
        let bare = NetPlan { sheet: open, closed: (closed, false), weights: None };
        let heavy = NetPlan { weights: Some(vec![weight; 30]), ..bare.clone() };
        let (bare, heavy) = (net_points(&automaton, &bare), net_points(&automaton, &heavy));
        for (a, b) in bare.points.iter().flatten().zip(heavy.points.iter().flatten()) {
            prop_assert!((a - b).abs() <= 1e-11, "{a} {b}");
        }
    }

    /// A rational product with weights of its two directions is rational along each of them.
    #[test]
    fn rows_of_a_rational_net_are_rational_curves(weights in prop::collection::vec(0.1..10.0, 4)) {
        let automaton = bezier(3, &r(1, 3));
        let patch = sheet(4, 4, (0, 3), false);
        let net = (0..16).map(|place| weights[place % 4] * if place < 4 { 2.0 } else { 1.0 }).collect();
        let grid = net_points(&automaton, &NetPlan { sheet: patch.clone(), closed: (false, false), weights: Some(net) });
        let first = ChainPlan {
            weights: Some(weights),
            windows: false,
            ..chain(patch.net[..4].to_vec(), 3, false)
        };
        for (a, b) in grid.points[..9].iter().flatten().zip(chain_points(&automaton, &first).iter().flatten()) {
            prop_assert!((a - b).abs() <= 1e-9, "{a} {b}");
        }
    }
}

#[test]
fn what_is_no_chain_or_net_is_refused() {
    let refused = |automaton: Automaton, shape: Shape| {
        Plan::try_new(automaton, vec![figure("one", None, shape)]).unwrap_err()
    };
    let name = "one".to_owned();
    let short = refused(bspline3_limit(), Shape::Chain(chain(ring(3), 1, true)));
    assert_eq!(short, PlanError::PointCount { figure: name.clone(), expected: 4, found: 3 });
    let parting = refused(bezier(3, &r(1, 2)), Shape::Chain(chain(ring(4), 1, true)));
    assert!(matches!(parting, PlanError::NotJoined { windows: true, .. }), "{parting}");
    let seam = NetPlan { sheet: sheet(4, 4, (1, 1), false), closed: (true, false), weights: None };
    let seam = refused(bezier(3, &r(1, 2)), Shape::Net(seam));
    assert!(matches!(seam, PlanError::NotJoined { windows: true, .. }), "{seam}");
    for (weights, point) in [
        (vec![1.0, 0.0, 1.0, 1.0], 1),
        (vec![1.0, 1.0, -2.0, 1.0], 2),
        (vec![f64::NAN, 1.0, 1.0, 1.0], 0),
        (vec![1.0; 3], 3),
    ] {
        let chain = ChainPlan { weights: Some(weights), ..chain(ring(4), 1, false) };
        let error = refused(bspline3_limit(), Shape::Chain(chain));
        assert_eq!(error, PlanError::Weight { figure: name.clone(), point });
    }
    let far = ChainPlan { weights: Some(vec![1e300; 4]), ..chain(vec![[1e300; 3]; 4], 1, false) };
    assert!(matches!(refused(bspline3_limit(), Shape::Chain(far)), PlanError::NotFinite { .. }));
}

/// Positive weights stay positive under a B-spline; that is known without a look at the vertices, and found by one.
#[test]
fn no_vertex_of_a_bspline_is_at_infinity() {
    let weights = Some(vec![1e-3, 1.0, 1e3, 1.0, 1.0]);
    let shape = Shape::Chain(ChainPlan { weights, ..chain(ring(5), 4, true) });
    assert_eq!(vertex_at_infinity(&bspline3_limit(), &shape), None);
}
