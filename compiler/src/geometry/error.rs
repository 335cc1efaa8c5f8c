//! Why a grid or a mesh cannot be built.

use std::fmt;

use glam::DVec3;

/// The largest size of a coordinate, mm: 1000 km. Beyond it the measures would lose the micrometres.
pub const LARGEST_COORDINATE: f64 = 1e9;

/// The reason a [`super::Grid`] or a [`super::QuadMesh`] was refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MeshError {
    /// A quad names a vertex the mesh does not have.
    VertexOutOfRange {
        /// The quad's index.
        quad: usize,
        /// The vertex it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A coordinate is infinite or not a number.
    NotFinite {
        /// The vertex with that coordinate.
        vertex: usize,
    },
    /// A coordinate is larger than [`LARGEST_COORDINATE`].
    TooFar {
        /// The vertex with that coordinate.
        vertex: usize,
    },
    /// An edge belongs to more than two quads, so "the neighbour across it" has no meaning.
    TooManyQuadsAtEdge {
        /// The edge's ends.
        vertices: [u32; 2],
    },
    /// More vertices or quads than a 32-bit index can name.
    TooLarge {
        /// How many there are.
        count: usize,
    },
    /// The list of points does not have `rows` times `columns` entries.
    WrongPointCount {
        /// Points that a grid of that size needs (saturated).
        wanted: usize,
        /// Points given.
        given: usize,
    },
    /// A grid needs two points in each open direction and three in each closed one.
    TooFewPoints {
        /// Points in that direction.
        given: usize,
        /// Points needed.
        needed: usize,
    },
}

impl MeshError {
    /// Refuses coordinates that are not finite or too large.
    pub(super) fn check_points(points: &[DVec3]) -> Result<(), Self> {
        let found = points
            .iter()
            .position(|point| !(point.abs().max_element() <= LARGEST_COORDINATE && point.is_finite()));
        match found {
            Some(vertex) if points[vertex].is_finite() => Err(Self::TooFar { vertex }),
            Some(vertex) => Err(Self::NotFinite { vertex }),
            None => Ok(()),
        }
    }
}

impl fmt::Display for MeshError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexOutOfRange { quad, vertex, vertices } => {
                write!(out, "quad {quad} names vertex {vertex}, but there are only {vertices} vertices")
            }
            Self::NotFinite { vertex } => write!(out, "vertex {vertex} has a coordinate that is not finite"),
            Self::TooFar { vertex } => write!(out, "vertex {vertex} is more than 1000km from the origin"),
            Self::TooManyQuadsAtEdge { vertices: [a, b] } => {
                write!(out, "the edge between vertices {a} and {b} belongs to more than two quads")
            }
            Self::TooLarge { count } => write!(out, "{count} is more than a mesh can number"),
            Self::WrongPointCount { wanted, given } => {
                write!(out, "a grid of this size has {wanted} points, but {given} were given")
            }
            Self::TooFewPoints { given, needed } => {
                write!(out, "a grid needs at least {needed} points in this direction, but has {given}")
            }
        }
    }
}

impl std::error::Error for MeshError {}
