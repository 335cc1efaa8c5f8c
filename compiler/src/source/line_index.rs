//! From bytes to lines and columns and back, in characters of UTF-8 and of UTF-16.

/// A place in a text; line and column start at 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LineColumn {
    /// The line, from 0.
    pub line: u32,
    /// The column, from 0; its unit is said by the method that made it.
    pub column: u32,
}

/// Where the lines of a text start. Lines end with LF, with CR and LF, or with a CR alone, as editors and their protocol
/// have it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LineIndex {
    starts: Vec<u32>,
    length: u32,
}

impl LineIndex {
    /// The index of `text`.
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let ends = || {
            bytes.iter().enumerate().filter(|(at, byte)| match byte {
                b'\n' => true,
                b'\r' => bytes.get(at + 1) != Some(&b'\n'),
                _ => false,
            })
        };
        // Counted first: a list that grows is moved again and again, and this one is made at every keystroke.
        let mut starts = Vec::with_capacity(ends().count() + 1);
        starts.push(0);
        starts.extend(ends().map(|(at, _)| at as u32 + 1));
        LineIndex { starts, length: text.len() as u32 }
    }

    /// How many lines there are, at least 1.
    pub fn lines(&self) -> u32 {
        self.starts.len() as u32
    }

    /// The byte where a line starts.
    pub fn line_start(&self, line: u32) -> Option<u32> {
        self.starts.get(line as usize).copied()
    }

    /// Line and column in bytes of the byte `offset`, which is clamped to the text.
    pub fn bytes(&self, offset: u32) -> LineColumn {
        let offset = offset.min(self.length);
        let line = self.starts.partition_point(|start| *start <= offset).saturating_sub(1);
        LineColumn { line: line as u32, column: offset - self.starts[line] }
    }

    /// Line and column in characters, as people count.
    pub fn characters(&self, text: &str, offset: u32) -> LineColumn {
        self.columns(text, offset, |_| 1)
    }

    /// Line and column in UTF-16 code units.
    pub fn utf16(&self, text: &str, offset: u32) -> LineColumn {
        self.columns(text, offset, |c| c.len_utf16() as u32)
    }

    fn columns(&self, text: &str, offset: u32, width: impl Fn(char) -> u32) -> LineColumn {
        let at = self.bytes(offset);
        let start = (offset.min(self.length) - at.column) as usize;
        let end = super::map::floor_boundary(text, start + at.column as usize);
        let column = text.get(start..end).map_or(0, |part| part.chars().map(width).sum());
        LineColumn { line: at.line, column }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_bytes_characters_and_utf16() {
        let text = "a\r\nß😀x\n";
        let index = LineIndex::new(text);
        let at = text.find('x').unwrap() as u32;
        assert_eq!(index.bytes(at), LineColumn { line: 1, column: 6 });
        assert_eq!(index.characters(text, at), LineColumn { line: 1, column: 2 });
        assert_eq!(index.utf16(text, at), LineColumn { line: 1, column: 3 });
        assert_eq!(index.bytes(999), LineColumn { line: 2, column: 0 });
        assert_eq!(index.lines(), 3);
    }

    #[test]
    fn lines_end_in_three_ways() {
        let starts = |text: &str| LineIndex::new(text).starts;
        assert_eq!(starts("a\rb\r\nc\nd"), [0, 2, 5, 7]);
        assert_eq!(starts("\r\r\n\r"), [0, 1, 3, 4]);
    }
}
