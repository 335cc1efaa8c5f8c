//! Error replies that are not of one request alone.

use tower_lsp::jsonrpc::Error;

/// The reply where we failed.
pub(crate) fn failed() -> Error {
    let mut error = Error::internal_error();
    error.message = "the server failed on this request; please report it with the file".into();
    error
}
