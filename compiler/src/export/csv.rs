//! Comma-separated values as RFC 4180 has them, but for line ends: UTF-8, LF, comma, point. Text from a design can
//! make no formula in a spreadsheet: such a cell gets a leading apostrophe.

use super::number::Fixed;

/// One cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell<'a> {
    /// Text, from a design or our own.
    Text(&'a str),
    /// A number; empty where it is not finite.
    Number(Fixed),
    /// A whole number.
    Count(u64),
    /// Does not apply.
    Empty,
}

impl From<Option<Fixed>> for Cell<'_> {
    fn from(number: Option<Fixed>) -> Self {
        number.map_or(Self::Empty, Self::Number)
    }
}

/// A table being written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Table {
    text: String,
}

impl Table {
    /// A table with these headers.
    #[must_use]
    pub fn new(headers: &[&str]) -> Self {
        let mut table = Self { text: String::new() };
        table.row(headers.iter().map(|header| Cell::Text(header)));
        table
    }

    /// Adds a row; its cells stand under the headers.
    pub fn row<'a>(&mut self, cells: impl IntoIterator<Item = Cell<'a>>) {
        for (column, cell) in cells.into_iter().enumerate() {
            if column > 0 {
                self.text.push(',');
            }
            match cell {
                Cell::Text(text) => self.push_text(text),
                Cell::Number(number) => self.text.push_str(&number.text().unwrap_or_default()),
                Cell::Count(count) => self.text.push_str(&count.to_string()),
                Cell::Empty => {}
            }
        }
        self.text.push('\n');
    }

    /// The whole table, each row ended by a line feed.
    #[must_use]
    pub fn finish(self) -> String {
        self.text
    }

    fn push_text(&mut self, text: &str) {
        let formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
        let quoted = text.contains([',', '"', '\n', '\r']);
        if quoted {
            self.text.push('"');
        }
        if formula {
            self.text.push('\'');
        }
        for character in text.chars() {
            if character == '"' {
                self.text.push('"');
            }
            self.text.push(character);
        }
        if quoted {
            self.text.push('"');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn quotes_formulas_and_empty_cells() {
        let mut table = Table::new(&["address", "x_mm", "note"]);
        table.row([Cell::Text("=1+1"), Cell::Number(Fixed::mm(-1.5)), Cell::Text("a \"b\", c")]);
        table.row([Cell::Text("@x,y"), Cell::Empty, Cell::Text("two\nlines")]);
        table.row([Cell::Text("-3"), Cell::Count(7), Cell::Text("Fuß")]);
        assert_eq!(
            table.finish(),
            "address,x_mm,note\n'=1+1,-1.500,\"a \"\"b\"\", c\"\n\"'@x,y\",,\"two\nlines\"\n'-3,7,Fuß\n"
        );
    }

    /// Reads one row of the format back.
    fn read(row: &str) -> Vec<String> {
        let (mut cells, mut cell, mut inside) = (Vec::new(), String::new(), false);
        let mut characters = row.strip_suffix('\n').unwrap().chars().peekable();
        while let Some(character) = characters.next() {
            match character {
                '"' if inside && characters.peek() == Some(&'"') => cell.extend(characters.next()),
                '"' => inside = !inside,
                ',' if !inside => cells.push(std::mem::take(&mut cell)),
                other => cell.push(other),
            }
        }
        cells.push(cell);
        cells
    }

    proptest! {
        #[test]
        fn any_text_comes_back_and_is_no_formula(texts in proptest::collection::vec("[-=+@,\"\n\r\t a-zé]*", 1..5)) {
            let mut table = Table { text: String::new() };
            table.row(texts.iter().map(|text| Cell::Text(text)));
            let cells = read(&table.finish());
            prop_assert_eq!(cells.len(), texts.len());
            for (cell, text) in cells.iter().zip(&texts) {
                prop_assert!(!cell.starts_with(['=', '+', '-', '@', '\t', '\r']));
                prop_assert!(cell == text || cell.strip_prefix('\'') == Some(text));
            }
        }
    }
}
