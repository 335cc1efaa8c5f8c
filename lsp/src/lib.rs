//! The language server of ifs, over standard input and output. It reads the compiler's one analysis and makes none of its
//! own: `features` turn it into plain data, `protocol` into messages, `world` keeps the open documents, `server` answers.
//! How projects lie on disk is the caller's ([`Projects`]).

mod features;
mod protocol;
mod server;
mod world;

use std::sync::Arc;
use std::time::Duration;

use tower_lsp::{LspService, Server};

pub use features::fixes::{Mend, mends};
pub use world::projects::{Project, Projects};

/// How many requests may be under way; cancelling needs a free place.
const CONCURRENCY: usize = 64;

/// Serves until the input ends or the client says so. `Ok(true)` where it was shut down in order.
///
/// # Errors
/// The runtime cannot be started.
pub fn serve(projects: Arc<dyn Projects>) -> std::io::Result<bool> {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_time().build()?;
    let orderly = runtime.block_on(async {
        let (service, socket) = LspService::new(|client| server::Backend::new(client, projects));
        let orderly = service.inner().orderly();
        let serving = Server::new(tokio::io::stdin(), tokio::io::stdout(), socket);
        serving.concurrency_level(CONCURRENCY).serve(service).await;
        orderly.load(std::sync::atomic::Ordering::Relaxed)
    });
    // What still runs in the background is not waited for: the client is gone.
    runtime.shutdown_timeout(Duration::from_millis(100));
    Ok(orderly)
}
