//! What the server says unasked: diagnostics, refreshes, and its own end when the client is gone.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::thread;
use std::time::Duration;

use tower_lsp::Client;
use tower_lsp::ls_types::{Diagnostic, MessageType};

use super::diagnostics::said_of;
use super::told::{Refreshed, Told};
use crate::protocol::uri::uri_of;
use crate::world::names::Names;
use crate::world::outbox::{Outbox, Wrong};

/// What stands beside the text was worked out anew. Their answers say nothing, and may take their time.
fn refresh(client: &Client, refreshed: Refreshed) {
    let client = client.clone();
    tokio::spawn(async move {
        if refreshed.hints {
            let _ = client.inlay_hint_refresh().await;
        }
        if refreshed.lenses {
            let _ = client.code_lens_refresh().await;
        }
    });
}

/// Tells the client what is new, as fast as it takes it.
pub(crate) async fn publish(client: Client, outbox: Outbox, told: Told, names: Names) {
    let mut said: BTreeMap<PathBuf, (Option<i32>, Vec<Diagnostic>)> = BTreeMap::new();
    let mut waiting: BTreeMap<PathBuf, Wrong> = BTreeMap::new();
    loop {
        let news = outbox.take().await;
        for words in news.failures {
            client.log_message(MessageType::ERROR, words).await;
        }
        if news.pull_again {
            refresh(&client, told.refreshed);
        }
        if told.pulls {
            if news.pull_again {
                let client = client.clone();
                // Its answer says nothing, and it may take its time.
                tokio::spawn(async move {
                    let _ = client.workspace_diagnostic_refresh().await;
                });
            }
            continue;
        }
        waiting.extend(news.wrong);
        while let Some((path, wrong)) = waiting.pop_first() {
            let all = said_of(&wrong, told);
            let version = wrong.version;
            if said.get(&path).is_some_and(|(before, list)| *before == version && *list == all) {
                continue;
            }
            let Some(uri) = uri_of(&names, &path) else { continue };
            client.publish_diagnostics(uri, all.clone(), version).await;
            said.insert(path, (version, all));
        }
    }
}

/// Ends this process soon after the one that started it: an editor that died says nothing any more.
pub(crate) fn end_with(parent: u32) {
    let Some(parent) = i32::try_from(parent).ok().and_then(rustix::process::Pid::from_raw) else { return };
    thread::spawn(move || {
        while rustix::process::test_kill_process(parent) != Err(rustix::io::Errno::SRCH) {
            thread::sleep(Duration::from_millis(500));
        }
        std::process::exit(1);
    });
}
