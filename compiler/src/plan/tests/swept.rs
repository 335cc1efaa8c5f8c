//! Surfaces that are planar by construction, on control points at random: every quad is planar to rounding.

use glam::DVec3;
use proptest::prelude::*;

use super::*;
use crate::plan::address::FigureAddresses;
use crate::plan::evaluate::{PointGrid, SheetEvaluator, chain_points, chain_rows, swept_points};
use crate::plan::{ChainPlan, Path, Rule, SweptPlan, Turn, budget};

fn chain(points: Vec<[f64; 3]>, weights: Option<Vec<f64>>, level: u32) -> ChainPlan {
    let dimension = Dimension::Space;
    ChainPlan { state: FIRST, points, weights, level, dimension, windows: false, closed: false }
}

fn points() -> impl Strategy<Value = Vec<[f64; 3]>> {
    prop::collection::vec(prop::array::uniform3(-5000.0..5000.0), 4)
}

fn weights() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.1..10.0, 4)
}

/// The volume that the worst quad's corners span, in parts of the coordinates' size times its longest side squared: the
/// corners' distance from a plane for quads that are not thin, and rounding of the coordinates for planar ones.
fn worst_warp(grid: &PointGrid, closed: (bool, bool)) -> f64 {
    let at = |i: usize, j: usize| DVec3::from(grid.points[i % grid.rows * grid.columns + j % grid.columns]);
    let size = grid.points.iter().map(|point| DVec3::from(*point).abs().max_element()).fold(1.0, f64::max);
    let (rows, columns) = (grid.rows - usize::from(!closed.0), grid.columns - usize::from(!closed.1));
    let mut worst = 0.0_f64;
    for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        let side =
            [(a, b), (b, c), (c, d), (d, a)].map(|(p, q)| p.distance(q)).into_iter().fold(0.0, f64::max);
        let volume = (b - a).cross(c - a).dot(d - a).abs();
        if side > size * 1e-9 {
            worst = worst.max(volume / (size * side * side));
        }
    }
    worst
}

const ROUNDING: f64 = 1e-12;

fn swept(profile: ChainPlan, path: Path) -> PointGrid {
    let plan = SweptPlan { profile, path };
    let grid = swept_points(&automaton_of_cubics(), &plan);
    assert_eq!(grid.points.len(), grid.rows * grid.columns);
    grid
}

fn automaton_of_cubics() -> Automaton {
    bezier(3, &r(2, 5))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn sums_of_curves_are_planar(
        a in points(), b in points(), heavy in weights(), light in weights(), scale in prop::collection::vec(0.1..3.0, 4),
    ) {
        let rail = chain(a, Some(heavy), 3);
        let profile = chain(b, Some(light), 2);
        for rule in [Rule::Sum, Rule::Scaled(scale), Rule::Projective] {
            let grid = swept(profile.clone(), Path::Rail(rail.clone(), rule.clone()));
            prop_assert_eq!((grid.rows, grid.columns), (9, 5));
            let warp = worst_warp(&grid, (false, false));
            prop_assert!(warp <= ROUNDING, "{rule:?}: {warp}");
        }
    }

    #[test]
    fn extrusions_and_revolutions_are_planar(
        flat in prop::collection::vec((100.0..5000.0, -5000.0..5000.0), 4),
        along in prop::array::uniform3(-900.0..900.0), axis in prop::array::uniform3(-1.0..1.0),
        angle in 0.1..6.2, full in any::<bool>(), segments in 3_u32..40,
    ) {
        let direction = DVec3::from(axis);
        prop_assume!(direction.length() > 0.1);
        let direction = direction.normalize();
        let out = direction.any_orthonormal_vector();
        let origin = DVec3::new(300.0, -200.0, 70.0);
        let place = |(far, high): &(f64, f64)| (origin + out * *far + direction * *high).to_array();
        let profile = chain(flat.iter().map(place).collect(), None, 3);
        let grid = swept(profile.clone(), Path::Straight { vector: along, pieces: segments });
        prop_assert!(worst_warp(&grid, (false, false)) <= ROUNDING);
        let angle = if full { core::f64::consts::TAU } else { angle };
        let turn = Turn { point: origin.to_array(), direction: direction.to_array(), angle, segments, full };
        let grid = swept(profile, Path::Turn(turn));
        prop_assert_eq!(grid.rows, segments as usize + usize::from(!full));
        prop_assert!(worst_warp(&grid, (full, false)) <= ROUNDING);
        for (i, point) in grid.points.iter().enumerate() {
            let first = DVec3::from(grid.points[i % grid.columns]) - origin;
            let arm = DVec3::from(*point) - origin;
            let tolerance = 1e-9;
            prop_assert!((arm.dot(direction) - first.dot(direction)).abs() <= tolerance);
            prop_assert!((arm.length() - first.length()).abs() <= tolerance);
        }
    }
}

