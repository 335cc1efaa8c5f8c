//! Raw sheets with the parts that lie on them, raw bars, and how much of each is used.

use glam::DVec2;

use crate::export::html::document::SheetShape;
use crate::export::html::draw::paper::{Anchor, Path, letters, rectangle, svg, text_width};
use crate::export::html::draw::scale_bar::scale_bar;
use crate::export::html::markup::Markup;
use crate::export::html::number::{count, count_figure, counted, shown};
use crate::export::html::table::{Cell, Column, table};
use crate::export::number::Fixed;
use crate::export::report::{BarsReport, Report, SheetReport, SheetsReport, UnplacedReport};

/// Sheets drawn, at most.
const MOST_SHEETS: usize = 60;

/// Bars listed, at most.
const MOST_BARS: usize = 500;

/// The room for one of them, mm.
const ROOM: DVec2 = DVec2::new(83.0, 110.0);

/// Writes sheets and bars; nothing where there are none. `shapes` are the sheets of the report in their order.
pub(in crate::export::html) fn sheets(page: &mut Markup, report: &Report, shapes: &[SheetShape]) {
    let mut shapes = shapes.iter();
    for (place, nest) in report.sheets.iter().enumerate() {
        let own: Vec<&SheetShape> = shapes.by_ref().take(nest.sheets.len()).collect();
        page.element("section", &[], |page| nested(page, nest, &own, &format!("/sheets/{place}")));
    }
    for (place, bars) in report.bars.iter().enumerate() {
        page.element("section", &[], |page| sawn(page, bars, &format!("/bars/{place}")));
    }
}

fn nested(page: &mut Markup, nest: &SheetsReport, shapes: &[&SheetShape], at: &str) {
    page.texts("h2", &[], &format!("Sheets: {}, {} mm", nest.material, short(nest.thickness_mm)));
    page.element("p", &[], |page| {
        let (length, width) = (short(nest.length_mm), short(nest.width_mm));
        page.text(&format!(
            "{} of {length} × {width} mm; no fewer than ",
            counted(nest.sheets.len(), "sheet")
        ));
        count_figure(page, nest.least_sheets, &format!("{at}/least_sheets"));
        page.text(" can do. Boards are ");
        percent(page, nest.part_of_area, &format!("{at}/yield"));
        page.text(&format!(" of their area; {} mm between boards, ", short(nest.gap_mm)));
        page.text(&format!("{} mm to the edge.", short(nest.margin_mm)));
        if shapes.len() > MOST_SHEETS {
            page.text(&format!(" The first {MOST_SHEETS} are drawn; all are in nest.csv."));
        }
    });
    let drawn: Vec<_> = shapes.iter().zip(&nest.sheets).take(MOST_SHEETS).collect();
    for pair in drawn.chunks(2) {
        page.element("figure", &[("class", "pair")], |page| {
            for (sheet, SheetReport { files, .. }) in pair {
                page.element("div", &[], |page| one(page, sheet, files));
            }
        });
    }
    unplaced(page, &nest.unplaced, at);
}

fn sawn(page: &mut Markup, nest: &BarsReport, at: &str) {
    let section = format!("{} × {} mm", short(nest.depth_mm), short(nest.width_mm));
    page.texts("h2", &[], &format!("Bars: {}, {section}", nest.material));
    page.element("p", &[], |page| {
        let length = short(nest.length_mm);
        page.text(&format!("{} of {length} mm; no fewer than ", counted(nest.bars.len(), "bar")));
        count_figure(page, nest.least_bars, &format!("{at}/least_bars"));
        page.text(" can do. Planks are ");
        percent(page, nest.part_of_length, &format!("{at}/yield"));
        page.text(&format!(" of their length; the saw takes {} mm a cut, ", short(nest.kerf_mm)));
        page.text(&format!(
            "{} mm are left aside at each end. The places of the cuts are in stock.csv.",
            short(nest.trim_mm)
        ));
    });
    let columns = [
        Column::text("Bar", "name"),
        Column::number("Planks", "", "planks"),
        Column::number("Cuts", "", "cuts"),
        Column::number("Offcut", "mm", "offcut_mm"),
    ];
    table(page, "dense narrow", &format!("{at}/bars"), &columns, |rows| {
        for (place, bar) in nest.bars.iter().enumerate().take(MOST_BARS) {
            let (planks, cuts) = (count(bar.planks), count(bar.cuts));
            let cells = [Cell::Name(&bar.name), Cell::Text(&planks), Cell::Text(&cuts)];
            rows.row_of(place, cells.into_iter().chain([Cell::Number(Some(bar.offcut_mm), 1)]));
        }
    });
    if nest.bars.len() > MOST_BARS {
        page.texts(
            "p",
            &[],
            &format!("The first {MOST_BARS} of {}; stock.csv has all.", count(nest.bars.len())),
        );
    }
    unplaced(page, &nest.unplaced, at);
}

/// Those that lie nowhere.
fn unplaced(page: &mut Markup, all: &[UnplacedReport], at: &str) {
    if all.is_empty() {
        return;
    }
    page.texts("h3", &[], &format!("{} not placed", counted(all.len(), "part")));
    let columns = [Column::text("Address", "address"), Column::text("Why", "reason")];
    table(page, "dense", &format!("{at}/unplaced"), &columns, |rows| {
        for (place, part) in all.iter().enumerate() {
            rows.row_of(place, [Cell::Text(&part.address), Cell::Text(&part.reason)]);
        }
    });
}

/// A length as short as it goes: `12`, or `3.2`.
fn short(length: Fixed) -> String {
    let text = shown(length.value, 1);
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// A part of 1 as it is in report.json, with the words that make a percentage of it.
fn percent(page: &mut Markup, part: Option<Fixed>, at: &str) {
    match part {
        Some(part) => {
            let text = format!("{} %", shown(100.0 * part.value, 1));
            let exact = part.text().unwrap_or_default();
            page.texts("data", &[("value", &exact), ("data-at", at), ("data-percent", "")], &text);
        }
        None => page.text("none"),
    }
}

fn one(page: &mut Markup, sheet: &SheetShape, files: &[String]) {
    let title = format!(
        "Sheet {}: {}, {} % used",
        sheet.name,
        counted(sheet.parts.len(), "board"),
        shown(100.0 * sheet.used, 1)
    );
    page.texts("p", &[("class", "over")], &title);
    if !files.is_empty() {
        page.texts("p", &[("class", "over")], &files.join(", "));
    }
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
