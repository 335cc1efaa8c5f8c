//! How much one design may ask for before it is refused.

/// What a design may ask for at most. The program uses the default; whoever must answer at once takes less.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Steps of one evaluation.
    pub steps: u64,
    /// Elements of all figures together.
    pub elements: u64,
    /// Boards or planks of one fabricate block.
    pub boards: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits { steps: 5_000_000, elements: 4_000_000, boards: 200_000 }
    }
}
