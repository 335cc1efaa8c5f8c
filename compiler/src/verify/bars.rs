//! `stock.csv`: planks on bars against `report.json`, and against each other: none reaches into another, into the kerf
//! beside it or out of its bar.

use std::collections::BTreeSet;

use serde_json::Value;

use super::csv;
use super::finding::Findings;
use super::report::{LAST_DECIMAL, Part, Report, list};

const LIST: &str = "stock.csv";

/// Two places are rounded to the third decimal each, and angles to the fourth.
const NEAR: f64 = 0.003;

/// Half of the last decimal of angles, degrees, and a hair.
const ANGLE: f64 = 0.000_051;

/// A plank on its bar.
struct Sawn<'a> {
    part: &'a Part,
    /// Where its cuts meet the axis, mm.
    at: [f64; 2],
    /// How they lean, degrees.
    leans: [f64; 2],
    /// How they are tilted, degrees.
    tilts: [f64; 2],
    offcut: String,
}

/// Reads the list and judges it; `whole` where nothing was left out of the set.
pub(super) fn check(text: &str, report: &Report, whole: bool, findings: &mut Findings) {
    let table = csv::read(LIST, text, findings);
    let nests = list(&report.value, "bars");
    let mut met = BTreeSet::new();
    let mut bars: Vec<(String, Vec<Sawn<'_>>)> = Vec::new();
    for row in &table.rows {
        let cell = |header: &str| table.cell(row, header).unwrap_or_default();
        let address = cell("address");
        let Some(part) = report.part(address).filter(|part| part.is_plank) else {
            findings.add(LIST, "address", "a plank of report.json", address);
            continue;
        };
        if !met.insert(address.to_owned()) {
            findings.add(LIST, "rows of a plank", "one", address);
        }
        let on_bar = |nest: &&Value| list(nest, "bars").iter().any(|bar| said(bar, "name") == cell("bar"));
        let too_long =
            |nest: &&Value| list(nest, "unplaced").iter().any(|plank| said(plank, "address") == address);
        let nest = match cell("bar") {
            "" => nests.iter().find(too_long),
            _ => nests.iter().find(on_bar),
        };
        let Some(nest) = nest else {
            findings.add(LIST, format!("bar of {address}"), "one of report.json", cell("bar"));
            continue;
        };
        of_part(part, nest, &cell, findings);
        if cell("bar").is_empty() {
            let unplaced = list(nest, "unplaced").iter().find(|plank| said(plank, "address") == address);
            let reason = unplaced.map_or("", |plank| said(plank, "reason"));
            findings.same(LIST, &format!("status of {address}"), reason, cell("status"));
            continue;
        }
        let sawn = sawn(part, &cell, findings);
        match bars.last_mut().filter(|(bar, _)| bar == cell("bar")) {
            Some((_, planks)) => planks.push(sawn),
            None => bars.push((cell("bar").to_owned(), vec![sawn])),
        }
        let place = bars.last().map_or(0, |(_, planks)| planks.len());
        findings.same(LIST, &format!("place of {address}"), &place.to_string(), cell("place"));
        neighbours(part, &cell, place, &table, row, findings);
    }
    let nested = report.parts.iter().filter(|part| part.is_plank && !part.text("sheet").is_empty());
    if let Some(part) = nested.into_iter().find(|part| whole && !met.contains(&part.address)) {
        findings.add(LIST, "rows", format!("one for {}", part.address), "none");
    }
    let names: Vec<&str> =
        nests.iter().flat_map(|nest| list(nest, "bars")).map(|bar| said(bar, "name")).collect();
    if whole && names != bars.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>() {
        findings.add(LIST, "bars", "those of report.json in order", "others");
    }
    for (name, planks) in &bars {
        for nest in nests {
            if let Some(bar) = list(nest, "bars").iter().find(|bar| said(bar, "name") == name) {
                of_bar(name, planks, nest, bar, findings);
            }
        }
    }
}

fn said<'a>(value: &'a Value, name: &str) -> &'a str {
    value.get(name).and_then(Value::as_str).unwrap_or_default()
}

fn number(value: &Value, name: &str) -> f64 {
    value.get(name).and_then(Value::as_f64).unwrap_or(f64::NAN)
}

/// What the list repeats of a plank and its stock.
fn of_part<'a>(part: &Part, nest: &Value, cell: &impl Fn(&str) -> &'a str, findings: &mut Findings) {
    let plain = |text: &'a str| text.strip_prefix('\'').unwrap_or(text);
    for (header, expected) in [
        ("alias", part.alias.as_str()),
        ("figure", part.text("figure")),
        ("material", part.text("material")),
        ("bar", part.text("sheet")),
    ] {
        findings.same(LIST, &format!("{header} of {}", part.address), expected, plain(cell(header)));
    }
    for (header, expected) in [
        ("length_mm", part.number("length_mm").unwrap_or(f64::NAN)),
        ("depth_mm", number(nest, "depth_mm")),
        ("width_mm", number(nest, "width_mm")),
        ("bar_length_mm", number(nest, "length_mm")),
        ("kerf_mm", number(nest, "kerf_mm")),
    ] {
        let found = cell(header).parse().unwrap_or(f64::NAN);
        findings.near(LIST, &format!("{header} of {}", part.address), expected, found, 1e-9);
    }
}

