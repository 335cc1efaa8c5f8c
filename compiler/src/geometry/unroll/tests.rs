//! Unrolled quads keep their lengths; bends are those of known roofs; what cannot be cut is refused.

use super::*;
use crate::geometry::{QuadMeasure, samples};
use proptest::prelude::*;

fn quad(points: [(f64, f64, f64); 4]) -> [DVec3; 4] {
    points.map(|(x, y, z)| DVec3::new(x, y, z))
}

/// The largest difference in length between space and plane, of the sides and the split diagonal.
fn length_error(corners: [DVec3; 4], unrolled: &UnrolledQuad) -> f64 {
    let [from, to] = unrolled.split.ends();
    [(0, 1), (1, 2), (2, 3), (3, 0), (from, to)]
        .into_iter()
        .map(|(p, q)| {
            (corners[p].distance(corners[q]) - unrolled.corners[p].distance(unrolled.corners[q])).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn a_flat_square_is_itself() {
    for split in [Diagonal::Ac, Diagonal::Bd] {
        let unrolled = unroll(samples::square(250.0), split).unwrap();
        for (flat, corner) in unrolled.corners.iter().zip(samples::square(250.0)) {
            assert!((*flat - corner.truncate()).length() < 1e-12);
        }
        assert_eq!((unrolled.bend.fold, unrolled.bend.radius()), (0.0, None));
        assert!((unrolled.bend.angle_to(DVec2::X) - std::f64::consts::FRAC_PI_4).abs() < 1e-12);
    }
}

#[test]
fn a_roof_has_the_radius_of_the_model() {
    // Over the diagonal AC of length 200, two triangles of height 100 and 50; the second turned by 0.1 rad.
    let turn = 0.1;
    let corners = [
        DVec3::ZERO,
        DVec3::new(100.0, -100.0, 0.0),
        DVec3::new(200.0, 0.0, 0.0),
        DVec3::new(100.0, 50.0 * libm::cos(turn), 50.0 * libm::sin(turn)),
    ];
    let bend = unroll(corners, Diagonal::Ac).unwrap().bend;
    assert!((bend.fold - turn).abs() < 1e-12);
    assert!((bend.heights[0] - 100.0).abs() < 1e-12 && (bend.heights[1] - 50.0).abs() < 1e-12);
    assert!((bend.radius().unwrap() - 750.0).abs() < 1e-6);
    let valley = unroll(corners.map(|corner| corner * DVec3::new(1.0, 1.0, -1.0)), Diagonal::Ac).unwrap();
    assert!((valley.bend.radius().unwrap() - 750.0).abs() < 1e-6);
}

#[test]
fn darts_unroll_to_darts() {
    let corners = quad([(0., 0., 0.), (100., 0., 0.), (30., 30., 5.), (0., 100., 0.)]);
    let measure = QuadMeasure::of(corners);
    let unrolled = unroll(corners, measure.split).unwrap();
    assert!(length_error(corners, &unrolled) < 1e-9);
    let [_, b, c, d] = unrolled.corners;
    assert!((c - b).perp_dot(d - c) < 0.0, "C stays reflex");
}

#[test]
fn what_cannot_be_cut_is_refused() {
    assert_eq!(unroll([DVec3::ONE; 4], Diagonal::Ac), Err(UnrollError::NoLength));
    let point = quad([(0., 0., 0.), (0., 0., 0.), (100., 0., 0.), (0., 100., 0.)]);
    assert_eq!(unroll(point, Diagonal::Ac), Err(UnrollError::NoLength));
    let line = quad([(0., 0., 0.), (1., 0., 0.), (2., 0., 0.), (3., 0., 0.)]);
    assert_eq!(unroll(line, Diagonal::Ac), Err(UnrollError::NoArea));
    // B lies on the line of AC beyond C: the side BC runs back over AB.
    let spike = quad([(0., 0., 0.), (150., 0., 0.), (100., 0., 0.), (50., 80., 30.)]);
    assert_eq!(unroll(spike, Diagonal::Ac), Err(UnrollError::SelfOverlapping));
    assert!(
        unroll(spike, Diagonal::Bd).is_ok()
            || unroll(spike, Diagonal::Bd) == Err(UnrollError::SelfOverlapping)
    );
}

proptest! {
    #[test]
    fn lengths_are_kept_and_the_outline_turns_left(
        shift in proptest::array::uniform12(-90.0f64..90.0),
        far in -1e4f64..1e4,
    ) {
        let square = samples::square(250.0);
        let corners = [0, 1, 2, 3]
            .map(|k| square[k] + DVec3::new(shift[3 * k] + far, shift[3 * k + 1] - far, shift[3 * k + 2]));
        for split in [QuadMeasure::of(corners).split, Diagonal::Ac, Diagonal::Bd] {
            let Ok(unrolled) = unroll(corners, split) else { continue };
            prop_assert!(length_error(corners, &unrolled) < 1e-9);
            let [a, b, c, d] = unrolled.corners;
            prop_assert_eq!((a, b.y), (DVec2::ZERO, 0.0));
            prop_assert!((c - a).perp_dot(d - b) > 0.0);
            prop_assert!(!cross(a, b, c, d) && !cross(b, c, d, a));
            let area: f64 = ((c - a).perp_dot(d - b)) / 2.0;
            let measure = QuadMeasure::of(corners);
            if split == measure.split {
                prop_assert!((area - measure.area).abs() < 1e-6 * measure.area);
                prop_assert!((unrolled.bend.fold - measure.fold().unwrap()).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn any_quad_is_unrolled_or_refused(values in proptest::array::uniform12(-2i8..3)) {
        let corner = |k: usize| DVec3::new(values[3 * k].into(), values[3 * k + 1].into(), values[3 * k + 2].into());
        let corners = [corner(0), corner(1), corner(2), corner(3)];
        for split in [Diagonal::Ac, Diagonal::Bd] {
            if let Ok(unrolled) = unroll(corners, split) {
                prop_assert!(length_error(corners, &unrolled) < 1e-9);
                prop_assert!(unrolled.corners.iter().all(|corner| corner.is_finite()));
            }
        }
    }
}
