//! What the server says unasked: diagnostics in order, refreshes, and its own end when the client is gone.

use std::sync::Arc;
use std::thread;
use std::time::Duration;

use tokio::sync::mpsc;
use tower_lsp::Client;
use tower_lsp::ls_types::MessageType;

use crate::protocol::diagnostics::diagnostic;
use crate::protocol::uri::uri_of;
use crate::world::Encoding;
use crate::world::owner::Outgoing;
use crate::world::places::Places;
use crate::world::projects::Projects;

/// What the client has told of itself.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Told {
    pub(crate) encoding: Encoding,
    /// It pulls diagnostics: they are not pushed too.
    pub(crate) pulls: bool,
    /// It can be asked to pull again.
    pub(crate) refreshes: bool,
    /// It can watch files.
    pub(crate) watches: bool,
}

/// Tells the client everything in the order it was found.
pub(crate) async fn publish(
    client: Client,
    mut outgoing: mpsc::UnboundedReceiver<Outgoing>,
    told: Told,
    projects: Arc<dyn Projects>,
) {
    while let Some(next) = outgoing.recv().await {
        match next {
            Outgoing::Failed(words) => client.log_message(MessageType::ERROR, words).await,
            Outgoing::Worked if told.pulls && told.refreshes => {
                let client = client.clone();
                // Its answer says nothing, and it may take its time.
                tokio::spawn(async move {
                    let _ = client.workspace_diagnostic_refresh().await;
                });
            }
            Outgoing::Worked => {}
            Outgoing::Diagnostics { .. } if told.pulls => {}
            Outgoing::Diagnostics { path, version, found } => {
                let Some(uri) = uri_of(&path) else { continue };
                let mut all = Vec::new();
                for (root, analysis, diagnostics) in found {
                    let places = Places { root, projects: Arc::clone(&projects) };
                    for one in &diagnostics {
                        let one = diagnostic(&places, &analysis, one, told.encoding);
                        if !all.contains(&one) {
                            all.push(one);
                        }
                    }
                }
                client.publish_diagnostics(uri, all, version).await;
            }
        }
    }
}

/// Ends this process soon after the one that started it: an editor that died says nothing any more.
pub(crate) fn end_with(parent: u32) {
    let Some(parent) = i32::try_from(parent).ok().and_then(rustix::process::Pid::from_raw) else { return };
    thread::spawn(move || {
        while rustix::process::test_kill_process(parent) != Err(rustix::io::Errno::SRCH) {
            thread::sleep(Duration::from_secs(1));
        }
        std::process::exit(1);
    });
}
