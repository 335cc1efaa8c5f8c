//! One constraint for each quad: the distance of its diagonals, by the distance at which it is just flat enough.

use glam::DVec3;

use crate::geometry::planarity::corner_normals;
use crate::geometry::{Diagonal, QuadMeasure, QuadMesh, Verdict};

/// The part of what is allowed that a step aims at, so that what the linear step leaves over stays within it.
const AIM: f64 = 0.7;

/// The least sine of a fold that is asked for: below it rounding decides.
const LEAST_SINE: f64 = 1e-9;

/// How flat is flat enough.
#[derive(Debug, Clone, Copy)]
pub(super) struct Goal {
    /// The sine of the largest fold.
    sine: f64,
    planarity: f64,
    /// The largest diagonal ratio, where one is asked for.
    ratio: Option<f64>,
}

impl Goal {
    pub(super) fn new(planarity: f64, ratio: Option<f64>) -> Self {
        let sine = (1.0 - planarity.max(0.0) * planarity.max(0.0)).max(0.0).sqrt();
        Self { sine: sine.max(LEAST_SINE), planarity, ratio }
    }

    /// Whether a quad which has a planarity is flat enough.
    pub(super) fn holds_for(&self, measure: &QuadMeasure) -> bool {
        measure.planarity.is_none_or(|planarity| planarity >= self.planarity)
            && self.ratio.is_none_or(|most| measure.diagonal_ratio.is_none_or(|ratio| ratio <= most))
    }
}

/// A quad that is to be flat: convex or a dart, with a corner that may move.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constraint {
    corners: [u32; 4],
    /// For a dart the one diagonal inside it.
    inside: Option<Diagonal>,
}

/// The quads that are to be flat. What is folded over is not: flat it would still lie on itself.
pub(super) fn constraints(mesh: &QuadMesh, measures: &[QuadMeasure], held: &[bool]) -> Vec<Constraint> {
    let quads = mesh.quads.iter().zip(measures);
    let movable = quads.filter(|(corners, _)| corners.iter().any(|&corner| !held[corner as usize]));
    movable
        .filter_map(|(&corners, measure)| match measure.verdict {
            Verdict::Convex => Some(Constraint { corners, inside: None }),
            Verdict::Dart => Some(Constraint { corners, inside: Some(measure.split) }),
            _ => None,
        })
        .collect()
}

/// A constraint linearised: how it changes with each corner, and how far it is beyond the aim.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    /// The corners, as vertices of the mesh.
    pub(super) corners: [u32; 4],
    /// The derivative by the position of each corner.
    pub(super) slopes: [DVec3; 4],
    /// What is to be taken away.
    pub(super) excess: f64,
}

impl Constraint {
    /// The constraint at the present positions; none where the diagonals are parallel.
    ///
    /// With p = A + s(C − A) and q = B + t(D − B) the nearest points of the diagonals and n the unit normal of both,
    /// the distance is (q − p)·n, and its derivatives are −(1 − s)n, (1 − t)n, −s·n and t·n: those of p, q and n
    /// along themselves vanish, for the distance is stationary there.
    pub(super) fn row(&self, vertices: &[DVec3], goal: &Goal) -> Option<Row> {
        let corners = self.corners.map(|corner| vertices[corner as usize]);
        let [a, b, c, d] = corners;
        let (e, f, g) = (c - a, d - b, b - a);
        let cross = e.cross(f);
        let size = cross.length_squared();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let normal = cross / size.sqrt();
        let allowed = self.allowed(corners, goal, size.sqrt());
        let s = g.cross(f).dot(cross) / size;
        let t = g.cross(e).dot(cross) / size;
        let unit = normal / allowed;
        Some(Row {
            corners: self.corners,
            slopes: [unit * (s - 1.0), unit * (1.0 - t), unit * -s, unit * t],
            excess: beyond(g.dot(normal) / allowed),
        })
    }

    /// How far the constraint is beyond the aim; 0 within it.
    pub(super) fn excess(&self, vertices: &[DVec3], goal: &Goal) -> f64 {
        let corners = self.corners.map(|corner| vertices[corner as usize]);
        let [a, b, c, d] = corners;
        let cross = (c - a).cross(d - b);
        let size = cross.length();
        if !(size > 0.0 && size.is_finite()) {
            return 0.0;
        }
        beyond((b - a).dot(cross) / size / self.allowed(corners, goal, size))
    }

