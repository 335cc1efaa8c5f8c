//! Dimension lines: between two points on paper, with slashes at the ends and the length over the middle.

use glam::DVec2;

use super::paper::{Anchor, letters, line, text_width, turned_letters};
use crate::export::html::markup::Markup;
use crate::export::html::number::shown;

/// Of the letters.
const SIZE: f64 = 2.9;

/// Half a slash.
const SLASH: DVec2 = DVec2::new(0.9, -0.9);

/// A level dimension under a view, from left to right.
pub(in crate::export::html) fn below(page: &mut Markup, from: DVec2, to: DVec2, length: f64) {
    ends(page, from, to, DVec2::Y);
    let text = words(length);
    // Between the slashes, or behind them where it does not fit.
    let fits = text_width(&text, SIZE) + 2.0 <= to.x - from.x;
    let (at, anchor) =
        if fits { ((from + to) / 2.0, Anchor::Middle) } else { (to + DVec2::X * 2.0, Anchor::Start) };
    letters(page, at - DVec2::Y * 0.9, SIZE, anchor, "number", &text);
}

/// An upright dimension at the left of a view, from its lower end up.
pub(in crate::export::html) fn beside(page: &mut Markup, from: DVec2, to: DVec2, length: f64) {
    ends(page, from, to, DVec2::NEG_X);
    let text = words(length);
    let width = text_width(&text, SIZE);
    let fits = width + 2.0 <= from.y - to.y;
    let at = if fits { (from + to) / 2.0 } else { to - DVec2::Y * (2.0 + width / 2.0) };
    turned_letters(page, at - DVec2::X * 0.9, SIZE, -90.0, "number", &text);
}

fn ends(page: &mut Markup, from: DVec2, to: DVec2, away: DVec2) {
    line(page, from, to, "dimension");
    for end in [from, to] {
        line(page, end - away * 4.0, end + away * 1.2, "extension");
        line(page, end - SLASH, end + SLASH, "dimension slash");
    }
}

/// A length in mm, as whole ones where that is near enough.
pub(in crate::export::html) fn words(length: f64) -> String {
    shown(length, if length < 100.0 { 1 } else { 0 })
}