/// What the tests above look for is there to be seen: the same net as a tensor product is warped.
#[test]
fn a_product_on_a_free_net_is_not_planar() {
    let automaton = automaton_of_cubics();
    let plan = SheetPlan { levels: (2, 2), ..sheet(4, 4, (2, 2), false) };
    let evaluator = SheetEvaluator::new(&automaton, &plan);
    let mut points = Vec::new();
    evaluator.fill(&mut points);
    let grid = PointGrid { rows: evaluator.rows(), columns: evaluator.columns(), points };
    assert!(worst_warp(&grid, (false, false)) > 1e-4);
}

#[test]
fn a_translation_begins_on_its_rail_and_moves_its_profile() {
    let rail = chain(ARC.to_vec(), None, 2);
    let profile = chain(ARC.map(|[x, y, z]| [z + 7.0, x, y]).to_vec(), None, 1);
    let (a, b) =
        (chain_points(&automaton_of_cubics(), &rail), chain_points(&automaton_of_cubics(), &profile));
    let grid = swept(profile, Path::Rail(rail, Rule::Sum));
    for (i, j) in (0..grid.rows).flat_map(|i| (0..grid.columns).map(move |j| (i, j))) {
        let moved = [0, 1, 2].map(|place| a[i][place] + (b[j][place] - b[0][place]));
        assert_eq!(grid.points[i * grid.columns + j], moved);
    }
}

/// The scale runs as the rail's own coordinates do.
#[test]
fn scales_run_through_the_rails_own_ifs() {
    let heavy = Some(vec![1.0, 3.0, 0.5, 2.0]);
    let scale = vec![1.0, 0.5, 2.0, 3.0];
    let rail = chain(ARC.to_vec(), heavy.clone(), 3);
    let told = chain(scale.iter().map(|s| [*s, 0.0, 0.0]).collect(), heavy, 3);
    let told = chain_points(&automaton_of_cubics(), &told);
    let profile = chain(vec![[0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 2.0], [0.0, 0.0, 3.0]], None, 0);
    let grid = swept(profile, Path::Rail(rail, Rule::Scaled(scale)));
    for (i, [expected, _, _]) in told.into_iter().enumerate() {
        let height = grid.points[i * 2 + 1][2] - grid.points[i * 2][2];
        assert!((height - 3.0 * expected).abs() < 1e-12, "{height}");
    }
}

/// With weights of 1 the projective sum is half way between its curves.
#[test]
fn a_projective_sum_of_plain_curves_is_their_middle() {
    let (rail, profile) =
        (chain(ARC.to_vec(), None, 1), chain(ARC.map(|[x, y, z]| [z, y, x]).to_vec(), None, 1));
    let (a, b) = (chain_rows(&automaton_of_cubics(), &rail), chain_rows(&automaton_of_cubics(), &profile));
    let grid = swept(profile, Path::Rail(rail, Rule::Projective));
    let middle = [0, 1, 2].map(|place| (a[1][place] + b[2][place]) / 2.0);
    assert_eq!(grid.points[grid.columns + 2], middle);
}

#[test]
fn turned_quads_are_named_by_their_step_and_counted_round() {
    let profile = chain(ARC.map(|[x, y, _]| [x + 10.0, 0.0, y]).to_vec(), None, 2);
    let direction = [0.0, 0.0, 1.0];
    let turn = Turn { point: [0.0; 3], direction, angle: core::f64::consts::TAU, segments: 12, full: true };
    let shape = Shape::Swept(SweptPlan { profile, path: Path::Turn(turn) });
    let dome = plan(automaton_of_cubics(), vec![figure("dome", None, shape)]);
    let counts = budget::check(&dome, 1000).unwrap()[0];
    assert_eq!((counts.elements, counts.vertices, counts.grid), (48, 60, (12, 4)));
    let addresses = FigureAddresses::new(dome.automaton(), &dome.figures()[0]);
    let quad = addresses.quad(11, 2).unwrap();
    assert_eq!((quad.to_string().as_str(), quad.alias.as_str()), ("dome.11-0.right.left", "dome-11-02"));
    assert_eq!((addresses.quad(12, 0), addresses.quad(0, 4), addresses.segment(0)), (None, None, None));
    assert!(dome.figures()[0].shape.planar_by_construction());
    let printed = dome.to_string();
    assert!(
        printed.ends_with(
            "figure dome: revolution, planar by construction, of the profile of state 0 in space at level 2 on 4 points in 12 segments: 48 elements, 60 vertices\n"
        ),
        "{printed}"
    );
}
