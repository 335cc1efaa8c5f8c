//! Single-stroke lettering: what a text looks like as pen strokes, in units of its own height. Where the text goes on
//! a part, and how it is cut, is `toolpath`'s business.

mod glyphs;
#[cfg(test)]
mod tests;

use glam::DVec2;

/// One pen stroke: a polyline of at least two points.
pub type Stroke = Vec<DVec2>;

/// Height of capitals and figures on the glyph grid.
const CAP: f64 = 12.0;
/// Space between neighbouring glyphs on the grid.
const GAP: f64 = 3.0;
/// Width of the space character on the grid.
const SPACE: f64 = 4.0;

/// A text as strokes. Baseline on y = 0, capitals reach y = 1, descenders y = -1/3; x starts at 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Lettering {
    /// In writing order.
    pub strokes: Vec<Stroke>,
    /// Where the next glyph would start, in heights.
    pub advance: f64,
}

/// A character the font does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownCharacter(pub char);

/// The strokes of `text`, in units of the capital height.
///
/// # Errors
/// The first character that has no glyph: nothing is ever dropped.
pub fn letter(text: &str) -> Result<Lettering, UnknownCharacter> {
    let mut pen = 0.0;
    let mut strokes = Vec::new();
    for c in text.chars() {
        let glyph = glyph(c).ok_or(UnknownCharacter(c))?;
        let shift = DVec2::new(pen, 0.0);
        strokes.extend(glyph.strokes.iter().map(|s| s.iter().map(|&p| p + shift).collect::<Stroke>()));
        pen += glyph.advance;
    }
    Ok(Lettering { strokes, advance: pen })
}

/// The strokes of one character, in units of the capital height; `None` if the font does not have it.
#[must_use]
pub fn glyph(c: char) -> Option<Lettering> {
    if c == ' ' {
        return Some(Lettering { strokes: Vec::new(), advance: (SPACE + GAP) / CAP });
    }
    let (_, width, strokes) = glyphs::TABLE.iter().find(|entry| entry.0 == c)?;
    Some(scaled(*width, strokes))
}

/// The mark that says which way is up on a part: an arrow as high as a capital. It stands before the text, and no
/// character looks like it.
#[must_use]
pub fn up_mark() -> Lettering {
    scaled(glyphs::UP_MARK.1, glyphs::UP_MARK.2)
}

/// All characters of the font except the space.
pub fn characters() -> impl Iterator<Item = char> {
    glyphs::TABLE.iter().map(|entry| entry.0)
}

fn scaled(width: i8, strokes: &[&[(i8, i8)]]) -> Lettering {
    let point = |&(x, y): &(i8, i8)| DVec2::new(f64::from(x), f64::from(y)) / CAP;
    let strokes = strokes.iter().map(|s| s.iter().map(point).collect()).collect();
    Lettering { strokes, advance: (f64::from(width) + GAP) / CAP }
}
