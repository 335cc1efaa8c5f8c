//! `ifs explain`: the page of a diagnostic code.

use ifs_compiler::diagnostic::{Code, closest};

use crate::args::Explain;
use crate::exit::Exit;
use crate::output;

/// Prints the page of a code.
pub fn explain(explain: &Explain) -> Exit {
    if let Some(code) = Code::parse(explain.code.trim()) {
        return output::data(&format!("{}\n", code.page().trim_end())).err().unwrap_or(Exit::Good);
    }
    output::message(&format!("error: there is no code `{}`\n", explain.code));
    let names = Code::ALL.iter().map(|code| code.name());
    if let Some(near) = closest(&explain.code.to_uppercase(), names) {
        output::message(&format!("  help: did you mean `{near}`?\n"));
    }
    Exit::Usage
}
