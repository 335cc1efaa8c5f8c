//! Grids, quad meshes, planarity, dihedral angles, unrolling, polylines. Imports glam only.
//!
//! Lengths are millimetres and angles radians. Nothing here knows of timber, boards, addresses or files, and
//! nothing here moves a vertex: that is `planarize`.

pub mod dihedral;
mod error;
pub mod grid;
pub mod mesh;
pub mod planarity;
pub mod polyline;
pub mod summary;
pub mod topology;
pub mod unroll;

#[cfg(test)]
pub(crate) mod samples;

pub use dihedral::{Dihedral, edge_dihedral};
pub use error::{LARGEST_COORDINATE, MeshError};
pub use grid::{Closed, Grid};
pub use mesh::QuadMesh;
pub use planarity::{Diagonal, QuadMeasure, Verdict};
pub use polyline::{Plane, PolylineShape};
pub use summary::MeshSummary;
pub use topology::{EdgeUse, MeshEdge, Topology};
pub use unroll::{Bend, UnrollError, UnrolledQuad, unroll};
