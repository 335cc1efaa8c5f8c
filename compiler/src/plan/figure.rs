//! [`Plan`] and its figures, checked on construction.

use std::collections::BTreeMap;
use std::fmt;

use crate::ifs::{
    Adjacency, Automaton, Drawn, Joins, StateId, SurfaceJoins, joins, surface_joins, windows_join,
};

use super::size::SizeBound;

use super::chain::{ChainPlan, homogeneous};
use super::net::NetPlan;
use super::swept::{Path, Rule, SweptPlan};

/// How many coordinates a design gave a figure's points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Two; the third is 0.
    Plane,
    /// Three.
    Space,
}

/// A surface that is the product of two curve states, u along the rows' index and v along the columns'.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetPlan {
    /// The state that runs over the net's first index.
    pub u: StateId,
    /// The state that runs over the net's second index.
    pub v: StateId,
    /// Points of the net along its first index.
    pub net_rows: usize,
    /// Points of the net along its second index.
    pub net_columns: usize,
    /// The net, row after row, in millimetres.
    pub net: Vec<[f64; 3]>,
    /// Levels of u and of v.
    pub levels: (u32, u32),
    /// Whether every window of the net is a patch (a sheet), or the net is one window (a tensor product).
    pub windows: bool,
}

/// What a figure is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A chain of segments.
    Curve {
        /// The ifs it runs.
        state: StateId,
        /// Its control points, in millimetres.
        points: Vec<[f64; 3]>,
        /// The iteration level.
        level: u32,
        /// Of the plane or of space.
        dimension: Dimension,
    },
    /// A grid of quads.
    Sheet(SheetPlan),
    /// Pieces that do not join.
    Pieces(PiecesPlan),
    /// Polygons that share their edges.
    Patchwork(PatchworkPlan),
    /// A chain of segments over windows, closed, or rational.
    Chain(ChainPlan),
    /// A grid of quads that is closed or rational.
    Net(NetPlan),
    /// A grid of quads that is planar by construction.
    Swept(SweptPlan),
}

/// A surface of one ifs with polygon germs, whose pieces are proved to share their edges.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchworkPlan {
    /// The ifs it runs.
    pub state: StateId,
    /// Its control points, in millimetres.
    pub points: Vec<[f64; 3]>,
    /// The iteration level.
    pub level: u32,
    /// Of the plane or of space.
    pub dimension: Dimension,
}

/// A figure whose pieces are drawn one by one and share nothing (LANGUAGE 9): a fern, a column that keeps its trunk.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecesPlan {
    /// The ifs it runs.
    pub state: StateId,
    /// Its control points, in millimetres.
    pub points: Vec<[f64; 3]>,
    /// Of the plane or of space.
    pub dimension: Dimension,
    /// How deep it goes.
    pub depth: Depth,
}

/// How deep the branches of a figure of pieces go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Depth {
    /// All equally deep.
    Level(u32),
    /// Each until its own germ is small enough (LANGUAGE 6).
    Each(Each),
}

/// Every branch stops on its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Each {
    /// Where a branch stops.
    pub bound: SizeBound,
    /// What it comes to, as [`super::evaluate::PiecesEvaluator::count_each`] has counted it.
    pub drawn: Drawn,
    /// Letters of the longest word.
    pub deepest: u32,
}

/// One figure: a shape with the name it has in the design.
#[derive(Clone, Debug, PartialEq)]
pub struct FigurePlan {
    /// Its name.
    pub name: String,
    /// Its place, when the figure is one of a list.
    pub index: Option<u32>,
    /// What it is.
    pub shape: Shape,
}

/// A design ready to be evaluated: sizes agree, coordinates are finite, and the pieces of every curve and surface are
/// proved to meet.
#[derive(Clone, Debug)]
pub struct Plan {
    automaton: Automaton,
    figures: Vec<FigurePlan>,
    joins: BTreeMap<StateId, Joins>,
    windows: BTreeMap<StateId, Joins>,
    surfaces: BTreeMap<StateId, SurfaceJoins>,
}

