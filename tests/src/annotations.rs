//! Annotations: what an `.ifs` test says about the diagnostics it expects, and comparing it with what was found.
//!
//! ```text
//! //@ set span=4m
//! //~ E0301 3:7..3:12 `spam` is not known
//! //~ E0302 parts/ribs.ifs 1:1..1:4
//! ```
//!
//! `//~` states one diagnostic: its code, the file if it is another than the test itself, where its primary span
//! begins and ends (line and column from 1; columns count characters; the end is the first place after it), and a part
//! of its message, which may be empty. Lines are those of the file as it stands, annotations included. `//@ set` gives
//! a parameter a value. Both may stand on any line of their own; updating puts the annotations at the top.
//!
//! Nothing here knows the compiler.

use std::fmt;

/// A diagnostic as it was found.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Found {
    /// The file's name relative to the test; `None` is the test itself.
    pub file: Option<String>,
    /// Where its primary span begins: line and column from 1, columns in characters.
    pub start: (usize, usize),
    /// The first place after the span.
    pub end: (usize, usize),
    /// Its code, `E0301`.
    pub code: String,
    /// Its message; white space is taken as one blank.
    pub message: String,
}

/// A stated diagnostic: its message may be a part of the found one's.
pub type Expected = Found;

/// What the comments of a test say.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Annotations {
    /// The stated diagnostics, each with the number of its line from 1.
    pub expected: Vec<(usize, Expected)>,
    /// The parameters given a value: name and value.
    pub settings: Vec<(String, String)>,
}

/// How found and stated diagnostics differ; nothing in it means they agree.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Difference {
    /// Stated and not found, with the numbers of their lines.
    pub missing: Vec<(usize, Expected)>,
    /// Found and not stated.
    pub unexpected: Vec<Found>,
}

impl Annotations {
    /// Reads the comments of a test.
    ///
    /// # Errors
    /// A line begins with `//~` or `//@` and cannot be read; the text names the line.
    pub fn parse(text: &str) -> Result<Annotations, String> {
        let mut annotations = Annotations::default();
        for (index, line) in text.lines().enumerate() {
            let line = line.trim();
            if let Some(words) = line.strip_prefix("//~") {
                let expected = parse_expected(words)
                    .ok_or_else(|| format!("line {}: cannot read {line:?}", index + 1))?;
                annotations.expected.push((index + 1, expected));
            } else if let Some(words) = line.strip_prefix("//@") {
                let setting = words.trim().strip_prefix("set ").and_then(|setting| setting.split_once('='));
                let (name, value) =
                    setting.ok_or_else(|| format!("line {}: cannot read {line:?}", index + 1))?;
                annotations.settings.push((name.trim().to_owned(), value.trim().to_owned()));
            }
        }
        Ok(annotations)
    }

    /// Compares with what was found: each found diagnostic must be stated and each stated one found.
    pub fn compare(&self, found: &[Found]) -> Difference {
        let mut missing = self.expected.clone();
        // Longer parts of messages first: a short one may fit where only the long one does not.
        missing.sort_by_key(|(line, expected)| (usize::MAX - expected.message.len(), *line));
        let mut unexpected = found.to_vec();
        missing.retain(|(_, expected)| {
            let fits = unexpected.iter().position(|found| expected.fits(found));
            fits.map(|index| unexpected.remove(index)).is_none()
        });
        missing.sort();
        unexpected.sort();
        Difference { missing, unexpected }
    }
}

impl Found {
    /// Whether this, as stated, fits what was found.
    fn fits(&self, found: &Found) -> bool {
        (&self.file, self.start, self.end, &self.code) == (&found.file, found.start, found.end, &found.code)
            && one_blank(&found.message).contains(&one_blank(&self.message))
    }
}

/// The text of a test with its annotations replaced by what was found, at the top. Annotations that fit are kept as
/// they are worded. The lines of what was found in the test itself are moved as the text moves.
///
/// # Errors
/// As [`Annotations::parse`].
pub fn update(text: &str, found: &[Found]) -> Result<String, String> {
    let annotations = Annotations::parse(text)?;
    let difference = annotations.compare(found);
    let mut stated: Vec<Found> = annotations
        .expected
        .iter()
        .filter(|expected| !difference.missing.contains(expected))
        .map(|(_, expected)| expected.clone())
        .chain(difference.unexpected)
        .collect();
    let moved = |(line, column): (usize, usize)| {
        let above = annotations.expected.iter().filter(|(at, _)| *at < line).count();
        (line - above + stated.len(), column)
    };
    let places: Vec<_> = stated.iter().map(|found| (moved(found.start), moved(found.end))).collect();
    for (found, (start, end)) in stated.iter_mut().zip(places) {
        if found.file.is_none() {
            (found.start, found.end) = (start, end);
        }
    }
    stated.sort();
    let mut updated: String = stated.iter().map(|found| format!("{found}\n")).collect();
    let kept = text.split_inclusive('\n').filter(|line| !line.trim_start().starts_with("//~"));
    updated.extend(kept);
    Ok(updated)
}

/// The line and column, both from 1 and the column in characters, of a byte of a text. A byte inside a character
/// counts as that character, one past the end as the end.
pub fn position(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(byte.min(text.len()))];
    let line = before.rsplit('\n').next().unwrap_or_default();
    (before.matches('\n').count() + 1, line.chars().count() + 1)
}

/// The annotation that states it.
impl fmt::Display for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "//~ {} ", self.code)?;
        if let Some(file) = &self.file {
            write!(f, "{file} ")?;
        }
        let ((line, column), (end_line, end_column)) = (self.start, self.end);
        write!(f, "{line}:{column}..{end_line}:{end_column}")?;
        let message = one_blank(&self.message);
        if message.is_empty() { Ok(()) } else { write!(f, " {message}") }
    }
}

/// For a person: what to look at, and what to write if it is right.
impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (line, expected) in &self.missing {
            writeln!(f, "stated in line {line} and not found:\n    {expected}")?;
        }
        for found in &self.unexpected {
            writeln!(f, "found and not stated:\n    {found}")?;
        }
        Ok(())
    }
}

impl Difference {
    /// Whether all agrees.
    pub fn is_empty(&self) -> bool {
        self.missing.is_empty() && self.unexpected.is_empty()
    }
}

fn parse_expected(words: &str) -> Option<Expected> {
    let (code, rest) = next_word(words);
    let (mut place, mut rest) = next_word(rest);
    let mut file = None;
    if parse_span(place).is_none() {
        file = Some(place.to_owned());
        (place, rest) = next_word(rest);
    }
    let (start, end) = parse_span(place)?;
    let is_code = code.starts_with(|c: char| c.is_ascii_uppercase())
        && code.len() > 1
        && code[1..].bytes().all(|b| b.is_ascii_digit());
    is_code.then(|| Found { file, start, end, code: code.to_owned(), message: rest.trim().to_owned() })
}

fn next_word(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    text.split_once(char::is_whitespace).unwrap_or((text, ""))
}

/// `3:7..3:12`
fn parse_span(text: &str) -> Option<((usize, usize), (usize, usize))> {
    let place = |text: &str| {
        let (line, column) = text.split_once(':')?;
        Some((line.parse().ok().filter(|n| *n > 0)?, column.parse().ok().filter(|n| *n > 0)?))
    };
    let (start, end) = text.split_once("..")?;
    Some((place(start)?, place(end)?))
}

fn one_blank(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests;
