//! [`SweptPlan`]: surfaces made of a curve and a way to move it, whose quads are planar by construction (GEOMETRY 6c).

use super::chain::ChainPlan;

/// A profile moved along a path. The grid's rows run along the path, its columns along the profile.
#[derive(Clone, Debug, PartialEq)]
pub struct SweptPlan {
    /// The curve that is moved, b(j).
    pub profile: ChainPlan,
    /// How it is moved.
    pub path: Path,
}

/// How a profile is moved.
#[derive(Clone, Debug, PartialEq)]
pub enum Path {
    /// Along another curve, a(i).
    Rail(ChainPlan, Rule),
    /// Round an axis.
    Turn(Turn),
    /// Along a vector, in equal pieces.
    Straight {
        /// From the profile to its last copy, mm.
        vector: [f64; 3],
        /// How many pieces that is, at least 1.
        pieces: u32,
    },
}

/// How a rail a(i) and a profile b(j) make S(i, j).
#[derive(Clone, Debug, PartialEq)]
pub enum Rule {
    /// a(i) + (b(j) − b(0)): parallelograms.
    Sum,
    /// a(i) + s(i)·(b(j) − b(0)): trapezoids. One number s for each control point of the rail.
    Scaled(Vec<f64>),
    /// A(i) + B(j) in homogeneous coordinates, divided once: the projected vector sum of Stotz 2009.
    Projective,
}

/// A turn round an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    /// A point of the axis, mm.
    pub point: [f64; 3],
    /// Its direction, of length 1.
    pub direction: [f64; 3],
    /// The whole angle, rad; turning from x to y round z is above 0.
    pub angle: f64,
    /// How many equal steps that is, at least 1; 3 when it is full.
    pub segments: u32,
    /// Whether the last step ends where the first began.
    pub full: bool,
}

impl SweptPlan {
    /// Whether the grid closes along the path and along the profile.
    pub fn closed(&self) -> (bool, bool) {
        let path = match &self.path {
            Path::Rail(rail, _) => rail.closed,
            Path::Turn(turn) => turn.full,
            Path::Straight { .. } => false,
        };
        (path, self.profile.closed)
    }

    /// The curves it is made of: the rail, where there is one, and the profile.
    pub fn curves(&self) -> impl Iterator<Item = &ChainPlan> {
        let rail = match &self.path {
            Path::Rail(rail, _) => Some(rail),
            _ => None,
        };
        rail.into_iter().chain([&self.profile])
    }

    /// What it is called.
    pub fn name(&self) -> &'static str {
        match &self.path {
            Path::Rail(_, Rule::Sum) => "translation",
            Path::Rail(_, Rule::Scaled(_)) => "scale-translation",
            Path::Rail(_, Rule::Projective) => "projective sum",
            Path::Turn(_) => "revolution",
            Path::Straight { .. } => "extrusion",
        }
    }
}
