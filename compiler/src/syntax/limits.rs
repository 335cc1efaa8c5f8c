//! The limits of the grammar, so that no text can exhaust the stack, the memory or the reader's patience.

use crate::diagnostic::Diagnostic;

/// The largest file that is read, in bytes.
pub const MAX_BYTES: usize = 16 << 20;
/// How deep brackets may be nested; `if` in `if` too.
pub const MAX_NESTING: usize = 128;
/// How deep a tree may become, brackets and chains of operators together.
pub const MAX_DEPTH: u32 = 256;
/// How many digits a number may have.
pub const MAX_DIGITS: usize = crate::exact::MAX_DECIMAL_DIGITS;
/// The largest power of ten of a number, up and down.
pub const MAX_EXPONENT: i64 = 300;
/// How many diagnostics are collected from one file.
pub const MAX_DIAGNOSTICS: usize = 1000;

/// Diagnostics of one file, up to a sensible number.
#[derive(Debug, Default)]
pub(super) struct Said {
    found: Vec<Diagnostic>,
    /// How many lexemes the grammar has read, those it read again included: shows that the work stays linear.
    pub(super) steps: usize,
}

impl Said {
    /// Adds one, unless there are enough.
    pub(super) fn push(&mut self, make: impl FnOnce() -> Diagnostic) {
        if !self.is_full() {
            self.found.push(make());
        }
    }

    /// Whether nothing more is collected.
    pub(super) fn is_full(&self) -> bool {
        self.found.len() >= MAX_DIAGNOSTICS
    }

    /// What was collected.
    pub(super) fn into_vec(self) -> Vec<Diagnostic> {
        self.found
    }
}
