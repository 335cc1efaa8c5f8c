//! The commands, one file each, and what they share: telling diagnostics.

pub mod build;
pub mod check;
pub mod explain;
pub mod fmt;
mod table;
mod tell;

pub use tell::{Told, tell};

use crate::args::Setting;
use ifs_compiler::hir::evaluate::Overrides;

/// The parameters set on the command line, as the compiler takes them.
pub fn overrides(settings: &[Setting]) -> Overrides {
    let parameters = settings.iter().map(|setting| (setting.name.clone(), setting.value.clone())).collect();
    Overrides { parameters, ..Overrides::default() }
}
