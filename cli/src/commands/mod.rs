//! The commands, one file each, and what they share: telling diagnostics.

pub mod build;
pub mod check;
pub mod doc;
pub mod explain;
pub mod fmt;
pub mod lsp;
pub mod params;
mod rebuilt;
mod table;
mod tell;
pub mod test;
pub mod verify;

pub use tell::{Messages, Told, tell};
