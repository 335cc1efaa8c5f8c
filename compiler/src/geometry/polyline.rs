//! Polylines in space: lengths, turning angles, and the plane they lie in.

use glam::DVec3;

use super::planarity::angle_between;

/// How far (mm) a point may lie off a line or a plane and still count as on it, unless a caller says otherwise.
pub const DEFAULT_TOLERANCE: f64 = 1e-6;

/// A plane through `point` with unit `normal`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// A point of the plane.
    pub point: DVec3,
    /// Unit normal. Of the two, the one whose component of largest size is positive.
    pub normal: DVec3,
}

/// Whether a polyline is straight, plane or neither.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PolylineShape {
    /// All points are one point.
    Point,
    /// All points lie on a line: many planes hold it.
    Straight {
        /// Unit direction from the first point to the one farthest from it.
        direction: DVec3,
    },
    /// All points lie in one plane, and not on a line.
    Planar(Plane),
    /// No plane holds it.
    Spatial {
        /// How far a point lies off the plane of the widest three points found, mm.
        deviation: f64,
    },
}

/// The lengths of the segments, one less than there are points. mm.
#[must_use]
pub fn segment_lengths(points: &[DVec3]) -> Vec<f64> {
    points.windows(2).map(|pair| pair[0].distance(pair[1])).collect()
}

/// The length of the polyline, mm.
#[must_use]
pub fn length(points: &[DVec3]) -> f64 {
    segment_lengths(points).iter().sum()
}

/// At each interior point the angle in 0 ..= π between the segment before and the segment after: 0 where the line
/// goes straight on, and 0 where a segment has no length. Two less than there are points. rad.
#[must_use]
pub fn turning_angles(points: &[DVec3]) -> Vec<f64> {
    points.windows(3).map(|three| angle_between(three[1] - three[0], three[2] - three[1])).collect()
}

/// The turning angles of a polyline in a plane, positive where it turns left seen against `normal` (a unit vector).
/// rad, −π ..= π.
#[must_use]
pub fn signed_turning_angles(points: &[DVec3], normal: DVec3) -> Vec<f64> {
    points
        .windows(3)
        .map(|three| {
            let (before, after) = (three[1] - three[0], three[2] - three[1]);
            libm::atan2(before.cross(after).dot(normal), before.dot(after))
        })
        .collect()
}

/// Whether the points are straight, plane or neither, within `tolerance` (mm; see [`DEFAULT_TOLERANCE`]).
///
/// The plane is that of the first point, the one farthest from it, and the one farthest from the line of these two;
/// so an S-shaped curve, whose area cancels out, has its plane too. No points count as one.
#[must_use]
pub fn shape(points: &[DVec3], tolerance: f64) -> PolylineShape {
    let Some(&origin) = points.first() else { return PolylineShape::Point };
    let (far, distance) = farthest(points, |point| point.distance(origin));
    if distance <= tolerance {
        return PolylineShape::Point;
    }
    let direction = (far - origin) / distance;
    let off_line = |point: DVec3| (point - origin).cross(direction);
    let (widest, width) = farthest(points, |point| off_line(point).length());
    if width <= tolerance {
        return PolylineShape::Straight { direction };
    }
    let normal = facing_positive(off_line(widest) / width);
    let (_, deviation) = farthest(points, |point| (point - origin).dot(normal).abs());
    if deviation <= tolerance {
        PolylineShape::Planar(Plane { point: origin, normal })
    } else {
        PolylineShape::Spatial { deviation }
    }
}

/// The point where `measure` is largest (the first on a tie), and that measure.
fn farthest(points: &[DVec3], measure: impl Fn(DVec3) -> f64) -> (DVec3, f64) {
    points.iter().fold((DVec3::ZERO, -1.0), |(best, most), &point| {
        let value = measure(point);
        if value > most { (point, value) } else { (best, most) }
    })
}

fn facing_positive(normal: DVec3) -> DVec3 {
    let [x, y, z] = normal.to_array();
    let largest =
        [x, y, z].into_iter().fold(0.0f64, |kept, part| if part.abs() > kept.abs() { part } else { kept });
    if largest < 0.0 { -normal } else { normal }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::{FRAC_PI_2, TAU};

    #[test]
    fn a_right_angle() {
        let points = [DVec3::ZERO, DVec3::X * 300.0, DVec3::new(300.0, 0.0, 400.0)];
        assert_eq!(segment_lengths(&points), vec![300.0, 400.0]);
        assert_eq!(length(&points), 700.0);
        assert!((turning_angles(&points)[0] - FRAC_PI_2).abs() < 1e-15);
        let PolylineShape::Planar(plane) = shape(&points, DEFAULT_TOLERANCE) else { panic!("not a plane") };
        assert!((plane.normal - DVec3::Y).length() < 1e-15);
        assert!((signed_turning_angles(&points, plane.normal)[0] + FRAC_PI_2).abs() < 1e-15);
    }

    #[test]
    fn small_turns_are_exact() {
        let points = [DVec3::ZERO, DVec3::X, DVec3::new(2.0, 1e-9, 0.0)];
        assert!((turning_angles(&points)[0] - 1e-9).abs() < 1e-24);
    }

    #[test]
    fn points_lines_planes_and_neither() {
        assert_eq!(shape(&[], 1e-6), PolylineShape::Point);
        assert_eq!(shape(&[DVec3::ONE; 3], 1e-6), PolylineShape::Point);
        let line = [DVec3::ZERO, DVec3::Z, DVec3::Z * 5.0, DVec3::Z * 2.0];
        assert_eq!(shape(&line, 1e-6), PolylineShape::Straight { direction: DVec3::Z });
        let helix: Vec<DVec3> = (0..20)
            .map(|k| f64::from(k) * 0.3)
            .map(|t| DVec3::new(100.0 * libm::cos(t), 100.0 * libm::sin(t), 10.0 * t))
            .collect();
        let PolylineShape::Spatial { deviation } = shape(&helix, 1e-6) else { panic!("not plane") };
        assert!(deviation > 1.0);
        assert!(matches!(shape(&helix, 100.0), PolylineShape::Planar(_)));
    }

    proptest! {
        #[test]
        fn a_plane_is_found_however_it_lies(
            normal in proptest::array::uniform3(-1.0f64..1.0),
            offset in proptest::array::uniform3(-1e4f64..1e4),
        ) {
            let Some(normal) = DVec3::from(normal).try_normalize() else { return Ok(()) };
            let (u, v) = normal.any_orthonormal_pair();
            // An S-curve: its area cancels.
            let points: Vec<DVec3> = (0..=16)
                .map(|k| f64::from(k) / 16.0)
                .map(|t| DVec3::from(offset) + u * (3000.0 * t) + v * (500.0 * libm::sin(TAU * t)))
                .collect();
            let PolylineShape::Planar(plane) = shape(&points, DEFAULT_TOLERANCE) else {
                return Err(TestCaseError::fail("not plane"));
            };
            prop_assert!(plane.normal.cross(normal).length() < 1e-9);
            prop_assert!(plane.normal.max_element() >= -plane.normal.min_element());
            let turning = turning_angles(&points);
            for (signed, plain) in signed_turning_angles(&points, plane.normal).iter().zip(&turning) {
                prop_assert!((signed.abs() - plain).abs() < 1e-9);
            }
        }
    }
}
