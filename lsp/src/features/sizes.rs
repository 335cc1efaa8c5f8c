//! How large the figures of one name are as they are designed: their box, the edges and planarity of surfaces, the segments
//! of curves. In words.

use ifs_compiler::analysis::{FigureGeometry, figure_geometry, value_words};
use ifs_compiler::geometry::{MeshSummary, QuadMeasure, QuadMesh};
use ifs_compiler::hir::dimension::Dimension;
use ifs_compiler::hir::evaluate::quantity_words_to;
use ifs_compiler::hir::schema::Measure;
use ifs_compiler::plan::FigurePlan;
use ifs_compiler::plan::extent::Extent;
use ifs_compiler::plan::lower::Lowered;
use ifs_compiler::plan::size::SizeRange;

/// The most elements that are worked out for a look at their size.
const MOST_ELEMENTS: u64 = 100_000;

/// What is measured of some figures.
#[derive(Default)]
struct Sizes {
    /// The least and the greatest coordinates, mm.
    box_of: Option<[[f64; 3]; 2]>,
    quads: Vec<QuadMeasure>,
    segments: Option<SizeRange>,
    /// The length of all segments, mm.
    length: f64,
    pieces: Option<SizeRange>,
}

/// The sizes of the figures of this name; `None` where there are none, or too many elements for a look.
pub(super) fn of_figures(lowered: &Lowered, name: &str) -> Option<String> {
    let all = lowered.plan.figures().iter().zip(&lowered.counts).zip(&lowered.extents);
    let own: Vec<_> = all.filter(|((figure, _), _)| figure.name == name).collect();
    let elements: u64 = own.iter().map(|((_, count), _)| count.elements).sum();
    if elements > MOST_ELEMENTS {
        return None;
    }
    let mut sizes = Sizes::default();
    for ((figure, _), extent) in own {
        match extent {
            Some(extent) => sizes.add_pieces(extent),
            None => sizes.add(lowered, figure)?,
        }
    }
    sizes.words()
}

impl Sizes {
    fn reach(&mut self, point: [f64; 3]) {
        let [low, high] = self.box_of.unwrap_or([point; 2]);
        let axes = |of: fn(f64, f64) -> f64, one: [f64; 3]| [0, 1, 2].map(|axis| of(one[axis], point[axis]));
        self.box_of = Some([axes(f64::min, low), axes(f64::max, high)]);
    }

    fn add_pieces(&mut self, extent: &Extent) {
        self.reach(extent.low);
        self.reach(extent.high);
        self.pieces = [self.pieces, extent.sizes].into_iter().flatten().reduce(SizeRange::with);
    }

    fn add(&mut self, lowered: &Lowered, figure: &FigurePlan) -> Option<()> {
        match figure_geometry(&lowered.plan, figure)? {
            FigureGeometry::Surface(mesh) => {
                mesh.vertices.iter().for_each(|point| self.reach(point.to_array()));
                self.quads.extend(measures(&mesh));
            }
            FigureGeometry::Curve(points) => {
                points.iter().for_each(|point| self.reach(point.to_array()));
                for pair in points.windows(2) {
                    let length = pair[0].distance(pair[1]);
                    self.length += length;
                    let one = Some(SizeRange::one(length));
                    self.segments = [self.segments, one].into_iter().flatten().reduce(SizeRange::with);
                }
            }
            // Their extent is known without.
            FigureGeometry::Pieces(_) => {}
        }
        Some(())
    }

    fn words(&self) -> Option<String> {
        let [low, high] = self.box_of?;
        let [x, y, z] = [0, 1, 2].map(|axis| length(high[axis] - low[axis]));
        let mut text = format!("{x} by {y} by {z}");
        if !self.quads.is_empty() {
            text += &of_surface(&MeshSummary::of_measures(self.quads.iter().cloned()));
        }
        if let Some(SizeRange { least, most }) = self.segments {
            text += &format!(", segments {}, {} in all", range(least, most), length(self.length));
        }
        if let Some(SizeRange { least, most }) = self.pieces {
            text += &format!(", elements {}", range(least, most));
        }
        Some(text)
    }
}

fn measures(mesh: &QuadMesh) -> impl Iterator<Item = QuadMeasure> {
    (0..mesh.quads.len()).map(|quad| QuadMeasure::of(mesh.corners_of(quad)))
}

/// Planarity and edges of surfaces, as words that go on.
fn of_surface(summary: &MeshSummary) -> String {
    let mut text = String::new();
    if let (Some(worst), Some(mean)) = (summary.worst, summary.mean) {
        let words = |value| value_words(Measure::Planarity, value);
        text += &format!(", planarity {} at worst and {} in the mean", words(worst.value), words(mean));
    }
    if let (Some(shortest), Some(longest)) = (summary.shortest_edge, summary.longest_edge) {
        text += &format!(", edges {}", range(shortest.value, longest.value));
    }
    text
}

/// The quads of several meshes as one.
pub(super) fn of_surfaces<'a>(meshes: impl Iterator<Item = &'a QuadMesh>) -> String {
    of_surface(&MeshSummary::of_measures(meshes.flat_map(measures)))
}

/// From one length to another, mm.
pub(super) fn range(least: f64, most: f64) -> String {
    let (least, most) = (length(least), length(most));
    if least == most { least } else { format!("{least} .. {most}") }
}

fn length(value: f64) -> String {
    quantity_words_to(value, Dimension::LENGTH, 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::features::fixture::fixture;

    fn sizes(text: &str, name: &str) -> Option<String> {
        of_figures(fixture(text).made().plan.as_ref().unwrap(), name)
    }

    #[test]
    fn of_a_surface_without_boards() {
        let text = "use std.curves (line)\nuse std.surfaces (tensor)\nfigure roof = tensor(line, line) on [[(0m, 0m, 0m), (0m, 3m, 0m)], [(4m, 0m, 0m), (4m, 3m, 0m)]] at level 0\n";
        let said = "4000mm by 3000mm by 0mm, planarity 1 at worst and 1 in the mean, edges 3000mm .. 4000mm";
        assert_eq!(sizes(text, "roof").as_deref(), Some(said));
        assert_eq!(sizes(text, "other"), None);
        assert_eq!(sizes(&text.replace("level 0", "level 9"), "roof"), None, "262144 quads");
    }

    #[test]
    fn of_pieces() {
        let text = "ifs square in plane {\n    transform only = scale(1/2) * self\n    germ polygon((0m, 0m), (1m, 0m), (1m, 2m))\n}\nfigure one = square at level 1\n";
        assert_eq!(sizes(text, "one").as_deref(), Some("500mm by 1000mm by 0mm, elements 1118mm"));
    }
}
