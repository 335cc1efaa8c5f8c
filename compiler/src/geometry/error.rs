//! Why a grid or a mesh cannot be built.

use std::fmt;

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

impl fmt::Display for MeshError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexOutOfRange { quad, vertex, vertices } => {
                write!(out, "quad {quad} names vertex {vertex}, but there are only {vertices} vertices")
            }
            Self::NotFinite { vertex } => write!(out, "vertex {vertex} has a coordinate that is not finite"),
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
