//! To and from the protocol's types: the only rooms that know them are this and `server`.

pub(crate) mod capabilities;
pub(crate) mod commands;
pub(crate) mod convert;
pub(crate) mod diagnostics;
pub(crate) mod errors;
pub(crate) mod plain;
pub(crate) mod uri;
