//! `labels.svg`: labels to stick on boards, 24 on a sheet of A4, each 70 mm by 37 mm, as label paper is sold. A label has
//! the alias, the address as text and as a QR code, a line about the part, and its outline with edge 0 marked.

mod code;

use std::fmt::Write as _;
use std::io::{self, Write};

use glam::DVec2;

use super::number::fixed;
use super::xml::Escaped;

/// Labels beside each other and below each other on a sheet.
const COLUMNS: usize = 3;
const ROWS: usize = 8;
/// Labels on a sheet.
pub const PER_SHEET: usize = COLUMNS * ROWS;

/// A sheet, mm.
const SHEET: DVec2 = DVec2::new(210.0, 297.0);
/// A label, mm; what is left over lies in equal parts above and below.
const LABEL: DVec2 = DVec2::new(70.0, 37.0);
/// White around everything on a label, mm: a QR code needs four of its modules.
const MARGIN: f64 = 4.0;
/// The square of the QR code, mm.
const CODE: f64 = 25.0;
/// The box of the outline, mm.
const OUTLINE: DVec2 = DVec2::new(31.0, 11.5);
/// Where text and outline begin, mm from the left of the label.
const RIGHT: f64 = MARGIN + CODE + 4.0;
/// An address of up to so many characters stands on one line.
const ONE_LINE: usize = 26;
/// Width of a character by the height of its font, in a font whose characters are all equally wide.
const MONOSPACED: f64 = 0.6;

/// What stands on one label.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The full address.
    pub address: String,
    /// The short name.
    pub alias: String,
    /// A line about the part: material and size.
    pub about: String,
    /// The outline, anticlockwise, mm; edge 0 is its first side.
    pub outline: Vec<DVec2>,
}

/// A sheet of at most [`PER_SHEET`] labels.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// What the document is called.
    pub title: String,
    /// From left to right, then down.
    pub labels: Vec<Label>,
}

impl Sheet {
    /// Writes the sheet, in mm.
    ///
    /// # Errors
    /// Those of `out`; a coordinate that is not finite.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let (width, height) = (number(SHEET.x)?, number(SHEET.y)?);
        writeln!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
            viewBox=\"0 0 {width} {height}\" font-family=\"monospace\">"
        )?;
        writeln!(out, "<title>{}</title>", Escaped(&self.title))?;
        writeln!(out, "<style>@page {{ size: A4; margin: 0 }}</style>")?;
        writeln!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>")?;
        let top = (SHEET.y - ROWS as f64 * LABEL.y) / 2.0;
        for (place, label) in self.labels.iter().take(PER_SHEET).enumerate() {
            let column = (place % COLUMNS) as f64;
            let row = (place / COLUMNS) as f64;
            let at = DVec2::new(column * LABEL.x, top + row * LABEL.y);
            writeln!(out, "<g transform=\"translate({} {})\">", number(at.x)?, number(at.y)?)?;
            label.write(out)?;
            writeln!(out, "</g>")?;
        }
        writeln!(out, "</svg>")
    }
}

