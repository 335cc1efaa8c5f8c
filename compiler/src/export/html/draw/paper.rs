//! The sheet that drawings are made on: its element, lines, boxes and letters.

use glam::DVec2;

use crate::export::html::markup::Markup;
use crate::export::html::number::coordinate;

/// Where a text is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::export::html) enum Anchor {
    /// At its start.
    Start,
    /// In its middle.
    Middle,
    /// At its end.
    End,
}

impl Anchor {
    fn word(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

/// A drawing of a size in mm; `title` says to those who cannot see it what it shows.
pub(in crate::export::html) fn svg(
    page: &mut Markup,
    (width, height): (f64, f64),
    title: &str,
    inside: impl FnOnce(&mut Markup),
) {
    let (wide, high) = (coordinate(width), coordinate(height));
    let attributes = [
        ("xmlns", "http://www.w3.org/2000/svg"),
        ("width", &format!("{wide}mm")),
        ("height", &format!("{high}mm")),
        ("viewBox", &format!("0 0 {wide} {high}")),
        ("role", "img"),
        ("aria-label", title),
    ];
    page.element("svg", &attributes, inside);
}

/// A group of a class of the style sheet.
pub(in crate::export::html) fn group(page: &mut Markup, class: &str, inside: impl FnOnce(&mut Markup)) {
    page.element("g", &[("class", class)], inside);
}

/// A line of a class.
pub(in crate::export::html) fn line(page: &mut Markup, from: DVec2, to: DVec2, class: &str) {
    let mut path = Path::default();
    path.chain(&[from, to], false);
    path.write(page, &[("class", class)]);
}

/// A box of a class; its corner is the upper left one.
pub(in crate::export::html) fn rectangle(page: &mut Markup, corner: DVec2, size: DVec2, class: &str) {
    let [x, y, width, height] = [corner.x, corner.y, size.x, size.y].map(coordinate);
    let attributes = [("class", class), ("x", &x), ("y", &y), ("width", &width), ("height", &height)];
    page.empty("rect", &attributes);
}

/// A text of a size in mm; `at` is on its base line.
pub(in crate::export::html) fn letters(
    page: &mut Markup,
    at: DVec2,
    size: f64,
    anchor: Anchor,
    class: &str,
    text: &str,
) {
    let [x, y, size] = [at.x, at.y, size].map(coordinate);
    let attributes =
        [("class", class), ("x", &x), ("y", &y), ("font-size", &size), ("text-anchor", anchor.word())];
    page.texts("text", &attributes, text);
}

/// A text turned by an angle in degrees, clockwise, around where it is held.
pub(in crate::export::html) fn turned_letters(
    page: &mut Markup,
    at: DVec2,
    size: f64,
    degrees: f64,
    class: &str,
    text: &str,
) {
    let [x, y, size, degrees] = [at.x, at.y, size, degrees].map(coordinate);
    let turn = format!("translate({x} {y}) rotate({degrees})");
    let attributes =
        [("class", class), ("transform", &turn), ("font-size", &size), ("text-anchor", "middle")];
    page.texts("text", &attributes, text);
}

/// About how wide a text is, mm: room to keep free for it, on the safe side for the fonts of the style sheet.
pub(in crate::export::html) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * 0.58
}

/// The outline of a shape, piece by piece.
#[derive(Debug, Default)]
pub(in crate::export::html) struct Path {
    data: String,
}

impl Path {
    /// Adds a chain of points, closed or not.
    pub(in crate::export::html) fn chain(&mut self, points: &[DVec2], closed: bool) {
        for (place, point) in points.iter().enumerate() {
            self.data.push(if place == 0 { 'M' } else { 'L' });
            self.data.push_str(&coordinate(point.x));
            self.data.push(' ');
            self.data.push_str(&coordinate(point.y));
        }
        if closed {
            self.data.push('Z');
        }
    }

    /// Whether nothing was added.
    pub(in crate::export::html) fn is_empty(&self) -> bool {
        self.data.is_empty()
    }

    /// Writes the element.
    pub(in crate::export::html) fn write(&self, page: &mut Markup, attributes: &[(&'static str, &str)]) {
        let all: Vec<(&'static str, &str)> =
            std::iter::once(("d", self.data.as_str())).chain(attributes.iter().copied()).collect();
        page.empty("path", &all);
    }
}
