//! Nested sheets: `nest.csv` against `report.json`, no two boards nearer than the nest allows; pictures and drawings of
//! sheets against where `nest.csv` says that boards lie. Programs of sheets are read in `nc`.

use std::collections::BTreeSet;

use glam::DVec2;
use serde_json::Value;

use super::csv;
use super::finding::Findings;
use super::report::{Part, Report, list};
use super::xml::{self, Event, attribute};
use crate::fabricate::cut_job::MAX_CORNERS;

const LIST: &str = "nest.csv";

/// Places and outlines are rounded to the third decimal each.
pub(super) const NEAR: f64 = 0.0025;

/// A board on a sheet.
#[derive(Debug, Clone)]
pub(super) struct Lying {
    pub(super) sheet: String,
    pub(super) address: String,
    pub(super) alias: String,
    /// Quarter turns anticlockwise.
    pub(super) quarters: u8,
    /// How far it is moved after that, mm.
    pub(super) at: DVec2,
    /// Where it lies, mm.
    pub(super) outline: Vec<DVec2>,
}

/// A raw board as the report has it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Raw {
    /// Length and width, mm.
    pub(super) size: DVec2,
    margin: f64,
    gap: f64,
}

/// What pictures and drawings show.
#[derive(Debug, Clone)]
pub(super) struct Shown {
    pub(super) path: String,
    /// The raw board from the lower left, mm.
    pub(super) size: DVec2,
    /// Cut outlines in order, mm.
    pub(super) outlines: Vec<Vec<DVec2>>,
    /// What stands on each of them.
    pub(super) names: Vec<String>,
}

/// A point turned by quarters anticlockwise about the origin.
pub(super) fn turned(point: DVec2, quarters: u8) -> DVec2 {
    match quarters % 4 {
        0 => point,
        1 => DVec2::new(-point.y, point.x),
        2 => -point,
        _ => DVec2::new(point.y, -point.x),
    }
}

/// The sheets of the report in order: their names, raw boards, and what the report says of each.
pub(super) fn raws(report: &Report) -> Vec<(String, Raw, Value)> {
    let number = |value: &Value, name: &str| value.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN);
    let mut raws = Vec::new();
    for nest in list(&report.value, "sheets") {
        let size = DVec2::new(number(nest, "length_mm"), number(nest, "width_mm"));
        let raw = Raw { size, margin: number(nest, "margin_mm"), gap: number(nest, "gap_mm") };
        for sheet in list(nest, "sheets") {
            let name = sheet.get("name").and_then(Value::as_str).unwrap_or_default();
            raws.push((name.to_owned(), raw, sheet.clone()));
        }
    }
    raws
}

/// Where the boards lie, after the list was compared with the report and the boards with each other.
pub(super) fn read(text: &str, report: &Report, whole: bool, findings: &mut Findings) -> Vec<Lying> {
    let table = csv::read(LIST, text, findings);
    let mut lying: Vec<Lying> = Vec::new();
    let (mut met, mut last) = (BTreeSet::new(), (String::new(), String::new()));
    for row in &table.rows {
        let cell = |header: &str| table.cell(row, header).unwrap_or_default();
        let address = cell("address");
        let Some(part) = report.part(address) else {
            findings.add(LIST, "address", "one of report.json", address);
            continue;
        };
        if !met.insert(address.to_owned()) {
            findings.add(LIST, "rows of a board", "one", address);
        }
        of_part(part, &cell, report, findings);
        if cell("status") != "placed" {
            refused(part, cell("status"), report, findings);
            continue;
        }
        let order = (cell("sheet").to_owned(), address.to_owned());
        if order <= last {
            findings.add(LIST, "order of the rows", "by sheet and address", address);
        }
        last = order;
        lying.extend(placed(part, &cell, findings));
    }
    let nested = report.parts.iter().filter(|part| !part.is_plank && !part.text("sheet").is_empty());
    if let Some(part) = nested.into_iter().find(|part| whole && !met.contains(&part.address)) {
        findings.add(LIST, "rows", format!("one for {}", part.address), "none");
    }
    for (name, raw, sheet) in raws(report) {
        let here: Vec<&Lying> = lying.iter().filter(|board| board.sheet == name).collect();
        of_sheet(&name, raw, &sheet, &here, findings);
    }
    lying
}

