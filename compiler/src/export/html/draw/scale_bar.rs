//! Scales of drawings: the round ones, and the bar that shows one.

use glam::DVec2;

use super::axis::round_step;
use super::paper::{Anchor, letters, rectangle};
use crate::export::html::markup::Markup;
use crate::export::html::number::shown;

/// The least of the usual denominators (1, 2, 2.5, 5, 7.5 times powers of ten) that is no less.
pub(in crate::export::html) fn round_denominator(least: f64) -> f64 {
    if !(least.is_finite() && least > 0.0) {
        return 1.0;
    }
    let power = libm::pow(10.0, libm::floor(libm::log10(least)));
    let usual = [1.0, 1.5, 2.0, 2.5, 4.0, 5.0, 7.5].map(|digit| digit * power);
    usual.into_iter().find(|found| *found >= least * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

/// `1:50`, or `2:1` where a thing is drawn larger than it is.
pub(in crate::export::html) fn scale_words(denominator: f64) -> String {
    let short = |value: f64| {
        let text = shown(value, 2);
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    if denominator >= 1.0 {
        format!("1:{}", short(denominator))
    } else {
        format!("{}:1", short(1.0 / denominator))
    }
}

/// Draws a bar of four parts under `at`, its upper left corner; `scale` is mm on paper for a mm of the thing. About 40 mm
/// long.
pub(in crate::export::html) fn scale_bar(page: &mut Markup, at: DVec2, scale: f64) {
    let whole = round_step(40.0 / scale / 2.0);
    let (part, width) = (whole / 4.0, whole * scale / 4.0);
    for place in 0..4 {
        let class = if place % 2 == 0 { "bar-dark" } else { "bar-light" };
        let corner = at + DVec2::X * width * f64::from(place);
        rectangle(page, corner, DVec2::new(width, 1.4), class);
    }
    let (unit, size, decimals) = if whole >= 4000.0 { ("m", 1000.0, 0) } else { ("mm", 1.0, 0) };
    let decimals = if (part * 2.0 / size).fract() > 1e-9 { 1 } else { decimals };
    for place in [0.0, 2.0, 4.0] {
        let text = shown(part * place / size, if place == 0.0 { 0 } else { decimals });
        let text = if place == 4.0 { format!("{text} {unit}") } else { text };
        letters(page, at + DVec2::new(width * place, 4.4), 2.6, Anchor::Middle, "number", &text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn usual_scales() {
        assert_eq!([38.0, 50.0, 51.0, 0.8].map(round_denominator), [40.0, 50.0, 75.0, 1.0]);
        assert_eq!([50.0, 2.5, 0.5].map(scale_words), ["1:50", "1:2.5", "2:1"].map(str::to_owned));
    }
}
