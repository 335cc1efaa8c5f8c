//! `report.json`: what a build made of a design, for programs. Lengths mm, angles degrees, areas m², masses kg; no
//! time, no path outside the output folder, no user.

mod distribution;
mod machine;
mod nest;
mod requirement;

use serde::Serialize;

use super::number::Fixed;
use super::part::Part;
use crate::fabricate::panel::{Corner, RELIEF_TOLERANCE};
use crate::geometry::summary::Extreme;
use crate::geometry::{MeshSummary, QuadMesh};

pub use distribution::{BINS, Distribution};
pub use machine::{ClampReport, EngravingReport, FixingReport, MachineReport, ToolReport};
pub use nest::{BarReport, BarsReport, SheetReport, SheetsReport, UnplacedReport};
pub use requirement::{LimitReport, Quantity, Requirement, WorstReport};

/// The version of the schema. It rises when a field goes or changes its meaning.
pub const SCHEMA_VERSION: u32 = 1;

/// The whole report.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Report {
    /// [`SCHEMA_VERSION`].
    pub schema_version: u32,
    /// The version of the compiler.
    pub compiler: String,
    /// The name of the design.
    pub design: String,
    /// What the design says about itself: its first paragraph, empty where there is none.
    pub summary: String,
    /// The hash of its sources and parameters, as in the headers of programs.
    pub design_hash: String,
    /// The texts it is made of, its own first.
    pub sources: Vec<SourceReport>,
    /// Its parameters, in the order of the sources.
    pub parameters: Vec<Parameter>,
    /// The machine that was named from outside, `machines.ifs:router`; none where the design's own are used.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub machine: Option<String>,
    /// Its figures, in the order of the sources.
    pub figures: Vec<FigureReport>,
    /// What was made of them.
    pub fabrications: Vec<Fabrication>,
    /// The sheets that boards are nested on.
    pub sheets: Vec<SheetsReport>,
    /// The bars that planks are cut out of.
    pub bars: Vec<BarsReport>,
}

impl Report {
    /// How many raw boards and bars all parts lie on; none where they are not nested, or some do not fit.
    #[must_use]
    pub fn nested_pieces(&self) -> Option<usize> {
        let sheets = self.sheets.iter().map(|nest| (nest.sheets.len(), nest.unplaced.len()));
        let bars = self.bars.iter().map(|nest| (nest.bars.len(), nest.unplaced.len()));
        let sum = sheets.chain(bars).fold((0, 0), |sum, nest| (sum.0 + nest.0, sum.1 + nest.1));
        (sum.0 > 0 && sum.1 == 0).then_some(sum.0)
    }

    /// A report of `design` without parameters, figures or fabrications yet.
    #[must_use]
    pub fn new(design: &str) -> Self {
        Self {
            schema_version: SCHEMA_VERSION,
            compiler: env!("CARGO_PKG_VERSION").to_owned(),
            design: design.to_owned(),
            summary: String::new(),
            design_hash: String::new(),
            sources: Vec::new(),
            parameters: Vec::new(),
            machine: None,
            figures: Vec::new(),
            fabrications: Vec::new(),
            sheets: Vec::new(),
            bars: Vec::new(),
        }
    }

    /// The bytes of `report.json`, indented, ended by a line feed.
    ///
    /// # Errors
    /// None that a report can cause: the error type is serde's.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }
}

/// A text that a design is made of.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SourceReport {
    /// Its path in the project.
    pub path: String,
    /// The SHA-256 of its bytes, in hexadecimal digits.
    pub sha256: String,
}

/// A parameter of the design.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Its value as the language writes it (`6m`).
    pub value: String,
    /// Whether it was set from outside.
    pub set: bool,
}

/// A figure of the design.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FigureReport {
    /// Its name.
    pub name: String,
    /// `curve`, `surface` or `figure`.
    pub kind: String,
    /// The levels, as the language writes them.
    pub level: String,
    /// How many elements it has: segments, quads or germs.
    pub elements: u64,
    /// Whether its quads are planar whatever its control points are.
    pub planar_by_construction: bool,
    /// How large it is, where it is of separate pieces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extent: Option<ExtentReport>,
}

