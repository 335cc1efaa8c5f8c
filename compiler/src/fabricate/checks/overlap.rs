//! `require overlap`: how far apart the joints of neighbouring curves of planks lie (GEOMETRY section 8).

use glam::DVec3;

use super::{CheckResult, Limit, Tally};
use crate::fabricate::label::Label;

/// A curve of planks, as [`crate::fabricate::plank::planks`] gets it.
#[derive(Debug, Clone, Copy)]
pub struct Curve<'a> {
    /// The points of the curve, mm; the inner ones are its joints.
    pub points: &'a [DVec3],
    /// The names of its planks, one for each segment.
    pub labels: &'a [Label],
    /// Whether it goes round: its last point is its first one, and a joint too.
    pub closed: bool,
}

/// For each pair of consecutive curves the least distance, mm, between an interior joint of one and an interior joint
/// of the other, measured along the planks: a joint is carried over to the nearest point of the other curve, and from
/// there the distance runs along that curve. Both ways round; one measurement for each pair with joints on both
/// curves. It is told at the two planks that start at these joints.
#[must_use]
pub fn overlap(curves: &[Curve<'_>], limit: Limit) -> CheckResult {
    let mut tally = Tally::default();
    for pair in curves.windows(2) {
        let forth = closest(pair[0], pair[1]);
        let back = closest(pair[1], pair[0])
            .map(|found| Closest { joints: [found.joints[1], found.joints[0]], ..found });
        let nearer = match (forth, back) {
            (Some(forth), Some(back)) if back.distance < forth.distance => back,
            (Some(found), _) | (None, Some(found)) => found,
            (None, None) => continue,
        };
        let plank = |side: usize| pair[side].labels.get(nearer.joints[side]);
        let (Some(first), Some(second)) = (plank(0), plank(1)) else { continue };
        tally.judge(nearer.distance, limit, first, || {
            format!("between {} and {}", first.address, second.address)
        });
    }
    tally.result
}

#[derive(Clone, Copy)]
struct Closest {
    /// The index of the joint on each curve, which is also that of the plank that starts there.
    joints: [usize; 2],
    /// mm
    distance: f64,
}

/// The joint of `other` that comes nearest to a joint of `curve`, measured along `curve`.
fn closest(curve: Curve<'_>, other: Curve<'_>) -> Option<Closest> {
    let stations = stations(curve.points);
    let first = usize::from(!curve.closed);
    let joints = stations.get(first..stations.len().saturating_sub(first)).unwrap_or_default();
    let planks = curve.labels.len().max(1);
    let mut found: Option<Closest> = None;
    for (carried, &point) in joints_of(other) {
        let at = station_of_nearest(curve.points, &stations, point);
        // Stations ascend: the nearest joint is the last before or the first after.
        let after = joints.partition_point(|&station| station < at);
        for joint in [after.checked_sub(1), Some(after)].into_iter().flatten() {
            let Some(station) = joints.get(joint) else { continue };
            let distance = (station - at).abs();
            if found.is_none_or(|found| distance < found.distance) {
                found = Some(Closest { joints: [(joint + first) % planks, carried], distance });
            }
        }
    }
    found
}

/// The points where planks meet and their indices: the inner ones, and where the curve goes round the first one.
fn joints_of(curve: Curve<'_>) -> impl Iterator<Item = (usize, &DVec3)> {
    let last = curve.points.len().saturating_sub(1);
    curve.points.iter().enumerate().take(last).skip(usize::from(!curve.closed))
}

/// How far along the curve each point lies, mm.
fn stations(points: &[DVec3]) -> Vec<f64> {
    let mut at = 0.0;
    let mut previous = points.first().copied().unwrap_or(DVec3::ZERO);
    points
        .iter()
        .map(|&point| {
            at += previous.distance(point);
            previous = point;
            at
        })
        .collect()
}

/// How far along the curve its point nearest to `point` lies, mm; the first of equals.
fn station_of_nearest(points: &[DVec3], stations: &[f64], point: DVec3) -> f64 {
    let mut best = (f64::INFINITY, 0.0);
    for (segment, pair) in points.windows(2).enumerate() {
        let along = pair[1] - pair[0];
        let squared = along.length_squared();
        let part = if squared > 0.0 { ((point - pair[0]).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
        let distance = point.distance_squared(pair[0] + along * part);
        if distance < best.0 {
            best = (distance, stations[segment] + part * along.length());
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points of a Bézier curve after `level` steps of De Casteljau's algorithm at `t`.
    fn bezier(control: [DVec3; 4], t: f64, level: u32) -> Vec<DVec3> {
        fn halve(control: [DVec3; 4], t: f64, level: u32, points: &mut Vec<DVec3>) {
            if level == 0 {
                points.push(control[3]);
                return;
            }
            let [p0, p1, p2, p3] = control;
            let [a, h, d] = [p0.lerp(p1, t), p1.lerp(p2, t), p2.lerp(p3, t)];
            let [b, c] = [a.lerp(h, t), h.lerp(d, t)];
            let m = b.lerp(c, t);
            halve([p0, a, b, m], t, level - 1, points);
            halve([m, c, d, p3], t, level - 1, points);
        }
        let mut points = vec![control[0]];
        halve(control, t, level, &mut points);
        points
    }

    /// The vault of LANGUAGE section 7.
    fn vault(span: f64) -> Vec<Vec<DVec3>> {
        let (rise, width) = (2800.0 * 4.0 / 3.0, 27.0);
        [0.46, 0.48, 0.50, 0.52, 0.54]
            .into_iter()
            .enumerate()
            .map(|(arch, split)| {
                let y = arch as f64 * width;
                let points = [(0.0, 0.0), (0.1 * span, rise), (0.9 * span, rise), (span, 0.0)];
                bezier(points.map(|(x, z)| DVec3::new(x, y, z)), split, 4)
            })
            .collect()
    }

    fn labels(arches: usize, planks: usize) -> Vec<Vec<Label>> {
        (0..arches)
            .map(|arch| {
                (0..planks)
                    .map(|plank| Label { address: format!("vault.{arch}.{plank}"), ..Label::default() })
                    .collect()
            })
            .collect()
    }

    fn measure(arches: &[Vec<DVec3>], limit: Limit) -> CheckResult {
        let labels = labels(arches.len(), arches[0].len() - 1);
        let curves: Vec<Curve<'_>> = arches
            .iter()
            .zip(&labels)
            .map(|(points, labels)| Curve { points, labels, closed: false })
            .collect();
        overlap(&curves, limit)
    }

    #[test]
    fn the_vault_of_the_language_page() {
        for (span, expected) in [(6000.0, 87.4), (4000.0, 85.5)] {
            let found = measure(&vault(span), Limit::AtLeast(80.0));
            let (least, _) = found.extremes.unwrap();
            assert!((least - expected).abs() < 0.05, "span {span}: {least}");
            assert_eq!((found.total, found.measured[0].value), (4, least));
        }
    }

    #[test]
    fn two_straight_curves() {
        let curve = |y: f64, xs: [f64; 4]| xs.map(|x| DVec3::new(x, y, 0.0)).to_vec();
        let arches = [curve(0.0, [0.0, 300.0, 600.0, 900.0]), curve(27.0, [0.0, 200.0, 650.0, 900.0])];
        let found = measure(&arches, Limit::AtLeast(80.0));
        assert_eq!((found.total, found.failing, found.extremes), (1, 1, Some((50.0, 50.0))));
        assert_eq!(found.measured[0].address, "vault.0.2");
        assert_eq!(found.measured[0].place, "between vault.0.2 and vault.1.2");
    }

    /// A square that goes round has a joint at its seam, and distances run across it.
    #[test]
    fn rings_have_a_joint_at_their_seam() {
        let square = |y: f64, turn: usize| -> Vec<DVec3> {
            let corners = [(0.0, 0.0), (900.0, 0.0), (900.0, 900.0), (0.0, 900.0)];
            (0..5).map(|i| corners[(i + turn) % 4]).map(|(x, z)| DVec3::new(x, y, z)).collect()
        };
        let labels = labels(2, 4);
        let measure = |points: [&[DVec3]; 2]| {
            let curves =
                [0, 1].map(|ring| Curve { points: points[ring], labels: &labels[ring], closed: true });
            overlap(&curves, Limit::AtLeast(80.0))
        };
        for turn in 0..4 {
            let found = measure([&square(0.0, 0), &square(27.0, turn)]);
            assert_eq!((found.total, found.extremes), (1, Some((0.0, 0.0))), "turn {turn}");
        }
        // Joints half way between the other's, but one 2 degrees before its seam.
        let ring = |angles: [f64; 4]| -> Vec<DVec3> {
            let point = |angle: f64| DVec3::new(libm::cos(angle), 0.0, libm::sin(angle)) * 1000.0;
            (0..5).map(|i| point(angles[i % 4].to_radians())).collect()
        };
        let found = measure([&ring([0.0, 90.0, 180.0, 270.0]), &ring([45.0, 135.0, 225.0, 358.0])]);
        let (least, _) = found.extremes.unwrap();
        assert!((least - 25.0).abs() < 1.0, "{least}");
        assert_eq!(found.measured[0].address, "vault.0.0");
    }

    #[test]
    fn joints_beyond_the_other_curve_are_carried_to_its_end() {
        let arches = [
            [0.0, 100.0, 200.0].map(|x| DVec3::new(x, 0.0, 0.0)).to_vec(),
            [-300.0, -200.0, 500.0].map(|x| DVec3::new(x, 27.0, 0.0)).to_vec(),
        ];
        assert_eq!(measure(&arches, Limit::AtLeast(80.0)).extremes, Some((100.0, 100.0)));
        let mirrored = arches.map(|points| points.into_iter().map(|point| -point).collect::<Vec<_>>());
        assert_eq!(measure(&mirrored, Limit::AtLeast(80.0)).extremes, Some((100.0, 100.0)));
    }

    #[test]
    fn without_joints_there_is_nothing_to_measure() {
        let straight = vec![DVec3::ZERO, DVec3::X * 100.0];
        for arches in [vec![straight.clone(), straight.clone()], vec![straight]] {
            assert_eq!(measure(&arches, Limit::AtLeast(80.0)), CheckResult::default());
        }
    }
}
