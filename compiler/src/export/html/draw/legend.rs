//! A scale of colours with numbers under it.

use glam::DVec2;

use super::colour::{Srgb, hex};
use super::paper::{Anchor, letters, line, svg};
use crate::export::html::markup::Markup;
use crate::export::html::number::coordinate;

/// Steps of the bar of colours.
const STEPS: usize = 48;

/// What is written at a place of the scale, from 0 to 1.
#[derive(Debug, Clone)]
pub(in crate::export::html) struct Mark {
    /// The place.
    pub(in crate::export::html) place: f64,
    /// The text.
    pub(in crate::export::html) text: String,
}

/// Draws the scale with its title; `colour` gives the colour at a place from 0 to 1.
pub(in crate::export::html) fn legend(
    page: &mut Markup,
    title: &str,
    colour: impl Fn(f64) -> Srgb,
    marks: &[Mark],
) {
    let (left, width, top, height) = (20.0, 130.0, 6.5, 3.2);
    svg(page, (170.0, 15.0), title, |page| {
        letters(page, DVec2::new(85.0, 4.0), 3.0, Anchor::Middle, "note", title);
        for step in 0..STEPS {
            let part = |step: usize| left + width * step as f64 / STEPS as f64;
            // Each box reaches under the next one, so that no seam shows.
            let reach = if step + 1 == STEPS { 1.0 } else { 1.2 };
            let fill = hex(colour((step as f64 + 0.5) / STEPS as f64));
            let [x, y, w, h] = [part(step), top, width / STEPS as f64 * reach, height].map(coordinate);
            let attributes = [("x", x.as_str()), ("y", &y), ("width", &w), ("height", &h), ("fill", &fill)];
            page.empty("rect", &attributes);
        }
        for mark in marks {
            let x = left + width * mark.place;
            line(page, DVec2::new(x, top), DVec2::new(x, top + height + 1.0), "tick");
            let at = DVec2::new(x, top + height + 4.2);
            letters(page, at, 2.9, Anchor::Middle, "number", &mark.text);
        }
    });
}