/// How large a figure is, mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExtentReport {
    /// The least x, y and z.
    pub low_mm: [Fixed; 3],
    /// The greatest x, y and z.
    pub high_mm: [Fixed; 3],
    /// The diameter of the smallest element; none where all are points.
    pub smallest_mm: Option<Fixed>,
    /// The diameter of the largest element.
    pub largest_mm: Option<Fixed>,
}

/// What a `fabricate` block made.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fabrication {
    /// The figure.
    pub figure: String,
    /// `panels` or `planks`.
    pub kind: &'static str,
    /// What the geometry was scaled by before anything was made of it: 1 for the building, 0.05 for a model of a
    /// twentieth. All lengths below are those of what is made.
    pub scale: Fixed,
    /// The material.
    pub material: MaterialReport,
    /// What cuts it; none where no machine is named.
    pub machine: Option<MachineReport>,
    /// How many elements there were, and what became of them.
    pub counts: Counts,
    /// For panels.
    pub planarity: Option<PlanarityReport>,
    /// For panels: the corners where boards have to be cut back.
    pub relief: Option<ReliefReport>,
    /// What the block requires, in the order it is written.
    pub requirements: Vec<Requirement>,
    /// Boards and planks, then refused ones.
    pub parts: Vec<Part>,
}

impl Fabrication {
    /// Whether every requirement holds and nothing was refused.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.counts.refused == 0 && self.requirements.iter().all(|requirement| requirement.holds)
    }
}

/// The corners of boards that reach past their neighbours, where four or more meet and the edges are bevelled.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReliefReport {
    /// Corners that reach no further than this need no relief.
    pub tolerance_mm: Fixed,
    /// How many corners need it.
    pub corners: usize,
    /// The worst of them, the worst first.
    pub worst: Vec<CornerReport>,
}

/// A corner where boards meet.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CornerReport {
    /// The addresses of the boards.
    pub boards: Vec<String>,
    /// The most that one of them has to be cut back.
    pub relief_mm: Fixed,
}

/// How many corners a [`ReliefReport`] names.
const NAMED_CORNERS: usize = 20;

impl ReliefReport {
    /// Of all corners that need relief.
    #[must_use]
    pub fn of(corners: &[Corner]) -> Self {
        let mut worst: Vec<&Corner> = corners.iter().collect();
        // Equal ones stay in the order of the vertices.
        worst.sort_by(|a, b| b.relief.total_cmp(&a.relief));
        let named = worst.into_iter().take(NAMED_CORNERS);
        Self {
            tolerance_mm: Fixed::mm(RELIEF_TOLERANCE),
            corners: corners.len(),
            worst: named
                .map(|corner| CornerReport {
                    boards: corner.boards.clone(),
                    relief_mm: Fixed::mm(corner.relief),
                })
                .collect(),
        }
    }
}

/// The material of a fabrication.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MaterialReport {
    /// Its name.
    pub name: String,
    /// None for what has no thickness of its own.
    pub thickness_mm: Option<Fixed>,
    /// All parts together; none where the density is unknown.
    pub mass_kg: Option<Fixed>,
    /// Of all parts together: outlines of boards, faces of planks in the plane of their curve.
    pub area_m2: Fixed,
    /// All planks end to end on their axes; none for boards.
    pub length_mm: Option<Fixed>,
    /// The raw board, length and width; none for planks.
    pub board_mm: Option<[Fixed; 2]>,
    /// The length of a raw bar; none for boards.
    pub bar_mm: Option<Fixed>,
    /// The raw boards or bars that hold as much as all parts: no fewer can do, and cuts and offcuts take more.
    pub raw_at_least: u64,
}

/// How many elements there were.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Quads or segments.
    pub elements: usize,
    /// Boards or planks made.
    pub made: usize,
    /// Those no board or plank can be made for.
    pub refused: usize,
}

/// The planarity of a surface before and after planarizing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanarityReport {
    /// As designed.
    pub before: SurfaceSummary,
    /// As fabricated: the same as before where nothing was planarized.
    pub after: SurfaceSummary,
    /// The folds of the quads, the larger over the two diagonals of each, degrees: the angle whose cosine is the
    /// planarity. As designed and as fabricated, in the same bins.
    pub folds_deg: Option<[Distribution; 2]>,
    /// How planarizing went; none where it was not asked for.
    pub planarize: Option<PlanarizeReport>,
    /// How far vertices moved.
    pub moved: MovedReport,
}