impl Label {
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        if let Some(code) = code::path(&self.address) {
            let scale = number(CODE / code.modules as f64)?;
            let (x, y) = (number(MARGIN)?, number((LABEL.y - CODE) / 2.0)?);
            let path = code.path;
            writeln!(out, "<path transform=\"translate({x} {y}) scale({scale})\" d=\"{path}\"/>")?;
        }
        let room = LABEL.x - RIGHT - MARGIN / 2.0;
        let fitting =
            |text: &str, most: f64| most.min(room / (MONOSPACED * text.chars().count().max(1) as f64));
        text(out, &self.alias, 8.0, fitting(&self.alias, 5.0), " font-weight=\"bold\"")?;
        for (line, part) in wrapped(&self.address).iter().enumerate() {
            text(out, part, 11.5 + 2.4 * line as f64, fitting(part, 2.2), "")?;
        }
        text(out, &self.about, 16.5, fitting(&self.about, 2.2), "")?;
        self.outline(out)
    }

    /// The outline as large as its box, edge 0 thick, with the number of each edge beside it.
    fn outline(&self, out: &mut dyn Write) -> io::Result<()> {
        let Some(&first) = self.outline.first() else { return Ok(()) };
        let bounds = |(low, high): (DVec2, DVec2), &at: &DVec2| (low.min(at), high.max(at));
        let (low, high) = self.outline.iter().fold((first, first), bounds);
        let size = (high - low).max(DVec2::splat(1e-9));
        let scale = (OUTLINE / size).min_element();
        let corner = DVec2::new(RIGHT + 2.0, LABEL.y - MARGIN - 1.0);
        // On paper y grows downwards.
        let place = |at: DVec2| corner + DVec2::new(at.x - low.x, low.y - at.y) * scale;
        let points: Vec<DVec2> = self.outline.iter().map(|&at| place(at)).collect();
        let mut path = String::new();
        for (index, point) in points.iter().enumerate() {
            let letter = if index == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{letter}{} {}", number(point.x)?, number(point.y)?);
        }
        writeln!(out, "<path d=\"{path}Z\" fill=\"none\" stroke=\"black\" stroke-width=\"0.2\"/>")?;
        let (from, to) = (points[0], points[1 % points.len()]);
        let (x0, y0, x1, y1) = (number(from.x)?, number(from.y)?, number(to.x)?, number(to.y)?);
        writeln!(out, "<path d=\"M{x0} {y0}L{x1} {y1}\" stroke=\"black\" stroke-width=\"0.8\"/>")?;
        for (edge, &from) in points.iter().enumerate() {
            let to = points[(edge + 1) % points.len()];
            let outwards = (to - from).perp().normalize_or_zero();
            let at = (from + to) / 2.0 + outwards * 1.4;
            writeln!(
                out,
                "<text x=\"{}\" y=\"{}\" font-size=\"2\" text-anchor=\"middle\">{edge}</text>",
                number(at.x)?,
                number(at.y + 0.7)?
            )?;
        }
        Ok(())
    }
}

fn text(out: &mut dyn Write, text: &str, y: f64, size: f64, more: &str) -> io::Result<()> {
    let (x, y, size) = (number(RIGHT)?, number(y)?, number(size)?);
    writeln!(out, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{more}>{}</text>", Escaped(text))
}

/// The text in one line, or in two of about the same length where it is long, parted after a separator if one is near.
fn wrapped(text: &str) -> Vec<String> {
    let characters: Vec<char> = text.chars().collect();
    if characters.len() <= ONE_LINE {
        return vec![text.to_owned()];
    }
    let half = characters.len().div_ceil(2);
    let after = |place: &usize| ['.', '-'].contains(&characters[place - 1]);
    let near = (0..half / 2).flat_map(|off| [half + off, half - off]);
    let place = near.filter(|place| (1..characters.len()).contains(place)).find(after).unwrap_or(half);
    let (first, second) = characters.split_at(place);
    vec![first.iter().collect(), second.iter().collect()]
}

fn number(value: f64) -> io::Result<String> {
    let text =
        fixed(value, 3).ok_or_else(|| io::Error::other("a label has a coordinate that is not finite"))?;
    Ok(text.trim_end_matches('0').trim_end_matches('.').to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_addresses_take_two_lines() {
        assert_eq!(wrapped("shell.0.left"), ["shell.0.left"]);
        assert_eq!(wrapped("shell.0-0.left-right.left-left"), ["shell.0-0.left-", "right.left-left"]);
        for long in ["left.".repeat(12), "x".repeat(27), "\u{fc}.".repeat(40)] {
            let lines = wrapped(&long);
            assert_eq!((lines.len(), lines.concat()), (2, long));
        }
    }

    #[test]
    fn texts_are_data() {
        let label = Label {
            address: "a".to_owned(),
            alias: "<script>".to_owned(),
            about: "\"&\u{0}".to_owned(),
            outline: vec![DVec2::ZERO, DVec2::X],
        };
        let mut bytes = Vec::new();
        Sheet { title: "]]><!--".to_owned(), labels: vec![label] }.write(&mut bytes).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert!(text.contains("&lt;script&gt;") && text.contains("&quot;&amp;\u{fffd}"), "{text}");
        assert!(text.contains("<title>]]&gt;&lt;!--</title>"), "{text}");
    }
}
