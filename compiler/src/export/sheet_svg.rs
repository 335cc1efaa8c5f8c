//! `sheets/<n>.svg`: a sheet as a picture, to scale: the raw board, its margin, the parts with their names. Up is up.

use std::fmt::Write as _;

use glam::DVec2;

use super::number::fixed;
use super::xml::Escaped;

/// A sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetPicture<'a> {
    /// What stands above it.
    pub title: String,
    /// Length and width, mm.
    pub size: DVec2,
    /// mm.
    pub margin: f64,
    /// Whether the grain runs along the sheet and counts.
    pub grain: bool,
    /// The parts as they lie, each with its short name, mm.
    pub parts: Vec<(&'a str, Vec<DVec2>)>,
}

/// Height of the title, mm.
const TITLE: f64 = 40.0;
/// Room around everything, mm.
const AROUND: f64 = 20.0;
/// Height of the names where there is room for it, mm.
const NAME: f64 = 28.0;
/// Width of a character by its height.
const CHARACTER: f64 = 0.62;

/// The text of the picture, in millimetres.
#[must_use]
pub fn sheet_svg(sheet: &SheetPicture<'_>) -> String {
    let whole = DVec2::new(sheet.size.x + 2.0 * AROUND, sheet.size.y + 3.0 * AROUND + TITLE);
    let mut out = String::new();
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">",
        number(whole.x),
        number(whole.y)
    );
    let _ = writeln!(out, "<title>{}</title>", Escaped(&sheet.title));
    out.push_str(STYLE);
    let _ = writeln!(
        out,
        "<text class=\"title\" x=\"{}\" y=\"{}\">{}</text>",
        number(AROUND),
        number(AROUND + TITLE * 0.75),
        Escaped(&sheet.title)
    );
    let place = Place { left: AROUND, bottom: 2.0 * AROUND + TITLE + sheet.size.y };
    rectangle(&mut out, "board", &place, DVec2::ZERO, sheet.size);
    rectangle(&mut out, "margin", &place, DVec2::splat(sheet.margin), sheet.size - sheet.margin);
    for (name, corners) in &sheet.parts {
        part(&mut out, &place, name, corners);
    }
    if sheet.grain {
        let (from, to) = (place.put(DVec2::new(0.0, -AROUND)), place.put(DVec2::new(150.0, -AROUND)));
        let y = number(from.y - AROUND / 2.0);
        let _ = writeln!(
            out,
            "<path class=\"grain\" d=\"M{0} {y}H{1}m-12 -5l12 5l-12 5\"/><text class=\"note\" x=\"{2}\" y=\"{3}\">grain</text>",
            number(from.x),
            number(to.x),
            number(to.x + 12.0),
            number(from.y - AROUND / 2.0 + 6.0)
        );
    }
    out.push_str("</svg>\n");
    out
}

const STYLE: &str = "<style>\n\
    text{font-family:sans-serif;fill:#222}\n\
    .title{font-size:28px}.note{font-size:18px}\n\
    .name{text-anchor:middle;dominant-baseline:central}\n\
    .board{fill:#f4ead7;stroke:#5b4a2f;stroke-width:2}\n\
    .margin{fill:none;stroke:#a08a60;stroke-width:1;stroke-dasharray:8 6}\n\
    .part{fill:#fff;stroke:#1f4e79;stroke-width:1.5}\n\
    .grain{fill:none;stroke:#5b4a2f;stroke-width:2}\n\
    </style>\n";

/// Where the lower left of the sheet stands in the picture, whose y runs down.
struct Place {
    left: f64,
    bottom: f64,
}

impl Place {
    fn put(&self, point: DVec2) -> DVec2 {
        DVec2::new(self.left + point.x, self.bottom - point.y)
    }
}

fn rectangle(out: &mut String, class: &str, place: &Place, low: DVec2, high: DVec2) {
    let (corner, size) = (place.put(DVec2::new(low.x, high.y)), high - low);
    let _ = writeln!(
        out,
        "<rect class=\"{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
        number(corner.x),
        number(corner.y),
        number(size.x),
        number(size.y)
    );
}

fn part(out: &mut String, place: &Place, name: &str, corners: &[DVec2]) {
    out.push_str("<polygon class=\"part\" points=\"");
    for (index, &corner) in corners.iter().enumerate() {
        let at = place.put(corner);
        let space = if index > 0 { " " } else { "" };
        let _ = write!(out, "{space}{},{}", number(at.x), number(at.y));
    }
    out.push_str("\"/>");
    let (low, high) = crate::fabricate::fit::bounds(corners);
    let size = high - low;
    let middle = place.put(corners.iter().sum::<DVec2>() / corners.len().max(1) as f64);
    // Names stand along the longer side, and shrink where they must.
    let upright = size.y > size.x;
    let wide = CHARACTER * name.chars().count().max(1) as f64;
    let height = NAME.min(0.8 * size.max_element() / wide).min(0.6 * size.min_element());
    let turned = match upright {
        true => format!(" transform=\"rotate(-90 {} {})\"", number(middle.x), number(middle.y)),
        false => String::new(),
    };
    let _ = writeln!(
        out,
        "<text class=\"name\" x=\"{}\" y=\"{}\" font-size=\"{}\"{turned}>{}</text>",
        number(middle.x),
        number(middle.y),
        number(height),
        Escaped(name)
    );
}

fn number(value: f64) -> String {
    fixed(value, 3).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_escaped_and_y_runs_up() {
        let corners = [(10.0, 20.0), (110.0, 20.0), (110.0, 90.0), (10.0, 90.0)];
        let corners = corners.map(|(x, y)| DVec2::new(x, y)).to_vec();
        let text = sheet_svg(&SheetPicture {
            title: "a < b & \"c\"".to_owned(),
            size: DVec2::new(500.0, 300.0),
            margin: 10.0,
            grain: true,
            parts: vec![("<x>", corners)],
        });
        assert!(
            text.contains("a &lt; b &amp; &quot;c&quot;") && text.contains(">&lt;x&gt;</text>"),
            "{text}"
        );
        assert!(
            text.contains("points=\"30.000,360.000 130.000,360.000 130.000,290.000 30.000,290.000\""),
            "{text}"
        );
        assert!(text.contains("width=\"540.000mm\" height=\"400.000mm\""), "{text}");
    }
}
