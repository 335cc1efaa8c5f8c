//! The bytes of every output: one file per format. Nothing is computed here that a part or a mesh does not already
//! say, and nothing is written to disk.

pub mod nc;
