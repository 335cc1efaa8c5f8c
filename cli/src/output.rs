//! Printing: data on stdout, messages on stderr. A reader that goes away is not an error and never a panic.

use std::io::{self, Write};

use crate::exit::Exit;
use crate::progress;

/// Prints data on stdout, as it is.
///
/// # Errors
/// [`Exit::InputOutput`] if stdout takes no more (a full disk), after saying so on stderr. A closed pipe, as of
/// `ifs build … | head -1`, is no error: whoever read has what they wanted.
pub fn data(text: &str) -> Result<(), Exit> {
    progress::hide();
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            message(&format!("error: could not write to the standard output: {error}\n"));
            Err(Exit::InputOutput)
        }
        _ => Ok(()),
    }
}

/// Prints a message on stderr, as it is. If stderr is closed there is nobody to tell.
pub fn message(text: &str) {
    progress::hide();
    let _ = io::stderr().lock().write_all(text.as_bytes());
}
