//! The elements that no board or plank can be made for, and why.

use crate::export::html::markup::Markup;
use crate::export::html::number::counted;
use crate::export::html::table::{Cell, Column, table};
use crate::export::report::Fabrication;

/// Rows, at most.
const MOST_ROWS: usize = 200;

/// Writes them.
pub(in crate::export::html) fn refused(page: &mut Markup, fabrication: &Fabrication, at: &str) {
    let parts = fabrication.parts.iter().enumerate();
    let refused: Vec<_> = parts.filter(|(_, part)| part.status.starts_with("refused")).collect();
    if refused.len() > MOST_ROWS {
        let text = format!(
            "The first {MOST_ROWS} of {}; cutlist.csv has all.",
            counted(refused.len(), "refused part")
        );
        page.texts("p", &[], &text);
    }
    let columns =
        [Column::text("Alias", "alias"), Column::text("Address", "address"), Column::text("Why", "")];
    table(page, "", &format!("{at}/parts"), &columns, |rows| {
        for (place, part) in refused.into_iter().take(MOST_ROWS) {
            let why = part.status.strip_prefix("refused: ").unwrap_or(&part.status);
            rows.row_of(place, [Cell::Name(&part.alias), Cell::Text(&part.address), Cell::Text(why)]);
        }
    });
}
