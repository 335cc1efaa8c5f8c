//! Tells Zed how the language server of ifs is started: `ifs lsp`, with the program on the PATH of the project.

use zed_extension_api::{self as zed, Command, LanguageServerId, Result, Worktree};

struct Ifs;

impl zed::Extension for Ifs {
    fn new() -> Self {
        Ifs
    }

    fn language_server_command(&mut self, _: &LanguageServerId, worktree: &Worktree) -> Result<Command> {
        let command = worktree.which("ifs").ok_or("the program `ifs` is not on the PATH")?;
        Ok(Command { command, args: vec!["lsp".to_owned()], env: worktree.shell_env() })
    }
}

zed::register_extension!(Ifs);
