//! From text to lines of words or a comment: the alphabet of the dialect. What words mean is `interpret`'s business.

use super::fault::{Fault, FaultKind};

/// Lines must be shorter than this.
const LINE_LIMIT: usize = 70;

/// A letter and its number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word {
    /// `G`, `X`, …
    pub letter: u8,
    /// In thousandths.
    pub thousandths: i64,
}

impl Word {
    /// The number.
    pub(super) fn value(self) -> f64 {
        self.thousandths as f64 / 1000.0
    }

    /// The number if it is whole.
    pub(super) fn whole(self) -> Option<i64> {
        (self.thousandths % 1000 == 0).then_some(self.thousandths / 1000)
    }
}

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Line {
    /// From 1.
    pub number: usize,
    /// Text between the parentheses of a comment line.
    pub comment: Option<String>,
    /// The words of any other line.
    pub words: Vec<Word>,
}

/// Reads all lines. A line with a fault keeps the words that could be read.
pub(super) fn read(text: &str, faults: &mut Vec<Fault>) -> Vec<Line> {
    if !text.ends_with('\n') {
        faults.push(Fault::new(FaultKind::NotAscii, text.lines().count(), "the last line has no LF"));
    }
    text.split_terminator('\n').enumerate().map(|(i, line)| read_line(line, i + 1, faults)).collect()
}

fn read_line(text: &str, number: usize, faults: &mut Vec<Fault>) -> Line {
    if let Some(c) = text.chars().find(|&c| !(' '..='~').contains(&c)) {
        faults.push(Fault::new(FaultKind::NotAscii, number, format!("has the character {c:?}")));
    }
    let length = text.chars().count();
    if length >= LINE_LIMIT {
        let message = format!("has {length} characters");
        faults.push(Fault::measured(FaultKind::LineLength, number, length as f64, message));
    }
    let mut line = Line { number, comment: None, words: Vec::new() };
    if let Some(inner) = text.strip_prefix('(') {
        match inner.strip_suffix(')') {
            Some(inner) if !inner.contains(['(', ')']) => line.comment = Some(inner.to_owned()),
            _ => {
                faults.push(Fault::new(FaultKind::Syntax, number, "has a comment that does not end the line"))
            }
        }
        return line;
    }
    for part in text.split(' ') {
        match word(part.as_bytes()) {
            Some(word) => line.words.push(word),
            None => {
                let message = format!("has {part:?}, which is no letter with a plain number");
                faults.push(Fault::new(FaultKind::Syntax, number, message));
            }
        }
    }
    line
}

/// A capital letter, a minus or nothing, one to seven digits, and either nothing or a point and three digits. Minus
/// zero is no number.
fn word(text: &[u8]) -> Option<Word> {
    let (&letter, rest) = text.split_first()?;
    let negative = rest.first() == Some(&b'-');
    let digits = if negative { &rest[1..] } else { rest };
    let point = digits.iter().position(|&b| b == b'.');
    let (whole, decimals): (&[u8], &[u8]) = match point {
        Some(at) => (&digits[..at], &digits[at + 1..]),
        None => (digits, b"000"),
    };
    if !letter.is_ascii_uppercase() || !(1..=7).contains(&whole.len()) || decimals.len() != 3 {
        return None;
    }
    let mut value: i64 = 0;
    for &digit in whole.iter().chain(decimals) {
        value = value * 10 + i64::from(char::from(digit).to_digit(10)?);
    }
    if negative && value == 0 {
        return None;
    }
    Some(Word { letter, thousandths: if negative { -value } else { value } })
}
