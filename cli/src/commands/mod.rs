//! The commands, one file each, and what they share: telling diagnostics.

pub mod build;
pub mod check;
pub mod explain;
pub mod fmt;
mod table;
mod tell;

pub use tell::{Told, tell};
