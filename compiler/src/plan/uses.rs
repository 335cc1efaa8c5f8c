//! What a figure stands on, whatever its shape: its states with their levels and windows, whether it is closed, whether
//! its quads are planar by construction.

use crate::ifs::{Automaton, StateId};

use super::chain::{ChainPlan, window_count};
use super::figure::{Depth, Shape, SheetPlan};
use super::swept::{Path, SweptPlan};

/// One chain of pieces of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StateUse {
    /// The state it runs.
    pub state: StateId,
    /// At this level.
    pub level: u32,
    /// On this many control points.
    pub points: usize,
    /// Whether they go round.
    pub closed: bool,
}

impl StateUse {
    /// Whether windows have neighbours that they must meet.
    pub fn has_neighbours(&self, automaton: &Automaton) -> bool {
        self.closed || self.points > automaton.state(self.state).control_points
    }

    /// How many windows there are.
    pub fn windows(&self, automaton: &Automaton) -> usize {
        window_count(self.points, automaton.state(self.state).control_points, self.closed)
    }
}

impl Shape {
    /// The chains the figure is made of: one for a curve; for a surface those along u and v, as far as they are chains.
    pub fn uses(&self) -> Vec<StateUse> {
        match self {
            Shape::Curve { state, points, level, .. } => {
                vec![StateUse { state: *state, level: *level, points: points.len(), closed: false }]
            }
            Shape::Sheet(sheet) => sheet_uses(sheet, (false, false)).into(),
            Shape::Chain(chain) => vec![chain_use(chain)],
            Shape::Pieces(pieces) => {
                let level = match pieces.depth {
                    Depth::Level(level) => level,
                    Depth::Each(each) => each.deepest,
                };
                vec![StateUse { state: pieces.state, level, points: pieces.points.len(), closed: false }]
            }
            Shape::Patchwork(patchwork) => {
                let (state, level, points) = (patchwork.state, patchwork.level, patchwork.points.len());
                vec![StateUse { state, level, points, closed: false }]
            }
            Shape::Net(net) => sheet_uses(&net.sheet, net.closed).into(),
            Shape::Swept(swept) => swept.curves().map(chain_use).collect(),
        }
    }

    /// Whether it is a line, a surface else.
    pub fn is_curve(&self) -> bool {
        matches!(self, Shape::Curve { .. } | Shape::Chain(_))
    }

    /// Whether it goes round along u (for a curve: along itself) and along v.
    pub fn closed(&self) -> (bool, bool) {
        match self {
            Shape::Curve { .. } | Shape::Sheet(_) | Shape::Pieces(_) | Shape::Patchwork(_) => (false, false),
            Shape::Chain(chain) => (chain.closed, false),
            Shape::Net(net) => net.closed,
            Shape::Swept(swept) => swept.closed(),
        }
    }

    /// Whether every quad is planar whatever the control points are.
    pub fn planar_by_construction(&self) -> bool {
        matches!(self, Shape::Swept(_))
    }

    /// The deepest level.
    pub fn deepest(&self) -> u32 {
        self.uses().iter().map(|used| used.level).max().unwrap_or(0)
    }

    /// The levels as the language writes them: `4`, `(4, 3)`.
    pub fn level_words(&self) -> String {
        match self.uses().as_slice() {
            [u, v] if u.level != v.level => format!("({}, {})", u.level, v.level),
            [first, ..] => first.level.to_string(),
            [] => String::new(),
        }
    }
}

fn chain_use(chain: &ChainPlan) -> StateUse {
    StateUse { state: chain.state, level: chain.level, points: chain.points.len(), closed: chain.closed }
}

fn sheet_uses(sheet: &SheetPlan, closed: (bool, bool)) -> [StateUse; 2] {
    [
        StateUse { state: sheet.u, level: sheet.levels.0, points: sheet.net_rows, closed: closed.0 },
        StateUse { state: sheet.v, level: sheet.levels.1, points: sheet.net_columns, closed: closed.1 },
    ]
}

impl SweptPlan {
    /// The steps of the path where it is no chain of pieces.
    pub fn steps(&self) -> Option<u32> {
        match &self.path {
            Path::Rail(..) => None,
            Path::Turn(turn) => Some(turn.segments),
            Path::Straight { pieces, .. } => Some(*pieces),
        }
    }
}