/// What the list repeats of a board.
fn of_part<'a>(part: &Part, cell: &impl Fn(&str) -> &'a str, report: &Report, findings: &mut Findings) {
    let figure = list(&report.value, "fabrications").get(part.block).and_then(|made| made.get("figure"));
    let plain = |text: &'a str| text.strip_prefix('\'').unwrap_or(text);
    for (header, expected) in [
        ("alias", part.alias.as_str()),
        ("figure", figure.and_then(Value::as_str).unwrap_or_default()),
        ("material", part.text("material")),
        ("sheet", part.text("sheet")),
    ] {
        findings.same(LIST, &format!("{header} of {}", part.address), expected, plain(cell(header)));
    }
    let thickness = cell("thickness_mm").parse().unwrap_or(f64::NAN);
    let what = format!("thickness_mm of {}", part.address);
    findings.near(LIST, &what, part.number("thickness_mm").unwrap_or(f64::NAN), thickness, 1e-9);
}

/// A board on no sheet is one of those the report names, for the same reason.
fn refused(part: &Part, status: &str, report: &Report, findings: &mut Findings) {
    let all = list(&report.value, "sheets").iter().flat_map(|nest| list(nest, "unplaced"));
    let text =
        |value: &Value, name: &str| value.get(name).and_then(Value::as_str).unwrap_or_default().to_owned();
    let reason =
        all.filter(|value| text(value, "address") == part.address).map(|value| text(value, "reason"));
    let expected = reason.collect::<Vec<_>>().pop().unwrap_or_else(|| "placed".to_owned());
    findings.same(LIST, &format!("status of {}", part.address), &expected, status);
}

fn placed<'a>(part: &Part, cell: &impl Fn(&str) -> &'a str, findings: &mut Findings) -> Option<Lying> {
    let number = |header: &str| cell(header).parse::<f64>().unwrap_or(f64::NAN);
    let quarters = match cell("rotation_deg") {
        "0" => 0,
        "90" => 1,
        "180" => 2,
        "270" => 3,
        other => {
            findings.add(LIST, format!("rotation_deg of {}", part.address), "0, 90, 180 or 270", other);
            return None;
        }
    };
    let at = DVec2::new(number("x_mm"), number("y_mm"));
    if !at.is_finite() || !(3..=MAX_CORNERS).contains(&part.outline.len()) {
        findings.add(LIST, format!("place of {}", part.address), "two numbers", at);
        return None;
    }
    Some(Lying {
        sheet: cell("sheet").to_owned(),
        address: part.address.clone(),
        alias: part.alias.clone(),
        quarters,
        at,
        outline: part.outline.iter().map(|&corner| turned(corner, quarters) + at).collect(),
    })
}

/// As many boards on a sheet as the report says, of that area, inside its margin, none too near to another.
fn of_sheet(name: &str, raw: Raw, sheet: &Value, here: &[&Lying], findings: &mut Findings) {
    let boards = sheet.get("boards").and_then(Value::as_u64).unwrap_or(u64::MAX);
    if boards != here.len() as u64 {
        findings.add(LIST, format!("boards on sheet {name}"), boards, here.len());
    }
    let used = here.iter().map(|board| area(&board.outline)).sum::<f64>() / (raw.size.x * raw.size.y);
    let said = sheet.get("yield").and_then(Value::as_f64).unwrap_or(f64::NAN);
    findings.near("report.json", &format!("yield of sheet {name}"), used, said, 1e-4);
    for (place, board) in here.iter().enumerate() {
        let (low, high) = bounds(&board.outline);
        let room = low.min_element().min((raw.size - high).min_element());
        if room.is_nan() || room < raw.margin - NEAR {
            findings.add(LIST, format!("{} to the edge of its sheet", board.address), raw.margin, room);
        }
        for other in &here[..place] {
            let apart = distance(&board.outline, &other.outline, raw.gap);
            if apart < raw.gap - 2.0 * NEAR {
                let what = format!("{} to {}, mm", board.address, other.address);
                findings.add(LIST, what, raw.gap, apart);
            }
        }
    }
}

fn area(outline: &[DVec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() / 2.0
}

fn bounds(outline: &[DVec2]) -> (DVec2, DVec2) {
    let low = outline.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    (low, outline.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max))
}

/// The distance of two outlines where it is less than `enough`; 0 where one reaches into the other.
fn distance(a: &[DVec2], b: &[DVec2], enough: f64) -> f64 {
    let ((a_low, a_high), (b_low, b_high)) = (bounds(a), bounds(b));
    let apart = (a_low - b_high).max(b_low - a_high).max_element();
    if apart >= enough {
        return apart;
    }
    if inside(a[0], b) || inside(b[0], a) {
        return 0.0;
    }
    let sides = |corners: &[DVec2]| -> Vec<(DVec2, DVec2)> {
        corners.iter().copied().zip(corners.iter().copied().cycle().skip(1)).collect()
    };
    let mut least = f64::INFINITY;
    for (p, q) in sides(a) {
        for (r, s) in sides(b) {
            if crosses(p, q, r, s) {
                return 0.0;
            }
            let ends = [to_side(p, r, s), to_side(q, r, s), to_side(r, p, q), to_side(s, p, q)];
            least = ends.into_iter().fold(least, f64::min);
        }
    }
    least
}

