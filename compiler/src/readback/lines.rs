//! From text to lines of words or a comment: the alphabet of the dialect. What words mean is `interpret`'s business.

use super::fault::{Fault, FaultKind};
use crate::fabricate::machine::Profile;

/// Lines must be shorter than this.
const LINE_LIMIT: usize = 70;

/// A letter and its number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word {
    /// `G`, `X`, …
    pub letter: u8,
    /// In thousandths.
    pub thousandths: i64,
    /// Whether it has a decimal point: without one, some controls count in thousandths.
    pub point: bool,
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
    /// From 1, counted on through the files of a program.
    pub number: usize,
    /// Whether it is all of a line `%`.
    pub percent: bool,
    /// Text between the parentheses of a comment line.
    pub comment: Option<String>,
    /// The words of any other line.
    pub words: Vec<Word>,
}

/// Reads all lines, after `before` others. A line with a fault keeps the words that could be read.
pub(super) fn read(text: &str, before: usize, profile: &Profile, faults: &mut Vec<Fault>) -> Vec<Line> {
    if !text.ends_with('\n') {
        faults.push(Fault::new(
            FaultKind::NotAscii,
            before + text.lines().count(),
            "the last line has no LF",
        ));
    }
    let lines = text.split_terminator('\n').enumerate();
    lines.map(|(i, line)| read_line(line, before + i + 1, profile, faults)).collect()
}

fn read_line(text: &str, number: usize, profile: &Profile, faults: &mut Vec<Fault>) -> Line {
    if let Some(c) = text.chars().find(|&c| !(' '..='~').contains(&c)) {
        faults.push(Fault::new(FaultKind::NotAscii, number, format!("has the character {c:?}")));
    }
    let length = text.chars().count();
    if length >= LINE_LIMIT {
        let message = format!("has {length} characters");
        faults.push(Fault::measured(FaultKind::LineLength, number, length as f64, message));
    }
    let mut line = Line { number, percent: false, comment: None, words: Vec::new() };
    if text == "%" && profile.numbered {
        line.percent = true;
        return line;
    }
    if let Some(inner) = text.strip_prefix('(') {
        match inner.strip_suffix(')') {
            Some(inner) if !inner.contains(['(', ')']) => {
                check_comment(inner, number, profile, faults);
                line.comment = Some(inner.to_owned());
            }
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

/// Only what the dialect bears in comments; what escapes are made of stands for itself.
fn check_comment(inner: &str, number: usize, profile: &Profile, faults: &mut Vec<Fault>) {
    let rule = &profile.comment;
    let escape = |c: char| c == rule.escape.0 || c == rule.escape.1;
    let bad =
        |c: &char| (rule.forbidden.contains(*c) && !escape(*c)) || (rule.capitals && c.is_ascii_lowercase());
    if let Some(c) = inner.chars().find(bad) {
        faults.push(Fault::new(FaultKind::Comment, number, format!("has {c:?} in a comment")));
    }
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
    Some(Word { letter, thousandths: if negative { -value } else { value }, point: point.is_some() })
}
