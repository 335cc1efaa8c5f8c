//! Quads whose measures are known, and properties every measure keeps.

use super::*;
use crate::geometry::samples;
use proptest::prelude::*;

fn quad(points: [(f64, f64, f64); 4]) -> [DVec3; 4] {
    points.map(|(x, y, z)| DVec3::new(x, y, z))
}

#[test]
fn flat_square() {
    let measure = QuadMeasure::of(samples::square(250.0));
    assert_eq!(measure.verdict, Verdict::Convex);
    assert_eq!(measure.planarity, Some(1.0));
    assert_eq!((measure.fold_ac, measure.fold_bd), (Some(0.0), Some(0.0)));
    assert_eq!(measure.split, Diagonal::Ac);
    assert_eq!(measure.diagonal_ratio, Some(0.0));
    assert_eq!(measure.area, 62500.0);
    assert_eq!(measure.edges, [250.0; 4]);
}

#[test]
fn roof_over_ac_folds_by_what_it_was_folded() {
    // Two right triangles over the diagonal AC, the second turned up by 30 degrees.
    let turn = std::f64::consts::FRAC_PI_6;
    let half = 100.0 * libm::sqrt(0.5);
    let up = DVec3::new(
        -half * libm::cos(turn) * libm::sqrt(0.5),
        half * libm::cos(turn) * libm::sqrt(0.5),
        half * libm::sin(turn),
    );
    let corners = [
        DVec3::ZERO,
        DVec3::new(100.0, 0.0, 0.0),
        DVec3::new(100.0, 100.0, 0.0),
        DVec3::new(50.0, 50.0, 0.0) + up,
    ];
    let measure = QuadMeasure::of(corners);
    assert!((measure.fold_ac.unwrap() - turn).abs() < 1e-12);
    // The other diagonal became shorter by folding, and the heights over it larger: its fold is the smaller.
    assert_eq!(measure.split, Diagonal::Bd);
    assert!(
        (measure.planarity.unwrap() - libm::cos(measure.fold_ac.unwrap().max(measure.fold_bd.unwrap())))
            .abs()
            < 1e-12
    );
}

#[test]
fn the_industry_ratio_and_the_cosine_meet_on_a_near_square() {
    // Raising one corner of a unit square: a diagonal ratio of 0.005 is about 1.1 degrees and cos 0.9998.
    let height = 2.0 * 0.005 * libm::sqrt(2.0) * 100.0;
    let measure = QuadMeasure::of(quad([(0., 0., 0.), (100., 0., 0.), (100., 100., height), (0., 100., 0.)]));
    assert!((measure.diagonal_ratio.unwrap() - 0.005).abs() < 1e-4, "{measure:?}");
    assert!((measure.fold().unwrap().to_degrees() - 1.1).abs() < 0.06, "{measure:?}");
    assert!((measure.planarity.unwrap() - 0.9998).abs() < 5e-5, "{measure:?}");
}

#[test]
fn a_flat_dart_is_a_dart_split_at_its_reflex_corner() {
    let measure = QuadMeasure::of(quad([(0., 0., 0.), (100., 0., 0.), (30., 30., 0.), (0., 100., 0.)]));
    assert_eq!(measure.verdict, Verdict::Dart);
    assert_eq!(measure.planarity, None);
    assert_eq!(measure.split, Diagonal::Ac);
    assert_eq!(measure.fold(), Some(0.0));
    let turned = QuadMeasure::of(quad([(0., 100., 0.), (0., 0., 0.), (100., 0., 0.), (30., 30., 0.)]));
    assert_eq!((turned.verdict, turned.split), (Verdict::Dart, Diagonal::Bd));
    assert!((measure.area - turned.area).abs() < 1e-9);
}

#[test]
fn a_collinear_corner_has_no_planarity_but_a_split() {
    let measure = QuadMeasure::of(quad([(0., 0., 0.), (50., 0., 0.), (100., 0., 0.), (50., 100., 0.)]));
    assert_eq!(measure.verdict, Verdict::CollinearCorner);
    assert_eq!((measure.planarity, measure.fold_ac), (None, None));
    assert_eq!((measure.split, measure.fold_bd), (Diagonal::Bd, Some(0.0)));
    assert_eq!(measure.area, 5000.0);
}

