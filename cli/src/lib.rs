//! The pieces of the `ifs` program: arguments, exit codes, files. The truth about a design is in the compiler.

#![allow(
    clippy::disallowed_methods,
    reason = "files, environment and clock are this crate's work; the lint keeps them out of the compiler"
)]

pub mod args;
pub mod commands;
pub mod environment;
pub mod exit;
pub mod folder;
pub mod interrupt;
pub mod output;
pub mod progress;
pub mod project;
mod replace;
pub mod sources;

use std::ffi::OsString;

use args::{Cli, Command};
use exit::Exit;

/// Reads the arguments and does what they say.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> Exit {
    let cli = match Cli::read(arguments) {
        Ok(cli) => cli,
        Err(error) => return answer(&error),
    };
    match &cli.command {
        Command::Check(check) => commands::check::check(check, cli.message_format),
        Command::Build(build) => commands::build::build(build, cli.message_format),
        Command::Fmt(fmt) => commands::fmt::fmt(fmt, cli.message_format),
        Command::Test(test) => commands::test::test(test, cli.message_format),
        Command::Verify(verify) => commands::verify::verify(verify, cli.message_format),
        Command::Params(params) => commands::params::params(params, cli.message_format),
        Command::Doc(doc) => commands::doc::doc(doc),
        Command::Lsp(_) => commands::lsp::lsp(),
        Command::Explain(explain) => commands::explain::explain(explain),
    }
}

/// Prints what clap has to say: help and version on stdout, wrong usage on stderr.
fn answer(error: &clap::Error) -> Exit {
    if !error.use_stderr() {
        return output::data(&error.render().to_string()).err().unwrap_or(Exit::Good);
    }
    // Through clap for its colours on a terminal. If stderr is closed there is nobody to tell.
    let _ = error.print();
    Exit::Usage
}
