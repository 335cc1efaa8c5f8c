//! Numbers as the report shows them: rounded for people, digits in groups of three from five on. What report.json has of
//! the same figure goes along as the value of the element, so that a program can compare the two.

use super::markup::Markup;
use crate::export::number::{Fixed, fixed};

/// The narrow space between groups of digits.
const GROUP: char = '\u{202f}';

/// The number with so many decimals, in groups; a dash for what is not finite.
pub(super) fn shown(value: f64, decimals: usize) -> String {
    let Some(text) = fixed(value, decimals) else { return "–".to_owned() };
    let (sign, size) = match text.strip_prefix('-') {
        Some(size) => ("\u{2212}", size),
        None => ("", text.as_str()),
    };
    let (whole, rest) = size.find('.').map_or((size, ""), |point| size.split_at(point));
    let mut out = sign.to_owned();
    for (place, digit) in whole.char_indices() {
        if whole.len() > 4 && place > 0 && (whole.len() - place) % 3 == 0 {
            out.push(GROUP);
        }
        out.push(digit);
    }
    out + rest
}

/// A count in groups.
pub(super) fn count(number: usize) -> String {
    shown(number as f64, 0)
}

/// A count with its noun: `1 board`, `256 boards`.
pub(super) fn counted(number: usize, noun: &str) -> String {
    match number {
        1 => format!("1 {noun}"),
        _ => format!("{} {noun}s", count(number)),
    }
}

/// A coordinate on paper: mm to two decimals, as short as it goes.
pub(super) fn coordinate(value: f64) -> String {
    let text = fixed(value, 2).unwrap_or_else(|| "0".to_owned());
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A number with as many decimals as a step needs.
pub(super) fn stepped(value: f64, step: f64) -> String {
    shown(value, decimals_of(step))
}

/// The decimals that tell multiples of `step` apart, at most nine.
pub(super) fn decimals_of(step: f64) -> usize {
    let tells = |decimals: &usize| {
        let scaled = step * libm::pow(10.0, *decimals as f64);
        scaled >= 0.999 && (scaled - scaled.round()).abs() < 1e-6
    };
    (0..9).find(tells).unwrap_or(9)
}

/// Writes a figure of report.json: `at` is its place there (RFC 6901), `decimals` those shown.
pub(super) fn figure(page: &mut Markup, number: Option<Fixed>, decimals: usize, at: &str) {
    let exact = number.and_then(Fixed::text);
    match exact.zip(number) {
        Some((exact, number)) => {
            let text = shown(number.value, decimals);
            page.texts("data", &[("value", &exact), ("data-at", at)], &text);
        }
        None => page.text("–"),
    }
}

/// Writes a count of report.json.
pub(super) fn count_figure(page: &mut Markup, number: usize, at: &str) {
    page.texts("data", &[("value", &number.to_string()), ("data-at", at)], &count(number));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn for_people() {
        assert_eq!(shown(1234.56, 1), "1234.6");
        assert_eq!(shown(-1_234_567.891, 2), "\u{2212}1\u{202f}234\u{202f}567.89");
        assert_eq!(shown(12_345.0, 0), "12\u{202f}345");
        assert_eq!(shown(-0.001, 2), "0.00");
        assert_eq!(shown(f64::NAN, 2), "–");
        assert_eq!(counted(1, "board"), "1 board");
        assert_eq!(counted(10_000, "board"), "10\u{202f}000 boards");
    }

    #[test]
    fn on_paper() {
        assert_eq!(
            ["0", "12.3", "-0.25", "100"],
            [0.001, 12.3, -0.25, 100.0].map(|value| coordinate(value)).as_slice()
        );
        assert_eq!(stepped(0.99985, 0.00005), "0.99985");
        assert_eq!(stepped(300.0, 50.0), "300");
        assert_eq!(decimals_of(0.5), 1);
    }
}
