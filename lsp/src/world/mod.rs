//! The open documents and what the compiler knows of them. One thread owns them and takes messages in order; readers get
//! snapshots. No message format lives here.

pub(crate) mod background;
mod designs;
mod discard;
pub(crate) mod documents;
pub(crate) mod edits;
pub(crate) mod names;
pub(crate) mod outbox;
pub(crate) mod overlay;
pub(crate) mod owner;
pub(crate) mod places;
pub(crate) mod project_file;
pub(crate) mod projects;
pub(crate) mod snapshot;
pub(crate) mod working;
mod worst;

pub(crate) use documents::Encoding;
pub(crate) use owner::{Message, start};
pub(crate) use snapshot::Snapshot;
