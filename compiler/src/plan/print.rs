//! The plan as text for people (`ifs build --emit plan`): states with exact matrices, proofs, figures with counts. The
//! same plan gives the same text.

use std::collections::BTreeMap;
use std::fmt;

use crate::exact::Rational;
use crate::ifs::{
    Contraction, Count, Germ, GermShape, Joins, Matrix, Norm, State, StateId, contraction, count,
    difference_norm,
};

use super::figure::{Dimension, FigurePlan, Plan, Shape};

/// Levels whose counts are printed for a state, at most.
const PRINTED_LEVELS: u32 = 16;

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let roots = root_levels(self);
        for (place, state) in self.automaton().states().iter().enumerate() {
            let id = StateId(place as u32);
            write_state(f, id, state)?;
            if let Some(level) = roots.get(&id) {
                write_proofs(f, self, id, *level)?;
            }
            writeln!(f)?;
        }
        self.figures().iter().try_for_each(|figure| write_figure(f, self, figure))
    }
}

/// The states figures stand on, with the highest level at which one does.
fn root_levels(plan: &Plan) -> BTreeMap<StateId, u32> {
    let mut roots = BTreeMap::new();
    let mut add = |state: StateId, level: u32| {
        let highest: &mut u32 = roots.entry(state).or_default();
        *highest = level.max(*highest);
    };
    for figure in plan.figures() {
        match &figure.shape {
            Shape::Curve { state, level, .. } => add(*state, *level),
            Shape::Sheet(sheet) => {
                add(sheet.u, sheet.levels.0);
                add(sheet.v, sheet.levels.1);
            }
            Shape::Patchwork(patchwork) => add(patchwork.state, patchwork.level),
        }
    }
    roots
}

fn write_state(f: &mut fmt::Formatter<'_>, id: StateId, state: &State) -> fmt::Result {
    writeln!(f, "state {} {} on {} points", id.0, state.name, state.control_points)?;
    for transform in &state.transforms {
        let factor = difference_norm(transform);
        writeln!(f, "  {} -> state {}, factor {factor}", transform.name, transform.target.0)?;
        write_matrix(f, &transform.matrix)?;
    }
    write_germ(f, "germ", &state.germ)?;
    for boundary in &state.boundaries {
        writeln!(f, "  boundary {} is state {}", boundary.name, boundary.target.0)?;
        write_matrix(f, &boundary.matrix)?;
    }
    state.keep.iter().try_for_each(|germ| write_germ(f, "keep", germ))
}

fn write_germ(f: &mut fmt::Formatter<'_>, word: &str, germ: &Germ) -> fmt::Result {
    if let Some((start, end)) = germ.ends() {
        return writeln!(f, "  {word} segment from {} to {}", row_text(start), row_text(end));
    }
    match &germ.shape {
        GermShape::Point => writeln!(f, "  {word} point")?,
        GermShape::Segment => writeln!(f, "  {word} segment")?,
        GermShape::Polygon => writeln!(f, "  {word} polygon")?,
        GermShape::Strut { width } => writeln!(f, "  {word} strut of {width} mm")?,
        GermShape::Mesh { faces } => writeln!(f, "  {word} mesh of {} faces", faces.len())?,
    }
    germ.vertices.iter().try_for_each(|row| writeln!(f, "    {}", row_text(row)))
}

/// Entries right-aligned in columns of one width.
fn write_matrix(f: &mut fmt::Formatter<'_>, matrix: &Matrix) -> fmt::Result {
    let texts: Vec<String> = matrix.entries().iter().map(Rational::to_string).collect();
    let width = texts.iter().map(String::len).max().unwrap_or(0);
    for row in texts.chunks_exact(matrix.columns()) {
        let cells: Vec<String> = row.iter().map(|text| format!("{text:>width$}")).collect();
        writeln!(f, "    [{}]", cells.join("  "))?;
    }
    Ok(())
}

fn row_text(row: &[Rational]) -> String {
    let cells: Vec<String> = row.iter().map(Rational::to_string).collect();
    format!("[{}]", cells.join(" "))
}

fn write_proofs(f: &mut fmt::Formatter<'_>, plan: &Plan, id: StateId, level: u32) -> fmt::Result {
    let automaton = plan.automaton();
    let shown = level.min(PRINTED_LEVELS);
    let counts: Vec<String> = (0..=shown)
        .map(|level| match count(automaton, id, level, u64::MAX) {
            Count::Exactly(elements) => elements.to_string(),
            Count::Exceeds => "too many".to_owned(),
        })
        .collect();
    writeln!(f, "  elements at levels 0 to {shown}: {}", counts.join(", "))?;
    match contraction(automaton, id) {
        Contraction::Proved { length, bound, norm } => {
            let norm = match norm {
                Norm::Infinity => "∞-norm",
                Norm::Euclidean => "2-norm",
            };
            writeln!(f, "  contraction proved: words of length {length} are at most {bound} in the {norm}")?;
        }
        Contraction::Refuted { word } => {
            writeln!(
                f,
                "  contraction refuted: {} has a spectral radius of at least 1",
                word.display(automaton)
            )?;
        }
        Contraction::Open { length, bound } => {
            writeln!(f, "  contraction open: words of length {length} reach {bound} in the ∞-norm")?;
        }
    }
    match plan.joins().get(&id) {
        Some(Joins::Joined) => writeln!(f, "  joins proved: the pieces meet at every level"),
        Some(Joins::Open(open)) => writeln!(
            f,
            "  joins open at level {}: {} against {}",
            open.level,
            row_text(&open.left_weights),
            row_text(&open.right_weights)
        ),
        Some(Joins::Unproved { levels }) => writeln!(f, "  joins unproved after {levels} levels"),
        Some(Joins::NotSegments { state }) => {
            writeln!(f, "  no curve: state {} is not drawn as segments", state.0)
        }
        None => Ok(()),
    }
}

fn write_figure(f: &mut fmt::Formatter<'_>, plan: &Plan, figure: &FigurePlan) -> fmt::Result {
    write!(f, "figure {figure}: ")?;
    match &figure.shape {
        Shape::Curve { state, level, dimension, .. } => {
            let dimension = match dimension {
                Dimension::Plane => "in the plane",
                Dimension::Space => "in space",
            };
            write!(f, "curve of state {} {dimension} at level {level}", state.0)?;
        }
        Shape::Sheet(sheet) => {
            let kind = if sheet.windows { "sheet" } else { "tensor product" };
            let (u, v) = sheet.levels;
            write!(f, "{kind} of states {} and {} at level ({u}, {v})", sheet.u.0, sheet.v.0)?;
            write!(f, " on a net of {} by {}", sheet.net_rows, sheet.net_columns)?;
        }
        Shape::Patchwork(patchwork) => {
            let glued = plan.adjacency(patchwork.state).into_iter().flat_map(|found| found.patches.values());
            let glued: usize = glued.map(|patch| patch.glued.len()).sum();
            write!(f, "patchwork of state {} at level {}", patchwork.state.0, patchwork.level)?;
            write!(f, ", {glued} pairs of edges proved to be shared")?;
        }
    }
    match super::budget::figure_count(plan.automaton(), figure, u32::MAX) {
        Some(counts) if matches!(figure.shape, Shape::Patchwork(_)) => {
            writeln!(f, ": {} elements", counts.elements)
        }
        Some(counts) => writeln!(f, ": {} elements, {} vertices", counts.elements, counts.vertices),
        None => writeln!(f, ": more elements than can be counted"),
    }
}
