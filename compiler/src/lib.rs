//! The ifs compiler: from `.ifs` text to typed programs, plans, meshes, boards and the bytes of every output.
//!
//! A pure library. It opens no file, reads no clock, environment or terminal; sources come in through
//! [`source::Files`], outputs go out as bytes. Lengths are millimetres and angles radians inside.

pub mod analysis;
pub mod diagnostic;
pub mod exact;
pub mod export;
pub mod fabricate;
pub mod geometry;
pub mod gltf;
pub mod hir;
pub mod ifs;
pub mod nest;
pub mod outputs;
pub mod plan;
pub mod planarize;
pub mod readback;
pub mod source;
pub mod syntax;
