//! What an editor can ask, one file each: pure functions of an analysis and a place, giving plain data. No message format
//! and no document lives here.

pub(crate) mod completion;
pub(crate) mod definition;
#[cfg(test)]
pub(crate) mod fixture;
pub(crate) mod format;
pub(crate) mod hover;
pub(crate) mod links;
pub(crate) mod references;
pub(crate) mod rename;
mod supplement;
pub(crate) mod symbols;
pub(crate) mod words;
