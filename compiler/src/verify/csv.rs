//! A reader of comma-separated values (RFC 4180 with line feeds).

use super::finding::Findings;
use std::collections::BTreeMap;

/// A table: its headers and its rows, every row as long as the headers.
pub(super) struct Table {
    pub(super) headers: Vec<String>,
    pub(super) rows: Vec<Vec<String>>,
}

/// Reads a table; rows of another length than the headers are found fault with and left out.
pub(super) fn read(path: &str, text: &str, findings: &mut Findings) -> Table {
    let mut rows = Vec::new();
    let (mut row, mut cell, mut quoted, mut was_quoted) = (Vec::new(), String::new(), false, false);
    let mut characters = text.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '"' if quoted && characters.peek() == Some(&'"') => {
                characters.next();
                cell.push('"');
            }
            '"' if quoted => quoted = false,
            '"' if cell.is_empty() && !was_quoted => (quoted, was_quoted) = (true, true),
            '"' => {
                findings.add(path, format!("row {}", rows.len() + 1), "quotes around whole cells", "others")
            }
            ',' | '\n' if !quoted => {
                row.push(std::mem::take(&mut cell));
                was_quoted = false;
                if c == '\n' {
                    rows.push(std::mem::take(&mut row));
                }
            }
            c => cell.push(c),
        }
    }
    if quoted || !cell.is_empty() || !row.is_empty() {
        findings.add(path, "the last row", "that it ends", "cut off");
    }
    let headers = if rows.is_empty() { Vec::new() } else { rows.remove(0) };
    for (place, row) in rows.iter().enumerate() {
        if row.len() != headers.len() {
            findings.add(path, format!("row {}", place + 2), format!("{} cells", headers.len()), row.len());
        }
    }
    rows.retain(|row| row.len() == headers.len());
    let table = Table { headers, rows };
    table.decimals(path, findings);
    table
}

impl Table {
    /// A cell by its header.
    pub(super) fn cell<'a>(&self, row: &'a [String], header: &str) -> Option<&'a str> {
        let place = self.headers.iter().position(|name| name == header)?;
        row.get(place).map(String::as_str)
    }

    /// Numbers of a column have the same number of decimals.
    fn decimals(&self, path: &str, findings: &mut Findings) {
        let mut of_column: BTreeMap<usize, usize> = BTreeMap::new();
        for (place, row) in self.rows.iter().enumerate() {
            for (column, cell) in row.iter().enumerate() {
                let Some(decimals) = decimals(cell) else { continue };
                let expected = *of_column.entry(column).or_insert(decimals);
                if expected != decimals {
                    let what = format!("row {}, {}", place + 2, self.headers[column]);
                    findings.add(path, what, format!("{expected} decimals"), cell);
                }
            }
        }
    }
}

/// How many decimals a plain number has; none for what is no plain number.
fn decimals(cell: &str) -> Option<usize> {
    let digits = cell.strip_prefix('-').unwrap_or(cell);
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let all_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    (!whole.is_empty() && all_digits(whole) && all_digits(part)).then_some(part.len())
}