/// Why a design is no plan. `figure` is the figure's text: `vault[2]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlanError {
    /// A figure of a state that the automaton has not.
    UnknownState {
        /// The figure.
        figure: String,
        /// The state.
        state: StateId,
    },
    /// A curve, or a figure of pieces, on a wrong number of points.
    PointCount {
        /// The figure.
        figure: String,
        /// Points its ifs stands on.
        expected: usize,
        /// Points given.
        found: usize,
    },
    /// A net of a wrong size.
    NetSize {
        /// The figure.
        figure: String,
        /// Rows and columns of one window; a sheet's net must have at least these, a tensor product's exactly.
        window: (usize, usize),
        /// Rows and columns stated.
        net: (usize, usize),
        /// Points given.
        points: usize,
    },
    /// A coordinate that is infinite or not a number.
    NotFinite {
        /// The figure.
        figure: String,
        /// The point, by its place in the list or net.
        point: usize,
    },
    /// A weight that is not above 0, or not one for each point.
    Weight {
        /// The figure.
        figure: String,
        /// The point, by its place in the list or net.
        point: usize,
    },
    /// Pieces that do not meet, or are not proved to.
    NotJoined {
        /// The figure.
        figure: String,
        /// The state whose pieces or windows they are.
        state: StateId,
        /// Whether it is neighbouring windows of a sheet that part, rather than pieces of one curve.
        windows: bool,
        /// What is known of them.
        joins: Joins,
    },
    /// Polygons that do not share their edges, or are not proved to.
    NotSurface {
        /// The figure.
        figure: String,
        /// The state.
        state: StateId,
    },
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PlanError::UnknownState { figure, state } => {
                write!(f, "`{figure}` is of state {}, which is not there", state.0)
            }
            PlanError::PointCount { figure, expected, found } => {
                write!(f, "`{figure}` has {found} control points where {expected} are needed")
            }
            PlanError::NetSize { figure, window, net, points } => write!(
                f,
                "`{figure}` has a net of {} by {} with {points} points for windows of {} by {}",
                net.0, net.1, window.0, window.1
            ),
            PlanError::NotFinite { figure, point } => {
                write!(f, "control point {point} of `{figure}` has a coordinate beyond all bounds")
            }
            PlanError::NotSurface { figure, .. } => {
                write!(f, "the polygons of `{figure}` are not proved to share their edges")
            }
            PlanError::Weight { figure, point } => {
                write!(f, "control point {point} of `{figure}` has no weight above 0")
            }
            PlanError::NotJoined { figure, windows, .. } => {
                let pieces = if *windows { "neighbouring windows" } else { "pieces" };
                write!(f, "the {pieces} of `{figure}` are not proved to meet")
            }
        }
    }
}

impl std::error::Error for PlanError {}

/// `vault[2]`, or `shell`.
impl fmt::Display for FigurePlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index {
            Some(index) => write!(f, "{}[{index}]", self.name),
            None => f.write_str(&self.name),
        }
    }
}

impl Plan {
    /// A plan of these figures.
    ///
    /// # Errors
    /// The first [`PlanError`] in the order of figures.
    pub fn try_new(automaton: Automaton, figures: Vec<FigurePlan>) -> Result<Plan, PlanError> {
        let mut plan = Plan {
            automaton,
            figures: Vec::new(),
            joins: BTreeMap::new(),
            windows: BTreeMap::new(),
            surfaces: BTreeMap::new(),
        };
        for figure in figures {
            plan.check(&figure)?;
            plan.figures.push(figure);
        }
        Ok(plan)
    }

    /// The states and transforms.
    pub fn automaton(&self) -> &Automaton {
        &self.automaton
    }

    /// The figures, in the order of the design.
    pub fn figures(&self) -> &[FigurePlan] {
        &self.figures
    }

    /// The states that figures stand on, with what is known of their joins.
    pub fn joins(&self) -> &BTreeMap<StateId, Joins> {
        &self.joins
    }

    /// How the polygons of a patchwork of this state share their edges; `None` when no figure of the plan is one.
    pub fn adjacency(&self, state: StateId) -> Option<&Adjacency> {
        match self.surfaces.get(&state) {
            Some(SurfaceJoins::Joined(adjacency)) => Some(adjacency),
            _ => None,
        }
    }

    fn check(&mut self, figure: &FigurePlan) -> Result<(), PlanError> {
        match &figure.shape {
            Shape::Curve { state, points, .. } => {
                self.check_points(figure, *state, points)?;
                self.check_joined(figure, *state)
            }
            Shape::Pieces(pieces) => {
                self.check_points(figure, pieces.state, &pieces.points)?;
                let found = || joins(&self.automaton, pieces.state);
                self.joins.entry(pieces.state).or_insert_with(found);
                Ok(())
            }
            Shape::Patchwork(patchwork) => {
                let expected = self.control_points(figure, patchwork.state)?;
                if patchwork.points.len() != expected {
                    let found = patchwork.points.len();
                    return Err(PlanError::PointCount { figure: figure.to_string(), expected, found });
                }
                check_finite(figure, &patchwork.points)?;
                let (automaton, state) = (&self.automaton, patchwork.state);
                let known = self.surfaces.entry(state).or_insert_with(|| surface_joins(automaton, state));
                match known {
                    SurfaceJoins::Joined(_) => Ok(()),
                    _ => Err(PlanError::NotSurface { figure: figure.to_string(), state }),
                }
            }
            Shape::Sheet(sheet) => self.check_sheet(figure, sheet, (false, false)),
            Shape::Chain(chain) => self.check_chain(figure, chain),
            Shape::Net(net) => {
                self.check_sheet(figure, &net.sheet, net.closed)?;
                check_weights(figure, &net.sheet.net, net.weights.as_deref())
            }
            Shape::Swept(swept) => {
                swept.curves().try_for_each(|curve| self.check_chain(figure, curve))?;
                match &swept.path {
                    Path::Rail(rail, Rule::Scaled(scale)) if scale.len() != rail.points.len() => {
                        let (expected, found) = (rail.points.len(), scale.len());
                        Err(PlanError::PointCount { figure: figure.to_string(), expected, found })
                    }
                    _ => Ok(()),
                }
            }
        }
    }