/// A row's cuts: the length between them, and how they lean for the way the plank lies.
fn sawn<'a, 'b>(part: &'b Part, cell: &impl Fn(&str) -> &'a str, findings: &mut Findings) -> Sawn<'b> {
    let both = |what: &str| {
        ["first", "second"].map(|cut| cell(&format!("{cut}_cut_{what}")).parse::<f64>().unwrap_or(f64::NAN))
    };
    let sawn = Sawn {
        part,
        at: both("mm"),
        leans: both("deg"),
        tilts: both("tilt_deg"),
        offcut: cell("offcut_mm").to_owned(),
    };
    let address = &part.address;
    let length = part.number("length_mm").unwrap_or(f64::NAN);
    findings.near(
        LIST,
        &format!("cuts of {address}, mm apart"),
        length,
        sawn.at[1] - sawn.at[0],
        3.0 * LAST_DECIMAL,
    );
    let (end_first, turned_over) = match cell("lies") {
        "as drawn" => (false, false),
        "end first" => (true, false),
        "turned over" => (false, true),
        "end first and turned over" => (true, true),
        other => {
            findings.add(LIST, format!("how {address} lies"), "one of four words", other);
            return sawn;
        }
    };
    // Turned end for end, cuts change places and are tilted the other way; turned over they lean and are tilted the
    // other way.
    let sign = |turned: bool| if turned { -1.0 } else { 1.0 };
    for (what, found, sign, name) in [
        ("lean", sawn.leans, sign(turned_over), "mitres_deg"),
        ("tilt", sawn.tilts, sign(end_first != turned_over), "end_bevels_deg"),
    ] {
        for end in 0..2 {
            let found = found[if end_first { 1 - end } else { end }];
            let expected = sign * part.item(name, end).unwrap_or(f64::NAN);
            findings.near(LIST, &format!("{what} of end {end} of {address}"), expected, found, 2.0 * ANGLE);
        }
    }
    if cell("status") != "placed" {
        findings.add(LIST, format!("status of {address}"), "placed", cell("status"));
    }
    sawn
}

/// A shared cut is said at both of its planks.
fn neighbours<'a>(
    part: &Part,
    cell: &impl Fn(&str) -> &'a str,
    place: usize,
    table: &csv::Table,
    row: &[String],
    findings: &mut Findings,
) {
    let before = table.rows.iter().position(|other| std::ptr::eq(other.as_slice(), row)).and_then(|at| {
        let before = table.rows.get(at.checked_sub(1)?)?;
        (place > 1).then(|| table.cell(before, "second_cut").unwrap_or_default())
    });
    let (shared, first) = (before == Some("shared"), cell("first_cut"));
    if !["raw", "shared", "own"].contains(&first) || (first == "shared") != shared {
        let expected = if shared { "shared" } else { "raw or own" };
        findings.add(LIST, format!("first_cut of {}", part.address), expected, first);
    }
    if first == "raw" && (place > 1 || cell("first_cut_mm").parse() != Ok(0.0)) {
        findings.add(LIST, format!("first_cut of {}", part.address), "raw at 0 alone", cell("first_cut_mm"));
    }
}

/// Planks of one bar: their number, what is left, and the room between them.
fn of_bar(name: &str, planks: &[Sawn<'_>], nest: &Value, bar: &Value, findings: &mut Findings) {
    let count = bar.get("planks").and_then(Value::as_u64).unwrap_or(0);
    findings.same(LIST, &format!("planks on {name}"), &count.to_string(), &planks.len().to_string());
    for (place, plank) in planks.iter().enumerate() {
        let expected = match place + 1 == planks.len() {
            true => bar
                .get("offcut_mm")
                .map_or_else(String::new, |offcut| format!("{:.3}", offcut.as_f64().unwrap_or(f64::NAN))),
            false => String::new(),
        };
        findings.same(LIST, &format!("offcut after {}", plank.part.address), &expected, &plank.offcut);
    }
    let (depth, width) = (number(nest, "depth_mm") / 2.0, number(nest, "width_mm") / 2.0);
    let (trim, length, kerf) = (number(nest, "trim_mm"), number(nest, "length_mm"), number(nest, "kerf_mm"));
    for (y, z) in [(depth, width), (depth, -width), (-depth, width), (-depth, -width)] {
        let mut free = trim - NEAR;
        for plank in planks {
            let [from, to] = [0, 1].map(|end| plank.corner(end, y, z));
            if from.is_nan() || from < free {
                let what = format!("room before {}, mm", plank.part.address);
                findings.add(LIST, what, format!("{:.3} at least", free + NEAR), format!("{from:.3}"));
            }
            free = to + kerf - NEAR;
        }
        if free - kerf > length - trim {
            findings.add(LIST, format!("planks on {name}"), "that they end on their bar", "longer");
        }
    }
}

impl Sawn<'_> {
    /// Where an edge of the plank ends, mm along the bar. A cut that leans anticlockwise runs ahead below the axis, one
    /// that is tilted upwards behind it.
    fn corner(&self, end: usize, y: f64, z: f64) -> f64 {
        let (lean, tilt) = (self.leans[end].to_radians(), self.tilts[end].to_radians());
        self.at[end] - libm::tan(lean) * y - libm::tan(tilt) / libm::cos(lean) * z
    }
}
