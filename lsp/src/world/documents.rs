//! An open document: its text, its version, and edits to it in the client's columns.

use ifs_compiler::source::LineIndex;

/// How the client counts columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// Bytes.
    Utf8,
    /// UTF-16 code units, which every client knows.
    #[default]
    Utf16,
}

/// A line and a column of the client, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    pub(crate) line: u32,
    pub(crate) column: u32,
}

/// A change of the text: of a range, or of all of it.
#[derive(Clone, Debug)]
pub(crate) struct Change {
    pub(crate) range: Option<(Place, Place)>,
    pub(crate) text: String,
}

/// Bytes `start..end` became `length` bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edit {
    pub(crate) start: u32,
    pub(crate) end: u32,
    pub(crate) length: u32,
}

/// A text with its lines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Document {
    pub(crate) text: String,
    pub(crate) lines: LineIndex,
    pub(crate) version: i32,
}

impl Document {
    pub(crate) fn new(text: String, version: i32) -> Self {
        let lines = LineIndex::new(&text);
        Document { text, lines, version }
    }

    /// Applies a change and says which bytes it changed: of a whole text or a long part, no more than differ. Places outside of the text are taken to its nearest place.
    pub(crate) fn apply(&mut self, change: &Change, encoding: Encoding) -> Edit {
        let whole = u32::try_from(self.text.len()).unwrap_or(u32::MAX);
        let length = u32::try_from(change.text.len()).unwrap_or(u32::MAX);
        let edit = match change.range {
            None => Edit { start: 0, end: whole, length },
            Some((from, to)) => {
                let start = offset(&self.text, &self.lines, from, encoding);
                let end = offset(&self.text, &self.lines, to, encoding).max(start);
                Edit { start, end, length }
            }
        };
        let range = edit.start as usize..edit.end as usize;
        let differs = differing(edit, &self.text[range.clone()], &change.text);
        self.text.replace_range(range, &change.text);
        self.lines = LineIndex::new(&self.text);
        differs
    }
}

/// An edit without the letters that are the same at the beginning and at the end.
fn differing(edit: Edit, old: &str, new: &str) -> Edit {
    let same = |(old, new): &(char, char)| old == new;
    let size = |(letter, _): (char, char)| letter.len_utf8() as u32;
    let before: u32 = old.chars().zip(new.chars()).take_while(same).map(size).sum();
    let (old, new) = (&old[before as usize..], &new[before as usize..]);
    let after: u32 = old.chars().rev().zip(new.chars().rev()).take_while(same).map(size).sum();
    Edit { start: edit.start + before, end: edit.end - after, length: new.len() as u32 - after }
}

/// The byte of a place, at a bound of characters and inside of its line.
pub(crate) fn offset(text: &str, lines: &LineIndex, place: Place, encoding: Encoding) -> u32 {
    let Some(start) = lines.line_start(place.line) else {
        return u32::try_from(text.len()).unwrap_or(u32::MAX);
    };
    let next = lines.line_start(place.line + 1).map_or(text.len(), |next| next as usize);
    let line = &text[start as usize..next];
    let line = line.strip_suffix('\n').unwrap_or(line);
    let line = line.strip_suffix('\r').unwrap_or(line);
    let mut column = 0;
    for (at, c) in line.char_indices() {
        if column >= place.column {
            return start + at as u32;
        }
        column += match encoding {
            Encoding::Utf8 => c.len_utf8() as u32,
            Encoding::Utf16 => c.len_utf16() as u32,
        };
        // A place inside of a character is before it.
        if column > place.column {
            return start + at as u32;
        }
    }
    start + line.len() as u32
}

/// The place of a byte.
pub(crate) fn place(text: &str, lines: &LineIndex, offset: u32, encoding: Encoding) -> Place {
    let found = match encoding {
        Encoding::Utf8 => lines.bytes(offset),
        Encoding::Utf16 => lines.utf16(text, offset),
    };
    Place { line: found.line, column: found.column }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(line: u32, column: u32) -> Place {
        Place { line, column }
    }

    #[test]
    fn columns_are_the_clients() {
        let text = "a😀b\r\nß\n";
        let lines = LineIndex::new(text);
        assert_eq!(offset(text, &lines, at(0, 3), Encoding::Utf16), 5);
        assert_eq!(offset(text, &lines, at(0, 5), Encoding::Utf8), 5);
        assert_eq!(offset(text, &lines, at(0, 2), Encoding::Utf16), 1, "inside of a character is before it");
        assert_eq!(offset(text, &lines, at(0, 99), Encoding::Utf16), 6, "the line end is not of the line");
        assert_eq!(offset(text, &lines, at(9, 0), Encoding::Utf16), text.len() as u32);
        assert_eq!(place(text, &lines, 5, Encoding::Utf16), at(0, 3));
        assert_eq!(place(text, &lines, 8, Encoding::Utf8), at(1, 0));
    }

    #[test]
    fn changes_follow_each_other() {
        let mut document = Document::new("let a = 1\nlet b = 2\n".to_owned(), 1);
        let change = Change { range: Some((at(0, 4), at(0, 5))), text: "änd".to_owned() };
        assert_eq!(document.apply(&change, Encoding::Utf16), Edit { start: 4, end: 5, length: 4 });
        let change = Change { range: Some((at(0, 7), at(1, 3))), text: String::new() };
        document.apply(&change, Encoding::Utf16);
        assert_eq!(document.text, "let änd b = 2\n");
        let whole = Change { range: None, text: "let änd c, d = 2\n".to_owned() };
        assert_eq!(document.apply(&whole, Encoding::Utf16), Edit { start: 9, end: 10, length: 4 });
        document.apply(&Change { range: None, text: "x".to_owned() }, Encoding::Utf16);
        assert_eq!(document.text, "x");
    }
}
