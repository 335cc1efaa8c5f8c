//! Shows at the client that a design is being worked out, where that takes longer than a moment.

use std::time::Duration;

use tokio::sync::watch;
use tower_lsp::Client;
use tower_lsp::ls_types::ProgressToken;

use crate::world::working::{Doing, Work};

/// What is done sooner is not shown: nothing should flicker while one types.
const AFTER: Duration = Duration::from_millis(600);
/// How often it is said anew.
const EVERY: Duration = Duration::from_millis(200);

/// Tells the client as long as the server lives; a client that refuses to show it is left in peace.
pub(crate) async fn show(client: Client, mut working: watch::Receiver<Option<Work>>) {
    for number in 1u64.. {
        if working.wait_for(Option::is_some).await.is_err() {
            return;
        }
        if ends_within(&mut working, AFTER).await {
            continue;
        }
        let token = ProgressToken::String(format!("ifs-works-{number}"));
        if client.create_work_done_progress(token.clone()).await.is_err() {
            return;
        }
        let Some(mut said) = words(&working) else { continue };
        let progress = client.progress(token, "Working out").with_message(said.clone()).begin().await;
        while !ends_within(&mut working, EVERY).await {
            if let Some(now) = words(&working).filter(|now| *now != said) {
                progress.report(now.clone()).await;
                said = now;
            }
        }
        progress.finish().await;
    }
}

/// Whether it is done, or nobody can say any more, before so long.
async fn ends_within(working: &mut watch::Receiver<Option<Work>>, time: Duration) -> bool {
    tokio::time::timeout(time, working.wait_for(Option::is_none)).await.is_ok()
}

fn words(working: &watch::Receiver<Option<Work>>) -> Option<String> {
    let work = working.borrow();
    let Work { design, doing } = work.as_ref()?;
    let doing = match doing {
        Doing::Measuring => "makes and measures what it is made of".to_owned(),
        Doing::Planarizing(figure, progress) => {
            let worst =
                progress.worst.map_or_else(String::new, |worst| format!(", worst planarity {worst:.4}"));
            format!(
                "planarizes {figure}, iteration {} of at most {}{worst}",
                progress.iteration, progress.iterations
            )
        }
        Doing::Mending => "looks for what would mend it".to_owned(),
        Doing::Cutting => "sees whether its machines can cut it".to_owned(),
    };
    Some(format!("{design}: {doing}"))
}
