//! What the background is working out at this moment, for whoever shows it. How it is worded is theirs.

use std::sync::Arc;

use ifs_compiler::planarize::Progress;
use tokio::sync::watch;

/// What is done with a design.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Doing {
    /// Boards are made and measured.
    Measuring,
    /// The quads of a figure are made flat.
    Planarizing(String, Progress),
    /// It is looked for what would mend its failures.
    Mending,
    /// It is seen whether its machines can cut it.
    Cutting,
}

/// A design that is being worked out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Work {
    /// The name of its file.
    pub(crate) design: String,
    pub(crate) doing: Doing,
}

/// The work at this moment, or none; all clones are the same.
#[derive(Clone)]
pub(crate) struct Working(Arc<watch::Sender<Option<Work>>>);

impl Default for Working {
    fn default() -> Working {
        Working(Arc::new(watch::Sender::new(None)))
    }
}

impl Working {
    pub(super) fn set(&self, work: Option<Work>) {
        self.0.send_replace(work);
    }

    /// Sees what it is, and waits for what it will be.
    pub(crate) fn seen(&self) -> watch::Receiver<Option<Work>> {
        self.0.subscribe()
    }
}
