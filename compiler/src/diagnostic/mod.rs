//! Diagnostics: what is wrong or worth knowing, where, why and how to mend it; and their two forms, for people
//! and for programs. No check lives here: each lives with what it checks.

mod code;
mod fix;
mod human;
mod json;
mod model;
mod report;
mod suggest;

pub use code::{Code, Severity};
pub use fix::{Edit, Fix};
pub use human::{HumanStyle, render_human, render_short};
pub use json::render_json;
pub use model::{Diagnostic, Hint, Label};
pub use report::{Diagnostics, SHOWN_AT_MOST};
pub use suggest::{closest, did_you_mean};
