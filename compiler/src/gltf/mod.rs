//! A reader of meshes: from the bytes of a binary glTF 2.0 file (GLB) to triangles in millimetres, z upwards. Knows
//! nothing of designs; materials, textures, lines and points in the file are passed over.
//!
//! After the Khronos Group, glTF 2.0 Specification (2021): 3.5 (scenes and nodes), 3.6 (buffers and accessors), 3.7.2
//! (primitives), 4 (the container). Never trusts a number of the file: lengths and places are checked before they are
//! used, and limits stand before memory is taken.

mod accessor;
mod container;
mod document;
mod fault;
mod nodes;
mod primitive;
mod weld;

#[cfg(test)]
mod tests;

pub use fault::{Fault, FaultKind};
pub use weld::TriangleMesh;

/// The most triangles a mesh may have.
pub const MOST_TRIANGLES: usize = 200_000;

/// The most bytes that the description of a scene may have, beside its data.
pub const MOST_JSON_BYTES: usize = 2 << 20;

/// How far from its origin a vertex may lie, mm: a thousand kilometres.
pub const FARTHEST: f64 = 1e9;

/// The surface in a GLB file: that of its scene, all of its nodes where they stand. Vertices at one place are one.
///
/// # Errors
/// What is wrong with the file and where, what of it cannot be read, or which limit it exceeds.
pub fn read_glb(bytes: &[u8]) -> Result<TriangleMesh, Fault> {
    let container = container::open(bytes)?;
    let document = document::parse(&container)?;
    let reader = accessor::Reader { document: &document, data: container.data };
    let mut welder = weld::Welder::default();
    for placed in nodes::placed_meshes(&document)? {
        primitive::add_mesh(&reader, &placed, &mut welder)?;
    }
    welder.finish()
}
