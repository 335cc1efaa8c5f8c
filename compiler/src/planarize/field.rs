//! The smooth objective of the search and its gradient by central differences.

use glam::DVec3;

use crate::geometry::planarity::corner_normals;
use crate::geometry::{Diagonal, QuadMeasure, QuadMesh, Verdict};

use super::faces::Face;
use super::selection::Selection;

/// The exponent of the mean that stands in for the worst.
const SMOOTH_WORST: i32 = 8;

/// How much the worst and the mean count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Weights {
    pub(super) worst: f64,
    pub(super) average: f64,
}

/// A quad that changes when free vertices move.
struct Patch {
    face: Face,
    /// Which of the folds over AC and BD count: both, or for a dart the one over its reflex corner.
    counts: [bool; 2],
}

/// The objective over the touched quads, as a function of all vertex positions.
pub(super) struct Field {
    patches: Vec<Patch>,
    free: Vec<bool>,
    step: f64,
}

impl Field {
    /// The objective for what `selection` touches; `measures` are those of the start. `step` in mm.
    pub(super) fn new(start: &QuadMesh, measures: &[QuadMeasure], selection: &Selection, step: f64) -> Self {
        let patches = selection.touched.iter().map(|&quad| patch(start, measures, quad as usize)).collect();
        Self { patches, free: selection.free.clone(), step }
    }

    /// The smooth objective: α times the q-norm of the deficits 1 − cos of the folds, plus β times their mean.
    pub(super) fn value(&self, vertices: &[DVec3], weights: Weights) -> f64 {
        let deficits = self.deficits(vertices);
        let (norm, mean) = self.norm_and_mean(&deficits);
        weights.worst * norm + weights.average * mean
    }

    /// The gradient of [`Field::value`], zero at vertices which may not move: central differences of each quad's
    /// deficits with the step, put together by the chain rule.
    pub(super) fn gradient(&self, vertices: &[DVec3], weights: Weights) -> Vec<DVec3> {
        let deficits = self.deficits(vertices);
        let (norm, _) = self.norm_and_mean(&deficits);
        let count = self.terms();
        let slope = |deficit: f64| {
            let share = if norm > 0.0 { power(deficit / norm, SMOOTH_WORST - 1) } else { 0.0 };
            weights.worst * share + weights.average / count
        };
        let mut gradient = vec![DVec3::ZERO; vertices.len()];
        for (patch, deficits) in self.patches.iter().zip(&deficits) {
            let slopes = [0, 1].map(|k| if patch.counts[k] { slope(deficits[k]) } else { 0.0 });
            let positions = patch.face.corners.map(|corner| vertices[corner]);
            for (k, &corner) in patch.face.corners.iter().enumerate() {
                if self.free[corner] {
                    gradient[corner] += self.difference(positions, k, slopes);
                }
            }
        }
        gradient
    }

    /// Whether no quad is inverted which was not: convex quads stay convex, none turns over against its start, and
    /// none loses its shape.
    pub(super) fn admits(&self, vertices: &[DVec3]) -> bool {
        self.patches.iter().all(|patch| patch.face.admits(vertices))
    }

    fn deficits(&self, vertices: &[DVec3]) -> Vec<[f64; 2]> {
        self.patches.iter().map(|patch| deficits(patch.face.corners.map(|corner| vertices[corner]))).collect()
    }

    fn counted<'a>(&'a self, deficits: &'a [[f64; 2]]) -> impl Iterator<Item = f64> + 'a {
        let pairs = self.patches.iter().zip(deficits);
        pairs.flat_map(|(patch, deficits)| (0..2).filter(|&k| patch.counts[k]).map(|k| deficits[k]))
    }

    fn terms(&self) -> f64 {
        let terms = self.patches.iter().flat_map(|patch| patch.counts).filter(|counts| *counts).count();
        terms.max(1) as f64
    }

    fn norm_and_mean(&self, deficits: &[[f64; 2]]) -> (f64, f64) {
        let largest = self.counted(deficits).fold(0.0, f64::max);
        if largest <= 0.0 {
            return (0.0, 0.0);
        }
        let sum: f64 = self.counted(deficits).map(|deficit| power(deficit / largest, SMOOTH_WORST)).sum();
        let mean = self.counted(deficits).sum::<f64>() / self.terms();
        (largest * root(sum), mean)
    }

    /// The derivative of `slopes` · deficits by the position of corner `k`.
    fn difference(&self, positions: [DVec3; 4], k: usize, slopes: [f64; 2]) -> DVec3 {
        let along = |axis: DVec3| {
            let at = |step: f64| {
                let mut moved = positions;
                moved[k] += axis * step;
                let [ac, bd] = deficits(moved);
                slopes[0] * ac + slopes[1] * bd
            };
            (at(self.step) - at(-self.step)) / (2.0 * self.step)
        };
        DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z))
    }
}

