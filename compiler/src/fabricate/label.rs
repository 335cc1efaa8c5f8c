//! What an element is called. Addresses and aliases are made elsewhere and only carried here.

/// The names of a board or plank.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Label {
    /// The IFS address: figure, index and word. Unique in the design, and unchanged by edits elsewhere.
    pub address: String,
    /// The short name that is engraved (`shell-07-12`), unique in the design.
    pub alias: String,
    /// The row in the figure's grid, where it has one.
    pub row: Option<u32>,
    /// The column in the figure's grid, where it has one.
    pub column: Option<u32>,
}
