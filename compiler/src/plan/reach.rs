//! How far from the origin a figure can reach, known before it is evaluated.

use crate::exact::Rational;
use crate::ifs::{Automaton, StateId};

use super::figure::{Shape, SheetPlan};

impl Shape {
    /// A distance along each axis, mm, that no vertex is further from the origin: the largest coordinate of a control point, as
    /// often as the weights of a row come to in size, step by step. Infinity where that says nothing: of rational figures,
    /// sums of curves, and separate pieces, which have their [`extent`](super::extent).
    pub fn reach(&self, automaton: &Automaton) -> f64 {
        match self {
            Shape::Curve { state, points, level, .. } => largest(points) * growth(automaton, *state, *level),
            Shape::Patchwork(of) => largest(&of.points) * growth(automaton, of.state, of.level),
            Shape::Sheet(sheet) => reach_of_sheet(automaton, sheet),
            Shape::Chain(chain) if chain.weights.is_none() => {
                largest(&chain.points) * growth(automaton, chain.state, chain.level)
            }
            Shape::Net(net) if net.weights.is_none() => reach_of_sheet(automaton, &net.sheet),
            Shape::Chain(_) | Shape::Net(_) | Shape::Swept(_) | Shape::Pieces(_) => f64::INFINITY,
        }
    }
}

fn reach_of_sheet(automaton: &Automaton, sheet: &SheetPlan) -> f64 {
    let (u, v) = (growth(automaton, sheet.u, sheet.levels.0), growth(automaton, sheet.v, sheet.levels.1));
    largest(&sheet.net) * u * v
}

fn largest(points: &[[f64; 3]]) -> f64 {
    points.iter().flatten().fold(0.0, |largest, value| largest.max(value.abs()))
}

/// How many times as large as control points vertices can be after so many steps.
fn growth(automaton: &Automaton, state: StateId, level: u32) -> f64 {
    let reached = automaton.reachable(state);
    let states = || reached.iter().map(|id| automaton.state(*id));
    let matrices = states().flat_map(|state| &state.transforms).map(|transform| &transform.matrix);
    let step =
        matrices.flat_map(|matrix| (0..matrix.rows()).map(|row| size(matrix.row(row)))).fold(1.0, f64::max);
    let germ = states().flat_map(|state| &state.germ.vertices).map(|row| size(row)).fold(1.0, f64::max);
    germ * libm::pow(step, f64::from(level))
}

/// What the weights of a row come to without their signs.
fn size(row: &[Rational]) -> f64 {
    row.iter().map(|weight| weight.abs().to_f64()).sum()
}