fn patch(start: &QuadMesh, measures: &[QuadMeasure], quad: usize) -> Patch {
    let measure = &measures[quad];
    let counts = match (measure.verdict, measure.split) {
        (Verdict::Convex | Verdict::FoldedOver, _) => [true, true],
        (Verdict::Degenerate, _) => [false, false],
        (_, Diagonal::Ac) => [true, false],
        (_, Diagonal::Bd) => [false, true],
    };
    Patch { face: Face::new(start, measure, quad), counts }
}

/// 1 − cos of the folds over AC and BD, without cancellation for small folds. 2 where a triangle has no area.
fn deficits(corners: [DVec3; 4]) -> [f64; 2] {
    let [a, b, c, d] = corner_normals(corners);
    [deficit(b, d), deficit(a, c)]
}

fn deficit(first: DVec3, second: DVec3) -> f64 {
    let lengths = (first.length_squared() * second.length_squared()).sqrt();
    let dot = first.dot(second);
    if lengths <= 0.0 {
        2.0
    } else if dot > 0.0 {
        first.cross(second).length_squared() / (lengths * (lengths + dot))
    } else {
        1.0 - dot / lengths
    }
}

/// `base` to a whole power by repeated products: the same bits on every machine.
fn power(base: f64, exponent: i32) -> f64 {
    (0..exponent).fold(1.0, |product, _| product * base)
}

/// The eighth root.
fn root(value: f64) -> f64 {
    value.sqrt().sqrt().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;
    use crate::planarize::Pin;
    use crate::planarize::lbfgs::{add, dot};
    use proptest::prelude::*;

    const BOTH: Weights = Weights { worst: 1.0, average: 2.0 };

    fn measures(mesh: &QuadMesh) -> Vec<QuadMeasure> {
        (0..mesh.quads.len()).map(|quad| QuadMeasure::of(mesh.corners_of(quad))).collect()
    }

    fn field(mesh: &QuadMesh) -> Field {
        let measures = measures(mesh);
        let selection = Selection::new(mesh, &measures, 1.0, Pin::None);
        Field::new(mesh, &measures, &selection, 0.01)
    }

    fn bumpy(heights: &[f64]) -> QuadMesh {
        samples::mesh(4, 4, |i, j| DVec3::new(250.0 * i, 250.0 * j, heights[(4.0 * i + j) as usize]))
    }

    #[test]
    fn deficits_are_exact_for_small_folds() {
        let [a, b, d] = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let lift = 1e-6;
        let [ac, bd] = deficits([a, b, DVec3::new(1.0, 1.0, lift), d]);
        // The folds of a unit square with a corner lifted by h: sin² = h² · |diagonal|² / (4 areas)², about 2h².
        assert!((ac / (lift * lift) - 1.0).abs() < 1e-6, "{ac}");
        assert!((bd / (lift * lift) - 1.0).abs() < 1e-6, "{bd}");
        assert_eq!(deficits([a, a, a, a]), [2.0, 2.0]);
    }

    #[test]
    fn the_smooth_worst_lies_little_above_the_true_one() {
        let heights: Vec<f64> = (0..16).map(|k| 20.0 * libm::sin(f64::from(k) * 1.7)).collect();
        let mesh = bumpy(&heights);
        let smooth = field(&mesh).value(&mesh.vertices, Weights { worst: 1.0, average: 0.0 });
        let worst = measures(&mesh).iter().filter_map(|measure| measure.planarity).fold(1.0, f64::min);
        // At most the eighth root of the 18 terms.
        assert!(smooth >= 1.0 - worst && smooth <= 1.44 * (1.0 - worst), "{smooth} {worst}");
    }

    proptest! {
        #[test]
        fn the_gradient_is_the_slope_of_the_value(
            heights in proptest::collection::vec(-60.0f64..60.0, 16),
            push in proptest::collection::vec(proptest::array::uniform3(-1.0f64..1.0), 16),
        ) {
            let mesh = bumpy(&heights);
            let field = field(&mesh);
            let push: Vec<DVec3> = push.into_iter().map(DVec3::from).collect();
            let gradient = field.gradient(&mesh.vertices, BOTH);
            let at = |length: f64| {
                let mut moved = mesh.vertices.clone();
                add(&mut moved, length, &push);
                field.value(&moved, BOTH)
            };
            let slope = (at(1e-3) - at(-1e-3)) / 2e-3;
            let size = (dot(&gradient, &gradient) * dot(&push, &push)).sqrt();
            prop_assert!((dot(&gradient, &push) - slope).abs() <= 1e-5 * size + 1e-12);
        }

        #[test]
        fn moving_or_scaling_the_whole_costs_nothing(heights in proptest::collection::vec(-60.0f64..60.0, 16)) {
            let mesh = bumpy(&heights);
            let gradient = field(&mesh).gradient(&mesh.vertices, BOTH);
            let size = dot(&gradient, &gradient).sqrt();
            let all: DVec3 = gradient.iter().copied().sum();
            prop_assert!(all.length() <= 1e-6 * size + 1e-12);
            prop_assert!(dot(&gradient, &mesh.vertices).abs() <= 1e-3 * size + 1e-9);
        }
    }
}
