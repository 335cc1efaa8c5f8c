//! What holds for every text, whatever stands in it: checks for tests and for the fuzz targets. They call the compiler
//! only through its public doors, and say in words what does not hold. A panic is for the caller to notice.

mod analysis;
mod diagnostics;
mod outputs;
mod parse;

pub use analysis::{MODEST, analysis_holds};
pub use parse::parse_holds;

/// Nothing, or what does not hold.
pub type Holds = Result<(), String>;

/// Says what does not hold.
fn holds(condition: bool, why: impl FnOnce() -> String) -> Holds {
    if condition { Ok(()) } else { Err(why()) }
}
