//! From boards and planks to what a workshop does with them: machines, lettering, toolpaths. No file format is
//! written here (see `export`), and nothing here reads a program back (see `readback`).

pub mod engrave;
pub mod machine;
pub mod toolpath;
