//! Text to tree: tokens with their trivia, the parser by grammar area, recovery, and the tree.
//!
//! Names and types are not looked up here, and parsing never fails.

pub mod ast;
