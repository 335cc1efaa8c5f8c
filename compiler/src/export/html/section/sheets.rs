//! Raw sheets with the parts that lie on them, and how much of each is used.

use glam::DVec2;

use crate::export::html::document::SheetShape;
use crate::export::html::draw::paper::{Anchor, Path, letters, rectangle, svg, text_width};
use crate::export::html::draw::scale_bar::scale_bar;
use crate::export::html::markup::Markup;
use crate::export::html::number::{counted, shown};

/// Sheets drawn, at most.
const MOST_SHEETS: usize = 60;

/// The room for one of them, mm.
const ROOM: DVec2 = DVec2::new(83.0, 110.0);

/// Writes them; nothing where there are none.
pub(in crate::export::html) fn sheets(page: &mut Markup, sheets: &[SheetShape]) {
    if sheets.is_empty() {
        return;
    }
    page.element("section", &[], |page| {
        page.texts("h2", &[], "Sheets");
        let used: f64 = sheets.iter().map(|sheet| sheet.used).sum();
        let mean = shown(100.0 * used / sheets.len() as f64, 1);
        let rest = match sheets.len() > MOST_SHEETS {
            true => format!(" The first {MOST_SHEETS} are drawn; all are in nest.csv."),
            false => String::new(),
        };
        page.texts(
            "p",
            &[],
            &format!("{}, {mean} % of them used in the mean.{rest}", counted(sheets.len(), "sheet")),
        );
        for pair in sheets[..sheets.len().min(MOST_SHEETS)].chunks(2) {
            page.element("figure", &[("class", "pair")], |page| {
                for sheet in pair {
                    page.element("div", &[], |page| one(page, sheet));
                }
            });
        }
    });
}

fn one(page: &mut Markup, sheet: &SheetShape) {
    let title = format!(
        "{}: {}, {}, {} % used",
        sheet.name,
        sheet.material,
        counted(sheet.parts.len(), "part"),
        shown(100.0 * sheet.used, 1)
    );
    page.texts("p", &[("class", "over")], &title);
    let scale = (ROOM.x / sheet.size.x).min(ROOM.y / sheet.size.y);
    if !(scale.is_finite() && scale > 0.0) {
        return;
    }
    let size = sheet.size * scale;
    let paper = |point: DVec2| DVec2::new(point.x * scale, size.y - point.y * scale);
    svg(page, (ROOM.x, size.y + 9.0), &title, |page| {
        rectangle(page, DVec2::ZERO, size, "raw");
        for (alias, outline) in &sheet.parts {
            let corners: Vec<DVec2> = outline.iter().map(|point| paper(*point)).collect();
            let mut path = Path::default();
            path.chain(&corners, true);
            path.write(page, &[("class", "plank")]);
            name(page, alias, &corners);
        }
        scale_bar(page, DVec2::new(1.0, size.y + 3.0), scale);
    });
}

/// The alias in the middle of a part, as large as it goes.
fn name(page: &mut Markup, alias: &str, corners: &[DVec2]) {
    let low = corners.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = corners.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    let room = high - low;
    let size = (0.85 * room.x / text_width(alias, 1.0)).min(0.6 * room.y).min(2.4);
    // Smaller letters than these are grey dust on paper.
    if size >= 0.7 {
        letters(page, (low + high) / 2.0 + DVec2::Y * size * 0.35, size, Anchor::Middle, "cell-text", alias);
    }
}
