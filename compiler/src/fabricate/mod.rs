//! From meshes and curves to boards and planks with sizes, bevels, mitres and solids, the checks of what a design requires
//! of them, and how a workshop cuts them: machines, lettering, toolpaths.
//!
//! No syntax, no plan: addresses and aliases come in as text, made elsewhere. No file format is written here (see
//! `export`), and nothing here reads a program back (see `readback`).

pub mod assembly;
pub mod checks;
pub mod cut_job;
pub mod engrave;
pub mod fit;
pub mod label;
pub mod machine;
pub mod material;
pub mod panel;
pub mod plank;
pub mod solid;
pub mod toolpath;