    /// The distance of the diagonals at which the quad is just flat enough. With n and n' the normals of the triangles
    /// over a diagonal, as long as twice their areas, and v six times the volume of the tetrahedron, the sine of the
    /// fold is v·|diagonal| / (|n|·|n'|), and v is the distance times |AC × BD|.
    fn allowed(&self, corners: [DVec3; 4], goal: &Goal, cross: f64) -> f64 {
        let normals = corner_normals(corners).map(DVec3::length);
        let diagonals = [corners[0].distance(corners[2]), corners[1].distance(corners[3])];
        let over = |areas: f64, diagonal: f64| goal.sine * areas / (cross * diagonal);
        let ac = over(normals[1] * normals[3], diagonals[0]);
        let bd = over(normals[0] * normals[2], diagonals[1]);
        let fold = match self.inside {
            None => ac.min(bd),
            Some(Diagonal::Ac) => ac,
            Some(Diagonal::Bd) => bd,
        };
        let mean = (diagonals[0] + diagonals[1]) / 2.0;
        let allowed = goal.ratio.map_or(fold, |ratio| fold.min(ratio * mean));
        allowed.max(1e-12 * mean)
    }
}

fn beyond(relative: f64) -> f64 {
    relative - relative.clamp(-AIM, AIM)
}

/// The sum of the squared excesses: what a step must lower.
pub(super) fn merit(constraints: &[Constraint], vertices: &[DVec3], goal: &Goal) -> f64 {
    constraints.iter().map(|constraint| constraint.excess(vertices, goal)).map(|excess| excess * excess).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn measured(corners: [DVec3; 4]) -> (Constraint, QuadMeasure) {
        let measure = QuadMeasure::of(corners);
        (Constraint { corners: [0, 1, 2, 3], inside: None }, measure)
    }

    fn quad() -> impl Strategy<Value = [DVec3; 4]> {
        let square = [(0.0, 0.0), (300.0, 0.0), (300.0, 250.0), (0.0, 250.0)];
        proptest::array::uniform4(proptest::array::uniform3(-60.0f64..60.0)).prop_map(move |shifts| {
            [0, 1, 2, 3].map(|k| DVec3::new(square[k].0, square[k].1, 0.0) + DVec3::from(shifts[k]))
        })
    }

    proptest! {
        #[test]
        fn a_quad_within_what_is_allowed_is_flat_enough(corners in quad(), planarity in 0.9f64..0.999_99) {
            let (constraint, measure) = measured(corners);
            let found = measure.planarity.unwrap();
            let cross = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
            let distance = (corners[1] - corners[0]).dot(cross).abs() / cross.length();
            let goal = Goal::new(planarity, None);
            let relative = distance / constraint.allowed(corners, &goal, cross.length());
            prop_assume!((found - planarity).abs() > 1e-9);
            prop_assert_eq!(relative <= 1.0, found >= planarity, "{} {}", relative, found);
            prop_assert_eq!(goal.holds_for(&measure), found >= planarity);
            let ratio = Goal::new(-1.0, Some(0.01));
            let relative = distance / constraint.allowed(corners, &ratio, cross.length());
            let fold_too = distance / constraint.allowed(corners, &Goal::new(-1.0, None), cross.length());
            prop_assert!((relative - (measure.diagonal_ratio.unwrap() / 0.01).max(fold_too)).abs() < 1e-9);
        }

        #[test]
        fn the_slopes_are_those_of_the_distance(corners in quad(), push in proptest::array::uniform4(proptest::array::uniform3(-1.0f64..1.0))) {
            let (constraint, _) = measured(corners);
            let goal = Goal::new(0.9, None);
            let row = constraint.row(&corners, &goal).unwrap();
            let cross = (corners[2] - corners[0]).cross(corners[3] - corners[1]).length();
            let allowed = constraint.allowed(corners, &goal, cross);
            let at = |length: f64| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|k| corners[k] + DVec3::from(push[k]) * length);
                (b - a).dot((c - a).cross(d - b).normalize())
            };
            let slope: f64 = (0..4).map(|k| row.slopes[k].dot(DVec3::from(push[k]))).sum::<f64>() * allowed;
            prop_assert!(((at(1e-4) - at(-1e-4)) / 2e-4 - slope).abs() < 1e-5);
        }
    }
}