#[test]
fn folded_over_and_crossing_quads() {
    let folded = QuadMeasure::of(quad([(0., 0., 0.), (100., 0., 0.), (100., 100., 0.), (95., 0., 20.)]));
    assert_eq!(folded.verdict, Verdict::FoldedOver);
    assert!(folded.planarity.unwrap() < 0.0);
    let crossing = QuadMeasure::of(quad([(0., 0., 0.), (100., 70., 0.), (100., 0., 0.), (0., 100., 0.)]));
    assert_eq!(crossing.verdict, Verdict::FoldedOver);
    assert!((crossing.planarity.unwrap() + 1.0).abs() < 1e-12);
}

#[test]
fn degenerate_quads() {
    for corners in [
        [DVec3::ONE; 4],
        quad([(0., 0., 0.), (0., 0., 0.), (100., 0., 0.), (0., 100., 0.)]),
        quad([(0., 0., 0.), (1., 0., 0.), (2., 0., 0.), (3., 0., 0.)]),
        quad([(0., 0., 0.), (1., 1., 0.), (0., 0., 0.), (3., 0., 0.)]),
    ] {
        let measure = QuadMeasure::of(corners);
        assert_eq!(measure.verdict, Verdict::Degenerate, "{corners:?}");
        assert_eq!(measure.planarity, None);
    }
}

#[test]
fn triangles_and_apexes_agree() {
    for split in [Diagonal::Ac, Diagonal::Bd] {
        for side in 0..4 {
            let ends = [side, (side + 1) % 4];
            let triangle =
                split.triangles().into_iter().find(|triangle| ends.iter().all(|end| triangle.contains(end)));
            let apex = triangle.unwrap().into_iter().find(|corner| !ends.contains(corner)).unwrap();
            assert_eq!(split.apex_of_side(side), apex);
        }
    }
}

fn near_square() -> impl Strategy<Value = [DVec3; 4]> {
    proptest::array::uniform12(-20.0f64..20.0).prop_map(|shift| {
        let square = samples::square(100.0);
        [0, 1, 2, 3].map(|k| square[k] + DVec3::new(shift[3 * k], shift[3 * k + 1], shift[3 * k + 2]))
    })
}

proptest! {
    #[test]
    fn turning_the_names_round_changes_nothing(corners in near_square()) {
        let [a, b, c, d] = corners;
        let measure = QuadMeasure::of(corners);
        let turned = QuadMeasure::of([b, c, d, a]);
        let back = QuadMeasure::of([d, c, b, a]);
        for other in [turned, back] {
            prop_assert_eq!(measure.verdict, other.verdict);
            prop_assert!((measure.planarity.unwrap() - other.planarity.unwrap()).abs() < 1e-12);
            prop_assert!((measure.diagonal_ratio.unwrap() - other.diagonal_ratio.unwrap()).abs() < 1e-12);
        }
        prop_assert!((measure.fold_ac.unwrap() - turned.fold_bd.unwrap()).abs() < 1e-12);
    }

    #[test]
    fn planarity_is_the_cosine_of_the_larger_fold(corners in near_square()) {
        let measure = QuadMeasure::of(corners);
        let larger = measure.fold_ac.unwrap().max(measure.fold_bd.unwrap());
        prop_assert!((measure.planarity.unwrap() - libm::cos(larger)).abs() < 1e-12);
        prop_assert!(measure.fold().unwrap() <= larger);
    }

    #[test]
    fn planarity_does_not_depend_on_size(corners in near_square(), scale in 0.001f64..1000.0) {
        let measure = QuadMeasure::of(corners);
        let scaled = QuadMeasure::of(corners.map(|corner| corner * scale));
        prop_assert!((measure.planarity.unwrap() - scaled.planarity.unwrap()).abs() < 1e-9);
        prop_assert!((measure.area * scale * scale - scaled.area).abs() <= 1e-9 * scaled.area);
    }

    #[test]
    fn never_not_a_number(values in proptest::array::uniform12(-2i8..3)) {
        let corner = |k: usize| DVec3::new(values[3 * k].into(), values[3 * k + 1].into(), values[3 * k + 2].into());
        let measure = QuadMeasure::of([corner(0), corner(1), corner(2), corner(3)]);
        let figures = [measure.planarity, measure.fold_ac, measure.fold_bd, measure.diagonal_ratio, Some(measure.area)];
        prop_assert!(figures.into_iter().flatten().all(f64::is_finite), "{:?}", measure);
    }
}
