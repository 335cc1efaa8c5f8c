//! The plan as text for people (`ifs build --emit plan`): states with exact matrices, proofs, figures with counts. The
//! same plan gives the same text.

use std::collections::BTreeMap;
use std::fmt;

use crate::exact::Rational;
use crate::ifs::{
    Contraction, Count, Germ, GermShape, Joins, Matrix, Norm, State, StateId, contraction, count,
    difference_norm,
};

use super::chain::ChainPlan;
use super::figure::{Depth, Dimension, Each, FigurePlan, PiecesPlan, Plan, Shape, SheetPlan};
use super::swept::Path;

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
    for used in plan.figures().iter().flat_map(|figure| figure.shape.uses()) {
        let highest: &mut u32 = roots.entry(used.state).or_default();
        *highest = used.level.max(*highest);
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
        Some(Joins::Rounded(widest)) => {
            writeln!(f, "  joins hold to within rounding: weights differ by at most {:.3e}", widest.gap())
        }
        Some(Joins::Open(open)) => {
            let transforms = &automaton.state(open.state).transforms;
            let (left, right) = (&transforms[open.left].name, &transforms[open.right].name);
            let (end, start) = (row_text(&open.left_weights), row_text(&open.right_weights));
            write!(f, "  joins open at level {}: in state {} ", open.level, open.state.0)?;
            writeln!(f, "{left} ends at {end}, {right} starts at {start}")
        }
        Some(Joins::Unproved { levels }) => writeln!(f, "  joins unproved after {levels} levels"),
        Some(Joins::NotSegments { state }) => {
            writeln!(f, "  no curve: state {} is not drawn as segments", state.0)
        }
        None => Ok(()),
    }
}

fn write_figure(f: &mut fmt::Formatter<'_>, plan: &Plan, figure: &FigurePlan) -> fmt::Result {
    write!(f, "figure {figure}: ")?;
    write_shape(f, plan, &figure.shape)?;
    match super::budget::figure_count(plan.automaton(), figure, u32::MAX) {
        Some(counts) if matches!(figure.shape, Shape::Patchwork(_)) => {
            writeln!(f, ": {} elements", counts.elements)
        }
        Some(counts) => writeln!(f, ": {} elements, {} vertices", counts.elements, counts.vertices),
        None => writeln!(f, ": more elements than can be counted"),
    }
}

fn write_pieces(f: &mut fmt::Formatter<'_>, pieces: &PiecesPlan) -> fmt::Result {
    write!(f, "separate pieces of state {} {}", pieces.state.0, space_words(pieces.dimension))?;
    match pieces.depth {
        Depth::Level(level) => write!(f, " at level {level}"),
        Depth::Each(Each { bound, deepest, .. }) => {
            let sign = if bound.strict { "<" } else { "<=" };
            let (measure, most) = (bound.measure.word(), bound.most);
            write!(f, ", each until {measure} {sign} {most} mm, words of up to {deepest} letters")
        }
    }
}

fn write_shape(f: &mut fmt::Formatter<'_>, plan: &Plan, shape: &Shape) -> fmt::Result {
    match shape {
        Shape::Curve { state, level, dimension, .. } => {
            write!(f, "curve of state {} {} at level {level}", state.0, space_words(*dimension))
        }
        Shape::Sheet(sheet) => write_sheet(f, sheet),
        Shape::Chain(chain) => {
            let weighted = if chain.weights.is_some() { "rational " } else { "" };
            write!(f, "{weighted}curve ")?;
            write_chain(f, chain)
        }
        Shape::Net(net) => {
            if net.weights.is_some() {
                f.write_str("rational ")?;
            }
            write_sheet(f, &net.sheet)?;
            match net.closed {
                (true, true) => f.write_str(", closed along u and v"),
                (true, false) => f.write_str(", closed along u"),
                (false, true) => f.write_str(", closed along v"),
                (false, false) => Ok(()),
            }
        }
        Shape::Pieces(pieces) => write_pieces(f, pieces),
        Shape::Patchwork(patchwork) => {
            let glued = plan.adjacency(patchwork.state).into_iter().flat_map(|found| found.patches.values());
            let glued: usize = glued.map(|patch| patch.glued.len()).sum();
            write!(f, "patchwork of state {} at level {}", patchwork.state.0, patchwork.level)?;
            write!(f, ", {glued} pairs of edges proved to be shared")
        }
        Shape::Swept(swept) => {
            write!(f, "{}, planar by construction, of the profile ", swept.name())?;
            write_chain(f, &swept.profile)?;
            match &swept.path {
                Path::Rail(rail, _) => {
                    f.write_str(" and the rail ")?;
                    write_chain(f, rail)
                }
                Path::Turn(turn) => write!(f, " in {} segments", turn.segments),
                Path::Straight { pieces, .. } => write!(f, " in {pieces} pieces"),
            }
        }
    }
}

fn write_sheet(f: &mut fmt::Formatter<'_>, sheet: &SheetPlan) -> fmt::Result {
    let kind = if sheet.windows { "sheet" } else { "tensor product" };
    let (u, v) = sheet.levels;
    write!(f, "{kind} of states {} and {} at level ({u}, {v})", sheet.u.0, sheet.v.0)?;
    write!(f, " on a net of {} by {}", sheet.net_rows, sheet.net_columns)
}

fn write_chain(f: &mut fmt::Formatter<'_>, chain: &ChainPlan) -> fmt::Result {
    let (state, level) = (chain.state.0, chain.level);
    write!(
        f,
        "of state {state} {} at level {level} on {} points",
        space_words(chain.dimension),
        chain.points.len()
    )?;
    f.write_str(if chain.closed { ", closed" } else { "" })
}

fn space_words(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Plane => "in the plane",
        Dimension::Space => "in space",
    }
}
