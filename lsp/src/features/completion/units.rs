//! Units behind a number: those of the dimension that its place would like first.

use ifs_compiler::analysis::Analysis;
use ifs_compiler::hir::dimension::unit_worth;
use ifs_compiler::source::Span;
use ifs_compiler::syntax::ast::Unit;

use super::{Kind, Offer, is_sound};
use crate::features::supplement::supplemented;
use crate::features::tokens::Before;
use crate::features::words::written;

/// The units that can follow the digits of a number, in place of the one it has.
pub(super) fn units(analysis: &Analysis, before: &Before<'_>, offset: u32) -> Option<(Span, Vec<Offer>)> {
    let number = before.word;
    let digits = digits(written(analysis, number));
    let start = number.start + digits as u32;
    if offset < start {
        return None;
    }
    let span = Span::new(number.file, start, number.end);
    // Of a name in its place the compiler says what is wanted there; numbers stand in operations too.
    let read = supplemented(analysis, number, &before.completed(is_sound(analysis, number.file)));
    let expected = read.as_ref().and_then(|read| read.analysis.index.expected_at(read.name)?.dimension());
    let offers = Unit::ALL.iter().enumerate().map(|(place, unit)| {
        let (dimension, _) = unit_worth(*unit);
        let fits = expected.is_none_or(|expected| expected == dimension);
        let rank = place as u8 + if fits { 0 } else { 100 };
        Offer::new(unit.suffix(), Kind::Unit).detail(dimension.name()).rank(rank)
    });
    Some((span, offers.collect()))
}

/// How many bytes of a number are its digits, with point and exponent.
fn digits(text: &str) -> usize {
    let bytes = text.as_bytes();
    let run = |from: usize| from + bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = run(0);
    if bytes.get(end) == Some(&b'.') && run(end + 1) > end + 1 {
        end = run(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let from = (end + 1 + sign).min(bytes.len());
        if run(from) > from {
            end = run(from);
        }
    }
    end
}