/// The figures of a surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SurfaceSummary {
    /// The lowest planarity.
    pub worst_planarity: Option<At>,
    /// The mean planarity.
    pub mean_planarity: Option<Fixed>,
    /// The largest fold over the diagonal a quad is split along, degrees.
    pub largest_fold_deg: Option<At>,
    /// The mean of these folds, degrees.
    pub mean_fold_deg: Option<Fixed>,
    /// The largest diagonal ratio.
    pub largest_diagonal_ratio: Option<At>,
    /// The shortest side, mm.
    pub shortest_edge_mm: Option<At>,
    /// The longest side, mm.
    pub longest_edge_mm: Option<At>,
    /// The area, m².
    pub area_m2: Fixed,
    /// How many quads are convex.
    pub convex: usize,
    /// How many are darts.
    pub darts: usize,
    /// How many have three corners on a line.
    pub collinear: usize,
    /// How many are folded over.
    pub folded_over: usize,
    /// How many have no area.
    pub degenerate: usize,
}

/// A figure and the element that has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct At {
    /// The figure.
    pub value: Fixed,
    /// The address of the element.
    pub address: String,
}

impl SurfaceSummary {
    /// The summary with addresses for quads: `address` gives that of a quad by its index.
    #[must_use]
    pub fn of(summary: &MeshSummary, address: impl Fn(u32) -> String) -> Self {
        let at = |extreme: Option<Extreme>, number: fn(f64) -> Fixed| {
            extreme.map(|extreme| At { value: number(extreme.value), address: address(extreme.quad) })
        };
        Self {
            worst_planarity: at(summary.worst, Fixed::planarity),
            mean_planarity: summary.mean.map(Fixed::planarity),
            largest_fold_deg: at(summary.largest_fold, Fixed::degrees),
            mean_fold_deg: summary.mean_fold.map(Fixed::degrees),
            largest_diagonal_ratio: at(summary.largest_diagonal_ratio, Fixed::ratio),
            shortest_edge_mm: at(summary.shortest_edge, Fixed::mm),
            longest_edge_mm: at(summary.longest_edge, Fixed::mm),
            area_m2: Fixed::square_metres(summary.area),
            convex: summary.convex,
            darts: summary.darts,
            collinear: summary.collinear,
            folded_over: summary.folded_over,
            degenerate: summary.degenerate,
        }
    }
}

/// How planarizing went.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanarizeReport {
    /// The method's name: `perturbation` or `projection`.
    pub method: &'static str,
    /// Its parameters as they were used, by the names the language has for them.
    pub options: Vec<OptionReport>,
    /// Why it ended.
    pub stop: String,
    /// How many iterations it made.
    pub iterations: u32,
    /// The one whose surface was taken.
    pub best_iteration: u32,
    /// How many quads it inverted: 0.
    pub inverted: usize,
    /// The start and the figures after each iteration.
    pub history: Vec<HistoryPoint>,
}

/// A parameter of planarizing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OptionReport {
    /// Its name.
    pub name: &'static str,
    /// Its value as the language writes it.
    pub value: String,
}

/// One point of the convergence plot.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HistoryPoint {
    /// The lowest planarity.
    pub worst: Option<Fixed>,
    /// The mean planarity.
    pub mean: Option<Fixed>,
}

/// How far vertices moved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MovedReport {
    /// The farthest, mm.
    pub max_mm: Fixed,
    /// The mean over all vertices, mm.
    pub mean_mm: Fixed,
    /// How many moved at all.
    pub count: usize,
    /// The distances of those that moved, in bins from 0.
    pub distances_mm: Option<Distribution>,
}

impl MovedReport {
    /// Between vertices of the same index.
    #[must_use]
    pub fn between(before: &QuadMesh, after: &QuadMesh) -> Self {
        let distances = || before.vertices.iter().zip(&after.vertices).map(|(from, to)| from.distance(*to));
        let sum: f64 = distances().sum();
        Self {
            max_mm: Fixed::mm(distances().fold(0.0, f64::max)),
            mean_mm: Fixed::mm(sum / before.vertices.len().max(1) as f64),
            count: distances().filter(|&distance| distance > 0.0).count(),
            distances_mm: Distribution::over(
                distances().filter(|&distance| distance > 0.0).collect(),
                (0.0, distances().fold(0.0, f64::max)),
                Fixed::mm,
            ),
        }
    }
}

#[cfg(test)]
pub(super) mod tests;