fn to_side(point: DVec2, from: DVec2, to: DVec2) -> f64 {
    let along = to - from;
    let t = ((point - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    point.distance(from + along * if t.is_finite() { t } else { 0.0 })
}

fn crosses(p: DVec2, q: DVec2, r: DVec2, s: DVec2) -> bool {
    let side = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    side(p, q, r) * side(p, q, s) < 0.0 && side(r, s, p) * side(r, s, q) < 0.0
}

/// Whether a point lies in a polygon: by how often its sides pass to the right of it.
fn inside(point: DVec2, polygon: &[DVec2]) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let passes = polygon.iter().zip(next).filter(|(a, b)| {
        (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    passes.count() % 2 == 1
}

/// Reads the picture of a sheet.
pub(super) fn picture(path: &str, text: &str, findings: &mut Findings) -> Shown {
    let mut shown =
        Shown { path: path.to_owned(), size: DVec2::NAN, outlines: Vec::new(), names: Vec::new() };
    let (mut corner, mut named) = (DVec2::NAN, false);
    for event in xml::read(path, text, &[], findings) {
        let (name, attributes) = match event {
            Event::Text(text) if named => {
                shown.names.push(text);
                continue;
            }
            Event::Open { name, attributes } => (name, attributes),
            _ => continue,
        };
        let text = |key: &str| attribute(&attributes, key).unwrap_or_default().to_owned();
        let number = |key: &str| text(key).parse::<f64>().unwrap_or(f64::NAN);
        named = name == "text" && text("class") == "name";
        match (name.as_str(), text("class").as_str()) {
            ("rect", "board") => {
                shown.size = DVec2::new(number("width"), number("height"));
                corner = DVec2::new(number("x"), number("y") + shown.size.y);
            }
            ("polygon", "part") => {
                let pairs = text("points");
                let point = |pair: &str| {
                    let (x, y) = pair.split_once(',')?;
                    Some(DVec2::new(x.parse::<f64>().ok()? - corner.x, corner.y - y.parse::<f64>().ok()?))
                };
                let points = pairs.split(' ').map(|pair| point(pair).unwrap_or(DVec2::NAN));
                shown.outlines.push(points.collect());
            }
            ("text", _) if !(number("x").is_finite() && number("y").is_finite()) => {
                findings.add(path, "place of a text", "two numbers", "others");
            }
            ("svg" | "title" | "style" | "text" | "path" | "rect", _) => {}
            (other, _) => findings.add(path, "an element", "one of a sheet", other),
        }
    }
    shown
}

/// Compares what is shown of a sheet with the boards that lie on it.
pub(super) fn compare(shown: &Shown, name: &str, raw: Raw, lying: &[Lying], findings: &mut Findings) {
    let path = shown.path.as_str();
    findings.near(path, "length of the raw board", raw.size.x, shown.size.x, NEAR);
    findings.near(path, "width of the raw board", raw.size.y, shown.size.y, NEAR);
    let here: Vec<&Lying> = lying.iter().filter(|board| board.sheet == name).collect();
    if here.len() != shown.outlines.len() || here.len() != shown.names.len() {
        findings.add(path, "boards", here.len(), shown.outlines.len().min(shown.names.len()));
        return;
    }
    for ((board, outline), text) in here.iter().zip(&shown.outlines).zip(&shown.names) {
        if *text != board.alias && *text != board.address {
            findings.add(path, "the name of a board", &board.alias, text);
        }
        if outline.len() != board.outline.len() {
            findings.add(path, format!("corners of {}", board.address), board.outline.len(), outline.len());
            continue;
        }
        for (place, (expected, found)) in board.outline.iter().zip(outline).enumerate() {
            let what = format!("corner {place} of {}", board.address);
            findings.near(path, &what, 0.0, expected.distance(*found), 1.5 * NEAR);
        }
    }
}

/// The sheet that a file of `sheets/` is of.
pub(super) fn name_of(path: &str) -> &str {
    path.strip_prefix("sheets/").and_then(|file| file.split('.').next()).unwrap_or_default()
}
