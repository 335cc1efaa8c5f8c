//! What a figure within its budget must be beyond joins: no vertex at infinity, three elements round where it is closed,
//! scales that stay above 0, a profile that can be turned round its axis.

use super::{FigureCount, FigureSource, Lowering};
use crate::diagnostic::{Code, Diagnostic};
use crate::ifs::Automaton;
use crate::plan::address::FigureAddresses;
use crate::plan::evaluate::{profile_points, rail_scales, vertex_at_infinity};
use crate::plan::figure::{FigurePlan, Plan, Shape};
use crate::plan::swept::{Path, SweptPlan, Turn};
use crate::source::Span;
use glam::DVec3;

/// How far, in parts of its size, a profile may lie off a plane through its axis, or off the axis to be on it: rounding.
const ROUNDING: f64 = 1e-9;

impl Lowering<'_, '_> {
    /// Whether every figure can be made; else the reasons are reported.
    pub(super) fn sound(&mut self, plan: &Plan, sources: &[FigureSource], counts: &[FigureCount]) -> bool {
        let mut good = true;
        for ((figure, source), count) in plan.figures().iter().zip(sources).zip(counts) {
            let at = self.hir.item(source.item).name_span;
            if let Some(diagnostic) = unsound(plan.automaton(), figure, count, at) {
                good = false;
                self.diagnostics.push(diagnostic);
            }
        }
        good
    }
}

fn unsound(automaton: &Automaton, figure: &FigurePlan, count: &FigureCount, at: Span) -> Option<Diagnostic> {
    let closed = figure.shape.closed();
    for (closed, elements) in [(closed.0, count.grid.0), (closed.1, count.grid.1)] {
        if closed && elements < 3 {
            let message = format!("`{figure}` closes round in {elements} elements, and needs at least 3");
            let diagnostic = Diagnostic::new(Code::E0524, at, message).label("too few to go round");
            return Some(diagnostic.hint("choose a higher level, or add control points"));
        }
    }
    if let Some((vertex, weight)) = vertex_at_infinity(automaton, &figure.shape) {
        let message = format!("vertex {vertex} of `{figure}` lies at infinity: its weight is {weight:.4}");
        let diagnostic = Diagnostic::new(Code::E0523, at, message).label("not above 0 everywhere");
        let hint = "bring the weights of neighbouring control points closer together, or use an ifs whose weights are not negative";
        return Some(diagnostic.hint(hint));
    }
    let Shape::Swept(swept) = &figure.shape else { return None };
    scale_below(automaton, swept, figure, at).or_else(|| match &swept.path {
        Path::Turn(turn) => off_the_meridian(automaton, swept, turn, figure, at),
        _ => None,
    })
}

fn scale_below(
    automaton: &Automaton,
    swept: &SweptPlan,
    figure: &FigurePlan,
    at: Span,
) -> Option<Diagnostic> {
    let scales = rail_scales(automaton, swept)?;
    let (vertex, scale) = scales.iter().enumerate().find(|(_, scale)| **scale <= 0.0 || scale.is_nan())?;
    let message = format!("at vertex {vertex} of its rail the scale of `{figure}` is {scale:.4}");
    let diagnostic = Diagnostic::new(Code::E0521, at, message).label("a scale is above 0");
    Some(diagnostic.hint("bring the scales of neighbouring control points closer together"))
}

/// Why a profile cannot be turned: a point on the axis makes triangles of quads, and one beside the plane through the
/// axis and the others makes quads that are not planar.
fn off_the_meridian(
    automaton: &Automaton,
    swept: &SweptPlan,
    turn: &Turn,
    figure: &FigurePlan,
    at: Span,
) -> Option<Diagnostic> {
    let (origin, axis) = (DVec3::from(turn.point), DVec3::from(turn.direction));
    let points: Vec<DVec3> = profile_points(automaton, swept).into_iter().map(DVec3::from).collect();
    let arm = |point: &DVec3| (*point - origin) - axis * (*point - origin).dot(axis);
    let arms: Vec<DVec3> = points.iter().map(arm).collect();
    let farthest = arms
        .iter()
        .copied()
        .fold(DVec3::ZERO, |far, arm| if arm.length() > far.length() { arm } else { far });
    let size = points.iter().map(|point| (*point - origin).length()).fold(0.0, f64::max);
    let tolerance = size * ROUNDING;
    if let Some(place) = arms.iter().position(|arm| arm.length() <= tolerance) {
        return Some(on_the_axis(automaton, figure, place, points.len(), at));
    }
    let normal = axis.cross(farthest).normalize_or_zero();
    let off = |arm: &DVec3| arm.dot(normal).abs();
    let (place, deviation) = arms
        .iter()
        .map(off)
        .enumerate()
        .fold((0, 0.0), |worst, (place, off)| if off > worst.1 { (place, off) } else { worst });
    if deviation <= tolerance {
        return across_the_axis(figure, &arms, at);
    }
    let message = format!(
        "the profile of `{figure}` does not lie in a plane with its axis: vertex {place} is {deviation:.3} mm beside it"
    );
    let diagnostic = Diagnostic::new(Code::E0522, at, message).label("its quads would not be planar");
    Some(diagnostic.hint("move the control points of the profile into one plane through the axis"))
}

fn across_the_axis(figure: &FigurePlan, arms: &[DVec3], at: Span) -> Option<Diagnostic> {
    let place = arms.windows(2).position(|pair| pair[0].dot(pair[1]) < 0.0)?;
    let message =
        format!("the profile of `{figure}` crosses its axis between the vertices {place} and {}", place + 1);
    let diagnostic = Diagnostic::new(Code::E0522, at, message).label("its quads would cross themselves");
    Some(
        diagnostic
            .hint("move the axis or the control points of the profile, so that all of it lies on one side"),
    )
}

fn on_the_axis(
    automaton: &Automaton,
    figure: &FigurePlan,
    vertex: usize,
    vertices: usize,
    at: Span,
) -> Diagnostic {
    // The quad that begins at the vertex, or ends there at the end of the profile.
    let column = vertex.min(vertices.saturating_sub(2)) as u64;
    let quad = FigureAddresses::new(automaton, figure).quad(0, column);
    let quad =
        quad.map_or(String::new(), |address| format!(": {} ({address}) would be a triangle", address.alias));
    let message = format!("vertex {vertex} of the profile of `{figure}` lies on the axis{quad}");
    let diagnostic = Diagnostic::new(Code::E0522, at, message).label("turns on the spot");
    diagnostic.hint("begin and end the profile a little away from the axis, and leave an opening there")
}
