//! Grids of nets that are closed round or have weights, by the evaluator of plain sheets: a closed net is continued by
//! its own first rows, a rational one is evaluated in homogeneous coordinates and divided once.

use crate::ifs::Automaton;

use super::super::chain::homogeneous;
use super::super::figure::SheetPlan;
use super::super::net::NetPlan;
use super::sheet::SheetEvaluator;

/// A grid of vertices, row after row; in a closed direction the first ones are not repeated at the end.
#[derive(Clone, Debug, PartialEq)]
pub struct PointGrid {
    /// Vertices along u.
    pub rows: usize,
    /// Vertices along v.
    pub columns: usize,
    /// In millimetres.
    pub points: Vec<[f64; 3]>,
}

/// The vertices of a net.
pub fn net_points(automaton: &Automaton, net: &NetPlan) -> PointGrid {
    let Some(weights) = &net.weights else { return evaluated(automaton, net, net.sheet.net.clone()) };
    let rows = homogeneous(&net.sheet.net, weights);
    let mut grid = evaluated(automaton, net, rows.iter().map(|[x, y, z, _]| [*x, *y, *z]).collect());
    for (point, weight) in grid.points.iter_mut().zip(net_weights(automaton, net, weights)) {
        for coordinate in point {
            *coordinate /= weight;
        }
    }
    grid
}

/// The weights of the vertices of a rational net.
pub(super) fn net_weights(automaton: &Automaton, net: &NetPlan, weights: &[f64]) -> Vec<f64> {
    let grid = evaluated(automaton, net, weights.iter().map(|weight| [*weight, 0.0, 0.0]).collect());
    grid.points.into_iter().map(|[weight, _, _]| weight).collect()
}

/// The grid of the net with these entries for its points.
fn evaluated(automaton: &Automaton, net: &NetPlan, entries: Vec<[f64; 3]>) -> PointGrid {
    let plan = continued(automaton, net, entries);
    let evaluator = SheetEvaluator::new(automaton, &plan);
    let mut points = Vec::new();
    evaluator.fill(&mut points);
    let (rows, columns) = (evaluator.rows(), evaluator.columns());
    let (kept_rows, kept_columns) = (rows - usize::from(net.closed.0), columns - usize::from(net.closed.1));
    points.truncate(kept_rows * columns);
    if net.closed.1 {
        let mut place = 0;
        points.retain(|_| {
            let kept = place % columns < kept_columns;
            place += 1;
            kept
        });
    }
    PointGrid { rows: kept_rows, columns: kept_columns, points }
}

/// The plain net whose windows are those of the closed one: its first rows and columns once more at its end.
fn continued(automaton: &Automaton, net: &NetPlan, entries: Vec<[f64; 3]>) -> SheetPlan {
    let sheet = &net.sheet;
    let more = |closed: bool, state| match closed {
        true => automaton.state(state).control_points.saturating_sub(1),
        false => 0,
    };
    let rows = sheet.net_rows + more(net.closed.0, sheet.u);
    let columns = sheet.net_columns + more(net.closed.1, sheet.v);
    let entry = |i: usize, j: usize| entries[i % sheet.net_rows * sheet.net_columns + j % sheet.net_columns];
    let continued =
        (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(|(i, j)| entry(i, j)).collect();
    SheetPlan { net: continued, net_rows: rows, net_columns: columns, ..*sheet }
}
