//! The language server of ifs. It reads the compiler's one analysis and makes none of its own: `features` turn it into plain
//! data, `protocol` into messages, `world` keeps the open documents, `server` answers, `transport` carries the messages. How
//! projects lie on disk is the caller's ([`Projects`]).

mod features;
mod protocol;
mod server;
mod transport;
mod world;

use std::io::{Read, Write};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use tower_lsp::LspService;

use world::names::Names;
use world::outbox::Outbox;

pub use features::fixes::{Mend, mends};
pub use world::projects::{Project, Projects};

/// How many requests are worked on beside each other; the others wait for their turn.
const WORKERS: usize = 4;
/// Bytes of stack for each: designs nest as deep as the compiler allows.
const STACK: usize = 16 << 20;

/// Serves on standard input and output until the input ends or the client says so. `Ok(true)` where it was shut down in
/// order.
///
/// # Errors
/// The runtime cannot be started.
pub fn serve(projects: Arc<dyn Projects>) -> std::io::Result<bool> {
    serve_on(std::io::stdin(), std::io::stdout(), projects)
}

/// The same on any two streams.
///
/// # Errors
/// The runtime cannot be started.
pub fn serve_on(
    input: impl Read + Send + 'static,
    output: impl Write + Send + 'static,
    projects: Arc<dyn Projects>,
) -> std::io::Result<bool> {
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_time()
        .max_blocking_threads(WORKERS)
        .thread_stack_size(STACK)
        .build()?;
    let (names, outbox) = (Names::default(), Outbox::default());
    let world = world::start(Arc::clone(&projects), names.clone(), outbox.clone(), STACK)?;
    let orderly = runtime.block_on(async {
        let (service, socket) =
            LspService::new(|client| server::Backend::new(client, projects, world, names, outbox));
        let orderly = service.inner().orderly();
        transport::serve(input, output, service, socket).await;
        orderly.load(Ordering::Relaxed)
    });
    // What still runs in the background is not waited for: the client is gone.
    runtime.shutdown_timeout(Duration::ZERO);
    Ok(orderly)
}
