//! What the client is to be told, until it is ready to hear it: of each file only the newest.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use ifs_compiler::analysis::Analysis;
use ifs_compiler::diagnostic::Diagnostic;
use tokio::sync::Notify;

use super::places::Places;
use super::working::Working;

/// What one design says of one file.
#[derive(Clone)]
pub(crate) struct Found {
    pub(crate) places: Places,
    pub(crate) analysis: Arc<Analysis>,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// What is wrong in a file, as far as all designs say.
#[derive(Clone, Default)]
pub(crate) struct Wrong {
    /// Of the document, where it is open.
    pub(crate) version: Option<i32>,
    pub(crate) found: Vec<Found>,
}

/// What is wrong, file by file, as far as open designs say; every open document is named.
pub(crate) type AllWrong = BTreeMap<PathBuf, Wrong>;

/// What has gathered since the last time.
#[derive(Default)]
pub(crate) struct News {
    pub(crate) wrong: AllWrong,
    /// What a client pulled may be another now without a change of the text: designs were worked out, or files changed.
    pub(crate) pull_again: bool,
    /// Mistakes of ours.
    pub(crate) failures: Vec<String>,
}

/// Where the news gathers; all clones are the same.
#[derive(Clone, Default)]
pub(crate) struct Outbox {
    inner: Arc<(Mutex<News>, Notify)>,
    /// What is being worked out.
    pub(crate) working: Working,
}

impl Outbox {
    /// Adds to the news.
    pub(crate) fn put(&self, add: impl FnOnce(&mut News)) {
        add(&mut self.inner.0.lock().unwrap_or_else(PoisonError::into_inner));
        self.inner.1.notify_one();
    }

    /// The news, when there is any.
    pub(crate) async fn take(&self) -> News {
        self.inner.1.notified().await;
        std::mem::take(&mut *self.inner.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
