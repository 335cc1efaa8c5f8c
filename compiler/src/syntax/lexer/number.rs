//! Where a number ends: its unit, words that are glued to it, and how large it may be.

use super::Scanner;
use crate::diagnostic::{Code, Diagnostic, closest};
use crate::source::Span;
use crate::syntax::ast::Unit;
use crate::syntax::limits::{MAX_DIGITS, MAX_EXPONENT};
use crate::syntax::token::TokenKind;

impl Scanner<'_, '_> {
    /// A number: takes its unit, or the word that is glued to it.
    pub(super) fn number(&mut self) -> TokenKind {
        let digits = self.lexer.slice();
        let rest = self.lexer.remainder();
        let unit = unit_at(rest);
        if let Some(unit) = unit {
            self.lexer.bump(unit.suffix().len());
        } else if rest.starts_with(|c: char| continues_word(c) || c == '%' || c == '°') {
            self.glued_word(digits);
            return TokenKind::BadNumber;
        }
        match size_problem(digits) {
            None => TokenKind::Number(unit),
            Some(problem) => {
                let span = self.span();
                self.complain(|| {
                    let limit = format!(
                        "numbers have at most {MAX_DIGITS} digits and lie between 1e-{MAX_EXPONENT} and 1e{MAX_EXPONENT}"
                    );
                    Diagnostic::new(Code::E0104, span, problem).hint(limit)
                });
                TokenKind::BadNumber
            }
        }
    }

    /// Takes the word that is glued to a number and says that it is no unit.
    fn glued_word(&mut self, digits: &str) {
        let start = self.lexer.span().end as u32;
        self.take_while(|c| continues_word(c) || c == '%' || c == '°');
        let span = Span::new(self.source.id, start, self.lexer.span().end as u32);
        let word = &self.lexer.slice()[digits.len()..];
        self.complain(|| unknown_unit(span, digits, word));
    }
}

/// Whether a word goes on with this character.
fn continues_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The longest unit a text begins with that is not followed by a letter, a digit or `_`.
fn unit_at(text: &str) -> Option<Unit> {
    let fits = |unit: &&Unit| {
        text.strip_prefix(unit.suffix()).is_some_and(|after| !after.starts_with(continues_word))
    };
    Unit::ALL.iter().filter(fits).max_by_key(|unit| unit.suffix().len()).copied()
}

/// What people write, and the unit of the table it stands for.
const OTHER_SPELLINGS: &[(&str, &str)] = &[
    ("°", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("grad", "deg"),
    ("meter", "m"),
    ("meters", "m"),
    ("metre", "m"),
    ("metres", "m"),
    ("millimeter", "mm"),
    ("millimetre", "mm"),
    ("inch", "in"),
    ("inches", "in"),
    ("feet", "ft"),
    ("foot", "ft"),
    ("sec", "s"),
    ("second", "s"),
    ("seconds", "s"),
    ("minute", "min"),
    ("minutes", "min"),
    ("mins", "min"),
    ("sqm", "m2"),
    ("qm", "m2"),
    ("m²", "m2"),
    ("mm²", "mm2"),
    ("m³", "m3"),
    ("mm³", "mm3"),
];

fn unknown_unit(span: Span, digits: &str, word: &str) -> Diagnostic {
    let all: Vec<&str> = Unit::ALL.iter().map(|unit| unit.suffix()).collect();
    let found = Diagnostic::new(Code::E0105, span, format!("there is no unit `{word}`"))
        .label(format!("glued to the number {digits}"));
    if let Some(product) = product_of_lengths(digits, word) {
        return found.hint(product);
    }
    let lower = word.to_lowercase();
    let meant = OTHER_SPELLINGS.iter().find(|(spelling, _)| *spelling == lower).map(|(_, unit)| *unit);
    let same = || all.iter().copied().find(|unit| *unit == lower);
    let near = || closest(word, all.iter().copied()).filter(|_| word.len() > 1);
    match meant.or_else(same).or_else(near) {
        Some(unit) => found.fix(format!("did you mean `{digits}{unit}`?"), span, unit),
        None if Unit::ALL.iter().any(|unit| word.starts_with(unit.suffix())) || word.len() > 3 => {
            found.hint(format!("the units are {}", all.join(" ")))
        }
        None => found
            .hint(format!("the units are {}", all.join(" ")))
            .hint(format!("to multiply, write `{digits} * {word}`")),
    }
}

/// What to write for an area or a volume in a unit that has none, such as `cm2`: no other unit is the same.
fn product_of_lengths(digits: &str, word: &str) -> Option<String> {
    let powers = [("²", "2"), ("2", "2"), ("³", "3"), ("3", "3")];
    let (length, power) = powers.iter().find_map(|(sign, power)| Some((word.strip_suffix(sign)?, *power)))?;
    let lengths = [Unit::Millimetre, Unit::Centimetre, Unit::Metre, Unit::Inch, Unit::Foot];
    let unit = lengths.iter().map(|unit| unit.suffix()).find(|unit| *unit == length)?;
    let whole = format!("{unit}{power}");
    if Unit::ALL.iter().any(|unit| unit.suffix() == whole) {
        return None;
    }
    let factor = format!(" * 1{unit}");
    let (what, more) = if power == "2" { ("an area", "") } else { ("a volume", factor.as_str()) };
    Some(format!(
        "{what} is written in mm{power} or m{power}, or as a product: `({digits}{unit}{factor}{more})`"
    ))
}

/// What is wrong with the size of a number, if anything.
fn size_problem(literal: &str) -> Option<String> {
    let (mantissa, exponent) = match literal.find(['e', 'E']) {
        Some(at) => (&literal[..at], literal[at + 1..].parse::<i64>().unwrap_or(i64::MAX)),
        None => (literal, 0),
    };
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
    if digits > MAX_DIGITS {
        return Some(format!("this number has {digits} digits"));
    }
    let whole = mantissa.split('.').next().unwrap_or(mantissa).len() as i64;
    let mut figures = mantissa.bytes().filter(u8::is_ascii_digit);
    let leading = figures.position(|digit| digit != b'0').map(|zeros| whole - 1 - zeros as i64);
    let power = leading.map_or(exponent, |leading| exponent.saturating_add(leading));
    if power > MAX_EXPONENT || exponent > MAX_EXPONENT {
        Some("this number is too large".to_owned())
    } else if power < -MAX_EXPONENT || exponent < -MAX_EXPONENT {
        Some("this number is too small to tell from zero".to_owned())
    } else {
        None
    }
}
