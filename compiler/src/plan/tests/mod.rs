//! Tests of plans: checks, budgets, evaluation, addresses and the printed form.

mod addresses;
mod chains;
mod checks;
mod evaluation;
mod patchworks;
mod pieces;
mod printed;
mod swept;

use super::{Dimension, FigurePlan, Plan, Shape, SheetPlan};
use crate::ifs::tests::fixtures::*;
use crate::ifs::{Automaton, StateId};

const FIRST: StateId = StateId(0);

fn figure(name: &str, index: Option<u32>, shape: Shape) -> FigurePlan {
    FigurePlan { name: name.to_owned(), index, shape }
}

/// Metres of LANGUAGE 3, in millimetres.
const ARC: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [500.0, 2000.0, 0.0], [3500.0, 2000.0, 0.0], [4000.0, 0.0, 0.0]];

fn arc(level: u32) -> Shape {
    Shape::Curve { state: FIRST, points: ARC.to_vec(), level, dimension: Dimension::Plane }
}

/// The net of LANGUAGE 5, `rows` by `columns`.
fn net(rows: usize, columns: usize) -> Vec<[f64; 3]> {
    let wave = |i: usize| libm::sin(i as f64 * std::f64::consts::FRAC_PI_6);
    let point = |i: usize, j: usize| [i as f64 * 1000.0, j as f64 * 1000.0, 800.0 * wave(i) * wave(j)];
    (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).map(|(i, j)| point(i, j)).collect()
}

fn sheet(rows: usize, columns: usize, levels: (u32, u32), windows: bool) -> SheetPlan {
    SheetPlan {
        u: FIRST,
        v: FIRST,
        net_rows: rows,
        net_columns: columns,
        net: net(rows, columns),
        levels,
        windows,
    }
}

fn plan(automaton: Automaton, figures: Vec<FigurePlan>) -> Plan {
    Plan::try_new(automaton, figures).unwrap()
}
