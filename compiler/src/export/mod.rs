//! The bytes of each output, one file per format. The structures serde writes live beside their format. Nothing here
//! opens a file, and nothing here decides: what is written was measured before.

pub mod csv;
pub mod cut_list;
pub mod dxf;
pub mod glb;
pub mod html;
pub mod nc;
pub mod number;
pub mod part;
pub mod planarity_csv;
pub mod report;
