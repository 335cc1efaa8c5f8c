//! Tables: a head that is repeated on every printed page, rows of text and of figures that can be looked up in
//! report.json.

use super::markup::Markup;
use super::number::shown;
use crate::export::number::Fixed;

/// A column.
#[derive(Debug, Clone, Copy)]
pub(super) struct Column {
    /// Its title.
    pub(super) title: &'static str,
    /// Its unit, under the title.
    pub(super) unit: &'static str,
    /// Whether it holds numbers, which stand at its right edge.
    pub(super) numeric: bool,
    /// The field of report.json that its cells show; empty for none.
    pub(super) field: &'static str,
}

impl Column {
    /// A column of texts.
    pub(super) const fn text(title: &'static str, field: &'static str) -> Self {
        Self { title, unit: "", numeric: false, field }
    }

    /// A column of numbers.
    pub(super) const fn number(title: &'static str, unit: &'static str, field: &'static str) -> Self {
        Self { title, unit, numeric: true, field }
    }
}

/// A cell.
#[derive(Debug, Clone)]
pub(super) enum Cell<'a> {
    /// Text that may break.
    Text(&'a str),
    /// A name, which may not.
    Name(&'a str),
    /// A number with so many decimals; empty where there is none.
    Number(Option<Fixed>, usize),
}

/// Writes a table. `at` is the place in report.json of the list that its rows follow; empty for none.
pub(super) fn table(
    page: &mut Markup,
    class: &str,
    at: &str,
    columns: &[Column],
    rows: impl FnOnce(&mut Rows<'_>),
) {
    let attributes = [("class", class), ("data-rows", at)];
    page.element("table", &attributes[..if at.is_empty() { 1 } else { 2 }], |page| {
        page.element("thead", &[], |page| page.element("tr", &[], |page| head(page, columns)));
        page.element("tbody", &[], |page| rows(&mut Rows { page, columns }));
    });
}

fn head(page: &mut Markup, columns: &[Column]) {
    for column in columns {
        let all = [
            ("scope", "col"),
            ("class", if column.numeric { "n" } else { "t" }),
            ("data-field", column.field),
        ];
        let attributes = &all[..if column.field.is_empty() { 2 } else { 3 }];
        page.element("th", attributes, |page| {
            page.text(column.title);
            if !column.unit.is_empty() {
                page.text(" ");
                page.texts("span", &[("class", "unit")], column.unit);
            }
        });
    }
}

/// The rows of a table being written.
pub(super) struct Rows<'a> {
    page: &'a mut Markup,
    columns: &'a [Column],
}

impl Rows<'_> {
    /// Adds a row; its cells stand under the columns.
    pub(super) fn row<'c>(&mut self, cells: impl IntoIterator<Item = Cell<'c>>) {
        self.numbered(None, cells);
    }

    /// Adds the row of an element of the list, by its place there.
    pub(super) fn row_of<'c>(&mut self, place: usize, cells: impl IntoIterator<Item = Cell<'c>>) {
        self.numbered(Some(place), cells);
    }

    fn numbered<'c>(&mut self, place: Option<usize>, cells: impl IntoIterator<Item = Cell<'c>>) {
        let columns = self.columns;
        let place = place.map(|place| place.to_string());
        let attributes: Vec<_> = place.iter().map(|place| ("data-row", place.as_str())).collect();
        self.page.element("tr", &attributes, |page| {
            for (cell, column) in cells.into_iter().zip(columns) {
                match cell {
                    Cell::Name(text) => page.texts("td", &[("class", "name")], text),
                    Cell::Text(text) if column.numeric => page.texts("td", &[("class", "n")], text),
                    Cell::Text(text) => page.texts("td", &[], text),
                    Cell::Number(number, decimals) => {
                        let text = number.map_or_else(String::new, |number| shown(number.value, decimals));
                        page.texts("td", &[("class", "n")], &text);
                    }
                }
            }
        });
    }
}
