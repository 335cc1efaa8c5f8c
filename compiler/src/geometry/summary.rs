//! Figures over all quads of a mesh: worst and mean planarity, sizes, how many quads of each verdict.

use super::mesh::QuadMesh;
use super::planarity::{QuadMeasure, Verdict};

/// A figure and the quad that has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// The figure.
    pub value: f64,
    /// The quad (the lowest index on a tie).
    pub quad: u32,
}

/// What a report says about a mesh. Sums run over the quads in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshSummary {
    /// How many quads there are.
    pub quads: usize,
    /// The lowest planarity, of the quads which have one.
    pub worst: Option<Extreme>,
    /// The mean planarity, of the quads which have one.
    pub mean: Option<f64>,
    /// The largest fold over the diagonal each quad is split along, rad.
    pub largest_fold: Option<Extreme>,
    /// The mean of these folds, rad.
    pub mean_fold: Option<f64>,
    /// The largest diagonal ratio.
    pub largest_diagonal_ratio: Option<Extreme>,
    /// The shortest side of any quad, mm.
    pub shortest_edge: Option<Extreme>,
    /// The longest side of any quad, mm.
    pub longest_edge: Option<Extreme>,
    /// Area of all quads, mm².
    pub area: f64,
    /// Quads with [`Verdict::Convex`].
    pub convex: usize,
    /// Quads with [`Verdict::Dart`].
    pub darts: usize,
    /// Quads with [`Verdict::CollinearCorner`].
    pub collinear: usize,
    /// Quads with [`Verdict::FoldedOver`].
    pub folded_over: usize,
    /// Quads with [`Verdict::Degenerate`].
    pub degenerate: usize,
}

impl MeshSummary {
    /// Measures every quad of `mesh` and sums up.
    #[must_use]
    pub fn of(mesh: &QuadMesh) -> Self {
        Self::of_measures((0..mesh.quads.len()).map(|quad| QuadMeasure::of(mesh.corners_of(quad))))
    }

    /// Sums up measures that were taken already, in the order of the quads.
    pub fn of_measures(measures: impl IntoIterator<Item = QuadMeasure>) -> Self {
        let mut summary = Self::default();
        let (mut planarities, mut folds) = (Mean::default(), Mean::default());
        for (quad, measure) in (0u32..).zip(measures) {
            summary.quads += 1;
            summary.area += measure.area;
            summary.count(measure.verdict);
            planarities.add(measure.planarity);
            folds.add(measure.fold());
            keep_least(&mut summary.worst, measure.planarity, quad);
            keep_most(&mut summary.largest_fold, measure.fold(), quad);
            keep_most(&mut summary.largest_diagonal_ratio, measure.diagonal_ratio, quad);
            for length in measure.edges {
                keep_least(&mut summary.shortest_edge, Some(length), quad);
                keep_most(&mut summary.longest_edge, Some(length), quad);
            }
        }
        summary.mean = planarities.value();
        summary.mean_fold = folds.value();
        summary
    }

    /// Quads which are no convex quad: darts, collinear corners, folded over, degenerate.
    #[must_use]
    pub fn not_convex(&self) -> usize {
        self.darts + self.collinear + self.folded_over + self.degenerate
    }

    fn count(&mut self, verdict: Verdict) {
        let counter = match verdict {
            Verdict::Convex => &mut self.convex,
            Verdict::Dart => &mut self.darts,
            Verdict::CollinearCorner => &mut self.collinear,
            Verdict::FoldedOver => &mut self.folded_over,
            Verdict::Degenerate => &mut self.degenerate,
        };
        *counter += 1;
    }
}

#[derive(Default)]
struct Mean {
    sum: f64,
    count: usize,
}

impl Mean {
    fn add(&mut self, value: Option<f64>) {
        if let Some(value) = value {
            self.sum += value;
            self.count += 1;
        }
    }

    fn value(&self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }
}

fn keep_least(kept: &mut Option<Extreme>, value: Option<f64>, quad: u32) {
    if let Some(value) = value
        && kept.is_none_or(|kept| value < kept.value)
    {
        *kept = Some(Extreme { value, quad });
    }
}

fn keep_most(kept: &mut Option<Extreme>, value: Option<f64>, quad: u32) {
    if let Some(value) = value
        && kept.is_none_or(|kept| value > kept.value)
    {
        *kept = Some(Extreme { value, quad });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::samples;

    #[test]
    fn one_raised_vertex_is_found() {
        let mut mesh = samples::flat_grid(4, 4, 100.0);
        mesh.vertices[0].z = 30.0;
        let summary = MeshSummary::of(&mesh);
        let worst = summary.worst.unwrap();
        assert_eq!(worst.quad, 0);
        assert_eq!(summary.largest_fold.unwrap().quad, 0);
        assert!((summary.mean.unwrap() - (8.0 + worst.value) / 9.0).abs() < 1e-12);
        assert_eq!((summary.quads, summary.convex, summary.not_convex()), (9, 9, 0));
        assert_eq!(summary.shortest_edge.unwrap().value, 100.0);
        assert!((summary.longest_edge.unwrap().value - libm::sqrt(10_900.0)).abs() < 1e-9);
    }

    #[test]
    fn no_quads_no_figures() {
        let summary = MeshSummary::of(&QuadMesh { vertices: Vec::new(), quads: Vec::new() });
        assert_eq!(summary, MeshSummary::default());
    }

    #[test]
    fn every_verdict_is_counted() {
        let mut mesh = samples::flat_grid(2, 2, 100.0);
        mesh.vertices[3] = glam::DVec3::new(20.0, 20.0, 0.0);
        let summary = MeshSummary::of(&mesh);
        assert_eq!((summary.darts, summary.worst, summary.mean), (1, None, None));
        mesh.vertices[3] = mesh.vertices[2];
        assert_eq!(MeshSummary::of(&mesh).degenerate, 1);
    }
}
