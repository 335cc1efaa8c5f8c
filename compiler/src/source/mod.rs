//! Sources: file identities, texts, byte spans, lines and columns, and the one I/O trait of the compiler.
//!
//! Nothing here knows what the text means. Positions are bytes; UTF-16 exists only in [`LineIndex`].

mod files;
mod line_index;
mod map;
mod span;

pub use files::{Files, MemoryFiles, ReadError};
pub use line_index::{LineColumn, LineIndex};
pub(crate) use map::floor_boundary;
pub use map::{Source, SourceMap};
pub use span::{FileId, Span};
