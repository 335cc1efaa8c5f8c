//! The sizes of an outline, and whether it fits a sheet. Where on the sheet it goes is nesting's.

use glam::DVec2;

use crate::geometry::polyline::DEFAULT_TOLERANCE;

/// The lower and upper corner of the box along the axes around some points; zero for none. mm.
#[must_use]
pub fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let Some(&first) = points.first() else { return (DVec2::ZERO, DVec2::ZERO) };
    points.iter().fold((first, first), |(low, high), &point| (low.min(point), high.max(point)))
}

/// The least distance of two parallel lines with all the points between them, mm; 0 for fewer than three.
///
/// One of the two lies on an edge of the convex hull (Houle and Toussaint, 1988, Computing the width of a set), so on
/// two of the points: their directions are tried.
#[must_use]
pub fn least_width(points: &[DVec2]) -> f64 {
    let mut least = f64::INFINITY;
    for (index, &from) in points.iter().enumerate() {
        for &to in &points[index + 1..] {
            let Some(along) = (to - from).try_normalize() else { continue };
            let heights = points.iter().map(|&point| along.perp_dot(point - from));
            let (low, high) =
                heights.fold((0.0f64, 0.0f64), |(low, high), height| (low.min(height), high.max(height)));
            least = least.min(high - low);
        }
    }
    if least.is_finite() { least } else { 0.0 }
}

/// Whether the outline, as it is turned, fits a sheet of `length` along x by `width` along y, within
/// [`DEFAULT_TOLERANCE`]. mm.
#[must_use]
pub fn fits_as_it_lies(outline: &[DVec2], length: f64, width: f64) -> bool {
    let (low, high) = bounds(outline);
    let size = high - low;
    size.x <= length + DEFAULT_TOLERANCE && size.y <= width + DEFAULT_TOLERANCE
}

/// Whether the outline fits a sheet of `length` by `width` (mm) turned some way or other.
///
/// Exact but for the tolerance: turn an outline that fits until it no longer would; there a pair of its corners just
/// touches two opposite sides of the sheet. So these angles are tried, and if there are none, any angle is as good.
#[must_use]
pub fn fits_turned(outline: &[DVec2], length: f64, width: f64) -> bool {
    directions(outline, length, width).into_iter().any(|x| {
        let turned: Vec<DVec2> =
            outline.iter().map(|&point| DVec2::new(x.dot(point), x.perp_dot(point))).collect();
        fits_as_it_lies(&turned, length, width) || fits_as_it_lies(&turned, width, length)
    })
}

/// Unit vectors to try as the sheet's x axis.
fn directions(outline: &[DVec2], length: f64, width: f64) -> Vec<DVec2> {
    let mut found = vec![DVec2::X];
    for (index, &from) in outline.iter().enumerate() {
        for &to in &outline[index + 1..] {
            let distance = from.distance(to);
            let Some(along) = (to - from).try_normalize() else { continue };
            for reach in [length, width].into_iter().filter(|&reach| reach < distance) {
                let cosine = reach / distance;
                let sine = (1.0 - cosine * cosine).sqrt();
                found.extend([sine, -sine].map(|sine| along.rotate(DVec2::new(cosine, sine))));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rectangle(length: f64, width: f64, angle: f64) -> Vec<DVec2> {
        let turn = DVec2::new(libm::cos(angle), libm::sin(angle));
        [(0.0, 0.0), (length, 0.0), (length, width), (0.0, width)]
            .map(|(x, y)| turn.rotate(DVec2::new(x, y)))
            .to_vec()
    }

    #[test]
    fn a_long_strip_only_fits_across_the_corners() {
        // A square of 100 holds a strip of 130 by 8 only at 45 degrees: 138 / √2 = 97.6.
        assert!(fits_turned(&rectangle(130.0, 8.0, 0.3), 100.0, 100.0));
        assert!(!fits_turned(&rectangle(134.0, 8.0, 0.3), 100.0, 100.0));
        assert!(!fits_as_it_lies(&rectangle(130.0, 8.0, 0.0), 100.0, 100.0));
    }

    #[test]
    fn widths_of_known_outlines() {
        assert!((least_width(&rectangle(300.0, 40.0, 0.7)) - 40.0).abs() < 1e-9);
        // A parallelogram of 200 by 100 leaning by 60 degrees: its height on the longer side.
        let leaning = [(0.0, 0.0), (200.0, 0.0), (250.0, 75f64.sqrt() * 10.0), (50.0, 75f64.sqrt() * 10.0)];
        assert!((least_width(&leaning.map(DVec2::from)) - 86.602_540_378).abs() < 1e-6);
        assert_eq!(least_width(&[]), 0.0);
        assert_eq!(least_width(&[DVec2::ZERO, DVec2::X]), 0.0);
    }

    proptest! {
        #[test]
        fn no_direction_is_narrower(points in proptest::collection::vec((0.0f64..100.0, 0.0f64..100.0), 4)) {
            let outline: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
            let widths = (0..3600).map(|step| {
                let turn = DVec2::from_angle(f64::from(step) * std::f64::consts::PI / 3600.0);
                let heights: Vec<f64> = outline.iter().map(|&point| turn.perp_dot(point)).collect();
                heights.iter().fold(f64::NEG_INFINITY, |high, &height| high.max(height))
                    - heights.iter().fold(f64::INFINITY, |low, &height| low.min(height))
            });
            let tried = widths.fold(f64::INFINITY, f64::min);
            let least = least_width(&outline);
            prop_assert!(least <= tried + 1e-6 && tried <= least + 0.2, "{least} {tried}");
        }

        #[test]
        fn agrees_with_trying_every_angle(
            points in proptest::collection::vec((0.0f64..100.0, 0.0f64..100.0), 4),
            length in 20.0f64..150.0,
            width in 20.0f64..150.0,
        ) {
            let outline: Vec<DVec2> = points.into_iter().map(DVec2::from).collect();
            let tried = (0..3600).any(|step| {
                let angle = f64::from(step) * std::f64::consts::TAU / 3600.0;
                let turn = DVec2::new(libm::cos(angle), libm::sin(angle));
                let turned: Vec<DVec2> = outline.iter().map(|&point| turn.rotate(point)).collect();
                fits_as_it_lies(&turned, length, width)
            });
            if tried {
                prop_assert!(fits_turned(&outline, length, width));
            } else {
                prop_assert!(!fits_turned(&outline, length - 0.5, width - 0.5));
            }
        }
    }
}
