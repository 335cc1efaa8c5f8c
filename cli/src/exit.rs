//! Exit codes: the one number a calling script sees.

use std::process::ExitCode;

/// How the program ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Exit {
    /// Everything asked for was done.
    Good = 0,
    /// The design has errors.
    Design = 1,
    /// The program was called wrongly.
    Usage = 2,
    /// Reading or writing failed.
    InputOutput = 3,
    /// A limit was hit: the design asks for more elements than allowed, or nests too deep.
    Limit = 4,
    /// Ctrl-C or a plain `kill`; what was there before is untouched.
    Interrupted = 130,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> ExitCode {
        ExitCode::from(exit as u8)
    }
}
