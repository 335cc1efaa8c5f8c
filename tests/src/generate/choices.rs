//! Choices made by bytes; when they are used up, every choice is the first.

/// The bytes that choose.
pub(super) struct Choices<'a> {
    bytes: &'a [u8],
}

impl<'a> Choices<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Choices { bytes }
    }

    fn byte(&mut self) -> u8 {
        match self.bytes.split_first() {
            None => 0,
            Some((first, rest)) => {
                self.bytes = rest;
                *first
            }
        }
    }

    /// Whether all bytes are used up.
    pub(super) fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    /// A number below `end`, which is at most 256.
    pub(super) fn below(&mut self, end: usize) -> usize {
        usize::from(self.byte()) % end.max(1)
    }

    /// True once in `times`; false when the bytes are used up.
    pub(super) fn chance(&mut self, times: usize) -> bool {
        self.below(times) == times - 1
    }

    /// True now and then: for what is wrong, or strange.
    pub(super) fn rarely(&mut self) -> bool {
        self.chance(64)
    }

    /// One of some words.
    pub(super) fn pick<'w>(&mut self, words: &[&'w str]) -> &'w str {
        words[self.below(words.len())]
    }
}
