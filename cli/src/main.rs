//! The `ifs` program. Everything is in the library beside it, where tests reach it.

use std::process::ExitCode;

fn main() -> ExitCode {
    ifs_cli::run(std::env::args_os()).into()
}
