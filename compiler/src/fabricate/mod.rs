//! From meshes and curves to boards and planks with sizes, bevels, mitres and solids, and the checks of what a design
//! requires of them. No syntax, no plan, no file format: addresses and aliases come in as text, made elsewhere.

pub mod checks;
pub mod fit;
pub mod label;
pub mod material;
pub mod panel;
pub mod plank;
pub mod solid;