    fn check_points(
        &self,
        figure: &FigurePlan,
        state: StateId,
        points: &[[f64; 3]],
    ) -> Result<(), PlanError> {
        let expected = self.control_points(figure, state)?;
        if points.len() != expected {
            let found = points.len();
            return Err(PlanError::PointCount { figure: figure.to_string(), expected, found });
        }
        check_finite(figure, points)
    }

    fn check_chain(&mut self, figure: &FigurePlan, chain: &ChainPlan) -> Result<(), PlanError> {
        let expected = self.control_points(figure, chain.state)?;
        let found = chain.points.len();
        if if chain.windows { found < expected } else { found != expected } {
            return Err(PlanError::PointCount { figure: figure.to_string(), expected, found });
        }
        check_finite(figure, &chain.points)?;
        check_weights(figure, &chain.points, chain.weights.as_deref())?;
        self.check_joined(figure, chain.state)?;
        if chain.closed || found > expected { self.check_windows(figure, chain.state) } else { Ok(()) }
    }

    fn check_windows(&mut self, figure: &FigurePlan, state: StateId) -> Result<(), PlanError> {
        let known = self.windows.entry(state).or_insert_with(|| windows_join(&self.automaton, state));
        if known.hold() {
            return Ok(());
        }
        Err(PlanError::NotJoined { figure: figure.to_string(), state, windows: true, joins: known.clone() })
    }

    fn check_sheet(
        &mut self,
        figure: &FigurePlan,
        sheet: &SheetPlan,
        closed: (bool, bool),
    ) -> Result<(), PlanError> {
        let window = (self.control_points(figure, sheet.u)?, self.control_points(figure, sheet.v)?);
        let net = (sheet.net_rows, sheet.net_columns);
        let fits = if sheet.windows { net.0 >= window.0 && net.1 >= window.1 } else { net == window };
        let points = sheet.net.len();
        if !fits || net.0.checked_mul(net.1) != Some(points) {
            return Err(PlanError::NetSize { figure: figure.to_string(), window, net, points });
        }
        check_finite(figure, &sheet.net)?;
        for (state, points, window, closed) in
            [(sheet.u, net.0, window.0, closed.0), (sheet.v, net.1, window.1, closed.1)]
        {
            self.check_joined(figure, state)?;
            if closed || points > window {
                self.check_windows(figure, state)?;
            }
        }
        Ok(())
    }

    fn control_points(&self, figure: &FigurePlan, state: StateId) -> Result<usize, PlanError> {
        match self.automaton.get(state) {
            Some(found) => Ok(found.control_points),
            None => Err(PlanError::UnknownState { figure: figure.to_string(), state }),
        }
    }

    fn check_joined(&mut self, figure: &FigurePlan, state: StateId) -> Result<(), PlanError> {
        let known = self.joins.entry(state).or_insert_with(|| joins(&self.automaton, state));
        if known.hold() {
            return Ok(());
        }
        Err(PlanError::NotJoined { figure: figure.to_string(), state, windows: false, joins: known.clone() })
    }
}

fn check_finite(figure: &FigurePlan, points: &[[f64; 3]]) -> Result<(), PlanError> {
    match points.iter().position(|point| point.iter().any(|coordinate| !coordinate.is_finite())) {
        Some(point) => Err(PlanError::NotFinite { figure: figure.to_string(), point }),
        None => Ok(()),
    }
}

fn check_weights(figure: &FigurePlan, points: &[[f64; 3]], weights: Option<&[f64]>) -> Result<(), PlanError> {
    let Some(weights) = weights else { return Ok(()) };
    let wrong = weights.iter().position(|weight| !(*weight > 0.0 && weight.is_finite()));
    if let Some(point) = wrong.or((weights.len() != points.len()).then_some(weights.len())) {
        return Err(PlanError::Weight { figure: figure.to_string(), point });
    }
    let rows = homogeneous(points, weights);
    match rows.iter().position(|row| row.iter().any(|entry| !entry.is_finite())) {
        Some(point) => Err(PlanError::NotFinite { figure: figure.to_string(), point }),
        None => Ok(()),
    }
}
