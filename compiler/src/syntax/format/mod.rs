//! The one way a text of the language is laid out. What it means is not looked at, and never changes.
//!
//! The tokens are kept as they are written, with all comments; the tree only says what a token does in its place.
//! Spaces, indents and optional commas are set anew; where lines end is the author's choice wherever there is one:
//!
//! - **Lines.** Every item begins a line. A block in braces stands on one line where it was written so and fits, else
//!   each of its entries has a line. A bracket that spans lines ends its line, and what closes it begins one; between
//!   its elements the author's line ends stay, so that rows stay rows. Line ends also stay after `=` and around
//!   operators, `on`, `at`, `until`, `then`, `else`, and before the range of a parameter. Elsewhere they go.
//! - **Indents** are four spaces a bracket, and four for the later lines of a statement or an element.
//! - **Width.** What is longer than [`COLUMNS`] columns is broken: after `=` where the value then fits on one line,
//!   else at the widest outermost bracket: short elements of a list fill lines, others have a line each. A row that is
//!   too long is filled too. A chain of operators and a comment are never broken.
//! - **Spaces.** One round operators, none inside `()` and `[]`, one inside `{}` on one line. A fraction of two plain
//!   numbers is one word, `4/3`; so is a range of two operands, `0..7`. The closed ranges of parameters, requirements
//!   and levels have spaces, `150mm .. 1200mm`. Three spaces part what stands side by side without a comma:
//!   the entries of an ifs on one line, and the step of a parameter.
//! - **Commas.** After each element of a bracket that spans lines, the last too; between the entries of a record or a
//!   fabricate block only where they stand on one line. A comma stands directly after its element; a `///` that stood
//!   between the two then documents what follows.
//! - **Blank lines.** One at most, between items, entries, elements and comments; none just inside a bracket.
//! - **Comments** stay where they are: on their own line, indented as what follows; or at the end of the line, two
//!   spaces after the code.
//! - **Columns.** On consecutive lines these stand below each other, as long as none is far away from the others: the
//!   `=` of `let`, `transform`, `boundary`, `figure` and `param`, and what follows in a `param`; the values of settings, but
//!   for records in braces;
//!   the parts of points and lists that each fill a line; comments behind lines that no blank line parts.
//!
//! Formatting twice is the same as once.

mod align;
mod group;
mod layout;
mod marks;
mod piece;
mod spacing;
mod write;

use super::Parse;
use super::limits::MAX_BYTES;
use crate::diagnostic::Severity;
use crate::source::Source;
use layout::Layout;

/// How wide a line may become before it is broken, comments and columns apart.
pub const COLUMNS: usize = 120;

/// The text of `source`, laid out; `parse` is what [`super::parse`] made of it. All lines end as the first
/// does, with LF or CRLF.
///
/// None where the text has errors, since a text that is not understood is left alone, and where indents would make it
/// longer than what is read ([`MAX_BYTES`]).
pub fn format(parse: &Parse, source: &Source) -> Option<String> {
    if parse.diagnostics.iter().any(|found| found.severity() == Severity::Error) {
        return None;
    }
    let mut pieces = piece::pieces(source, &parse.tokens);
    marks::mark(&parse.ast, &mut pieces);
    let groups = group::groups(&pieces);
    let lines = write::lines(Layout::new(&pieces, groups));
    let text = align::text(lines, MAX_BYTES)?;
    let first = source.text.split_inclusive('\n').next().unwrap_or("");
    if !first.ends_with("\r\n") {
        return Some(text);
    }
    let text = text.replace('\n', "\r\n");
    (text.len() <= MAX_BYTES).then_some(text)
}
