//! What an editor can ask, one file each: pure functions of an analysis and a place, giving plain data. No message format
//! and no document lives here.

mod boards;
pub(crate) mod calls;
pub(crate) mod completion;
pub(crate) mod definition;
pub(crate) mod facts;
pub(crate) mod fixes;
#[cfg(test)]
mod fixture;
pub(crate) mod folding;
pub(crate) mod format;
pub(crate) mod hints;
pub(crate) mod hover;
mod keywords;
pub(crate) mod lens;
pub(crate) mod links;
#[cfg(test)]
mod properties;
pub(crate) mod refactor;
pub(crate) mod references;
pub(crate) mod rename;
pub(crate) mod search;
pub(crate) mod selection;
pub(crate) mod semantics;
pub(crate) mod signature;
mod sizes;
mod states;
mod sums;
mod supplement;
pub(crate) mod symbols;
mod tokens;
mod walk;
pub(crate) mod words;
